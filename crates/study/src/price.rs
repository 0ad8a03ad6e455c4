//! The price of a computation: the processor time that it is predicted to take, from the counts that its stages take.
//!
//! Nothing depends on a price but whether a computation is accepted and what is said about its duration. The constants were
//! measured on a core of an AMD EPYC at 2.0 GHz that other processes shared, with a release build, on one thread, on bent ellipsoids of
//! 162 to 10,242 vertices and studies of 4 to 400 subjects; `tests/study/price.rs` compares prices with measured processor times. What depends on the shapes of the surfaces
//! is not known, and iterations, sweeps and trials are counted as if all that are allowed were needed. A default match of surfaces that are bent against each other takes several times
//! as long as one of surfaces that are not.

use crate::joint::JointSettings;
use crate::memory::{measures, permutations};
use crate::model::{COMPLETE, many, n_folds};
use crate::plan::RIVALS_PER_SUBJECT;
use crate::rivals::GroupSettings;
use homolog_contract::parameters::{
    Algorithm, ClampingMode, CurvatureEstimator, DisplacementMode, FeatureKind, FeatureParameters, MatchParameters,
    Refinement, Update,
};
use homolog_contract::study::StudySize;
use std::time::Duration;

/// A price, and what most of it is for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Price {
    /// Processor time of all parts together.
    pub processor_time: Duration,
    /// Advice that lowers the largest part, for people.
    pub advice: &'static str,
}

impl Price {
    /// `parts`: seconds, and what lowers them.
    fn of(parts: &[(f64, &'static str)]) -> Self {
        let seconds: f64 = parts.iter().map(|(seconds, _)| seconds).sum();
        let largest = parts.iter().copied().max_by(|(a, _), (b, _)| a.total_cmp(b));
        Price {
            processor_time: Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX),
            advice: largest.map_or("", |(_, advice)| advice),
        }
    }
}

/// Vertices above which a surface with a coarse level of its energy is measured on so many.
const MEASURED_ABOVE: f64 = 5000.0;
const MEASURED: f64 = 3000.0;
/// Edge of a surface from a label volume of 1 mm, mm: `radius_mm` is compared with it, because areas are not known here.
const EDGE_MM: f64 = 1.0;

/// Seconds of a match besides its vertices, and for each vertex of either surface: preparation, a default match (or the second
/// opinion that it is for all other methods), measures of the answer.
const OF_MATCH: f64 = 0.05;
const OF_VERTEX: f64 = 3e-5;
/// Seconds for each vertex of either surface of a registration without a field, and of iterative closest points over all vertices.
const OF_REGISTERED_VERTEX: f64 = 2.5e-5;
const OF_ICP_VERTEX: f64 = 6e-5;

/// Seconds for each directed edge of the source and each label in an iteration of belief propagation, besides the labels within the
/// neighborhood radius, and for each of those.
const OF_MESSAGE: f64 = 1.2e-9;
const OF_NEAR_LABEL: f64 = 1.5e-11;
/// The same for each of all labels, with the update `full`.
const OF_ANY_LABEL: f64 = 4.5e-11;
/// Factors on that for an energy with distances (`energy.beta`), and for tree-reweighted messages and bounds.
const WITH_DISTANCES: f64 = 2.5;
const DUAL: f64 = 5.0;
/// Seconds for each variable in a sweep of a sampler.
const OF_GIBBS: f64 = 1.2e-6;
const OF_METROPOLIS: f64 = 4.5e-7;
const OF_LAS_VEGAS: f64 = 4.5e-7;
/// Seconds for each variable and label of the tables of potentials, once for each feature.
const OF_POTENTIAL: f64 = 2e-9;
/// Seconds of an allowed trial of RANSAC for each variable; it rarely needs all of them.
const OF_TRIAL: f64 = 2e-10;

/// The price of a match of surfaces of these numbers of vertices; `source` also has this number of faces.
pub fn match_price(parameters: &MatchParameters, source: (usize, usize), target_vertices: usize) -> Price {
    let (n, faces, m) = (source.0 as f64, source.1 as f64, target_vertices as f64);
    let i = &parameters.inference;
    let mut parts = vec![
        (OF_MATCH + OF_VERTEX * (n + m), "smaller surfaces (input.max_vertices)"),
        (registration_seconds(parameters, n + m), "another registration.initial or smaller surfaces"),
        (mode_seconds(parameters.displacement.mode, n, m), "another displacement.mode or smaller surfaces"),
    ];
    if i.algorithm != Algorithm::None {
        let measured = |n: f64| if i.coarse_vertices.is_some() && n > MEASURED_ABOVE { MEASURED } else { n };
        let coarse = i.coarse_vertices.map_or(f64::INFINITY, f64::from);
        let (variables, labels) = (measured(n).min(coarse), measured(m).min(coarse));
        let edges = if coarse < n { 6.0 * coarse } else { 2.0 * (n + faces - 2.0).max(0.0) };
        for feature in &parameters.features {
            let advice = "a smaller features[].support or radius_mm, another kind, or fewer features";
            parts.push((feature_seconds(feature, measured(n)) + feature_seconds(feature, measured(m)), advice));
        }
        let tables = OF_POTENTIAL * variables * labels * parameters.features.len() as f64;
        parts.push((tables, "inference.coarse_vertices"));
        let rounds = if parameters.clamping.mode == ClampingMode::None { 0 } else { parameters.clamping.max_rounds };
        let iterations = f64::from(i.max_iterations) * (1.0 + 0.25 * f64::from(rounds));
        let iteration = iteration_seconds(parameters, variables, labels, edges);
        parts.push((iterations * iteration, "fewer inference.max_iterations, or inference.coarse_vertices"));
        let bound = f64::from(i.lower_bound_iterations) * DUAL * message_seconds(parameters, labels, edges, false);
        parts.push((bound, "fewer inference.lower_bound_iterations, or inference.coarse_vertices"));
        let trials = f64::from(parameters.registration.max_trials) * f64::from(1 + rounds) * OF_TRIAL * variables;
        parts.push((trials, "fewer registration.max_trials"));
    }
    Price::of(&parts)
}

/// Seconds of a registration of surfaces of this number of vertices together.
fn registration_seconds(parameters: &MatchParameters, vertices: f64) -> f64 {
    if parameters.displacement.mode == DisplacementMode::Smooth {
        return 0.0;
    }
    let refined = parameters.registration.refine == Refinement::PointToPoint;
    vertices * (OF_REGISTERED_VERTEX + if refined { OF_ICP_VERTEX } else { 0.0 })
}

/// Seconds of an iteration or sweep of the minimizer.
fn iteration_seconds(parameters: &MatchParameters, variables: f64, labels: f64, edges: f64) -> f64 {
    let i = &parameters.inference;
    let passed = |is_full| message_seconds(parameters, labels, edges, is_full);
    match i.algorithm {
        Algorithm::None => 0.0,
        Algorithm::MaxProduct | Algorithm::SumProduct => passed(i.update == Update::Full),
        Algorithm::TreeReweighted => DUAL * passed(false),
        Algorithm::Gibbs => OF_GIBBS * variables,
        Algorithm::Metropolis => OF_METROPOLIS * variables,
        Algorithm::LasVegas => OF_LAS_VEGAS * variables,
    }
}

/// Seconds of an iteration of belief propagation over all messages.
fn message_seconds(parameters: &MatchParameters, labels: f64, edges: f64, is_full: bool) -> f64 {
    let rings = f64::from(parameters.energy.neighborhood_rings);
    let near = OF_NEAR_LABEL * (1.0 + 3.0 * rings * (rings + 1.0)).min(labels);
    let distances = if parameters.energy.beta > 0.0 { WITH_DISTANCES } else { 1.0 };
    distances * edges * labels * (OF_MESSAGE + if is_full { OF_ANY_LABEL * labels } else { near })
}

/// Seconds of measuring a feature on a surface of `n` vertices.
fn feature_seconds(feature: &FeatureParameters, n: f64) -> f64 {
    // The share of a surface within this many square roots of its area.
    let in_support = n * (std::f64::consts::PI * feature.support.powi(2)).min(1.0);
    let each = match feature.kind {
        FeatureKind::HeatKernelSignature | FeatureKind::WaveKernelSignature => 1.5e-4,
        FeatureKind::SpinImage => 7e-5,
        FeatureKind::ShapeContext => 2.7e-4,
        FeatureKind::Fpfh => 2e-6 + 5.7e-8 * in_support,
        FeatureKind::Shot => 2.5e-5 + 5.5e-8 * in_support,
        FeatureKind::GaussianCurvature
        | FeatureKind::MeanCurvature
        | FeatureKind::ShapeIndex
        | FeatureKind::Curvedness => {
            let scales = feature.scales_mm.as_ref().map_or(feature.scales.len(), Vec::len) as f64;
            // Vertices of a regular triangulation in a ball.
            let in_ball = |radius: f64| (3.6 * radius * radius).min(n);
            let in_ball = feature.radius_mm.map_or(25.0, |radius_mm| in_ball(radius_mm / EDGE_MM));
            let fitted = match feature.estimator {
                CurvatureEstimator::AngleDefect => 0.0,
                CurvatureEstimator::Covariance => 2e-6 + 1.6e-8 * in_ball,
                CurvatureEstimator::Quadric => 3e-6 + 3e-8 * in_ball,
            };
            scales * (2e-6 + fitted)
        }
    };
    n * each
}

/// Seconds of a method in place of the default field, between surfaces of `n` and `m` vertices. The methods work on surfaces that
/// are thinned to a number of vertices.
fn mode_seconds(mode: DisplacementMode, n: f64, m: f64) -> f64 {
    let thinned = |most: f64| (n.min(most), m.min(most));
    match mode {
        DisplacementMode::None | DisplacementMode::Smooth => 0.0,
        DisplacementMode::Cpd => {
            let (n, m) = thinned(1500.0);
            2.5e-7 * n * m
        }
        DisplacementMode::Bcpd => {
            let (n, m) = thinned(1500.0);
            2e-7 * n * m
        }
        DisplacementMode::NonrigidIcp => 1.9e-4 * thinned(1500.0).0,
        DisplacementMode::SpharmPdm | DisplacementMode::Medial => 2e-5 * (n + m),
        DisplacementMode::FunctionalMap => {
            let (n, m) = thinned(2500.0);
            3.5e-4 * (n + m)
        }
        // All steps of the optimizer, with the varifold distance between all pairs of triangles in each.
        DisplacementMode::Diffeomorphic => {
            let (n, m) = thinned(500.0);
            4e-5 * n * (n + m) / 2.0
        }
    }
}

/// Seconds of a step besides its subjects, and of each subject.
const OF_STEP: f64 = 0.08;
const OF_SUBJECT: f64 = 1e-3;
/// Seconds for each vertex of each subject: alignment, measures, the surface that is written.
const OF_SHAPE_VERTEX: f64 = 4e-6;
/// Seconds for each vertex of each pair of subjects, and for each cube of their number in a decomposition.
const OF_PAIR_VERTEX: f64 = 2e-9;
const OF_DECOMPOSITION: f64 = 2.5e-10;
/// Seconds for each vertex of each subject in a read of a large group, and for each of these with each component.
const OF_READ_VERTEX: f64 = 6e-8;
const OF_COMPONENT_VERTEX: f64 = 1e-9;
/// Seconds for each map, and for each of its vertices: its statistics, and two files.
const OF_MAP: f64 = 0.05;
const OF_MAP_VERTEX: f64 = 1e-5;
/// Seconds for each value of t of a permutation test: for each subject and column of the design, and besides.
const OF_PERMUTED: f64 = 3e-10;
const OF_VALUE: f64 = 1.2e-7;
/// Seconds for each byte of label volumes.
const OF_VOLUME_BYTE: f64 = 1e-7;

/// Seconds for each vertex of each subject in a round of joint maps, if all rounds are needed: predictions, slides,
/// closest points.
const OF_JOINT_VERTEX: f64 = 3e-6;

/// Seconds for each vertex of each visit of a person with a template of its own: surfaces that are read, two means, and the map that
/// is composed.
const OF_VISIT_VERTEX: f64 = 6e-6;
/// Seconds for each vertex of each map in a rival pose: the surface that is turned back, the record, its shape.
const OF_RIVAL_VERTEX: f64 = 1e-6;
/// Seconds for each pair of subjects that are decided together: distances of all candidates, and their messages.
const OF_RIVAL_PAIR: f64 = 5e-5;

/// The price of the largest step of a study.
pub fn step_price(size: &StudySize) -> Price {
    let (n, v) = (size.subjects as f64, size.vertices as f64);
    let maps = size.contrasts as f64 * measures(size) as f64;
    let values = permutations(size) as f64 * maps * v;
    let volumes = if size.has_volumes { n * size.file_bytes as f64 } else { 0.0 };
    let models = 1.0 + n_folds(size.subjects as usize) as f64;
    let model = if n <= COMPLETE as f64 {
        OF_PAIR_VERTEX * n * n * v + models * OF_DECOMPOSITION * n.powi(3)
    } else {
        let components = many::COMPONENTS as f64;
        models * (many::MAX_PASSES as f64 + 2.0) * n * v * (OF_READ_VERTEX + OF_COMPONENT_VERTEX * components)
    };
    let joint = JointSettings::default();
    let rounds = if size.joint { joint.max_rounds as f64 } else { 0.0 };
    let in_model = n.min(joint.most_in_model as f64);
    let models =
        rounds * (joint.folds as f64 * OF_DECOMPOSITION * in_model.powi(3) + OF_PAIR_VERTEX * in_model * in_model * v);
    let visits = if size.own_templates { n * v } else { 0.0 };
    // Any subject may be ambiguous.
    let (ambiguous, group) = (if size.rivals { n } else { 0.0 }, GroupSettings::default());
    let decided = ambiguous * (ambiguous.min(group.together as f64) + n.min(group.most_observed as f64));
    let rivals = OF_RIVAL_VERTEX * ambiguous * v * RIVALS_PER_SUBJECT as f64 + OF_RIVAL_PAIR * decided;
    Price::of(&[
        (OF_VISIT_VERTEX * visits, "visits group_template, or a smaller template"),
        (rivals, "rivals leave_out, or a smaller template"),
        (rounds * OF_JOINT_VERTEX * n * v + models, "correspondence pairs, or a smaller template"),
        (
            OF_STEP + n * (OF_SUBJECT + OF_SHAPE_VERTEX * v) + OF_VOLUME_BYTE * volumes,
            "fewer subjects or a smaller template",
        ),
        (model, "fewer subjects"),
        (maps * (OF_MAP + OF_MAP_VERTEX * v), "fewer contrasts or measures, or a smaller template"),
        (
            values * (OF_VALUE + OF_PERMUTED * n * (size.columns as f64 + 1.0)),
            "fewer permutations, measures or contrasts, or a smaller template",
        ),
    ])
}
