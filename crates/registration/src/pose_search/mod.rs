//! The pose of one surface on another from any initial orientation: sampled rotations, ranked and refined by soft
//! assignment.
//!
//! Closest points and principal axes find a pose if both surfaces are complete and similar. Noise distorts normals and
//! curvature, a missing end shifts the centroid and the axes, and a different shape has different axes. This search
//! therefore tries every rotation, cheaply:
//!
//! 1. Both surfaces become patches ([`patches`]), few and many, in the frames of their centroids and principal axes.
//! 2. **Screening**: rotations on a spiral, and the four of the principal axes, are ranked on the few patches by the
//!    misfit of a wide soft assignment ([`crate::alignment`]); the best that are not close to each other remain.
//!    Centroids coincide, except for a part: its centroid is placed on the centroids of several pieces of the whole in
//!    turn, each as large as the part ([`patches::pieces`]).
//! 3. **Annealing**: each candidate is refined by rigid steps of coherent point drift while the kernel width shrinks;
//!    candidates that end in the same pose are merged.
//! 4. **Settling**: the few best are refined on the many patches with narrower kernels.
//! 5. **Bending**: a smooth field ([`crate::deformation`]) absorbs the difference in shape of each pose before its
//!    final misfit is measured. If shapes differ, the rigid transform of least distance is not the anatomical one: a
//!    bent end rotates the whole about its long axis. The field improves the assigned pairs, and the pose is their
//!    absolute orientation.
//!
//! Sources: Myronenko, Song, "Point set registration: coherent point drift", IEEE PAMI 32(12), 2010 (rigid steps);
//! Alexa 2022 (the spiral, see [`rotations`]).

mod features;
mod patches;
mod rotations;
#[cfg(test)]
mod tests;

use super::{RigidTransform, SAME_POSE_ANGLE, SamePose, absolute_orientation};
use crate::alignment::compact::{CompactAssignment, CompactTarget};
use crate::alignment::{OrientedPoint, OrientedPoints, annealed, progress_short_of_end};
use crate::deformation::GaussianKernel;
use crate::deformation::taylor::TaylorBasis;
use features::describe;
pub use features::surroundings;
use nalgebra::{Matrix3, Point3, Vector3};
use patches::{Patch, Patches, mirrored, pieces};
use rayon::prelude::*;
use rotations::spread_rotations;

/// Options of a pose search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PoseSearchOptions {
    /// Whether to try poses with a reflection as well.
    pub allow_reflection: bool,
    /// Whether the source shows only a part of the target.
    pub source_is_part: bool,
    /// Rotations on the spiral.
    pub n_rotations: usize,
    /// Patches of each surface in screening and annealing.
    pub n_coarse: usize,
    /// Patches of each surface in settling and bending.
    pub n_fine: usize,
    /// Number of poses of each handedness that are annealed.
    pub n_annealed: usize,
    /// Largest number of poses of each handedness that are settled and returned.
    pub n_settled: usize,
    /// Kernel width `σ` in diagonals of the larger surface: for screening, at the end of annealing, and at the end of
    /// settling. Bending anneals again from the second to the third value.
    pub sigma: [f64; 3],
    /// Steps of annealing, settling and bending.
    pub steps: [u32; 3],
}

impl Default for PoseSearchOptions {
    fn default() -> Self {
        PoseSearchOptions {
            allow_reflection: false,
            source_is_part: false,
            n_rotations: 400,
            n_coarse: 96,
            n_fine: 256,
            n_annealed: 24,
            n_settled: 4,
            sigma: [0.08, 0.04, 0.02],
            steps: [12, 12, 12],
        }
    }
}

/// A pose, and the agreement of the surfaces in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScoredPose {
    /// The pose.
    pub target_from_source: RigidTransform,
    /// Misfit (see [`crate::alignment`]) after bending, plus the cost of the bending under its prior; lower is better.
    pub misfit: f64,
    /// Misfit minus that of the best pose.
    pub excess: f64,
}

/// Width of the bending field in diagonals: it bends over a third of a structure; its standard deviation is a tenth.
const WIDTH: f64 = 0.3;
const AMPLITUDE: f64 = 0.1;
/// Number of independent observations over a surface: the errors of neighboring patches are correlated.
const OBSERVATIONS: f64 = 80.0;
/// Angle, radians, within which poses are annealed only once; 20°.
const APART: f64 = 0.35;

/// Number of places of the whole on which the centroid of a part is tried. An end of 30 % of a hippocampus has about
/// three lengths of its own to lie on.
const N_PLACES: usize = 16;

/// A pose in the frames of the patches.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    mirrors: bool,
    rotation: Matrix3<f64>,
    shift: Vector3<f64>,
    misfit: f64,
}

impl Candidate {
    fn moved(&self, source: &[Patch]) -> Vec<Patch> {
        source.iter().map(|p| p.moved(&self.rotation, &self.shift)).collect()
    }
}

/// Poses that align `source` with `target`, best first. No two of equal handedness are the same within 30°
/// ([`SamePose`]; for a part, by orientation and place).
///
/// Empty if a surface has fewer than three points, no area, or a number that is not finite. Optional features of the
/// inputs are those of [`surroundings`], in any unit; they may for example come from a surface whose points have moved
/// since. Otherwise they are computed from the points. Moving an input rigidly moves the result with it. Candidates are
/// refined independently on all threads, so any number of threads gives the same bits.
///
/// # Cost
/// `O((rotations · places + annealed · steps) · coarse² + settled · steps · fine² + fine · points)`; twice with reflections.
pub fn pose_search(
    source: &OrientedPoints<'_>,
    target: &OrientedPoints<'_>,
    options: &PoseSearchOptions,
) -> Vec<ScoredPose> {
    let patches = |surface| Patches::new(surface, options.n_coarse, options.n_fine);
    let (Some(mut of_source), Some(mut of_target)) = rayon::join(|| patches(source), || patches(target)) else {
        return Vec::new();
    };
    let diagonal_mm = of_source.diagonal_mm.max(of_target.diagonal_mm);
    describe(&mut of_source, &mut of_target, diagonal_mm, options.source_is_part);
    let (places, same) = if options.source_is_part {
        let (centers, areas): (Vec<_>, Vec<f64>) =
            of_source.coarse.iter().map(|p| (Point3::from(p.center), p.area)).unzip();
        (pieces(&of_target.coarse, areas.iter().sum(), N_PLACES), SamePose::of_place(&centers, &areas))
    } else {
        (vec![Vector3::zeros()], SamePose::of_orientation())
    };
    let search = Search {
        coarse: Level::new(&of_source.coarse, &of_target.coarse),
        fine: Level::new(&of_source.fine, &of_target.fine),
        places,
        same,
        diagonal_mm,
        options,
    };
    let settled = search.run();
    let best = settled.first().map_or(0.0, |c| c.misfit);
    let moved = |c: &Candidate| {
        let mirror = Matrix3::from_diagonal(&Vector3::new(if c.mirrors { -1.0 } else { 1.0 }, 1.0, 1.0));
        let rotation = of_target.axes * c.rotation * mirror * of_source.axes.transpose();
        let translation = of_target.center + of_target.axes * c.shift - rotation * of_source.center;
        RigidTransform { rotation, translation }
    };
    settled
        .iter()
        .map(|c| ScoredPose { target_from_source: moved(c), misfit: c.misfit, excess: c.misfit - best })
        .collect()
}

/// Both surfaces at one resolution.
struct Level {
    source: Vec<Patch>,
    /// The mirror image of the source.
    mirrored: Vec<Patch>,
    target: CompactTarget,
}

impl Level {
    fn new(source: &[Patch], target: &[Patch]) -> Self {
        let target: Vec<OrientedPoint<'_>> = points_of(target).collect();
        Level { source: source.to_vec(), mirrored: mirrored(source), target: CompactTarget::new(&target) }
    }

    fn source(&self, mirrors: bool) -> &[Patch] {
        if mirrors { &self.mirrored } else { &self.source }
    }
}

fn points_of(patches: &[Patch]) -> impl Iterator<Item = OrientedPoint<'_>> + Clone {
    patches.iter().map(Patch::as_point)
}

struct Search<'a> {
    coarse: Level,
    fine: Level,
    /// Possible positions of the source's centroid on the target, in the frame of its patches.
    places: Vec<Vector3<f64>>,
    same: SamePose,
    diagonal_mm: f64,
    options: &'a PoseSearchOptions,
}

impl Search<'_> {
    fn run(&self) -> Vec<Candidate> {
        let [wide, middle, narrow] = self.options.sigma.map(|s| s * self.diagonal_mm);
        let [annealing, settling, bending] = self.options.steps;
        let n = self.options.n_settled;
        let moved = for_each_candidate(&self.screened(wide), |assignment, c| {
            refined(c, &self.coarse, (wide, middle), annealing, assignment)
        });
        let settled = for_each_candidate(&self.best_apart(moved, SAME_POSE_ANGLE, n), |assignment, c| {
            refined(c, &self.fine, (middle, narrow), settling, assignment)
        });
        let bent = for_each_candidate(&self.best_apart(settled, SAME_POSE_ANGLE, n), |assignment, c| {
            self.bent(c, (middle, narrow), bending, assignment)
        });
        self.best_apart(bent, SAME_POSE_ANGLE, n)
    }

    /// `start` refined with a field that absorbs the difference in shape. Its misfit is that of the bent surface plus
    /// the cost of the bending.
    fn bent(
        &self,
        start: &Candidate,
        sigma_mm: (f64, f64),
        steps: u32,
        assignment: &mut CompactAssignment,
    ) -> Candidate {
        let (source, target) = (self.fine.source(start.mirrors), &self.fine.target);
        let from: Vec<Point3<f64>> = source.iter().map(|p| Point3::from(p.center)).collect();
        let kernel = GaussianKernel { width_mm: WIDTH * self.diagonal_mm, amplitude_mm: AMPLITUDE * self.diagonal_mm };
        let basis = TaylorBasis::new(&from, kernel);
        let area: f64 = source.iter().map(|p| p.area).sum();
        let (mut found, mut cost) = (*start, 0.0);
        let mut base = start.moved(source);
        let mut bent = base.clone();
        for step in 0..steps {
            let sigma = annealed(sigma_mm.0, sigma_mm.1, progress_short_of_end(step, steps));
            assignment.misfit(points_of(&bent), target, sigma);
            let (to, weights) = assignment.means(points_of(source), target, sigma);
            let precision: Vec<f64> = weights.iter().map(|w| w * OBSERVATIONS / (area * sigma * sigma)).collect();
            let Some(fitted) = basis.fit(|i| to[i].coords - base[i].center, &precision) else { break };
            cost = fitted.cost;
            let to: Vec<Point3<f64>> =
                base.iter().zip(&fitted.displacements).map(|(p, u)| Point3::from(p.center + u)).collect();
            // The rigid part of the field moves into the pose, where it costs nothing.
            let Ok(pose) = absolute_orientation(&from, &to, Some(weights), false) else { break };
            (found.rotation, found.shift) = (pose.rotation, pose.translation);
            base = found.moved(source);
            bent.clone_from(&base);
            for (patch, at) in bent.iter_mut().zip(&to) {
                patch.center = at.coords;
            }
        }
        // Per observation, like the misfit, which is a mean; the cost covers all observations together.
        found.misfit = assignment.misfit(points_of(&bent), target, sigma_mm.1) + cost / OBSERVATIONS;
        found
    }

    /// The best rotations, with the centroid of the source on each of the places.
    fn screened(&self, sigma_mm: f64) -> Vec<Candidate> {
        let mut rotations =
            [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].map(|[a, b]| diagonal(a, b, a * b)).to_vec();
        rotations.extend(spread_rotations(self.options.n_rotations));
        let handedness: &[bool] = if self.options.allow_reflection { &[false, true] } else { &[false] };
        let all_rotations = |&mirrors| {
            let everywhere = move |&rotation| {
                self.places.iter().map(move |&shift| Candidate { mirrors, rotation, shift, misfit: 0.0 })
            };
            rotations.iter().flat_map(everywhere)
        };
        let tried: Vec<Candidate> = handedness.iter().flat_map(all_rotations).collect();
        let found = for_each_candidate(&tried, |assignment, c| {
            let moved = c.moved(self.coarse.source(c.mirrors));
            Candidate { misfit: assignment.misfit(points_of(&moved), &self.coarse.target, sigma_mm), ..*c }
        });
        self.best_apart(found, APART, self.options.n_annealed)
    }

    /// The `n` best of `candidates` of each handedness, best first, skipping those within `angle`, radians, of a better
    /// one. Candidates of equal misfit stay in the given order; candidates whose misfit is not finite are left out.
    fn best_apart(&self, mut candidates: Vec<Candidate>, angle: f64, n: usize) -> Vec<Candidate> {
        candidates.retain(|c| c.misfit.is_finite());
        candidates.sort_by(|a, b| a.misfit.total_cmp(&b.misfit));
        // Rotations at an angle φ to each other have tr(RᵀR') = 1 + 2 cos φ. The centroid of the source is the origin.
        let (least_trace, distance_mm) = (1.0 + 2.0 * angle.cos(), self.same.distance_mm(angle));
        let are_same = |a: &Candidate, b: &Candidate| {
            a.rotation.dot(&b.rotation) >= least_trace && (a.shift - b.shift).norm() < distance_mm
        };
        let mut kept: Vec<Candidate> = Vec::new();
        for c in candidates {
            let mut same_handedness = kept.iter().filter(|k| k.mirrors == c.mirrors);
            if same_handedness.clone().count() < n && !same_handedness.any(|k| are_same(k, &c)) {
                kept.push(c);
            }
        }
        kept
    }
}

/// Applies `refine` to each candidate, in their order, on all threads. The scratch memory is reused between candidates
/// and does not affect the result.
fn for_each_candidate(
    candidates: &[Candidate],
    refine: impl Fn(&mut CompactAssignment, &Candidate) -> Candidate + Sync + Send,
) -> Vec<Candidate> {
    candidates.par_iter().map_init(CompactAssignment::default, refine).collect()
}

fn diagonal(x: f64, y: f64, z: f64) -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::new(x, y, z))
}

/// `start` after rigid steps while `σ` is annealed from the first to the second of `sigma_mm`, with its misfit at the
/// second.
fn refined(
    start: &Candidate,
    level: &Level,
    sigma_mm: (f64, f64),
    steps: u32,
    assignment: &mut CompactAssignment,
) -> Candidate {
    let source = level.source(start.mirrors);
    let from: Vec<Point3<f64>> = source.iter().map(|p| Point3::from(p.center)).collect();
    let mut found = *start;
    for step in 0..steps {
        let sigma = annealed(sigma_mm.0, sigma_mm.1, progress_short_of_end(step, steps));
        assignment.misfit(points_of(&found.moved(source)), &level.target, sigma);
        let (to, weights) = assignment.means(points_of(source), &level.target, sigma);
        // Surfaces out of reach of each other keep this pose, whose misfit is large.
        let Ok(fitted) = absolute_orientation(&from, to, Some(weights), false) else { break };
        (found.rotation, found.shift) = (fitted.rotation, fitted.translation);
    }
    found.misfit = assignment.misfit(points_of(&found.moved(source)), &level.target, sigma_mm.1);
    found
}
