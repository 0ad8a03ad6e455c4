//! Faces side by side that share no vertices: corners that differ by rounding are joined. If the faces still do not
//! hold together, the surface is a soup and is refused.

use homolog_mesh::repair::{RepairedMesh, WeldReport, weld_boundary};
use homolog_mesh::topology::{SurfaceFault, TopologyReport, topology_report};
use homolog_mesh::{MeshError, SurfaceMesh};

/// Distance, as a share of the median edge, below which boundary vertices are joined: far below the detail of any
/// surface, above the rounding of programs that write few digits.
const NEAR: f64 = 0.01;
/// Distance, in tolerances, below which vertices left on the boundaries of a soup show that it was joined only in part.
const LEFT_NEAR: f64 = 8.0;
/// Faces per piece below which a surface is a soup. Closed pieces are exempt: a tetrahedron has four faces but no
/// boundary.
const FACES_OF_A_PIECE: u32 = 8;

/// Result of [`weld_near`].
pub(super) struct Joined {
    pub welded: RepairedMesh,
    /// A sentence on the repair.
    pub detail: String,
    /// Whether corners slightly farther apart remain, so that the surface has holes that the soup did not have.
    pub in_part: bool,
}

/// `mesh` with boundary vertices joined that lie within [`NEAR`] median edges of each other; `None` if that closes no
/// boundary.
///
/// # Errors
/// [`MeshError::Empty`] if no face is left.
///
/// # Cost
/// `O(n log n)`.
pub(super) fn weld_near(mesh: &SurfaceMesh) -> Result<Option<Joined>, MeshError> {
    let before = topology_report(mesh);
    if before.n_boundary_edges == 0 {
        return Ok(None);
    }
    let tolerance_mm = NEAR * median_edge(mesh);
    let (welded, found) = weld_boundary(mesh, tolerance_mm)?;
    let WeldReport { n_merged, n_collapsed, largest_mm, n_degenerate, n_duplicate } = found;
    let after = topology_report(&welded.mesh);
    // A short edge is detail, not a seam.
    if n_merged == n_collapsed || after.n_boundary_edges >= before.n_boundary_edges {
        return Ok(None);
    }
    let detail = format!(
        "{n_merged} of {} vertices joined to another at most {largest_mm:.3e} mm away, where neighboring faces did not share \
         them (tolerance {tolerance_mm:.3e} mm, 1 % of the median edge); edges with one face: {} before, {} after; {} faces \
         dropped",
        before.n_vertices,
        before.n_boundary_edges,
        after.n_boundary_edges,
        n_degenerate + n_duplicate
    );
    let in_part = soup(&before).is_some()
        && after.n_boundary_edges > 0
        && weld_boundary(&welded.mesh, LEFT_NEAR * tolerance_mm)?.1.n_merged > 0;
    Ok(Some(Joined { welded, detail, in_part }))
}

/// The median length of all edges of all faces, mm.
fn median_edge(mesh: &SurfaceMesh) -> f64 {
    let v = mesh.vertices();
    let edges = mesh.faces().flat_map(|face| (0..face.len()).map(move |k| (face[k], face[(k + 1) % face.len()])));
    let mut lengths: Vec<f64> = edges.map(|(a, b)| (v[a as usize] - v[b as usize]).norm()).collect();
    let middle = lengths.len() / 2;
    let (_, median, _) = lengths.select_nth_unstable_by(middle, f64::total_cmp);
    *median
}

/// The fault of a surface whose faces mostly share no edges.
pub(super) fn soup(report: &TopologyReport) -> Option<SurfaceFault> {
    let TopologyReport { n_faces, n_edges, n_boundary_edges, n_components, .. } = *report;
    let is_loose = n_boundary_edges > n_edges / 2 && n_components >= FACES_OF_A_PIECE;
    let is_soup = is_loose && n_faces < n_components.saturating_mul(FACES_OF_A_PIECE);
    is_soup.then(|| soup_fault(report))
}

/// The fault of a surface whose faces do not hold together.
pub(super) fn soup_fault(report: &TopologyReport) -> SurfaceFault {
    let TopologyReport { n_faces, n_components, n_boundary_edges, .. } = *report;
    SurfaceFault::Soup { n_faces, n_components, n_edges: n_boundary_edges }
}
