//! An image on the target for every source vertex.

use crate::energy::inference::InferenceOutcome;
use crate::surface::levels::Levels;
use homolog_contract::result::{PoseDocument, ReliabilityDocument};
use homolog_mesh::ClosestPoint;
use homolog_mrf::Labeling;
use homolog_registration::RigidTransform;
use nalgebra::Point3;

/// The images of all vertices of the source as given, the result of the third stage, in canonical numbering.
pub(crate) struct VertexImages {
    /// The rigid transform.
    pub transform: RigidTransform,
    /// The target vertex of each source vertex.
    pub labeling: Labeling,
    /// The confidence of each label.
    pub confidence: Vec<f64>,
    /// Expected distance of each image from the true image, mm.
    pub spread_mm: Vec<f64>,
    /// Poses that were compared.
    pub poses: Vec<PoseDocument>,
    pub images: Images,
    /// Whether the answer can be relied on; `None` if no displacement field was fitted.
    pub reliability: Option<ReliabilityDocument>,
    /// Whether the source was scaled to the area of the target.
    pub resized: bool,
    /// Outcome of inference over near isometries for this answer, if it took part.
    pub inference: Option<InferenceOutcome>,
}

impl VertexImages {
    /// Converts this answer for `levels`, the source at another size with the same vertex numbering, to an answer for
    /// the source. `rigid` converts a transform of the resized source to one of the source.
    pub(crate) fn of_original(
        mut self,
        levels: &Levels,
        rigid: impl Fn(&RigidTransform) -> RigidTransform,
    ) -> VertexImages {
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

/// The images of the source vertices.
pub(crate) enum Images {
    /// On the vertices of the target in `labeling`; the source is moved by the transform alone.
    OnVertices,
    /// At the closest points to the source moved by a displacement field.
    Smooth(SmoothImages),
}

/// Images by a displacement field.
pub(crate) struct SmoothImages {
    /// The point of the target closest to each moved source vertex.
    pub points: Vec<ClosestPoint>,
    /// Each moved source vertex, mm.
    pub moved: Vec<Point3<f64>>,
    /// Whether the target has no surface at each moved source vertex.
    pub no_counterpart: Vec<bool>,
}

/// `labels` of all source vertices as a labeling of the level of the energy.
pub(crate) fn labeling_of_energy(source: &Levels, target: &Levels, labels: &[u32]) -> Labeling {
    let (source_level, target_level) = (source.energy(), target.energy());
    let mut labeling = vec![0; source_level.side.mesh().n_vertices()];
    // One vertex of each cell is its site; its image is the label of the cell.
    for (i, &k) in source_level.cells.iter().enumerate() {
        if source.full.surface.numbering.original(i as u32) == source_level.side.surface.numbering.original(k) {
            labeling[k as usize] = target_level.cells[labels[i] as usize];
        }
    }
    labeling
}
