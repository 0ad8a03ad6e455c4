//! The pose of structures relative to one another: where a structure lies once the first one lies on that of the mean.

use crate::align::fit_onto;
use crate::complex::Complex;
use crate::rotation::angle;
use crate::subjects::RelativePose;
use nalgebra::{Point3, Vector3};
use std::ops::Range;

/// The pose of each structure of a person, `None` for the first, in relation to the mean: the rigid motion of the first
/// structure onto that of the mean is applied to all. The shift is that of the centroid, weighted by area, along the axes
/// of the mean, mm; the rotation is that of the fit of the mean's structure onto the person's, degrees.
///
/// `shape`, `mean`: the vertices of all structures, mm; `scale`: of the person to the size of the mean, 1 if size is part of
/// shape; `weights`: shares of the area. A structure that determines no orientation has no pose.
pub(crate) fn relative_poses(
    complex: &Complex,
    (shape, scale): (&[Point3<f64>], f64),
    mean: &[Point3<f64>],
    weights: &[f64],
) -> Vec<Option<RelativePose>> {
    let sized: Vec<Point3<f64>> = shape.iter().map(|p| p * scale).collect();
    let Some(first) = complex.structures.first().map(|first| first.vertices.clone()) else { return Vec::new() };
    let onto = fit_onto(&sized[first.clone()], &mean[first.clone()], &weights[first], false);
    let pose = |at: Range<usize>| {
        let onto = onto.as_ref().ok()?;
        let own: Vec<Point3<f64>> = sized[at.clone()].iter().map(|p| onto.apply(p)).collect();
        let (mean, weights) = (&mean[at.clone()], &weights[at]);
        let turned = fit_onto(mean, &own, weights, false).ok()?.rotation;
        let shift = centroid(&own, weights) - centroid(mean, weights);
        Some(RelativePose { shift_mm: shift.into(), rotation_degrees: angle(&turned).to_degrees() })
    };
    let mut poses = vec![None];
    poses.extend(complex.structures[1..].iter().map(|structure| pose(structure.vertices.clone())));
    poses
}

fn centroid(points: &[Point3<f64>], weights: &[f64]) -> Vector3<f64> {
    let sum: Vector3<f64> = points.iter().zip(weights).map(|(p, w)| p.coords * *w).sum();
    sum / weights.iter().sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::align::area_weights;
    use crate::cohort::Cohort;
    use crate::complex::{Structure, concatenated};
    use crate::settings::{Analysis, Correspondence, MadeTemplate, Settings, Size, TemplateChoice};
    use homolog_contract::parameters::{Method, preset};
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::{Isometry3, UnitQuaternion};

    #[test]
    fn the_motion_of_a_structure_relative_to_the_first_is_found_in_any_pose_and_size() {
        let first = ellipsoid(Vector3::new(9.0, 5.0, 3.0), 2);
        let second = ellipsoid(Vector3::new(4.0, 3.0, 2.0), 2).transformed(&Isometry3::translation(0.0, 9.0, 1.0));
        let n = first.n_vertices();
        let mean = concatenated(&[first.clone(), second.clone()]).unwrap();
        let center = Vector3::new(0.0, 9.0, 1.0);
        let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.1, -0.05, 0.02));
        let shift = Vector3::new(1.0, -0.5, 0.25);
        let own = second.vertices().iter().map(|p| Point3::from(turn * (p.coords - center) + center + shift));
        let motion = Isometry3::new(Vector3::new(20.0, -7.0, 4.0), Vector3::new(0.4, 1.0, -0.3));
        let person: Vec<Point3<f64>> =
            first.vertices().iter().copied().chain(own).map(|p| Point3::from((motion * p).coords / 1.25)).collect();
        let structure = |name: &str, vertices: Range<usize>| Structure {
            name: name.to_owned(),
            vertices,
            template: String::new(),
            rounds: Vec::new(),
            joint: None,
        };
        let complex = Complex {
            structures: vec![structure("a", 0..n), structure("b", n..mean.n_vertices())],
            rows: Cohort { subjects: Vec::new(), covariates: Vec::new() },
            hashes: Vec::new(),
            settings: Settings {
                template: TemplateChoice::Made(MadeTemplate::default()),
                template_side: None,
                size: Size::Kept,
                correspondence: Correspondence::Pairs,
                visits: crate::settings::Visits::GroupTemplate,
                rivals: crate::settings::Rivals::Decide,
                analysis: Analysis::default(),
                cycle_subjects: 0,
                cycle_ring: Vec::new(),
                parameters: preset(Method::Rigid),
            },
            of_persons: Vec::new(),
        };
        let found = relative_poses(&complex, (&person, 1.25), mean.vertices(), &area_weights(&mean));
        let pose = found[1].unwrap();
        assert!(found[0].is_none() && (Vector3::from(pose.shift_mm) - shift).norm() < 1e-9, "{pose:?}");
        assert!((pose.rotation_degrees - turn.angle().to_degrees()).abs() < 1e-6, "{pose:?}");
    }
}
