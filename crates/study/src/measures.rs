//! Measures at each vertex of a subject, in the frame of the mean.

use crate::align::vertex_areas;
use crate::settings::Measure;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};

/// Largest number of steps of a shrinking ball; it rarely needs more than eight.
const MAX_STEPS: usize = 40;
/// Relative decrease of the radius below which a shrinking ball touches.
const TOUCHES: f64 = 0.01;

/// One measure at each vertex of a subject: `subject` has the vertices of `mean` and was moved onto it. `None` if the
/// measure is not meaningful, such as the thickness of a surface that is not closed.
///
/// # Errors
/// [`Cancelled`].
pub fn measured(
    measure: Measure,
    mean: &SurfaceMesh,
    subject: &SurfaceMesh,
    observer: &dyn Observer,
) -> Result<Option<Vec<f64>>, Cancelled> {
    checkpoint(observer)?;
    Ok(match measure {
        Measure::NormalDisplacement => {
            let normals = mean.vertex_normals();
            let pairs = mean.vertices().iter().zip(subject.vertices());
            Some(pairs.zip(normals).map(|((mean, own), normal)| (own - mean).dot(&normal)).collect())
        }
        Measure::LogArea => {
            let (own, mean) = (vertex_areas(subject), vertex_areas(mean));
            // A vertex folded away by a map has no area; a lower bound of a thousandth limits its weight.
            Some(own.iter().zip(&mean).map(|(own, mean)| (own / mean).max(1e-3).ln()).collect())
        }
        Measure::Thickness if subject.boundary_vertices().is_some() => None,
        Measure::Thickness => Some(thickness(subject, observer)?),
    })
}

/// Local thickness of a closed surface at each vertex, mm: diameter of the largest ball inside that touches the vertex, which
/// is twice the distance to the medial axis along the normal.
///
/// A ball that touches at the vertex and is too large is cut by the surface nearest to its center. The ball through
/// that point is smaller; this is repeated to a precision of a hundredth, starting with half the diagonal. Bumps beside
/// the vertex do not count: the two points where the ball touches are at least 60 degrees apart as seen from its
/// center.
///
/// Source: Ma, Bae, Choi, *3D medial axis point approximation using nearest neighbors and the normal field*, Visual Computer
/// 28, 2012.
///
/// # Errors
/// [`Cancelled`].
pub fn thickness(mesh: &SurfaceMesh, observer: &dyn Observer) -> Result<Vec<f64>, Cancelled> {
    let index = ClosestPointIndex::new(mesh);
    let (low, high) = mesh.bounding_box();
    let largest = (high - low).norm() / 2.0;
    let of = |v: usize, normal: &nalgebra::Vector3<f64>| {
        let p = mesh.vertices()[v];
        let mut radius = largest;
        for _ in 0..MAX_STEPS {
            let center = p - radius * normal;
            let nearest = index.closest(&center);
            if (nearest.point - center).norm() >= radius * (1.0 - TOUCHES) {
                break;
            }
            // Vertices lie on the sampled surface; between them flat triangles cut off its curvature.
            let corners = nearest.triangle.iter().filter(|&&corner| corner as usize != v);
            let through = corners.filter_map(|&corner| {
                let to = mesh.vertices()[corner as usize] - p;
                let depth = -2.0 * normal.dot(&to);
                // A point less than 60 degrees from the vertex, seen from the center, is a bump beside it or an error
                // of its normal, not the other side.
                (depth > 0.0 && to.norm() * depth >= to.norm_squared()).then(|| to.norm_squared() / depth)
            });
            let smaller = through.fold(f64::INFINITY, f64::min);
            if smaller >= radius * (1.0 - TOUCHES) {
                break;
            }
            radius = smaller;
        }
        2.0 * radius
    };
    let each = mesh.vertex_normals().into_iter().enumerate().map(|(v, normal)| {
        checkpoint(observer)?;
        Ok(of(v, &normal))
    });
    each.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::FaceArity;
    use homolog_mesh::shapes::{ellipsoid, torus};
    use homolog_primitives::observe::Silent;
    use nalgebra::Vector3;

    #[test]
    fn a_grown_sphere_is_displaced_by_the_difference_of_radii() {
        let mean = ellipsoid(Vector3::repeat(5.0), 4);
        let grown = mean.with_vertices(mean.vertices().iter().map(|p| p * 1.2).collect()).unwrap();
        let of = |measure| measured(measure, &mean, &grown, &Silent).unwrap().unwrap();
        assert!(of(Measure::NormalDisplacement).iter().all(|d| (d - 1.0).abs() < 0.01));
        assert!(of(Measure::LogArea).iter().all(|a| (a - 2.0 * 1.2f64.ln()).abs() < 1e-9));
        assert!(of(Measure::Thickness).iter().all(|d| (d - 12.0).abs() < 0.2));
    }

    #[test]
    fn the_ball_in_a_torus_is_its_tube_and_an_open_surface_has_no_thickness() {
        let mesh = torus(10.0, 3.0, 60, 30, FaceArity::Triangle);
        assert!(thickness(&mesh, &Silent).unwrap().iter().all(|d| (d - 6.0).abs() < 0.3));
        let open =
            SurfaceMesh::new(mesh.vertices().to_vec(), FaceArity::Triangle, mesh.indices()[3..].to_vec()).unwrap();
        assert_eq!(measured(Measure::Thickness, &mesh, &open, &Silent).unwrap(), None);
    }
}
