//! How probable a deformation is: the marginal likelihood of its components along the normals under a Gaussian process.
//!
//! Between surfaces of one shape the right pose needs the smallest and smoothest deformation, also where a flexible
//! field hides the difference: noise and two subjects leave residuals that differ little between poses, while a wrong
//! pose needs a larger displacement to reach them. What is measured is the displacement without its rigid part, along
//! the normals of the target: a surface says nothing else of it ([`super::uncertainty`]).
//!
//! Both deformations are measured with the same noise. Noise and amplitude are at least the distance at which a fit
//! counts as settled, since displacements below it are an accident of where the fit ended.
//!
//! Source: Kass, Raftery, "Bayes factors", Journal of the American Statistical Association 90, 1995.

use super::displacement::FitContext;
use super::schedule::SETTLED;
use homolog_mesh::ClosestPoint;
use homolog_registration::RigidTransform;
use homolog_registration::deformation::{HeightEvidence, ONE_KERNEL};
use nalgebra::{Point3, Vector3};

/// Most points of the source at which displacements are observed.
const MOST_POINTS: usize = 200;
/// Widths of the process, in diagonals: in steps of √2 from those of the local stage to that of a whole structure.
pub(super) const WIDTHS: [f64; 7] = [0.075, 0.105, 0.15, 0.21, 0.3, 0.42, 0.6];
/// Largest ratio of the variances of the process and of the noise, as a power of two: on surfaces without noise a field
/// is known to a thousandth of its size.
pub(super) const EVIDENCE_MAX_LOG2_RATIO: i32 = 22;

/// A sampled vertex of the source and where it comes to lie on the target.
pub(super) struct Observed {
    pub vertex: usize,
    pub image: ClosestPoint,
    /// Unit normal of the target there.
    pub normal: Vector3<f64>,
}

/// Every how many of `n` points are taken, so that these are `most` at most.
pub(super) fn every(n: usize, most: usize) -> usize {
    n.div_ceil(most).max(1)
}

/// Every `step`-th vertex of the source, `most` of them at most, with its image on the target if it moves to `moved`; and
/// `step`. Points beyond the rim of the target have no counterpart and are left out.
pub(super) fn observed(displacement: &FitContext<'_>, moved: &[Point3<f64>], most: usize) -> (Vec<Observed>, usize) {
    let (target, closest) = (&displacement.target, displacement.target.closest());
    let step = every(moved.len(), most);
    let of_vertex = |vertex: usize| {
        let image = closest.index.closest(&moved[vertex]);
        let normal = image.blend(|k| target.normals[k]).try_normalize(1e-9)?;
        (!closest.is_at_rim(&image)).then_some(Observed { vertex, image, normal })
    };
    ((0..moved.len()).step_by(step).filter_map(of_vertex).collect(), step)
}

/// The deformation of the source to `moved` without its rigid part `rigid`, prepared for comparison; `None` without a
/// displacement, or if a number is not finite. Cost `O(widths · points³)`.
pub(super) fn deformation_evidence(
    displacement: &FitContext<'_>,
    moved: &[Point3<f64>],
    rigid: &RigidTransform,
) -> Option<HeightEvidence> {
    let vertices = displacement.source.mesh.vertices();
    let (sample, _) = observed(displacement, moved, MOST_POINTS);
    let points: Vec<Point3<f64>> = sample.iter().map(|at| vertices[at.vertex]).collect();
    let normals: Vec<Vector3<f64>> = sample.iter().map(|at| at.normal).collect();
    let heights: Vec<f64> =
        sample.iter().map(|at| at.normal.dot(&(at.image.point - rigid.apply(&vertices[at.vertex])))).collect();
    let widths = WIDTHS.map(|width| width * displacement.diagonal_mm);
    HeightEvidence::new(&points, &normals, &heights, (&widths, &ONE_KERNEL))
}

/// How much more probable the first deformation is than the second, as a number of variance 1: twice the difference of
/// log likelihoods is the square of a normal deviate. Negative if the second is more probable; 0 where one of them is
/// no deformation. `resolution_mm`: the least noise and amplitude.
pub(super) fn lead(first: &HeightEvidence, second: &HeightEvidence, resolution_mm: f64) -> f64 {
    let of =
        |evidence: &HeightEvidence| evidence.most_probable(EVIDENCE_MAX_LOG2_RATIO, 0.0).map(|found| found.noise_mm);
    let (Some(of_first), Some(of_second)) = (of(first), of(second)) else { return 0.0 };
    let noise_mm = of_first.max(of_second).max(resolution_mm);
    let log_likelihood =
        |evidence: &HeightEvidence| evidence.log_likelihood(noise_mm, resolution_mm, EVIDENCE_MAX_LOG2_RATIO);
    let difference = log_likelihood(first) - log_likelihood(second);
    (2.0 * difference.abs()).sqrt().copysign(difference)
}

/// The least displacement that counts, mm: the movement at which a fit is settled.
pub(super) fn resolution_mm(displacement: &FitContext<'_>) -> f64 {
    SETTLED * displacement.lengths.root_mm
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::numbers;

    /// Heights of this function over a sphere of radius 10.
    fn over_sphere(height: impl FnMut(&Vector3<f64>) -> f64) -> HeightEvidence {
        let normals: Vec<Vector3<f64>> = (0..160)
            .map(|k| {
                let (z, turn) = (1.0 - (2.0 * f64::from(k) + 1.0) / 160.0, 2.399_963 * f64::from(k));
                let radius = (1.0 - z * z).sqrt();
                Vector3::new(radius * turn.cos(), radius * turn.sin(), z)
            })
            .collect();
        let points: Vec<Point3<f64>> = normals.iter().map(|n| Point3::from(10.0 * n)).collect();
        let heights: Vec<f64> = normals.iter().map(height).collect();
        HeightEvidence::new(&points, &normals, &heights, (&WIDTHS.map(|width| 20.0 * width), &ONE_KERNEL)).unwrap()
    }

    #[test]
    fn a_larger_deformation_is_less_probable_unless_both_are_below_the_resolution() {
        let mut number = numbers(3);
        let mut wave = |size: f64| over_sphere(|n| size * (3.0 * n.z).sin() + 0.01 * (number() - 0.5));
        let (small, equal, large) = (wave(0.5), wave(0.5), wave(2.0));
        assert!(lead(&small, &large, 0.1) > 4.0);
        assert!((lead(&small, &large, 0.1) + lead(&large, &small, 0.1)).abs() < 1e-9);
        assert!(lead(&small, &equal, 0.1).abs() < 2.0);
        let (none, little) = (wave(0.0), wave(0.01));
        assert!(lead(&none, &little, 0.1).abs() < 2.0);
        assert!(lead(&none, &little, 0.001) > 4.0);
    }

    #[test]
    fn a_rough_deformation_is_less_probable_than_a_smooth_one_of_its_size() {
        let smooth = over_sphere(|n| (2.0 * n.x).sin());
        let rough = over_sphere(|n| (9.0 * n.x).sin());
        assert!(lead(&smooth, &rough, 0.1) > 4.0);
    }
}
