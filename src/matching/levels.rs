//! The levels of a match: the surfaces as they came, those that a field is fitted on, those whose labels the energy has.

use super::parameters::MatchParameters;
use super::prepare::Side;
use crate::mesh::SurfaceMesh;
use std::sync::Arc;

/// Above so many vertices a field is fitted on a level of [`MIDDLE_VERTICES`]. The field has about forty functions;
/// more vertices than these tell it nothing that an anatomy of 1 mm voxels holds.
const MIDDLE_ABOVE: usize = 5000;
const MIDDLE_VERTICES: usize = 3000;

/// One surface on its levels.
pub(super) struct Levels {
    /// As it came, in canonical numbering.
    pub full: Arc<Side>,
    /// What a displacement field is fitted on.
    pub middle: Arc<Side>,
    /// What the energy is minimised on.
    pub energy: Arc<Side>,
    /// For every vertex of `full` the vertex of `energy` in whose cell it lies.
    pub cells: Vec<u32>,
}

impl Levels {
    pub fn new(mesh: &SurfaceMesh, parameters: &MatchParameters) -> Self {
        let full = Arc::new(Side::new(mesh));
        let n = full.mesh().n_vertices();
        let mut cells: Vec<u32> = (0..n as u32).collect();
        let coarse = parameters.inference.coarse_vertices;
        // What asks for no coarse level gets none: the energy of all vertices stays that.
        let wanted = coarse.is_some() && n > MIDDLE_ABOVE;
        let middle = match wanted.then(|| Side::coarser(&full, MIDDLE_VERTICES, false)).flatten() {
            Some((side, of_full)) => {
                cells = of_full;
                Arc::new(side)
            }
            None => Arc::clone(&full),
        };
        let energy = match coarse.and_then(|n_sites| Side::coarser(&middle, n_sites as usize, true)) {
            Some((side, of_middle)) => {
                cells.iter_mut().for_each(|k| *k = of_middle[*k as usize]);
                Arc::new(side)
            }
            None => Arc::clone(&middle),
        };
        Levels { full, middle, energy, cells }
    }

    /// Whether the energy is that of all vertices.
    pub fn is_direct(&self) -> bool {
        Arc::ptr_eq(&self.full, &self.energy)
    }
}
