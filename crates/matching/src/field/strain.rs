//! Stretch of a surface under a map.

use homolog_mesh::SurfaceMesh;
use nalgebra::Point3;

/// Largest ratio `σ₁/σ₂` of the stretches of a triangle; larger ratios count as this one. A triangle collapsed to a
/// line would outweigh all others.
const MAX_DRAWN_OUT: f64 = 10.0;

/// Stretch of a triangle under a map with singular values `σ₁ ≥ σ₂`.
struct Stretch {
    /// Twice the area of the triangle, mm².
    doubled_area: f64,
    /// `ln(σ₁/σ₂)`, at most `ln` of [`MAX_DRAWN_OUT`].
    drawn_out: f64,
    /// `σ₁ σ₂`: ratio of its area after and before the map.
    growth: f64,
}

/// The stretch of every triangle of `mesh` that has an area, for the map of the vertices to `moved`.
fn stretches(mesh: &SurfaceMesh, moved: &[Point3<f64>]) -> impl Iterator<Item = Stretch> {
    mesh.triangles().into_iter().filter_map(move |corners| {
        let form = |points: &[Point3<f64>]| {
            let [a, b, c] = corners.map(|v| points[v as usize]);
            let (e, f) = (b - a, c - a);
            (e.dot(&e), e.dot(&f), f.dot(&f), e.cross(&f).norm_squared())
        };
        let (g11, g12, g22, g) = form(mesh.vertices());
        let (h11, h12, h22, h) = form(moved);
        if g <= 0.0 {
            return None;
        }
        // With G and H the first fundamental forms, σ₁² and σ₂² are the eigenvalues of G⁻¹H.
        let trace = (g22 * h11 - 2.0 * g12 * h12 + g11 * h22) / g;
        let growth = (h / g).sqrt();
        let cosh = trace / (2.0 * growth);
        let drawn_out = if h > 0.0 { cosh.max(1.0).acosh().min(MAX_DRAWN_OUT.ln()) } else { MAX_DRAWN_OUT.ln() };
        Some(Stretch { doubled_area: g.sqrt(), drawn_out, growth })
    })
}

/// Mean angular distortion of the map of the vertices of `mesh` to `moved`: the mean over the area of `mesh` of
/// `ln(σ₁/σ₂)`, where `σ₁ ≥ σ₂` are the singular values of the map of a triangle (Hormann, Greiner 2000 take their
/// ratio). 0 for similarities, 0.69 if every triangle is stretched to twice its width.
///
/// Cost `O(n)`; sums in order of the triangles.
pub(crate) fn distortion(mesh: &SurfaceMesh, moved: &[Point3<f64>]) -> f64 {
    let (mut sum, mut total) = (0.0, 0.0);
    for stretch in stretches(mesh, moved) {
        sum += stretch.doubled_area * stretch.drawn_out;
        total += stretch.doubled_area;
    }
    if total > 0.0 { sum / total } else { 0.0 }
}

/// Mean squared strain of the map of the vertices of `mesh` to `moved`, relative to a similarity: the mean over the
/// area of `mesh` of `ln²(σ₁/s) + ln²(σ₂/s)`, the squared logarithmic (Hencky) strain, where `s²` is the growth of the
/// whole area. 0 for similarities.
///
/// Cost `O(n)`; sums in order of the triangles.
pub(crate) fn squared_strain(mesh: &SurfaceMesh, moved: &[Point3<f64>]) -> f64 {
    let (before, after) = stretches(mesh, moved).fold((0.0, 0.0), |(before, after), stretch| {
        (before + stretch.doubled_area, after + stretch.doubled_area * stretch.growth)
    });
    if before <= 0.0 || after <= 0.0 {
        return 0.0;
    }
    let most = MAX_DRAWN_OUT.ln();
    let squares = stretches(mesh, moved).map(|stretch| {
        let grown = (stretch.growth * before / after).ln().clamp(-most, most);
        // The sum of two squares, from the sum and the difference of the logarithms.
        stretch.doubled_area * 0.5 * (grown * grown + stretch.drawn_out * stretch.drawn_out)
    });
    squares.sum::<f64>() / before
}

#[cfg(test)]
mod tests {
    use super::{MAX_DRAWN_OUT, distortion, squared_strain};
    use homolog_mesh::SurfaceMesh;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::{Matrix3, Point3, Rotation3, Vector3};
    use proptest::prelude::*;

    fn sphere() -> SurfaceMesh {
        ellipsoid(Vector3::new(5.0, 5.0, 5.0), 2)
    }

    fn moved(mesh: &SurfaceMesh, map: &Matrix3<f64>) -> Vec<Point3<f64>> {
        mesh.vertices().iter().map(|p| Point3::from(map * p.coords)).collect()
    }

    /// Logarithms of the singular values of the map of one triangle, from the map between orthonormal bases of the two
    /// planes.
    fn of_triangle(before: [Point3<f64>; 3], after: [Point3<f64>; 3]) -> [f64; 2] {
        let plane = |[a, b, c]: [Point3<f64>; 3]| {
            let x = (b - a).normalize();
            let y = (b - a).cross(&(c - a)).cross(&x).normalize();
            nalgebra::Matrix2::new((b - a).dot(&x), (c - a).dot(&x), (b - a).dot(&y), (c - a).dot(&y))
        };
        let map = plane(after) * plane(before).try_inverse().unwrap();
        let values = map.singular_values();
        [values.max().ln(), values.min().ln()]
    }

    #[test]
    fn similarities_do_not_distort() {
        let mesh = sphere();
        let turned = moved(&mesh, &(Rotation3::new(Vector3::new(0.3, -1.0, 0.7)).matrix() * 2.5));
        assert!(distortion(&mesh, &turned) < 1e-6);
        assert!(squared_strain(&mesh, &turned) < 1e-12);
    }

    #[test]
    fn a_collapsed_triangle_counts_as_far_drawn_out_and_no_further() {
        let mesh = sphere();
        let flat = moved(&mesh, &Matrix3::from_diagonal(&Vector3::new(1.0, 0.0, 0.0)));
        assert!((distortion(&mesh, &flat) - MAX_DRAWN_OUT.ln()).abs() < 1e-9);
        assert_eq!(squared_strain(&mesh, &flat), 0.0);
    }

    proptest! {
        #[test]
        fn distortion_and_strain_are_those_of_the_singular_values_of_every_triangle(
            entries in prop::array::uniform9(-1.0..1.0f64),
        ) {
            let map = Matrix3::from_iterator(entries) + Matrix3::identity() * 1.5;
            prop_assume!(map.determinant().abs() > 0.1);
            let mesh = sphere();
            let moved = moved(&mesh, &map);
            let triangles: Vec<(f64, [f64; 2], f64)> = mesh
                .triangles()
                .iter()
                .map(|t| {
                    let [before, after] = [mesh.vertices(), &moved[..]].map(|points| t.map(|v| points[v as usize]));
                    let area = |[a, b, c]: [Point3<f64>; 3]| (b - a).cross(&(c - a)).norm();
                    (area(before), of_triangle(before, after), area(after))
                })
                .collect();
            let total: f64 = triangles.iter().map(|t| t.0).sum();
            let overall = 0.5 * (triangles.iter().map(|t| t.2).sum::<f64>() / total).ln();
            let (mut drawn_out, mut strain) = (0.0, 0.0);
            for (area, [most, least], _) in triangles {
                let apart = (most - least).min(MAX_DRAWN_OUT.ln());
                let grown = (most + least - 2.0 * overall).clamp(-MAX_DRAWN_OUT.ln(), MAX_DRAWN_OUT.ln());
                drawn_out += area * apart / total;
                strain += area * ((grown + apart).powi(2) + (grown - apart).powi(2)) / (4.0 * total);
            }
            prop_assert!((distortion(&mesh, &moved) - drawn_out).abs() < 1e-6);
            prop_assert!((squared_strain(&mesh, &moved) - strain).abs() < 1e-6);
        }
    }

    #[test]
    fn the_strain_of_a_stretch_along_one_axis_is_that_of_a_plane() {
        // A strip in the plane, stretched by 1.5 along x only: the two logarithms minus their mean are ± ln(1.5)/2.
        let corners = [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0], [5.0, 2.0]].map(|[x, y]| Point3::new(x, y, 1.0));
        let mesh =
            SurfaceMesh::new(corners.to_vec(), homolog_mesh::FaceArity::Triangle, vec![0, 1, 2, 1, 3, 2]).unwrap();
        let drawn = moved(&mesh, &Matrix3::from_diagonal(&Vector3::new(1.5, 1.0, 1.0)));
        assert!((squared_strain(&mesh, &drawn) - 0.5 * 1.5f64.ln().powi(2)).abs() < 1e-12);
    }
}
