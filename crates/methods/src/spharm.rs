//! SPHARM-PDM: points of equal parameter correspond.
//!
//! Each surface of genus 0 is mapped onto the unit sphere with equal areas and little distortion. The sphere is rotated
//! so that the axes of the first-order ellipsoid lie on the coordinate axes; then points with the same parameter
//! correspond. Axes have no sign: of the four rotations that differ by half turns, the one is chosen for which
//! corresponding points lie closest in the given pose. A series of spherical harmonics describes each surface.
//!
//! Sources: Brechbühler, Gerig, Kübler, "Parametrization of closed surfaces for 3-D shape description", 1995; Styner et al.,
//! "Framework for the statistical shape analysis of brain structures using SPHARM-PDM", Insight Journal, 2006.

use crate::MethodError;
use homolog_geometry::curvature::vertex_areas;
use homolog_geometry::harmonics::{
    FirstOrderEllipsoid, HarmonicSeries, HarmonicsError, Parametrization, ParametrizationOptions,
    first_order_ellipsoid, parametrize,
};
use homolog_mesh::{ClosestPointIndex, FaceArity, SurfaceMesh};
use homolog_primitives::observe::Observer;
use nalgebra::{Matrix3, Point3, Vector3};
use rayon::prelude::*;

/// Settings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpharmOptions {
    /// Degree of the series. Brain structures are usually described with 12 to 15.
    pub degree: u32,
}

impl Default for SpharmOptions {
    fn default() -> Self {
        SpharmOptions { degree: 12 }
    }
}

/// The result of [`register`].
#[derive(Debug, Clone)]
pub struct Spharm {
    /// The point of the target with the same parameter, for every source vertex.
    pub images: Vec<Point3<f64>>,
    /// The corresponding points on the series of the target.
    pub reconstructed: Vec<Point3<f64>>,
    /// The series of the source, over its own sphere rotated to its axes.
    pub source: HarmonicSeries,
    /// The series of the target, over its sphere rotated so that equal parameters correspond.
    pub target: HarmonicSeries,
}

/// A surface over its sphere.
struct Parametrized {
    /// Unit vectors of the vertices with the axes of the ellipsoid as coordinate axes.
    directions: Vec<Vector3<f64>>,
    areas: Vec<f64>,
}

/// A correspondence of `source` with `target`, both closed and of genus 0, in one pose.
///
/// # Errors
/// [`MethodError::Sphere`]; [`MethodError::Singular`] if the vertices do not determine a series; [`MethodError::Cancelled`].
///
/// # Cost
/// Two maps onto the sphere ([`parametrize`]), and `O(n degree⁴)`.
pub fn register(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    options: &SpharmOptions,
    observer: &dyn Observer,
) -> Result<Spharm, MethodError> {
    let (of_source, of_target) =
        rayon::join(|| parametrized(source, "source", observer), || parametrized(target, "target", observer));
    let (of_source, of_target) = (of_source?, of_target?);
    let singular = MethodError::Singular { method: "spherical harmonics" };
    let best = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]]
        .into_iter()
        .filter_map(|[a, b]| {
            let signs = Vector3::new(a, b, a * b);
            let turned: Vec<_> = of_target.directions.iter().map(|d| d.component_mul(&signs)).collect();
            let images = at_equal_parameters(&of_source.directions, &turned, target)?;
            let squares: f64 =
                (0..images.len()).map(|i| of_source.areas[i] * (images[i] - source.vertices()[i]).norm_squared()).sum();
            Some((squares, turned, images))
        })
        .min_by(|a, b| a.0.total_cmp(&b.0));
    let (_, turned, images) = best.ok_or(singular.clone())?;
    let degree = options.degree;
    let series = |directions: &[Vector3<f64>], mesh: &SurfaceMesh, areas: &[f64]| {
        HarmonicSeries::fit(directions, mesh.vertices(), areas, degree)
    };
    let of = (
        series(&of_source.directions, source, &of_source.areas).ok_or(singular.clone())?,
        series(&turned, target, &of_target.areas).ok_or(singular)?,
    );
    let reconstructed = of_source.directions.par_iter().map(|d| of.1.at(d)).collect();
    Ok(Spharm { images, reconstructed, source: of.0, target: of.1 })
}

fn parametrized(
    mesh: &SurfaceMesh,
    surface: &'static str,
    observer: &dyn Observer,
) -> Result<Parametrized, MethodError> {
    let found = parametrize(mesh, &ParametrizationOptions::default(), observer)
        .and_then(|on_sphere| Ok((first_order_ellipsoid(mesh, &on_sphere)?, on_sphere)));
    let (ellipsoid, on_sphere): (FirstOrderEllipsoid, Parametrization) = found.map_err(|error| match error {
        HarmonicsError::Cancelled(cancelled) => MethodError::Cancelled(cancelled),
        error => MethodError::Sphere { surface, error },
    })?;
    // A right-handed frame of the sphere: a mirror image would exchange inside and outside.
    let mut axes: Matrix3<f64> = ellipsoid.parameter_axes;
    if axes.determinant() < 0.0 {
        axes.set_column(2, &-axes.column(2));
    }
    let directions = on_sphere.directions.iter().map(|d| axes.tr_mul(d)).collect();
    Ok(Parametrized { directions, areas: vertex_areas(mesh) })
}

/// For each of `wanted` the point of `target` at that parameter; `directions` are the directions of its vertices.
/// `None` if a number is not finite.
fn at_equal_parameters(
    wanted: &[Vector3<f64>],
    directions: &[Vector3<f64>],
    target: &SurfaceMesh,
) -> Option<Vec<Point3<f64>>> {
    let indices = target.triangles().into_iter().flatten().collect();
    let sphere =
        SurfaceMesh::new(directions.iter().map(|d| Point3::from(*d)).collect(), FaceArity::Triangle, indices).ok()?;
    let index = ClosestPointIndex::new(&sphere);
    let vertices = target.vertices();
    let image = |d: &Vector3<f64>| Point3::from(index.closest(&Point3::from(*d)).blend(|k| vertices[k].coords));
    Some(wanted.par_iter().map(image).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{bean, rms};
    use homolog_primitives::observe::Silent;

    #[test]
    fn a_copy_corresponds_to_itself_and_is_reconstructed() {
        let mesh = bean(4);
        let found = register(&mesh, &mesh, &SpharmOptions::default(), &Silent).unwrap();
        assert!(rms(&found.images, mesh.vertices()) < 1e-6, "{}", rms(&found.images, mesh.vertices()));
        // A smooth shape: a series of degree 12 leaves less than a hundredth of its size.
        assert!(rms(&found.reconstructed, mesh.vertices()) < 0.01, "{}", rms(&found.reconstructed, mesh.vertices()));
        assert_eq!(found.source.coefficients_mm().len(), 169);
    }

    #[test]
    fn a_stretched_surface_corresponds_better_than_by_closest_points() {
        // Along a lengthened axis closest points slip, and equal areas stretch along it.
        let mesh = bean(4);
        let truth: Vec<_> = mesh.vertices().iter().map(|p| Point3::new(1.3 * p.x, p.y, p.z)).collect();
        let target = mesh.with_vertices(truth.clone()).unwrap();
        let found = register(&mesh, &target, &SpharmOptions::default(), &Silent).unwrap();
        let index = ClosestPointIndex::new(&target);
        let closest: Vec<_> = mesh.vertices().iter().map(|p| index.closest(p).point).collect();
        assert!(rms(&found.images, &truth) < 0.7 * rms(&closest, &truth), "{}", rms(&found.images, &truth));
    }

    #[test]
    fn a_torus_has_no_map_onto_the_sphere() {
        let torus = homolog_mesh::shapes::torus(3.0, 1.0, 24, 12, FaceArity::Triangle);
        let found = register(&torus, &torus, &SpharmOptions::default(), &Silent);
        assert!(matches!(found, Err(MethodError::Sphere { surface: "source", .. })));
    }
}
