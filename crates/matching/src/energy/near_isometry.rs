//! The energy of near isometries alone, for measuring it.

use super::minimize::{fused, minimized};
use super::model::{Isometry, SiteMeasurements};
use super::settings::IsometrySettings;
use crate::error::MatchError;
use crate::pair::lengths::Lengths;
use crate::pair::smooth_pair::smooth_pair;
use crate::surface::side::SurfaceLevel;
use homolog_mesh::SurfaceMesh;
use homolog_mrf::Labeling;
use homolog_mrf::metric::MetricModel;

/// The energy of near isometries between two surfaces, and the starts of its minimization, for measuring the energy
/// itself.
#[derive(Debug, Clone, PartialEq)]
pub struct NearIsometryModel {
    /// The energy.
    pub model: MetricModel,
    /// The vertex of the source at each variable.
    pub variables: Vec<u32>,
    /// The vertex of the target at each label.
    pub labels: Vec<u32>,
    /// For each assignment of extremities its bias, an initial addition to the unary potentials.
    pub of_extremities: Vec<Vec<f32>>,
}

impl NearIsometryModel {
    /// The labeling from belief propagation with an initial bias (may be empty), followed by conditional modes.
    pub fn minimized(&self, bias: &[f32]) -> Labeling {
        minimized(&self.model, bias, &IsometrySettings::default())
    }

    /// The labeling from fusing `labelings`, followed by conditional modes; `None` for an empty list.
    pub fn fused(&self, labelings: &[Labeling]) -> Option<Labeling> {
        fused(&self.model, labelings, &IsometrySettings::default())
    }
}

/// The model of two surfaces in canonical numbering.
///
/// # Errors
/// [`MatchError::ScaleSpace`].
pub fn near_isometry_model(source: &SurfaceMesh, target: &SurfaceMesh) -> Result<NearIsometryModel, MatchError> {
    let (source, target) = (SurfaceLevel::new(source), SurfaceLevel::new(target));
    let root_mm = Lengths::of(&source, &target).root_mm;
    let smooth = smooth_pair(source.mesh(), target.mesh(), root_mm, false)?;
    let settings = IsometrySettings::default();
    let (of_source, of_target) = (
        SiteMeasurements::of(&smooth.0, source.sites(), &settings),
        SiteMeasurements::of(&smooth.1, target.sites(), &settings),
    );
    let isometry = Isometry::new(&of_source, &of_target, settings);
    Ok(NearIsometryModel {
        variables: isometry.variables.iter().map(|&k| source.sites().vertices[k as usize]).collect(),
        labels: target.sites().vertices.clone(),
        of_extremities: isometry.of_extremities(),
        model: isometry.model,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::canonicalize;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::{Point3, Vector3};

    /// A surface with one plane of symmetry, `z = 0`, bent by `angle` radians within that plane, in canonical
    /// numbering.
    fn symmetric(angle: f64) -> SurfaceMesh {
        let mesh = ellipsoid(Vector3::new(16.0, 6.0, 5.0), 4);
        let radius = 32.0 / angle;
        let shaped = |p: &Point3<f64>| {
            let (y, z) = (p.y * (1.0 + 0.02 * p.x) + 0.01 * p.x * p.x, p.z * (1.0 - 0.015 * p.x + 0.02 * p.y));
            let phi = p.x / radius;
            Point3::new((radius - y) * phi.sin(), radius - (radius - y) * phi.cos(), z)
        };
        canonicalize(&mesh.with_vertices(mesh.vertices().iter().map(shaped).collect()).unwrap()).mesh
    }

    fn nearest(places: &[Point3<f64>], to: Point3<f64>) -> u32 {
        let away = |k: &u32| (places[*k as usize] - to).norm();
        (0..places.len() as u32).min_by(|a, b| away(a).total_cmp(&away(b))).unwrap()
    }

    fn at(mesh: &SurfaceMesh, vertices: &[u32]) -> Vec<Point3<f64>> {
        vertices.iter().map(|&k| mesh.vertices()[k as usize]).collect()
    }

    #[test]
    fn the_truth_has_a_lower_energy_than_its_mirror_image() {
        let mesh = symmetric(0.4);
        let found = near_isometry_model(&mesh, &mesh).unwrap();
        let (variables, labels) = (at(&mesh, &found.variables), at(&mesh, &found.labels));
        let truth: Vec<u32> = variables.iter().map(|p| nearest(&labels, *p)).collect();
        let mirrored: Vec<u32> = variables.iter().map(|p| nearest(&labels, Point3::new(p.x, p.y, -p.z))).collect();
        let [truth, mirrored] = [truth, mirrored].map(|x| found.model.energy(&found.model.descend(x, 20)));
        assert!(truth.unary + 40.0 < mirrored.unary, "{truth:?} {mirrored:?}");
        // The mirror image has the same distances along the surface, so its pairwise energy comes only from the
        // distances between labels and places.
        assert!(mirrored.pairwise < 0.5 * mirrored.unary, "{truth:?} {mirrored:?}");
    }

    #[test]
    fn a_collapse_costs_more_than_the_truth() {
        let mesh = symmetric(0.4);
        let found = near_isometry_model(&mesh, &mesh).unwrap();
        let (variables, labels) = (at(&mesh, &found.variables), at(&mesh, &found.labels));
        let truth: Vec<u32> = variables.iter().map(|p| nearest(&labels, *p)).collect();
        let energy = |x: &[u32]| found.model.energy(x).total();
        for collapsed in [vec![truth[0]; truth.len()], truth.iter().map(|&x| x % 8).collect()] {
            assert!(energy(&collapsed) > 3.0 * energy(&truth), "{} {}", energy(&collapsed), energy(&truth));
        }
    }

    #[test]
    fn propagation_from_nothing_and_from_extremities_ends_as_low_as_the_truth_and_where_it_is() {
        let (source, target) = (symmetric(0.2), symmetric(1.6));
        let found = near_isometry_model(&source, &target).unwrap();
        // The counterpart on the straighter surface of a point of the bent one: the same place along and about the
        // axis.
        let unbent = |p: &Point3<f64>, angle: f64| {
            let radius = 32.0 / angle;
            let phi = p.x.atan2(radius - p.y);
            Point3::new(phi * radius, radius - (radius - p.y) / phi.cos(), p.z)
        };
        let variables: Vec<_> = at(&source, &found.variables).iter().map(|p| unbent(p, 0.2)).collect();
        let labels: Vec<_> = at(&target, &found.labels).iter().map(|p| unbent(p, 1.6)).collect();
        let truth: Vec<u32> = variables.iter().map(|p| nearest(&labels, *p)).collect();
        let energy = |x: &[u32]| found.model.energy(x).total();
        let relaxed = energy(&found.model.descend(truth, 50));
        for starts in [&vec![Vec::<f32>::new()], &found.of_extremities] {
            let labelings = starts.iter().map(|bias| found.minimized(bias));
            let best = labelings.min_by(|a, b| energy(a).total_cmp(&energy(b))).unwrap();
            let away = best.iter().zip(&variables).map(|(&x, p)| (labels[x as usize] - p).norm()).sum::<f64>() / 160.0;
            assert!(energy(&best) < 1.1 * relaxed, "{} {relaxed}", energy(&best));
            assert!(away < 2.0, "{away} mm away, of a surface 32 mm long");
        }
    }
}
