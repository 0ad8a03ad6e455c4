//! From an answer to the outcome of a match: what is measured on it, in the numbering of the inputs.

use super::MatchOutcome;
use super::consistency::topology_consistency_within;
use super::inverse::inverse;
use super::outliers::{self, identify_outliers};
use super::scene::Scene;
use super::side::Side;
use homolog_contract::parameters::OrientationSolver as Solver;
use homolog_contract::result::{
    AnatomyDocument, ConsistencyDocument, Correspondences, EnergyDocument, OutlierReason, PoseDocument,
    ReliabilityDocument, RoundDocument, SimilarityDocument, StopReason, SupportDocument, SurfaceDistanceDocument,
    TransformDocument,
};
use homolog_mesh::{ClosestPoint, SurfaceDistances, SurfaceMesh};
use homolog_mrf::MrfModel;
use homolog_primitives::graph::{EdgeGraph, Reach};
use homolog_registration::{OrientationSolver, ProcrustesOptions, RigidTransform, procrustes};
use nalgebra::Point3;
use rayon::prelude::*;

/// What inference and registration found, in canonical numbering.
pub(super) struct Answer {
    pub labeling: Vec<u32>,
    pub confidence: Vec<f64>,
    pub spread_mm: Vec<f64>,
    /// Where on the target the images lie, if not on its vertices.
    pub points: Option<Vec<ClosestPoint>>,
    /// Where the displacement moves the source, mm, if there is one.
    pub moved: Option<Vec<Point3<f64>>>,
    /// Source vertices that the displacement takes to where the target has nothing; empty where none was fitted.
    pub no_counterpart: Vec<bool>,
    /// Whether it can be relied on, where a displacement says so.
    pub reliability: Option<ReliabilityDocument>,
    /// What is known of the structure had to say.
    pub anatomy: Option<AnatomyDocument>,
    pub transform: RigidTransform,
    pub confidence_reached: bool,
    pub trials: u64,
    pub stop_reason: StopReason,
    pub rounds: Vec<RoundDocument>,
    pub poses: Vec<PoseDocument>,
    pub ambiguous_axes: bool,
    pub lower_bound: Option<f64>,
}

/// The outcome of `answer`.
pub(super) fn outcome(scene: &Scene<'_>, energy: Option<EnergyDocument>, answer: Answer) -> MatchOutcome {
    let (surface_distance, of_pairs) = rayon::join(
        || surface_distance(scene.source, scene.target, &answer.transform),
        || OfPairs::new(scene, &answer),
    );
    let OfPairs { similarity, support, topology, mut correspondences } = of_pairs;
    correspondences.inverse = scene.parameters.both_directions.then(|| inverse(scene, &answer)).flatten().map(Box::new);
    MatchOutcome {
        transform: TransformDocument { similarity, ..transform_document(&answer.transform) },
        support,
        surface_distance,
        energy,
        topology,
        rounds: answer.rounds,
        poses: answer.poses,
        reliability: answer.reliability,
        anatomy: answer.anatomy,
        ambiguous_axes: answer.ambiguous_axes,
        correspondences,
        stop_reason: answer.stop_reason,
    }
}

/// What is measured on the pairs of vertices and images.
struct OfPairs {
    similarity: Option<SimilarityDocument>,
    support: SupportDocument,
    topology: ConsistencyDocument,
    /// In the numbering of the inputs, without the map the other way.
    correspondences: Correspondences,
}

impl OfPairs {
    fn new(scene: &Scene<'_>, answer: &Answer) -> Self {
        let n = answer.labeling.len();
        let source = scene.source.mesh();
        let images = scene.images(&answer.labeling);
        let residual = |i: usize| (answer.transform.apply(&source.vertices()[i]) - images[i]).norm();
        let residuals: Vec<f64> = (0..n).map(residual).collect();
        let inlier: Vec<bool> = residuals.iter().map(|&r| r <= scene.tolerance_mm).collect();
        let supporting: Vec<usize> = (0..n).filter(|&i| inlier[i]).collect();
        let squares: f64 = supporting.iter().map(|&i| residuals[i] * residuals[i]).sum();
        let rings = scene.parameters.energy.neighborhood_rings as usize;
        let (variables, graph) = rayon::join(|| source.edge_graph(), || scene.target.mesh().edge_graph());
        let labels = Reach { graph: &graph, rings };
        let mut outlier = outlier_reasons(scene, &variables, &labels, &answer.labeling, &residuals);
        for (reason, alone) in outlier.iter_mut().zip(&answer.no_counterpart) {
            if *alone {
                *reason = OutlierReason::NoCounterpart;
            }
        }
        let on_vertices = answer.points.is_none().then(|| on_vertices(scene.target.mesh(), &answer.labeling));
        let points = answer.points.as_ref().or(on_vertices.as_ref()).map_or(&[][..], Vec::as_slice);
        // Back to the numbering of the inputs, in its order.
        let rows = scene.source.surface.numbering.by_original();
        let as_uploaded = |x: u32| scene.target.surface.numbering.original(x);
        let correspondences = Correspondences {
            source: rows.iter().map(|&(original, _)| original).collect(),
            target: rows.iter().map(|&(_, i)| as_uploaded(answer.labeling[i])).collect(),
            confidence: rows.iter().map(|&(_, i)| answer.confidence[i]).collect(),
            inlier: rows.iter().map(|&(_, i)| inlier[i]).collect(),
            spread_mm: rows.iter().map(|&(_, i)| answer.spread_mm[i]).collect(),
            outlier: rows.iter().map(|&(_, i)| outlier[i]).collect(),
            triangle: rows.iter().map(|&(_, i)| points[i].triangle.map(as_uploaded)).collect(),
            barycentric: rows.iter().map(|&(_, i)| points[i].barycentric).collect(),
            inverse: None,
        };
        OfPairs {
            similarity: similarity(scene, &images, &supporting),
            support: SupportDocument {
                inliers: supporting.len() as u32,
                ratio: supporting.len() as f64 / n as f64,
                rms_mm: if supporting.is_empty() { 0.0 } else { (squares / supporting.len() as f64).sqrt() },
                tolerance_mm: scene.tolerance_mm,
                trials: answer.trials,
                confidence_reached: answer.confidence_reached,
            },
            topology: topology(scene, &answer.transform, &variables, &labels, &answer.labeling),
            correspondences,
        }
    }
}

/// Labels as points: each the corner of a triangle around it.
fn on_vertices(target: &SurfaceMesh, labeling: &[u32]) -> Vec<ClosestPoint> {
    let mut around: Vec<Option<[u32; 3]>> = vec![None; target.n_vertices()];
    for triangle in target.triangles() {
        for corner in triangle {
            around[corner as usize].get_or_insert(triangle);
        }
    }
    let point = |&x: &u32| {
        let triangle = around[x as usize].unwrap_or([x; 3]);
        let corner = triangle.iter().position(|&y| y == x).unwrap_or(0);
        let mut barycentric = [0.0; 3];
        barycentric[corner] = 1.0;
        ClosestPoint { point: target.vertices()[x as usize], triangle, barycentric }
    };
    labeling.iter().map(point).collect()
}

/// Energies of `labeling`.
pub(super) fn energy(model: &MrfModel, labeling: &[u32], lower_bound: Option<f64>) -> EnergyDocument {
    let found = model.energy(labeling);
    EnergyDocument {
        n_variables: model.variables.n_vertices() as u32,
        n_labels: model.labels.n_labels() as u32,
        initial: model.energy(&model.unary_minimum()).total(),
        r#final: found.total(),
        unary: found.unary,
        pairwise: found.pairwise,
        lower_bound,
        broken_edges: model.broken_edges(labeling) as u32,
    }
}

/// Quality of the map. A mirrored answer is judged as a map of the mirrored source, which looks outwards again.
fn topology(
    scene: &Scene<'_>,
    transform: &RigidTransform,
    variables: &EdgeGraph,
    labels: &Reach<'_>,
    labeling: &[u32],
) -> ConsistencyDocument {
    let (source, target) = (scene.source.mesh(), scene.target.mesh());
    let found = topology_consistency_within(source, variables, target, labeling, labels);
    // Every label is a target vertex: minimisers and closest points give no other.
    let Ok(found) = found else { unreachable!("a labeling with labels that are no target vertices") };
    let flipped = if transform.is_reflection() {
        found.n_triangles - found.n_degenerate - found.n_flipped
    } else {
        found.n_flipped
    };
    ConsistencyDocument {
        consistency: found.consistency,
        coverage: found.coverage,
        flipped_triangles: flipped as u32,
        degenerate_triangles: found.n_degenerate as u32,
        n_triangles: found.n_triangles as u32,
    }
}

fn outlier_reasons(
    scene: &Scene<'_>,
    variables: &EdgeGraph,
    labels: &Reach<'_>,
    labeling: &[u32],
    residuals: &[f64],
) -> Vec<OutlierReason> {
    let found = identify_outliers(variables, labels, labeling, residuals, scene.tolerance_mm);
    let Ok(found) = found else { unreachable!("a labeling with labels that are no target vertices") };
    let reason = |reason: Option<outliers::OutlierReason>| match reason {
        None => OutlierReason::None,
        Some(outliers::OutlierReason::Residual) => OutlierReason::Residual,
        Some(outliers::OutlierReason::Neighborhood) => OutlierReason::Neighborhood,
        Some(outliers::OutlierReason::Both) => OutlierReason::Both,
    };
    found.into_iter().map(reason).collect()
}

/// The similarity over the support, where it is asked for and three pairs determine it.
fn similarity(scene: &Scene<'_>, images: &[Point3<f64>], supporting: &[usize]) -> Option<SimilarityDocument> {
    let p = &scene.parameters.registration;
    if !p.similarity {
        return None;
    }
    let source: Vec<_> = supporting.iter().map(|&i| scene.source.mesh().vertices()[i]).collect();
    let target: Vec<_> = supporting.iter().map(|&i| images[i]).collect();
    let options =
        ProcrustesOptions { solver: solver(p.solver), with_scale: true, allow_reflection: p.allow_reflection };
    let found = procrustes(&source, &target, None, &options).ok()?;
    let fitted = found.target_from_source;
    Some(SimilarityDocument { scale: fitted.scale, matrix: fitted.matrix(), rms_mm: found.rms_mm })
}

/// The solver that the parameters name.
pub(super) fn solver(named: Solver) -> OrientationSolver {
    match named {
        Solver::Svd => OrientationSolver::Svd,
        Solver::Quaternion => OrientationSolver::Quaternion,
        Solver::OrthonormalMatrix => OrientationSolver::OrthonormalMatrix,
    }
}

/// The transform in all its forms.
pub(super) fn transform_document(transform: &RigidTransform) -> TransformDocument {
    let q = transform.quaternion();
    TransformDocument {
        matrix: transform.matrix(),
        rotation_quaternion_wxyz: [q.w, q.i, q.j, q.k],
        rotation_angle_deg: transform.angle_rad().to_degrees(),
        translation_mm: transform.translation.into(),
        similarity: None,
    }
}

/// Distances of the vertices of both surfaces from the other, the source moved by `transform`.
fn surface_distance(source: &Side, target: &Side, transform: &RigidTransform) -> SurfaceDistanceDocument {
    // Moved the other way, the target meets the source where it is.
    let back = transform.inverse();
    let distances = |from: &Side, to: &Side, motion: &RigidTransform| -> Vec<f64> {
        let moved: Vec<Point3<f64>> = from.mesh().vertices().iter().map(|p| motion.apply(p)).collect();
        SurfaceDistances::new(to.mesh()).of(&moved)
    };
    let (mut all, returned) = rayon::join(|| distances(source, target, transform), || distances(target, source, &back));
    all.extend(returned);
    // No two that are equal differ, so that nothing depends on how this sorts.
    all.par_sort_unstable_by(f64::total_cmp);
    let at = |share: f64| all[((all.len() - 1) as f64 * share).round() as usize];
    SurfaceDistanceDocument { mean_mm: all.iter().sum::<f64>() / all.len() as f64, p95_mm: at(0.95), max_mm: at(1.0) }
}
