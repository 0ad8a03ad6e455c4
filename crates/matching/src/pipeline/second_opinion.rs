//! A second opinion by the default method, for answers of methods without a verdict.
//!
//! Labelings, nearest vertices after a rigid registration and maps of published methods do not show whether the
//! surfaces are of one structure, or whether another pose fits as well. The default method does. So it matches the same
//! surfaces: if the two answers agree on the pose and on the corresponding points, the answer gets the verdict of the
//! default method, otherwise it is unreliable.

use super::pose::find_pose;
use super::resized::find_images_at_either_size;
use super::unseen::StepsOnly;
use crate::answer::displaced::{Images, VertexImages};
use crate::error::MatchError;
use crate::starts::search::sameness;
use crate::surface::levels::Levels;
use crate::thesis::coarse::prepare_problem;
use homolog_contract::parameters::{DisplacementMode, MatchParameters, Method, preset};
use homolog_contract::result::{SecondOpinionDocument, UnreliableReason, confidence_factor};
use homolog_mesh::{Numbering, SurfaceMesh};
use homolog_primitives::observe::Observer;
use homolog_registration::RigidTransform;
use nalgebra::Point3;

/// Agreement of the corresponding points from which two answers count as equal: halfway between unrelated and equal
/// maps.
const LEAST_AGREEMENT: f64 = 0.5;

/// `answer` with the verdict of the default method, unless it has a verdict or the parameters ask for a displacement
/// field.
///
/// # Errors
/// As [`find_images_at_either_size()`], except that `answer` is returned without a verdict if the default method finds no
/// registration.
///
/// # Cost
/// A match by the default method, without the measures of its answer.
pub(crate) fn with_second_opinion(
    source: &Levels,
    target: &Levels,
    parameters: &MatchParameters,
    mut answer: VertexImages,
    observer: &dyn Observer,
) -> Result<VertexImages, MatchError> {
    if answer.reliability.is_some() || parameters.displacement.mode == DisplacementMode::Smooth {
        return Ok(answer);
    }
    let parameters = of_default_method(parameters);
    let levels = |levels: &Levels| {
        let mesh = levels.full.mesh();
        let numbering = Numbering::identity(mesh.n_vertices());
        Levels::observed(mesh, &numbering, parameters.inference.coarse_vertices, observer)
    };
    let (from, onto) = rayon::join(|| levels(source), || levels(target));
    let (from, onto) = (from?, onto?);
    let other = match by_default_method(&from, &onto, &parameters, &StepsOnly(observer)) {
        Err(MatchError::NoRegistration { .. }) => return Ok(answer),
        other => other?,
    };
    let Some(mut reliability) = other.reliability.clone() else { return Ok(answer) };
    // `from` was built from a mesh in canonical numbering, so its originals are the vertices of `answer`.
    let order = from.full.surface.numbering.by_original();
    let alone: &[bool] = match &other.images {
        Images::OnVertices => &[],
        Images::Smooth(smooth) => &smooth.no_counterpart,
    };
    let points = other.points(onto.full.mesh());
    let others = |i: usize| {
        let k = order[i].1;
        (!alone.get(k).copied().unwrap_or(false)).then(|| points[k])
    };
    let images = answer.points(target.full.mesh());
    let pairs: Vec<(Point3<f64>, Point3<f64>)> =
        (0..images.len()).filter_map(|i| Some((images[i], others(i)?))).collect();
    let agreement = agreement(&pairs);
    let same_pose = sameness(&source.full, &target.full)(&answer.transform, &other.transform);
    if !same_pose || agreement < LEAST_AGREEMENT {
        reliability.reliable = false;
        reliability.reasons.push(UnreliableReason::SecondOpinion);
    }
    reliability.second_opinion =
        Some(SecondOpinionDocument { angle_deg: angle_deg(&answer.transform, &other.transform), agreement });
    let factor = confidence_factor(&reliability.reasons, other.poses.iter().filter(|pose| pose.as_good).count());
    answer.confidence.iter_mut().for_each(|confidence| *confidence *= factor);
    answer.reliability = Some(reliability);
    Ok(answer)
}

/// The parameters of the default method, with the landmarks, seed and handedness of `parameters`.
fn of_default_method(parameters: &MatchParameters) -> MatchParameters {
    let mut found = preset(Method::Balanced);
    found.landmarks.clone_from(&parameters.landmarks);
    found.registration.allow_reflection = parameters.registration.allow_reflection;
    found.seed = parameters.seed;
    found
}

fn by_default_method(
    source: &Levels,
    target: &Levels,
    parameters: &MatchParameters,
    observer: &dyn Observer,
) -> Result<VertexImages, MatchError> {
    let coarse = prepare_problem(source, target, parameters, observer)?;
    let posed = find_pose(&coarse)?;
    find_images_at_either_size((source, target), (&coarse, &posed))
}

/// Agreement of two maps, from the two images of each vertex: 1 minus the mean distance of the two images of a vertex
/// over that of the images of unrelated vertices. 1 for equal maps, about 0 for unrelated ones; 0 without images.
fn agreement(pairs: &[(Point3<f64>, Point3<f64>)]) -> f64 {
    let apart: f64 = pairs.iter().map(|(a, b)| (a - b).norm()).sum();
    // Neighbors in canonical numbering are neighbors in space; vertices half of the list apart mostly are not.
    let others = pairs.iter().cycle().skip(pairs.len() / 2);
    let unrelated: f64 = pairs.iter().zip(others).map(|((a, _), (_, b))| (a - b).norm()).sum();
    if unrelated > 0.0 { 1.0 - apart / unrelated } else { 0.0 }
}

/// Angle between two transforms, 180 if one mirrors and the other does not.
fn angle_deg(a: &RigidTransform, b: &RigidTransform) -> f64 {
    if a.is_reflection() == b.is_reflection() { a.angle_to(b).to_degrees() } else { 180.0 }
}

impl VertexImages {
    /// The image of every source vertex on `target`, mm.
    fn points(&self, target: &SurfaceMesh) -> Vec<Point3<f64>> {
        match &self.images {
            Images::OnVertices => self.labeling.iter().map(|&x| target.vertices()[x as usize]).collect(),
            Images::Smooth(smooth) => smooth.points.iter().map(|at| at.point).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Vector3;

    #[test]
    fn equal_maps_agree_and_random_ones_do_not() {
        let points = ellipsoid(Vector3::new(18.0, 8.0, 6.0), 4).vertices().to_vec();
        let paired = |other: &dyn Fn(usize) -> usize| -> f64 {
            agreement(&(0..points.len()).map(|i| (points[i], points[other(i)])).collect::<Vec<_>>())
        };
        assert_eq!(paired(&|i| i), 1.0);
        // A stride without a common divisor visits every vertex once, far from its image under the other map.
        let stride = points.len() / 2 + 7;
        assert!(paired(&|i| (i * stride + 13) % points.len()).abs() < 0.2);
        assert_eq!(agreement(&[]), 0.0);
    }
}
