//! The levels of a surface: all vertices, those that a displacement field is fitted on, and those of the energy.

use super::displacement::Form;
use super::side::Side;
use homolog_mesh::{Numbering, SurfaceMesh};
use std::sync::Arc;

/// Above this number of vertices a field is fitted on a level of [`MIDDLE_VERTICES`]. The field has about forty functions,
/// which more vertices do not determine better for structures of 1 mm voxels.
const MIDDLE_ABOVE: usize = 5000;
const MIDDLE_VERTICES: usize = 3000;

/// One surface on its levels, with all that does not depend on what it is matched with. Can be kept for further matches.
pub struct Levels {
    /// All vertices, in canonical numbering.
    pub(super) full: Arc<Side>,
    /// The level that a displacement field is fitted on.
    pub(super) middle: Arc<Side>,
    /// The level that the energy is minimised on.
    pub(super) energy: Arc<Side>,
    /// For every vertex of `full` the vertex of `energy` in whose cell it lies.
    pub(super) cells: Vec<u32>,
}

impl Levels {
    /// The levels of `mesh` for a match whose parameters have this `inference.coarse_vertices`.
    ///
    /// # Cost
    /// As [`Levels::numbered`].
    pub fn new(mesh: &SurfaceMesh, coarse_vertices: Option<u32>) -> Self {
        Levels::numbered(mesh, &Numbering::identity(mesh.n_vertices()), coarse_vertices)
    }

    /// The same; answers name a vertex of `mesh` by its original in `numbering`.
    ///
    /// # Cost
    /// `O(n log n)`, and `O(n · 3000)` above 5,000 vertices, on one thread.
    pub fn numbered(mesh: &SurfaceMesh, numbering: &Numbering, coarse_vertices: Option<u32>) -> Self {
        let full = Arc::new(Side::numbered(mesh, numbering));
        let n = full.mesh().n_vertices();
        let mut cells: Vec<u32> = (0..n as u32).collect();
        // Without a coarse level of the energy there is no middle one either: the energy is that of all vertices.
        let wanted = coarse_vertices.is_some() && n > MIDDLE_ABOVE;
        let middle = match wanted.then(|| Side::coarser(&full, MIDDLE_VERTICES, false)).flatten() {
            Some((side, of_full)) => {
                cells = of_full;
                Arc::new(side)
            }
            None => Arc::clone(&full),
        };
        let energy = match coarse_vertices.and_then(|n_sites| Side::coarser(&middle, n_sites as usize, true)) {
            Some((side, of_middle)) => {
                cells.iter_mut().for_each(|k| *k = of_middle[*k as usize]);
                Arc::new(side)
            }
            None => Arc::clone(&middle),
        };
        Levels { full, middle, energy, cells }
    }

    /// The surface on whose vertices the energy is, mm.
    pub fn energy_mesh(&self) -> &SurfaceMesh {
        self.energy.mesh()
    }

    /// Whether the energy is that of all vertices.
    pub(super) fn is_direct(&self) -> bool {
        Arc::ptr_eq(&self.full, &self.energy)
    }

    /// Memory of the levels, bytes, with all parts that matches compute on first use: an upper bound.
    pub fn heap_bytes(&self) -> usize {
        let middle = if Arc::ptr_eq(&self.middle, &self.full) { 0 } else { self.middle.heap_bytes() };
        let energy = if Arc::ptr_eq(&self.energy, &self.middle) { 0 } else { self.energy.heap_bytes() };
        let form = Form::heap_bytes_over(self.middle.mesh().n_vertices());
        self.full.heap_bytes() + middle + energy + form + size_of_val(self.cells.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface_index::SurfaceIndex;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Vector3;

    #[test]
    fn the_counted_memory_bounds_that_of_every_tree_of_closest_points() {
        for (level, coarse) in [(3, None), (4, Some(300)), (5, Some(700))] {
            let mesh = ellipsoid(Vector3::new(18.0, 8.0, 6.0), level);
            let levels = Levels::new(&mesh, coarse);
            for side in [&levels.full, &levels.middle, &levels.energy] {
                for (index, mesh) in [(side.closest(), side.mesh()), (&side.light().closest, &side.light().mesh)] {
                    let (made, counted) = (index.heap_bytes(), SurfaceIndex::heap_bytes_over(mesh));
                    assert!(made <= counted && 10 * counted < 15 * made, "{made} bytes of {counted} counted");
                }
            }
        }
    }
}
