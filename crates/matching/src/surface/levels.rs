//! The levels of a surface: all vertices, the vertices that a displacement field is fitted on, and those of the energy.

use super::form::BendingInvariantForm;
use super::side::SurfaceLevel;
use super::sites::Sites;
use homolog_mesh::{Numbering, SurfaceMesh};
use homolog_primitives::observe::{Cancelled, Observer, Silent};
use std::sync::{Arc, OnceLock};

/// Number of vertices above which a field is fitted on a level of [`MIDDLE_VERTICES`]. The field has about forty
/// functions, which more vertices do not determine better for structures of 1 mm voxels.
const MIDDLE_ABOVE: usize = 5000;
const MIDDLE_VERTICES: usize = 3000;

/// The levels of one surface, with all values that do not depend on the other surface. Can be kept for further matches.
pub struct Levels {
    /// All vertices, in canonical numbering.
    pub(crate) full: Arc<SurfaceLevel>,
    /// The level on which a displacement field is fitted.
    pub(crate) middle: Arc<SurfaceLevel>,
    /// For every vertex of `full` the vertex of `middle` whose cell contains it.
    cells_of_middle: Vec<u32>,
    /// Number of vertices of the level on which an energy is minimized; `None`: all.
    coarse_vertices: Option<u32>,
    energy: OnceLock<EnergyLevel>,
}

/// The level on which an energy is minimized.
pub(crate) struct EnergyLevel {
    pub side: Arc<SurfaceLevel>,
    /// For every vertex of the full surface the vertex of this level whose cell contains it.
    pub cells: Vec<u32>,
}

impl Levels {
    /// The levels of `mesh` for a match with this `inference.coarse_vertices`.
    ///
    /// # Cost
    /// As [`Levels::numbered`].
    pub fn new(mesh: &SurfaceMesh, coarse_vertices: Option<u32>) -> Self {
        Levels::numbered(mesh, &Numbering::identity(mesh.n_vertices()), coarse_vertices)
    }

    /// The levels of `mesh`, whose vertices the outcome names by their originals in `numbering`.
    ///
    /// # Cost
    /// `O(n log n)`, and `O(n · 3000)` above 5,000 vertices, on one thread.
    pub fn numbered(mesh: &SurfaceMesh, numbering: &Numbering, coarse_vertices: Option<u32>) -> Self {
        match Levels::observed(mesh, numbering, coarse_vertices, &Silent) {
            Ok(levels) => levels,
            Err(Cancelled) => unreachable!("nobody asks to stop"),
        }
    }

    /// [`Levels::numbered`], which stops when `observer` asks.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn observed(
        mesh: &SurfaceMesh,
        numbering: &Numbering,
        coarse_vertices: Option<u32>,
        observer: &dyn Observer,
    ) -> Result<Self, Cancelled> {
        let full = Arc::new(SurfaceLevel::numbered(mesh, numbering));
        let n = full.mesh().n_vertices();
        let mut cells: Vec<u32> = (0..n as u32).collect();
        // Without a coarse level the energy has all vertices as variables, so there is no middle level either.
        let wanted = coarse_vertices.is_some() && n > MIDDLE_ABOVE;
        let coarser = if wanted { SurfaceLevel::coarser(&full, MIDDLE_VERTICES, false, observer)? } else { None };
        let middle = match coarser {
            Some((side, of_full)) => {
                cells = of_full;
                Arc::new(side)
            }
            None => Arc::clone(&full),
        };
        Ok(Levels { full, middle, cells_of_middle: cells, coarse_vertices, energy: OnceLock::new() })
    }

    /// Number of vertices on which features of a surface of `n` vertices are measured.
    pub(crate) fn n_measured(n: usize, coarse_vertices: Option<u32>) -> usize {
        if coarse_vertices.is_some() && n > MIDDLE_ABOVE { MIDDLE_VERTICES } else { n }
    }

    /// The vertex of the middle level whose cell contains `vertex`.
    pub(crate) fn middle_of(&self, vertex: u32) -> u32 {
        self.cells_of_middle[vertex as usize]
    }

    /// The vertex of the full surface at every vertex of the middle level. Cost `O(n)`.
    pub(crate) fn full_of_middle(&self) -> Vec<u32> {
        let mut found = vec![0; self.middle.mesh().n_vertices()];
        for (vertex, &cell) in self.cells_of_middle.iter().enumerate() {
            let (full, middle) = (&self.full.surface.numbering, &self.middle.surface.numbering);
            if full.original(vertex as u32) == middle.original(cell) {
                found[cell as usize] = vertex as u32;
            }
        }
        found
    }

    /// The level on which an energy is minimized, built on first use.
    pub(crate) fn energy(&self) -> &EnergyLevel {
        match self.energy_observed(&Silent) {
            Ok(level) => level,
            Err(Cancelled) => unreachable!("nobody asks to stop"),
        }
    }

    /// [`Levels::energy`], which stops when `observer` asks.
    ///
    /// # Errors
    /// [`Cancelled`]; a later call makes the level.
    pub(crate) fn energy_observed(&self, observer: &dyn Observer) -> Result<&EnergyLevel, Cancelled> {
        if let Some(level) = self.energy.get() {
            return Ok(level);
        }
        let n_sites = self.coarse_vertices.map(|n| n as usize);
        let coarser = match n_sites {
            Some(n_sites) => SurfaceLevel::coarser(&self.middle, n_sites, true, observer)?,
            None => None,
        };
        // Of two matches that make it at the same time, both make the same.
        Ok(self.energy.get_or_init(|| match coarser {
            Some((side, of_middle)) => {
                let cells = self.cells_of_middle.iter().map(|&k| of_middle[k as usize]).collect();
                EnergyLevel { side: Arc::new(side), cells }
            }
            None => EnergyLevel { side: Arc::clone(&self.middle), cells: self.cells_of_middle.clone() },
        }))
    }

    /// The surface whose vertices are the variables or labels of the energy, mm.
    pub fn energy_mesh(&self) -> &SurfaceMesh {
        self.energy().side.mesh()
    }

    /// Whether the energy is over all vertices.
    pub(crate) fn is_direct(&self) -> bool {
        Arc::ptr_eq(&self.full, &self.energy().side)
    }

    /// Memory of the levels, bytes, including all parts that matches compute on first use: an upper bound.
    pub fn heap_bytes(&self) -> usize {
        let middle = if Arc::ptr_eq(&self.middle, &self.full) { 0 } else { self.middle.heap_bytes() };
        let n = self.middle.mesh().n_vertices();
        // Memory of a vertex of the finer level and of its site number, times 1.5: a coarse level has triangles where
        // the finer one may have quads, and more of them around tunnels.
        let of_sites =
            |n_sites: u32| 3 * (self.middle.heap_bytes() / n.max(1) + size_of::<u32>()) * n.min(n_sites as usize) / 2;
        let energy = self.coarse_vertices.map_or(0, of_sites);
        let cells = 2 * size_of_val(self.cells_of_middle.as_slice());
        let once = BendingInvariantForm::heap_bytes_over(n) + Sites::heap_bytes_over(n);
        self.full.heap_bytes() + middle + energy + once + cells
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::surface_index::SurfaceIndex;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Vector3;

    #[test]
    fn the_level_of_the_energy_is_counted_before_it_is_made() {
        for (level, coarse) in [(3, 100), (4, 300), (5, 700)] {
            let levels = Levels::new(&ellipsoid(Vector3::new(18.0, 8.0, 6.0), level), Some(coarse));
            let without = Levels { coarse_vertices: None, ..Levels::new(levels.full.mesh(), Some(coarse)) };
            let (made, counted) = (levels.energy().side.heap_bytes(), levels.heap_bytes() - without.heap_bytes());
            assert!(made <= counted && counted < 2 * made, "{made} bytes of {counted} counted");
        }
    }

    #[test]
    fn the_counted_memory_bounds_that_of_every_tree_of_closest_points() {
        for (level, coarse) in [(3, None), (4, Some(300)), (5, Some(700))] {
            let mesh = ellipsoid(Vector3::new(18.0, 8.0, 6.0), level);
            let levels = Levels::new(&mesh, coarse);
            for side in [&levels.full, &levels.middle, &levels.energy().side] {
                for (index, mesh) in [(side.closest(), side.mesh()), (&side.light().closest, &side.light().mesh)] {
                    let (made, counted) = (index.heap_bytes(), SurfaceIndex::heap_bytes_over(mesh));
                    assert!(made <= counted && 10 * counted < 15 * made, "{made} bytes of {counted} counted");
                }
            }
        }
    }
}
