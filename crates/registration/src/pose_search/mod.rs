//! The pose of one surface on another from any orientation: a lattice of rotations, judged and refined by soft assignment.
//!
//! Closest points and principal axes find a pose where surfaces are whole and alike. Noise bends normals and curvature,
//! a missing end moves the centroid and the axes, a different shape has axes of its own. What is left then is to try
//! every rotation, cheaply:
//!
//! 1. Both surfaces become patches ([`patches`]), few and many, in the frames of their centroids and principal axes.
//! 2. **Screening**: rotations on a spiral, and the four of the principal axes, are judged on the few patches by the
//!    misfit of a wide soft assignment ([`affinity`]); the best that are not close to each other stay.
//! 3. **Annealing**: each is moved by rigid steps of coherent point drift while the assignment narrows; those that end
//!    in one pose are counted once.
//! 4. **Settling**: the few best again on the many patches, narrower.
//! 5. **Bending**: each may take up what differs in shape by a smooth field ([`bending`]), and is judged after that.
//!
//! Sources: Myronenko, Song, "Point set registration: coherent point drift", IEEE PAMI 32(12), 2010 (rigid steps);
//! Alexa 2022 (the spiral, see [`rotations`]).

mod affinity;
mod bending;
mod features;
mod patches;
mod rotations;
#[cfg(test)]
mod tests;

use super::{RigidTransform, absolute_orientation};
use affinity::{Columns, Workspace};
use bending::Bending;
use features::describe;
use nalgebra::{Matrix3, Point3, Vector3};
use patches::{Patch, Patches, mirrored};
use rayon::prelude::*;
use rotations::spread_rotations;

/// Points of a surface with what is known at each; slices of equal length.
#[derive(Debug, Clone, Copy)]
pub struct OrientedPoints<'a> {
    /// Positions, mm.
    pub points: &'a [Point3<f64>],
    /// Unit normals, all outwards or all inwards.
    pub normals: &'a [Vector3<f64>],
    /// Area that each stands for, mm².
    pub areas: &'a [f64],
}

/// How far a pose search looks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PoseSearchOptions {
    /// Whether poses that mirror are tried as well.
    pub allow_reflection: bool,
    /// Rotations of the lattice.
    pub n_rotations: usize,
    /// Patches of each surface in screening and annealing.
    pub n_coarse: usize,
    /// Patches in settling and bending.
    pub n_fine: usize,
    /// Poses of either handedness that are annealed.
    pub n_annealed: usize,
    /// Poses of either handedness that are settled and returned at most.
    pub n_settled: usize,
    /// `σ` of the assignment in diagonals of the larger surface: when screening, and at the end of annealing and settling.
    /// Bending goes from the second to the third again.
    pub sigma: [f64; 3],
    /// Steps of annealing, settling and bending.
    pub steps: [u32; 3],
}

impl Default for PoseSearchOptions {
    fn default() -> Self {
        PoseSearchOptions {
            allow_reflection: false,
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

/// A pose and how well the surfaces lie on each other there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScoredPose {
    /// The pose.
    pub target_from_source: RigidTransform,
    /// Mean over both surfaces of `−ln` of how much of a matching surface each patch sees, and what the bending costs
    /// that this takes; lower is better.
    pub misfit: f64,
    /// How much worse than the best that is; 0 for the best.
    pub excess: f64,
}

/// Poses within this angle, radians, are one; 30 degrees.
pub const SAME_POSE_ANGLE: f64 = 0.52;
/// Width and standard deviation of the bending field in diagonals: bends of a third of a structure, by a tenth.
const WIDTH: f64 = 0.3;
const AMPLITUDE: f64 = 0.1;
/// Independent observations a square millimetre: patches next to each other err alike.
const DENSITY: f64 = 0.05;
/// Rotations of the lattice that are annealed are at least this far apart, radians; 20 degrees.
const APART: f64 = 0.35;

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

/// Poses that lay `source` on `target`, best first, no two within 30 degrees unless one of them mirrors.
///
/// Empty where a surface has fewer than three points, no area, or numbers that are not finite. A pure function of its
/// inputs: poses are followed on all threads, each alone. Moving an input moves the answer with it.
///
/// # Cost
/// `O((rotations + annealed · steps) · coarse² + settled · steps · fine² + fine · points)`; twice with reflections.
pub fn pose_search(
    source: &OrientedPoints<'_>,
    target: &OrientedPoints<'_>,
    options: &PoseSearchOptions,
) -> Vec<ScoredPose> {
    let cut = |surface| Patches::new(surface, options.n_coarse, options.n_fine);
    let (Some(mut of_source), Some(mut of_target)) = rayon::join(|| cut(source), || cut(target)) else {
        return Vec::new();
    };
    let diagonal_mm = of_source.diagonal_mm.max(of_target.diagonal_mm);
    describe(&mut of_source, &mut of_target, diagonal_mm);
    let search = Search {
        coarse: Level::new(&of_source.coarse, of_target.coarse.clone()),
        fine: Level::new(&of_source.fine, of_target.fine.clone()),
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

/// Both surfaces at one number of patches.
struct Level {
    source: Vec<Patch>,
    /// The mirror image of the source.
    mirrored: Vec<Patch>,
    target: Columns,
}

impl Level {
    fn new(source: &[Patch], target: Vec<Patch>) -> Self {
        Level { source: source.to_vec(), mirrored: mirrored(source), target: Columns::new(target) }
    }

    fn source(&self, mirrors: bool) -> &[Patch] {
        if mirrors { &self.mirrored } else { &self.source }
    }
}

struct Search<'a> {
    coarse: Level,
    fine: Level,
    diagonal_mm: f64,
    options: &'a PoseSearchOptions,
}

impl Search<'_> {
    fn run(&self) -> Vec<Candidate> {
        let [wide, middle, narrow] = self.options.sigma.map(|s| s * self.diagonal_mm);
        let [annealing, settling, bending] = self.options.steps;
        let n = self.options.n_settled;
        let annealed = of_each(&self.screened(wide), |workspace, c| {
            improved(c, &self.coarse, (wide, middle), annealing, workspace)
        });
        let settled = of_each(&best_apart(annealed, SAME_POSE_ANGLE, n), |workspace, c| {
            improved(c, &self.fine, (middle, narrow), settling, workspace)
        });
        let bent = of_each(&best_apart(settled, SAME_POSE_ANGLE, n), |workspace, c| {
            self.bent(c, (middle, narrow), bending, workspace)
        });
        best_apart(bent, SAME_POSE_ANGLE, n)
    }

    /// `start` with a field that takes up what differs in shape, its misfit that of the bent surface together with what
    /// the bending costs.
    fn bent(&self, start: &Candidate, sigma_mm: (f64, f64), steps: u32, workspace: &mut Workspace) -> Candidate {
        let (source, target) = (self.fine.source(start.mirrors), &self.fine.target);
        let bending = Bending::new(source, WIDTH * self.diagonal_mm, AMPLITUDE * self.diagonal_mm);
        let from: Vec<Point3<f64>> = source.iter().map(|p| Point3::from(p.center)).collect();
        let (mut found, mut cost) = (*start, 0.0);
        let mut base = start.moved(source);
        let mut bent = base.clone();
        for step in 0..steps {
            let sigma = between(sigma_mm, step, steps);
            workspace.misfit(&bent, target, sigma);
            let (to, weights) = workspace.pulls(source, target, sigma);
            let precision: Vec<f64> = weights.iter().map(|w| w * DENSITY / (sigma * sigma)).collect();
            let Some(fitted) = bending.fit(&base, to, &precision) else { break };
            cost = fitted.cost;
            let to: Vec<Point3<f64>> =
                base.iter().zip(&fitted.displacements).map(|(p, u)| Point3::from(p.center + u)).collect();
            // What of the field is a motion goes into the pose, where it costs nothing.
            let Ok(pose) = absolute_orientation(&from, &to, Some(weights), false) else { break };
            (found.rotation, found.shift) = (pose.rotation, pose.translation);
            base = found.moved(source);
            bent.clone_from(&base);
            for (patch, at) in bent.iter_mut().zip(&to) {
                patch.center = at.coords;
            }
        }
        // Both terms are per observation: the misfit is a mean, the cost that of all together.
        let area: f64 = source.iter().map(|p| p.area).sum();
        found.misfit = workspace.misfit(&bent, target, sigma_mm.1) + cost / (DENSITY * area);
        found
    }

    /// The best rotations about the centroids.
    fn screened(&self, sigma_mm: f64) -> Vec<Candidate> {
        let mut rotations =
            [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].map(|[a, b]| diagonal(a, b, a * b)).to_vec();
        rotations.extend(spread_rotations(self.options.n_rotations));
        let hands: &[bool] = if self.options.allow_reflection { &[false, true] } else { &[false] };
        let of_hand = |&mirrors| {
            let centered = move |&rotation| Candidate { mirrors, rotation, shift: Vector3::zeros(), misfit: 0.0 };
            rotations.iter().map(centered)
        };
        let tried: Vec<Candidate> = hands.iter().flat_map(of_hand).collect();
        let found = of_each(&tried, |workspace, c| {
            let moved = c.moved(self.coarse.source(c.mirrors));
            Candidate { misfit: workspace.misfit(&moved, &self.coarse.target, sigma_mm), ..*c }
        });
        best_apart(found, APART, self.options.n_annealed)
    }
}

/// What `follow` makes of each candidate, in their order, on all threads. A workspace is reused, and holds nothing that
/// the next candidate could see.
fn of_each(
    candidates: &[Candidate],
    follow: impl Fn(&mut Workspace, &Candidate) -> Candidate + Sync + Send,
) -> Vec<Candidate> {
    candidates.par_iter().map_init(Workspace::default, follow).collect()
}

/// Geometric interpolation; the end is not reached.
fn between((from, to): (f64, f64), step: u32, steps: u32) -> f64 {
    from * (to / from).powf(f64::from(step) / f64::from(steps))
}

fn diagonal(x: f64, y: f64, z: f64) -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::new(x, y, z))
}

/// `start` after rigid steps with `σ` falling from the first to the second of `sigma_mm`, its misfit at the second.
fn improved(
    start: &Candidate,
    level: &Level,
    sigma_mm: (f64, f64),
    steps: u32,
    workspace: &mut Workspace,
) -> Candidate {
    let source = level.source(start.mirrors);
    let from: Vec<Point3<f64>> = source.iter().map(|p| Point3::from(p.center)).collect();
    let mut found = *start;
    for step in 0..steps {
        let sigma = between(sigma_mm, step, steps);
        workspace.misfit(&found.moved(source), &level.target, sigma);
        let (to, weights) = workspace.pulls(source, &level.target, sigma);
        // Surfaces out of reach of each other stay where they are; their misfit says so.
        let Ok(fitted) = absolute_orientation(&from, to, Some(weights), false) else { break };
        (found.rotation, found.shift) = (fitted.rotation, fitted.translation);
    }
    found.misfit = workspace.misfit(&found.moved(source), &level.target, sigma_mm.1);
    found
}

/// The `n` best of `candidates` of either handedness, best first, none within `angle` (radians) of a better one. Those
/// of equal misfit in the order given; those without a number left out.
fn best_apart(mut candidates: Vec<Candidate>, angle: f64, n: usize) -> Vec<Candidate> {
    candidates.retain(|c| c.misfit.is_finite());
    candidates.sort_by(|a, b| a.misfit.total_cmp(&b.misfit));
    // Of rotations at an angle φ the trace of `RᵀR'` is `1 + 2 cos φ`.
    let near = 1.0 + 2.0 * angle.cos();
    let mut kept: Vec<Candidate> = Vec::new();
    for c in candidates {
        let mut alike = kept.iter().filter(|k| k.mirrors == c.mirrors);
        if alike.clone().count() < n && alike.all(|k| k.rotation.dot(&c.rotation) < near) {
            kept.push(c);
        }
    }
    kept
}
