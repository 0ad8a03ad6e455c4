//! Verification of the rigid-transform estimators: agreement, sensitivity to noise, degenerate input.

use super::{About, Body, Experiment, mean, sentences};
use crate::experiment::document::{Axis, Plot, PlotKind};
use crate::experiment::draws::Draws;
use crate::experiment::results::{Metric, Results};
use crate::experiment::statistics::Summary;
use crate::experiment::study::Study;
use crate::experiment::units::{Measurement, Unit};
use crate::phantom::{Phantom, random_pose};
use homolog_registration::{MinimalEstimator, OrientationSolver, RigidTransform, solve_orientation};
use nalgebra::{Point3, Vector3};
use serde_json::json;

pub(in crate::experiment) struct Estimators;

const NOISE: &str = "noise";
const DEGENERATE: &str = "degenerate";

/// Standard deviations of the noise per axis, mm.
const LEVELS: [f64; 6] = [0.0, 0.01, 0.1, 0.3, 1.0, 3.0];
/// Point pairs for absolute orientation.
const N_PAIRS: usize = 50;
/// Minimum distance between the points of a triple, mm: the orientation of a smaller triple is dominated by noise.
const APART_MM: f64 = 6.0;

const SOLVERS: [(OrientationSolver, &str); 3] = [
    (OrientationSolver::Svd, "svd"),
    (OrientationSolver::Quaternion, "quaternion"),
    (OrientationSolver::OrthonormalMatrix, "orthonormal_matrix"),
];
const ESTIMATORS: [(MinimalEstimator, &str); 2] =
    [(MinimalEstimator::Frame, "frame"), (MinimalEstimator::RotationAxis, "rotation_axis")];

fn level_name(sigma_mm: f64) -> String {
    format!("noise of {sigma_mm} mm")
}

/// Source points on a phantom, and their images under the true transform.
struct Problem {
    source: Vec<Point3<f64>>,
    truth: RigidTransform,
    target: Vec<Point3<f64>>,
}

impl Problem {
    fn new(surface: &[Point3<f64>], seed: u64, sigma_mm: f64) -> Self {
        let mut draws = Draws::new(seed);
        let source: Vec<_> = (0..N_PAIRS).map(|_| surface[draws.below(surface.len())]).collect();
        let motion = random_pose(seed);
        let moved: Vec<_> = source.iter().map(|p| motion * p).collect();
        let truth = RigidTransform {
            rotation: *motion.rotation.to_rotation_matrix().matrix(),
            translation: motion.translation.vector,
        };
        Problem { source, truth, target: draws.jitter(&moved, sigma_mm) }
    }

    /// The first three pairs that are far enough apart.
    fn triple(&self) -> Option<[usize; 3]> {
        let apart = |a: usize, b: usize| (self.source[a] - self.source[b]).norm() >= APART_MM;
        let b = (1..N_PAIRS).find(|&b| apart(0, b))?;
        let area = |c: usize| (self.source[b] - self.source[0]).cross(&(self.source[c] - self.source[0])).norm();
        let c = (b + 1..N_PAIRS).find(|&c| apart(0, c) && apart(b, c) && area(c) >= APART_MM * APART_MM)?;
        Some([0, b, c])
    }
}

/// Rotation errors of both minimal estimators and of all solvers, and the largest difference between solvers, over `n` problems.
fn noise(surface: &[Point3<f64>], sigma_mm: f64, first: u64, n: u64) -> Measurement {
    let mut errors: Vec<(&str, Vec<f64>)> = ESTIMATORS
        .iter()
        .map(|(_, name)| *name)
        .chain(SOLVERS.map(|(_, name)| name))
        .map(|n| (n, Vec::new()))
        .collect();
    let mut note = |name: &str, found: &RigidTransform, truth: &RigidTransform| {
        if let Some((_, list)) = errors.iter_mut().find(|(n, _)| *n == name) {
            list.push(found.angle_to(truth).to_degrees());
        }
    };
    let mut difference = 0.0f64;
    for seed in first..first + n {
        let problem = Problem::new(surface, seed, sigma_mm);
        if let Some(triple) = problem.triple() {
            let (source, target) = (triple.map(|i| problem.source[i]), triple.map(|i| problem.target[i]));
            for (estimator, name) in ESTIMATORS {
                if let Ok(found) = estimator.estimate(&source, &target, false) {
                    note(name, &found, &problem.truth);
                }
            }
        }
        let found = SOLVERS.map(|(solver, _)| solve_orientation(solver, &problem.source, &problem.target, None, false));
        for (result, (_, name)) in found.iter().zip(SOLVERS) {
            if let (Ok(transform), Ok(reference)) = (result, &found[0]) {
                note(name, transform, &problem.truth);
                difference = difference.max((transform.rotation - reference.rotation).amax());
            }
        }
    }
    let mut m = Measurement::default().with("solver_difference", difference);
    for (name, list) in errors {
        m.set(&format!("{name}_n"), list.len() as f64);
        if let Some(s) = Summary::of(list) {
            m.set(&format!("{name}_deg"), s.median);
        }
    }
    m
}

/// Kinds of point pairs that determine the transform not at all or only barely.
const KINDS: [&str; 6] = [
    "collinear points",
    "coincident points",
    "two pairs only",
    "a non-finite coordinate",
    "coplanar points",
    "a reflected copy",
];

fn degenerate(kind: &str, surface: &[Point3<f64>], seed: u64) -> (Vec<Point3<f64>>, Vec<Point3<f64>>) {
    let mut problem = Problem::new(surface, seed, 0.0);
    let along = Draws::new(seed).normals().normalize();
    let across = along.cross(&Vector3::new(0.3, 0.5, 0.8)).normalize();
    let place = |p: &Point3<f64>| match kind {
        "collinear points" => Point3::from(along * p.coords.dot(&along)),
        "coincident points" => Point3::from(along),
        "coplanar points" => Point3::from(p.coords - along * p.coords.dot(&along)),
        _ => *p,
    };
    problem.source = problem.source.iter().map(place).collect();
    let mirror = |p: &Point3<f64>| {
        if kind == "a reflected copy" { p - 2.0 * across * p.coords.dot(&across) } else { *p }
    };
    problem.target = problem.source.iter().map(|p| problem.truth.apply(&mirror(p))).collect();
    if kind == "two pairs only" {
        problem.source.truncate(2);
        problem.target.truncate(2);
    }
    if kind == "a non-finite coordinate" {
        problem.target[1].y = f64::NAN;
    }
    (problem.source, problem.target)
}

/// The solvers that reject the input, and whether the results of the others are proper rotations.
fn refused(kind: &str, surface: &[Point3<f64>], seed: u64) -> Measurement {
    let (source, target) = degenerate(kind, surface, seed);
    let mut m = Measurement::default();
    let mut proper = true;
    for (solver, name) in SOLVERS {
        let found = solve_orientation(solver, &source, &target, None, false);
        m.set(name, f64::from(u8::from(found.is_err())));
        proper &= found.is_ok_and(|t| (t.rotation.determinant() - 1.0).abs() < 1e-9);
    }
    m.set("proper", f64::from(u8::from(proper)));
    m
}

impl Experiment for Estimators {
    fn about(&self) -> About {
        About {
            id: "estimators",
            title: "Verification of the rigid-transform estimators",
            question: "Do the estimators agree, how sensitive are they to noise, and do they detect degenerate input?",
            varied: "The noise on the target points and the kind of degenerate input. Two minimal estimators from three \
                     pairs (orthonormal frame; rotation axis) and three absolute-orientation solvers on 50 pairs (SVD; \
                     unit quaternion; orthonormal matrix).",
        }
    }

    fn units<'a>(&self, study: &'a Study<'_>) -> Vec<Unit<'a>> {
        let mut units = Vec::new();
        let n = study.either(100, 500);
        let blocks = study.either(2u64, 10);
        let surface = move |block: u64| -> Result<Vec<Point3<f64>>, String> {
            let phantom = Phantom::new(block).surface(2.0).map_err(|e| e.to_string())?;
            Ok(phantom.mesh.vertices().to_vec())
        };
        for block in 1..=blocks {
            let first = 10_000 * block;
            for sigma_mm in LEVELS {
                units.push(Unit {
                    group: NOISE.to_owned(),
                    configuration: level_name(sigma_mm),
                    case: format!("block {block} of {n} problems"),
                    inputs: json!(["noise", sigma_mm, first, n]),
                    work: Box::new(move || Ok(noise(&surface(block)?, sigma_mm, first, n))),
                });
            }
            for kind in KINDS {
                units.push(Unit {
                    group: DEGENERATE.to_owned(),
                    configuration: kind.to_owned(),
                    case: format!("problem {block}"),
                    inputs: json!(["degenerate", kind, block]),
                    work: Box::new(move || Ok(refused(kind, &surface(block)?, block))),
                });
            }
        }
        units
    }

    fn report(&self, study: &Study<'_>, results: &Results) -> Body {
        let (noise, degenerate) = (results.group(NOISE), results.group(DEGENERATE));
        let error = |key, name| Metric::number(key, name, "°", 3);
        let errors = [
            error("frame_deg", "frame, 3 pairs"),
            error("rotation_axis_deg", "rotation axis, 3 pairs"),
            error("svd_deg", "SVD, 50 pairs"),
            error("quaternion_deg", "quaternion, 50 pairs"),
            error("orthonormal_matrix_deg", "orthonormal matrix, 50 pairs"),
        ];
        let mut metrics = errors.to_vec();
        metrics.push(Metric::number("solver_difference", "largest difference between solvers", "", 12));
        let refusals = [
            Metric::percent("svd", "rejected by SVD"),
            Metric::percent("quaternion", "rejected by quaternion"),
            Metric::percent("orthonormal_matrix", "rejected by orthonormal matrix"),
            Metric::percent("proper", "all return a proper rotation"),
        ];
        let sigma = |setting: &str| LEVELS.into_iter().find(|&s| level_name(s) == setting);
        let finding = || {
            let apart = |setting: &&str| {
                noise
                    .measured(setting)
                    .iter()
                    .filter_map(|(_, m)| m.values.get("solver_difference").copied())
                    .fold(0.0, f64::max)
            };
            let worst = noise.configurations().iter().map(apart).fold(0.0, f64::max);
            let one = level_name(1.0);
            let n = study.either(100, 500) * noise.cases().len() * noise.configurations().len();
            Some(format!(
                "The three solvers differ by at most {worst:.1e} in any entry of the rotation matrix over {n} problems; at 1 mm \
                 of noise the median rotation error is {} from three pairs with the frame estimator, {} with the rotation-axis \
                 estimator, and {} from 50 pairs with SVD.",
                mean(&noise, &one, &errors[0])?,
                mean(&noise, &one, &errors[1])?,
                mean(&noise, &one, &errors[2])?,
            ))
        };
        let named = || {
            let all = |kind: &str| refusals[..3].iter().all(|m| degenerate.mean(kind, m.key) == Some(1.0));
            let none = |kind: &str| refusals[..3].iter().all(|m| degenerate.mean(kind, m.key) == Some(0.0));
            let (by_all, by_none) = (KINDS.into_iter().filter(|k| all(k)), KINDS.into_iter().filter(|k| none(k)));
            let (by_all, by_none): (Vec<_>, Vec<_>) = (by_all.collect(), by_none.collect());
            (!by_all.is_empty()).then(|| {
                format!("All three solvers reject {}; all three solve {}.", by_all.join(", "), by_none.join(", "))
            })
        };
        Body {
            pairs: format!(
                "{} blocks of {} random problems per noise level",
                noise.cases().len(),
                study.either(100, 500)
            ),
            finding: sentences([finding(), named()]),
            notes: vec!["Errors are medians within a block, given as mean ± SD over blocks.".to_owned()],
            tables: vec![
                noise.table("noise", "Rotation error versus noise", "noise", &metrics),
                degenerate.table("degenerate", "Degenerate input", "input", &refusals),
            ],
            plots: vec![Plot {
                title: "Median rotation error versus noise".to_owned(),
                kind: PlotKind::Lines,
                x: Axis::logarithmic("noise", "mm"),
                y: Axis::logarithmic("rotation error", "°"),
                categories: Vec::new(),
                series: errors[..3].iter().map(|m| noise.series(m.name, m, sigma)).collect(),
            }],
        }
    }
}
