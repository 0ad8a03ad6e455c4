//! The fourth stage: measures of the images of the source vertices, in the numbering of the inputs.

use super::consistency::topology_consistency;
use super::deformation::deformation;
use super::displaced::{Images, VertexImages, labeling_of_energy};
use super::inverse::inverse;
use super::outcome::MatchOutcome;
use super::outliers::identify_outliers;
use crate::pair::problem::{EnergyProblem, MatchProblem};
use crate::pair::scene::Scene;
use crate::pair::solver::solver;
use crate::poses::posed::{InferredPose, PoseResult};
use crate::surface::side::SurfaceLevel;
use homolog_contract::result::{
    ConsistencyDocument, Correspondences, DeformationDocument, EnergyDocument, OutlierReason, SimilarityDocument,
    StopReason, SupportDocument, SurfaceDistanceDocument, TransformDocument,
};
use homolog_mesh::{ClosestPoint, SurfaceDistances, SurfaceMesh};
use homolog_primitives::graph::{EdgeGraph, Reach};
use homolog_registration::{ProcrustesOptions, RigidTransform, procrustes};
use nalgebra::{Matrix3, Point3, Vector3};
use rayon::prelude::*;
use std::borrow::Cow;

/// The outcome of a match: results of the previous stages and measures of the answer, in the numbering of the inputs.
pub(crate) fn build_outcome(coarse: &MatchProblem<'_>, posed: &PoseResult<'_>, answer: &VertexImages) -> MatchOutcome {
    let scene = &coarse.full;
    let energy = energy_of(coarse, posed, answer);
    let (surface_distance, of_pairs) = rayon::join(
        || surface_distance(scene.source, scene.target, &answer.transform),
        || OfPairs::new(scene, posed, answer),
    );
    let OfPairs { similarity, support, topology, deformation, mut correspondences } = of_pairs;
    correspondences.inverse = scene.parameters.both_directions.then(|| inverse(scene, answer)).flatten().map(Box::new);
    let (rounds, ambiguous_axes, stop_reason) = match posed {
        PoseResult::Inference { inferred, .. } => (inferred.rounds.clone(), false, inferred.stop_reason),
        PoseResult::Registration(registered) => (Vec::new(), registered.ambiguous_axes, StopReason::RegistrationOnly),
        PoseResult::ByField => match &answer.inference {
            Some(found) => (found.rounds.clone(), false, found.stop_reason),
            None => (Vec::new(), false, StopReason::RegistrationOnly),
        },
    };
    MatchOutcome {
        transform: TransformDocument { similarity, ..transform_document(&answer.transform) },
        support,
        surface_distance,
        energy,
        topology,
        deformation,
        rounds,
        poses: answer.poses.clone(),
        reliability: answer.reliability.clone(),
        ambiguous_axes,
        correspondences,
        stop_reason,
    }
}

/// Energies of the answer, if an energy was minimized: of the images as labels, or of the labeling of the rounds if the
/// source is moved rigidly.
fn energy_of(coarse: &MatchProblem<'_>, posed: &PoseResult<'_>, answer: &VertexImages) -> Option<EnergyDocument> {
    let PoseResult::Inference { problem, inferred } = posed else {
        return answer.inference.as_ref().map(|found| found.energy.clone());
    };
    Some(match &answer.images {
        Images::OnVertices => energy(problem, &inferred.map.labeling),
        Images::Smooth(_) => energy(problem, &labeling_of_energy(coarse.source, coarse.target, &answer.labeling)),
    })
}

/// Measures of the pairs of vertices and images.
struct OfPairs {
    similarity: Option<SimilarityDocument>,
    support: SupportDocument,
    topology: ConsistencyDocument,
    deformation: Option<DeformationDocument>,
    /// In the numbering of the inputs, without the inverse map.
    correspondences: Correspondences,
}

impl OfPairs {
    fn new(scene: &Scene<'_>, posed: &PoseResult<'_>, answer: &VertexImages) -> Self {
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
        let points = match &answer.images {
            Images::OnVertices => Cow::Owned(on_vertices(scene.target.mesh(), &answer.labeling)),
            Images::Smooth(smooth) => {
                for (reason, alone) in outlier.iter_mut().zip(&smooth.no_counterpart) {
                    if *alone {
                        *reason = OutlierReason::NoCounterpart;
                    }
                }
                Cow::Borrowed(smooth.points.as_slice())
            }
        };
        let has_counterpart = |i: usize| outlier[i] != OutlierReason::NoCounterpart;
        let mirrored = answer.transform.is_reflection();
        let deformation = deformation(source, scene.target.mesh(), &points, has_counterpart, mirrored);
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
        let (trials, confidence_reached) = match posed {
            PoseResult::Inference { inferred, .. } => match inferred.pose {
                InferredPose::Supported { trials, confidence_reached, .. } => (trials, confidence_reached),
                InferredPose::Unsupported => (0, false),
            },
            PoseResult::Registration(_) | PoseResult::ByField => {
                answer.inference.as_ref().map_or((0, true), |found| (found.trials, found.confidence_reached))
            }
        };
        OfPairs {
            similarity: similarity(scene, answer, &images, &supporting),
            support: SupportDocument {
                inliers: supporting.len() as u32,
                ratio: supporting.len() as f64 / n as f64,
                rms_mm: if supporting.is_empty() { 0.0 } else { (squares / supporting.len() as f64).sqrt() },
                tolerance_mm: scene.tolerance_mm,
                trials,
                confidence_reached,
            },
            topology: topology(scene, &answer.transform, &variables, &labels, &answer.labeling),
            deformation,
            correspondences,
        }
    }
}

/// Labels as points on the target: each is a corner of a triangle.
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
fn energy(problem: &EnergyProblem<'_>, labeling: &[u32]) -> EnergyDocument {
    let EnergyProblem { model, lower_bound, .. } = problem;
    let found = model.energy(labeling);
    EnergyDocument {
        n_variables: model.variables.n_vertices() as u32,
        n_target_vertices: model.labels.n_labels() as u32,
        initial: model.energy(&model.unary_minimum()).total(),
        r#final: found.total(),
        per_variable: found.total() / model.variables.n_vertices() as f64,
        unary: found.unary,
        pairwise: found.pairwise,
        lower_bound: *lower_bound,
        broken_edges: model.broken_edges(labeling) as u32,
    }
}

/// Quality of the map. A mirroring transform is measured as a map of the mirrored source, whose faces are
/// oriented outwards again.
fn topology(
    scene: &Scene<'_>,
    transform: &RigidTransform,
    variables: &EdgeGraph,
    labels: &Reach<'_>,
    labeling: &[u32],
) -> ConsistencyDocument {
    let (source, target) = (scene.source.mesh(), scene.target.mesh());
    let found = topology_consistency(source, variables, target, labeling, labels);
    // Minimizers and closest points give target vertices only.
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
    found
}

/// The similarity over the support, if the parameters ask for it and three pairs determine it. For a source scaled to
/// the size of the target, of which few pairs support a rigid transform, it is over all vertices with a counterpart.
fn similarity(
    scene: &Scene<'_>,
    answer: &VertexImages,
    images: &[Point3<f64>],
    supporting: &[usize],
) -> Option<SimilarityDocument> {
    let p = &scene.parameters.registration;
    let with_counterpart: Vec<usize>;
    let supporting = match &answer.images {
        Images::Smooth(smooth) if answer.resized => {
            with_counterpart = (0..images.len()).filter(|&i| !smooth.no_counterpart[i]).collect();
            &with_counterpart
        }
        _ if p.similarity => supporting,
        _ => return None,
    };
    let source: Vec<_> = supporting.iter().map(|&i| scene.source.mesh().vertices()[i]).collect();
    let target: Vec<_> = supporting.iter().map(|&i| images[i]).collect();
    let options =
        ProcrustesOptions { solver: solver(p.solver), with_scale: true, allow_reflection: p.allow_reflection };
    let found = procrustes(&source, &target, None, &options).ok()?;
    let fitted = found.target_from_source;
    Some(SimilarityDocument { scale: fitted.scale, matrix: fitted.matrix(), rms_mm: found.rms_mm })
}

/// The transform in all its forms.
fn transform_document(transform: &RigidTransform) -> TransformDocument {
    let q = transform.quaternion();
    let mirrored = transform.is_reflection();
    // The quaternion of a reflection is that of −R.
    let in_origin = RigidTransform { rotation: -Matrix3::identity(), translation: Vector3::zeros() };
    TransformDocument {
        matrix: transform.matrix(),
        mirrored,
        reflection: mirrored.then(|| in_origin.matrix()),
        rotation_quaternion_wxyz: [q.w, q.i, q.j, q.k],
        rotation_angle_deg: transform.angle_rad().to_degrees(),
        translation_mm: transform.translation.into(),
        similarity: None,
    }
}

/// Distances of the vertices of each surface from the other, the source moved by `transform`.
fn surface_distance(
    source: &SurfaceLevel,
    target: &SurfaceLevel,
    transform: &RigidTransform,
) -> SurfaceDistanceDocument {
    // The inverse transform moves the target onto the source in its original place.
    let back = transform.inverse();
    let distances = |from: &SurfaceLevel, to: &SurfaceLevel, motion: &RigidTransform| -> Vec<f64> {
        let moved: Vec<Point3<f64>> = from.mesh().vertices().iter().map(|p| motion.apply(p)).collect();
        SurfaceDistances::new(to.mesh()).of(&moved)
    };
    let (mut all, returned) = rayon::join(|| distances(source, target, transform), || distances(target, source, &back));
    all.extend(returned);
    // Equal distances are indistinguishable, so the result does not depend on the order of an unstable sort.
    all.par_sort_unstable_by(f64::total_cmp);
    let at = |share: f64| all[((all.len() - 1) as f64 * share).round() as usize];
    SurfaceDistanceDocument { mean_mm: all.iter().sum::<f64>() / all.len() as f64, p95_mm: at(0.95), max_mm: at(1.0) }
}
