//! An image on the target for every source vertex.

use crate::energy::inference::InferenceOutcome;
use crate::surface::levels::Levels;
use homolog_contract::result::{PoseDocument, ReliabilityDocument};
use homolog_mesh::ClosestPoint;
use homolog_mrf::Labeling;
use homolog_registration::RigidTransform;
use nalgebra::Point3;

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
    /// Whether the answer can be relied on; `None` where no smooth displacement field could be fitted to say so.
    pub reliability: Option<ReliabilityDocument>,
    /// Whether the source was scaled to the area of the target.
    pub resized: bool,
    /// What the energy of near isometries says of this answer, where it was minimized.
    pub inference: Option<InferenceOutcome>,
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
