//! Converts the images of a displacement field to an answer.

use super::displaced::{Images, SmoothImages, VertexImages};
use super::displacement::DisplacementAnswer;
use super::reliability::without_counterpart;
use crate::pair::scene::Scene;
use crate::poses::compared::{ComparedPose, Origin};
use crate::starts::candidates::Start;
use homolog_contract::result::{PoseDocument, PoseOrigin, ReliabilityDocument, confidence_factor};

/// The answer of a displacement field; confidences are lowered if `reliability` is low.
pub(crate) fn answered(
    scene: &Scene<'_>,
    starts: &[Start],
    found: &DisplacementAnswer,
    reliability: ReliabilityDocument,
) -> VertexImages {
    let n_as_good = found.compared[1..].iter().filter(|other| other.is_as_good_as(&found.compared[0])).count();
    let factor = confidence_factor(&reliability.reasons, n_as_good);
    let no_counterpart = without_counterpart(scene.target.mesh(), scene.edge_mm, &found.images);
    let confidence = found
        .images
        .iter()
        .zip(&no_counterpart)
        .map(|(image, &alone)| if alone { 0.0 } else { factor * image.confidence })
        .collect();
    VertexImages {
        transform: found.transform,
        labeling: found.images.iter().map(|image| image.label).collect(),
        confidence,
        spread_mm: found.images.iter().map(|image| image.spread_mm).collect(),
        poses: found.compared.iter().map(|compared| document(scene, starts, compared, found)).collect(),
        images: Images::Smooth(SmoothImages {
            points: found.images.iter().map(|image| image.closest).collect(),
            moved: found.images.iter().map(|image| image.moved).collect(),
            no_counterpart,
        }),
        reliability: Some(reliability),
        resized: false,
        inference: None,
    }
}

/// Converts a compared pose to its result document.
fn document(scene: &Scene<'_>, starts: &[Start], compared: &ComparedPose, found: &DisplacementAnswer) -> PoseDocument {
    let (origin, pose) = match compared.origin {
        Origin::Pose(k) => (starts[k].origin, starts[k].pose),
        Origin::Symmetric(k, pose) => (starts[k].origin, pose),
        Origin::Bent(pose) => (PoseOrigin::Form, pose),
    };
    PoseDocument {
        origin,
        matrix: pose.matrix(),
        angle_deg: pose.angle_to(&found.transform).to_degrees(),
        rms_mm: scene.sample_rms_mm(&pose),
        misfit: Some(compared.misfit),
        mirrored: compared.mirrored,
        as_good: compared.is_as_good_as(&found.compared[0]),
    }
}
