//! The third stage: an image on the target for every source vertex, through a smooth displacement field or rigidly.

use super::MatchError;
use super::candidate_poses::{rotations_of_best, sameness, searched};
use super::coarse::Coarse;
use super::displacement::{
    ComparedPose, DisplacementAnswer, DisplacementOptions, StartPose, Surfaces, displace, landmark_pose,
};
use super::field_methods::by_method;
use super::lengths::Lengths;
use super::levels::Levels;
use super::posed::{InferredPose, Posed};
use super::registration_only::register;
use super::reliability::{UNRELIABLE_CONFIDENCE, reliability, without_counterpart};
use super::rounds::{PROGRESS_AT_END, PROGRESS_BEFORE_DISPLACEMENT, PROGRESS_BEFORE_ROUNDS};
use super::scene::Scene;
use super::side::{Which, part};
use super::vertex_map::VertexMap;
use homolog_contract::parameters::{Bending, DisplacementMode};
use homolog_contract::result::{PoseDocument, PoseOrigin, ReliabilityDocument};
use homolog_mesh::ClosestPoint;
use homolog_mrf::Labeling;
use homolog_primitives::observe::{Observer, Phase, TracePoint};
use homolog_registration::{RigidTransform, ScoredPose};
use nalgebra::Point3;
use std::sync::{Mutex, PoisonError};

/// What the third stage hands over: every vertex of the source as it came, in canonical numbering.
pub(crate) struct Displaced {
    /// The rigid transform.
    pub transform: RigidTransform,
    /// The target vertex of each source vertex.
    pub labeling: Labeling,
    /// Its probability.
    pub confidence: Vec<f64>,
    /// Expected distance of the true image, mm.
    pub spread_mm: Vec<f64>,
    /// Poses that were compared.
    pub poses: Vec<PoseDocument>,
    pub images: Images,
    /// Whether the source was scaled to the area of the target.
    pub resized: bool,
}

impl Displaced {
    /// This answer for `levels`, which are a source at another size whose vertices are numbered as those of the source, as an answer for
    /// the source: `rigid` is the transform of the source that stands for one of theirs.
    pub(crate) fn of_original(
        mut self,
        levels: &Levels,
        rigid: impl Fn(&RigidTransform) -> RigidTransform,
    ) -> Displaced {
        let order: Vec<usize> = levels.full.surface.numbering.by_original().into_iter().map(|(_, i)| i).collect();
        self.labeling = in_order(&order, &self.labeling);
        self.confidence = in_order(&order, &self.confidence);
        self.spread_mm = in_order(&order, &self.spread_mm);
        if let Images::Smooth(smooth) = &mut self.images {
            smooth.points = in_order(&order, &smooth.points);
            smooth.moved = in_order(&order, &smooth.moved);
            smooth.no_counterpart = in_order(&order, &smooth.no_counterpart);
        }
        for pose in &mut self.poses {
            pose.matrix = rigid(&RigidTransform::of_matrix(&pose.matrix)).matrix();
        }
        self.transform = rigid(&self.transform);
        self.resized = true;
        self
    }
}

/// `values` at the indices of `order`.
fn in_order<T: Clone>(order: &[usize], values: &[T]) -> Vec<T> {
    order.iter().map(|&i| values[i].clone()).collect()
}

/// Where the images of the source vertices lie.
pub(crate) enum Images {
    /// On the vertices of the target that `labeling` names; the source is moved by the transform alone.
    OnVertices,
    /// Where a smooth displacement field moves the source.
    Smooth(SmoothImages),
}

/// Images by a smooth displacement field.
pub(crate) struct SmoothImages {
    /// The point of the target closest to each moved source vertex.
    pub points: Vec<ClosestPoint>,
    /// Each moved source vertex, mm.
    pub moved: Vec<Point3<f64>>,
    /// Whether the target has nothing where a source vertex is moved to.
    pub no_counterpart: Vec<bool>,
    /// Whether the images can be relied on; known of the smooth displacement field alone.
    pub reliability: Option<ReliabilityDocument>,
}

/// An image for every source vertex of `coarse`, from the pose of `posed`.
///
/// With a displacement field the poses compared are that of `posed`, that of the landmarks and those of a search of all
/// orientations, mirrored ones too; the one that fits best after the deformation is kept. Where no field can be fitted,
/// the images are those of the rigid pose, and where `posed` has none, of the first of the other poses. A method of the field
/// starts from that one pose. Where the pose was left to the field and none can be fitted, the answer is that of registration alone.
///
/// # Errors
/// [`MatchError::NoRegistration`] where `posed` has no pose and no other is at hand: without a displacement field, or
/// where neither landmarks nor the search give one. [`MatchError::ScaleSpace`]; [`MatchError::Cancelled`].
pub(crate) fn displaced(coarse: &Coarse<'_>, posed: &Posed<'_>) -> Result<Displaced, MatchError> {
    let starts = match coarse.full.parameters.displacement.mode {
        DisplacementMode::None => Starts::of(posed),
        DisplacementMode::Smooth => {
            coarse.full.observer.phase(Phase::Displacement);
            let starts = Starts::with_search(coarse, posed);
            if let Some(found) = by_field(coarse, posed, &starts)? {
                return Ok(found);
            }
            if matches!(posed, Posed::ByField) {
                let registered = Posed::Registration(register(&coarse.full)?);
                return rigid(coarse, &registered, &starts);
            }
            starts
        }
        _ => {
            coarse.full.observer.phase(Phase::Displacement);
            let starts =
                if posed.transform().is_some() { Starts::of(posed) } else { Starts::with_search(coarse, posed) };
            if let Some(pose) = starts.first(coarse) {
                let poses = match posed {
                    Posed::Registration(registered) => registered.poses.clone(),
                    Posed::Inference { .. } | Posed::ByField => Vec::new(),
                };
                if let Some(found) = by_method(coarse, &pose, poses)? {
                    coarse.full.observer.progress(PROGRESS_AT_END);
                    return Ok(found);
                }
            }
            starts
        }
    };
    rigid(coarse, posed, &starts)
}

/// A rigid pose to start from.
struct Start {
    origin: PoseOrigin,
    pose: RigidTransform,
    /// The index of the start that was rotated to give this one.
    rotation_of: Option<usize>,
}

impl Start {
    fn new(origin: PoseOrigin, pose: RigidTransform) -> Start {
        Start { origin, pose, rotation_of: None }
    }
}

/// Rigid poses to start from, the most trusted first.
struct Starts {
    poses: Vec<Start>,
    /// All that the search found, the best first.
    of_search: Vec<ScoredPose>,
}

impl Starts {
    /// The pose of `posed` alone.
    fn of(posed: &Posed<'_>) -> Starts {
        let origin = match posed {
            Posed::Inference { .. } => PoseOrigin::Inference,
            Posed::Registration(_) | Posed::ByField => PoseOrigin::Registration,
        };
        Starts {
            poses: posed.transform().map(|pose| Start::new(origin, pose)).into_iter().collect(),
            of_search: Vec::new(),
        }
    }

    /// The pose of `posed`, that of the landmarks, and those of a search of all orientations.
    fn with_search(coarse: &Coarse<'_>, posed: &Posed<'_>) -> Starts {
        let parameters = coarse.full.parameters;
        let Starts { mut poses, .. } = Starts::of(posed);
        let of_landmarks = landmark_pose(&parameters.landmarks, parameters.registration.allow_reflection);
        poses.extend(of_landmarks.map(|pose| Start::new(PoseOrigin::Landmarks, pose)));
        // Of either handedness, so that a mirrored image is noticed.
        let of_search = searched(&coarse.source.middle, &coarse.target.middle, true);
        let first = poses.len();
        poses.extend(of_search.iter().map(|p| Start::new(PoseOrigin::Search, p.target_from_source)));
        let rotations = rotations_of_best(&coarse.source.middle, &of_search);
        let rotation = |(k, pose)| Start { rotation_of: Some(first + k), ..Start::new(PoseOrigin::Search, pose) };
        poses.extend(rotations.into_iter().map(rotation));
        Starts { poses, of_search }
    }

    /// The most trusted pose that may be answered.
    fn first(&self, coarse: &Coarse<'_>) -> Option<RigidTransform> {
        let allow_reflection = coarse.full.parameters.registration.allow_reflection;
        self.poses.iter().map(|start| start.pose).find(|pose| allow_reflection || !pose.is_reflection())
    }

    /// How much worse than the best the search found `pose`: as much as the best pose it returned that is the same;
    /// a pose that it did not return is as bad as its last.
    fn excess(&self, pose: &RigidTransform, are_same: impl Fn(&RigidTransform, &RigidTransform) -> bool) -> f64 {
        let alike = self.of_search.iter().filter(|p| are_same(&p.target_from_source, pose));
        let least = alike.map(|p| p.excess).fold(f64::INFINITY, f64::min);
        least.min(self.of_search.last().map_or(0.0, |p| p.excess))
    }
}

/// The images of a rigid pose.
fn rigid(coarse: &Coarse<'_>, posed: &Posed<'_>, starts: &Starts) -> Result<Displaced, MatchError> {
    let scene = &coarse.full;
    let found = posed.transform().or_else(|| starts.first(coarse));
    let transform = found.ok_or(MatchError::NoRegistration { tolerance_mm: scene.tolerance_mm })?;
    let (map, poses) = match posed {
        // The labels of an energy of all vertices are the answer.
        Posed::Inference { inferred, .. }
            if coarse.is_direct() && matches!(inferred.pose, InferredPose::Supported { .. }) =>
        {
            (inferred.map.clone(), Vec::new())
        }
        Posed::Inference { .. } | Posed::ByField => (VertexMap::nearest(scene, &transform), Vec::new()),
        Posed::Registration(registered) => (VertexMap::nearest(scene, &transform), registered.poses.clone()),
    };
    let VertexMap { labeling, confidence, spread_mm } = map;
    Ok(Displaced { transform, labeling, confidence, spread_mm, poses, images: Images::OnVertices, resized: false })
}

/// Checks for cancellation in the displacement of a pair of two subjects: 70 to 74 in four pairs of hippocampi. Other pairs have
/// fewer or more.
const CHECKS_OF_DISPLACEMENT: f64 = 75.0;

/// Says how much of a displacement is done, by the number of checks for cancellation: there is one for each step. The rounds of its energy
/// trace follow those of inference.
struct Counting<'a> {
    observer: &'a dyn Observer,
    /// The share of the match that was done before.
    done_before: f64,
    n_checks: Mutex<u32>,
    /// The last round of inference, which is that of the first fit too; `None` where no energy of labels was minimised before.
    last_round: Option<u32>,
}

/// The share of the time of a displacement that has passed after `share` of its checks. Something has been done before the first
/// one, poses are compared by many cheap steps before later ones have more points, and a displacement of more checks than expected
/// comes to its end ever more slowly.
fn time_share(share: f64) -> f64 {
    const FIRST: f64 = 0.14;
    const EXPONENT: f64 = 2.0;
    const LAST: f64 = 0.9;
    let early = |share: f64| FIRST + (1.0 - FIRST) * share.powf(EXPONENT);
    if share <= LAST {
        return early(share);
    }
    let (reached, slope) = (early(LAST), (1.0 - FIRST) * EXPONENT * LAST.powf(EXPONENT - 1.0));
    1.0 - (1.0 - reached) * (-(share - LAST) * slope / (1.0 - reached)).exp()
}

impl Observer for Counting<'_> {
    fn inner(&self) -> Option<&dyn Observer> {
        Some(self.observer)
    }
    fn trace(&self, point: &TracePoint) {
        // Labels of near isometries have another energy than those of the rounds.
        if self.last_round.is_none() || point.phase != Phase::Inference {
            self.observer.trace(&TracePoint { round: self.last_round.unwrap_or(0) + point.round, ..point.clone() });
        }
    }
    fn is_cancelled(&self) -> bool {
        // Held while it is said, so that what is said never decreases.
        let mut n_checks = self.n_checks.lock().unwrap_or_else(PoisonError::into_inner);
        *n_checks += 1;
        let done = time_share(f64::from(*n_checks) / CHECKS_OF_DISPLACEMENT);
        self.observer.progress(self.done_before + (PROGRESS_AT_END - self.done_before) * done);
        self.observer.is_cancelled()
    }
}

/// The images of a smooth displacement field, from the start that fits best after the deformation. `None` if no field
/// can be fitted.
fn by_field(coarse: &Coarse<'_>, posed: &Posed<'_>, starts: &Starts) -> Result<Option<Displaced>, MatchError> {
    let (scene, source, target) = (&coarse.full, coarse.source, coarse.target);
    let observer = scene.observer;
    let (done_before, last_round) = match posed {
        Posed::Inference { inferred, .. } => (PROGRESS_BEFORE_DISPLACEMENT, inferred.rounds.last().map(|r| r.round)),
        Posed::Registration(_) | Posed::ByField => (PROGRESS_BEFORE_ROUNDS, None),
    };
    let counting = Counting { observer, done_before, n_checks: Mutex::default(), last_round };
    let surfaces = Surfaces {
        source: source.middle.mesh(),
        target: target.middle.mesh(),
        full_source: source.full.mesh(),
        full_target: target.full.mesh(),
        source_closest: &source.full.closest().index,
        target_closest: &scene.closest.index,
        landmarks: &scene.parameters.landmarks,
        open: source.full.is_open || target.full.is_open,
        part: part(&source.full, &target.full),
        lengths: Lengths::of(&source.middle, &target.middle),
        bending: scene.parameters.displacement.bending,
        form_of: &|which| match (scene.parameters.displacement.bending, which) {
            (Bending::None | Bending::Straightened, _) => None,
            (Bending::NearIsometry, Which::Source) => source.middle.form(),
            (Bending::NearIsometry, Which::Target) => target.middle.form(),
        },
    };
    let are_same = sameness(&source.middle, &target.middle);
    let poses: Vec<StartPose> = starts
        .poses
        .iter()
        .map(|start| StartPose {
            pose: start.pose,
            excess: starts.excess(&start.pose, &are_same),
            rotation_of: start.rotation_of,
        })
        .collect();
    let options = DisplacementOptions::default();
    let allow_reflection = scene.parameters.registration.allow_reflection;
    let Some(found) = displace(&surfaces, &poses, allow_reflection, &options, &counting)? else { return Ok(None) };
    let displaced = answered(scene, starts, &found, reliability(&found, &source.full, &target.full));
    observer.progress(PROGRESS_AT_END);
    Ok(Some(displaced))
}

/// The answer of a displacement field, with confidences lowered where `reliability` is low.
fn answered(
    scene: &Scene<'_>,
    starts: &Starts,
    found: &DisplacementAnswer,
    reliability: ReliabilityDocument,
) -> Displaced {
    let trust = if reliability.reliable { 1.0 } else { UNRELIABLE_CONFIDENCE };
    let no_counterpart = without_counterpart(scene.target.mesh(), scene.edge_mm, &found.images);
    let confidence = found
        .images
        .iter()
        .zip(&no_counterpart)
        .map(|(image, &alone)| if alone { 0.0 } else { trust * image.confidence })
        .collect();
    Displaced {
        transform: found.transform,
        labeling: found.images.iter().map(|image| image.label).collect(),
        confidence,
        spread_mm: found.images.iter().map(|image| image.spread_mm).collect(),
        poses: found
            .compared
            .iter()
            .map(|compared| document(scene, &starts.poses, compared, &found.transform))
            .collect(),
        images: Images::Smooth(SmoothImages {
            points: found.images.iter().map(|image| image.closest).collect(),
            moved: found.images.iter().map(|image| image.moved).collect(),
            no_counterpart,
            reliability: Some(reliability),
        }),
        resized: false,
    }
}

/// `labels` of all source vertices as a labeling of the level on which the energy is.
pub(crate) fn labeling_of_energy(source: &Levels, target: &Levels, labels: &[u32]) -> Labeling {
    let (source_level, target_level) = (source.energy(), target.energy());
    let mut labeling = vec![0; source_level.side.mesh().n_vertices()];
    // Of the vertices of a cell one is its site, and the image of that one counts.
    for (i, &k) in source_level.cells.iter().enumerate() {
        if source.full.surface.numbering.original(i as u32) == source_level.side.surface.numbering.original(k) {
            labeling[k as usize] = target_level.cells[labels[i] as usize];
        }
    }
    labeling
}

/// A compared.pose as the result states it.
fn document(scene: &Scene<'_>, starts: &[Start], compared: &ComparedPose, answered: &RigidTransform) -> PoseDocument {
    let (origin, pose) = match &compared.of_form {
        Some(pose) => (PoseOrigin::Form, *pose),
        None => (starts[compared.pose].origin, starts[compared.pose].pose),
    };
    PoseDocument {
        origin,
        matrix: pose.matrix(),
        angle_deg: pose.angle_to(answered).to_degrees(),
        rms_mm: scene.sample_rms_mm(&pose),
        misfit: Some(compared.misfit),
        mirrored: compared.mirrored,
    }
}
