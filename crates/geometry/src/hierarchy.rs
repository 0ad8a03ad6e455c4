//! Coarse levels of a surface: fewer vertices, each representing a cell of the finer surface.
//!
//! Sites cover the surface evenly ([`farthest_points`]). Every vertex belongs to the cell of its nearest site along
//! edges. A coarse triangle joins three cells that meet in a face. With enough sites the result is a discrete version
//! of the intrinsic Delaunay triangulation: closed where the surface is closed, with edges of nearly equal length, as
//! an energy on edges needs. Decimation by quadrics would place its vertices where the surface bends and leave long
//! triangles elsewhere.
//!
//! Sources: Peyré, Cohen, "Geodesic remeshing using front propagation", IJCV 69(1), 2006; Dijkstra 1959.

use homolog_mesh::{FaceArity, SurfaceMesh};
use homolog_primitives::graph::EdgeGraph;
use homolog_primitives::observe::{Cancelled, Observer, Silent, checkpoint_within};
use homolog_primitives::points::farthest_points;
use nalgebra::Point3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Candidate vertices per site; limits the time on the finest surfaces.
const CANDIDATES_PER_SITE: usize = 16;
/// Largest number of rounds; each drops sites whose cell has no corner and recomputes the cells.
const ROUNDS: usize = 32;
/// Vertices that are taken from the front between two checks for cancellation, about a millisecond.
const AT_ONCE: usize = 4096;

/// A coarse level, with the maps to and from the finer surface.
#[derive(Debug, Clone, PartialEq)]
pub struct CoarseSurface {
    /// Triangles over the sites.
    pub mesh: SurfaceMesh,
    /// For every coarse vertex its index on the finer surface; ascending.
    pub sites: Vec<u32>,
    /// For every finer vertex the coarse vertex of its cell.
    pub cells: Vec<u32>,
}

/// A coarse version of `mesh` with about `n_sites` of its vertices. `None` if `mesh` has no more than `n_sites`
/// vertices, or if the cells form no surface. `mesh` must be in canonical numbering (see
/// [`homolog_mesh::canonicalize`]).
///
/// # Cost
/// `O(n log n + n_sites²)`.
pub fn coarsen(mesh: &SurfaceMesh, n_sites: usize) -> Option<CoarseSurface> {
    coarsen_observed(mesh, n_sites, &Silent).unwrap_or(None)
}

/// [`coarsen`], which stops when `observer` asks.
///
/// # Errors
/// [`Cancelled`]; the observer is asked after every few thousand vertices.
pub fn coarsen_observed(
    mesh: &SurfaceMesh,
    n_sites: usize,
    observer: &dyn Observer,
) -> Result<Option<CoarseSurface>, Cancelled> {
    let n = mesh.n_vertices();
    if n <= n_sites || n_sites < 4 {
        return Ok(None);
    }
    let graph = mesh.edge_graph();
    // Canonical numbering follows a curve through space, so every k-th vertex is an even sample.
    let step = (n / (CANDIDATES_PER_SITE * n_sites)).max(1);
    let candidates: Vec<Point3<f64>> = mesh.vertices().iter().step_by(step).copied().collect();
    let mut sites: Vec<u32> = farthest_points(&candidates, n_sites).iter().map(|&k| (k * step) as u32).collect();
    sites.sort_unstable();
    for _ in 0..ROUNDS {
        let cells = cells(mesh, &graph, &sites, observer)?;
        let triangles = coarse_triangles(mesh, &cells);
        let mut used = vec![false; sites.len()];
        triangles.iter().flatten().for_each(|&k| used[k as usize] = true);
        if used.iter().all(|&u| u) {
            let vertices = sites.iter().map(|&k| mesh.vertices()[k as usize]).collect();
            let mesh = SurfaceMesh::new(vertices, FaceArity::Triangle, triangles.concat());
            return Ok(mesh.ok().map(|mesh| CoarseSurface { mesh, sites, cells }));
        }
        sites = sites.iter().zip(&used).filter(|(_, u)| **u).map(|(&s, _)| s).collect();
    }
    Ok(None)
}

/// For every vertex the index of its nearest site along edges; ties go to the lowest index. Vertices of a piece without
/// a site get the nearest site through space.
fn cells(mesh: &SurfaceMesh, graph: &EdgeGraph, sites: &[u32], observer: &dyn Observer) -> Result<Vec<u32>, Cancelled> {
    let v = mesh.vertices();
    let mut cell = vec![u32::MAX; v.len()];
    // Non-negative lengths compare like their bit patterns.
    let mut front: BinaryHeap<Reverse<(u64, u32, u32)>> =
        sites.iter().enumerate().map(|(k, &s)| Reverse((0, k as u32, s))).collect();
    // The shortest known path to each vertex and its site, so that only improvements enter the queue.
    let mut nearest = vec![(u64::MAX, u32::MAX); v.len()];
    let mut n_popped = 0usize;
    while let Some(Reverse((length, k, i))) = front.pop() {
        n_popped += 1;
        if n_popped.is_multiple_of(AT_ONCE) {
            checkpoint_within(observer)?;
        }
        if cell[i as usize] != u32::MAX {
            continue;
        }
        cell[i as usize] = k;
        let length = f64::from_bits(length);
        for &j in graph.neighbors(i as usize) {
            if cell[j as usize] == u32::MAX {
                let next = ((length + (v[i as usize] - v[j as usize]).norm()).to_bits(), k);
                if next < nearest[j as usize] {
                    nearest[j as usize] = next;
                    front.push(Reverse((next.0, k, j)));
                }
            }
        }
    }
    for (p, k) in v.iter().zip(&mut cell).filter(|(_, k)| **k == u32::MAX) {
        checkpoint_within(observer)?;
        let distances = sites.iter().map(|&s| (v[s as usize] - p).norm_squared());
        let nearest = distances.zip(0..).min_by(|a, b| a.0.total_cmp(&b.0));
        *k = nearest.map_or(0, |(_, k)| k);
    }
    Ok(cell)
}

/// The triples of cells that meet in a face, oriented like the face, each once, ascending. Pairs of triangles with the
/// same corners and opposite orientation are folds without an inside and are left out.
fn coarse_triangles(mesh: &SurfaceMesh, cells: &[u32]) -> Vec<[u32; 3]> {
    let mut found: Vec<[u32; 3]> = mesh
        .triangles()
        .iter()
        .map(|t| t.map(|i| cells[i as usize]))
        .filter(|[a, b, c]| a != b && b != c && c != a)
        .map(|mut t| {
            let first = (0..3).min_by_key(|&k| t[k]).unwrap_or(0);
            t.rotate_left(first);
            t
        })
        .collect();
    found.sort_unstable();
    found.dedup();
    let folded = |t: &[u32; 3]| found.binary_search(&[t[0], t[2], t[1]]).is_ok();
    found.iter().copied().filter(|t| !folded(t)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::canonicalize;
    use homolog_mesh::shapes::{ellipsoid, torus};
    use homolog_mesh::topology::topology_report;
    use nalgebra::Vector3;

    #[test]
    fn a_closed_surface_of_genus_0_stays_one() {
        let fine = canonicalize(&ellipsoid(Vector3::new(18.0, 8.0, 6.0), 5)).mesh;
        for n_sites in [100, 400, 1500] {
            let coarse = coarsen(&fine, n_sites).unwrap();
            let report = topology_report(&coarse.mesh);
            assert_eq!(
                (report.n_boundary_edges, report.n_nonmanifold_edges, report.genus),
                (0, 0, Some(0)),
                "{n_sites}"
            );
            assert_eq!(coarse.mesh.n_vertices(), n_sites);
            assert!((coarse.mesh.area() / fine.area() - 1.0).abs() < 0.08, "{}", coarse.mesh.area() / fine.area());
            assert!(coarse.mesh.signed_volume() > 0.0);
        }
    }

    #[test]
    fn a_quad_torus_stays_a_torus() {
        let fine = canonicalize(&torus(10.0, 4.0, 90, 45, FaceArity::Quad)).mesh;
        let report = topology_report(&coarsen(&fine, 600).unwrap().mesh);
        assert_eq!((report.n_boundary_edges, report.genus), (0, Some(1)));
    }

    #[test]
    fn sites_and_cells_are_inverse_maps() {
        let fine = canonicalize(&ellipsoid(Vector3::new(9.0, 6.0, 4.0), 4)).mesh;
        let coarse = coarsen(&fine, 300).unwrap();
        for (k, &site) in coarse.sites.iter().enumerate() {
            assert_eq!(coarse.cells[site as usize] as usize, k);
            assert_eq!(coarse.mesh.vertices()[k], fine.vertices()[site as usize]);
        }
        // A vertex lies near the site of its cell: within twice the mean distance of neighboring sites.
        let edge = coarse.mesh.mean_edge_length();
        for (p, &k) in fine.vertices().iter().zip(&coarse.cells) {
            assert!((p - coarse.mesh.vertices()[k as usize]).norm() < 2.0 * edge);
        }
    }

    #[test]
    fn every_vertex_is_in_the_cell_of_the_site_that_is_nearest_along_edges() {
        for fine in [ellipsoid(Vector3::new(9.0, 6.0, 4.0), 3), torus(10.0, 4.0, 24, 12, FaceArity::Quad)] {
            let (fine, graph) = (canonicalize(&fine).mesh, canonicalize(&fine).mesh.edge_graph());
            let sites: Vec<u32> = (0..fine.n_vertices() as u32).step_by(23).collect();
            let found = cells(&fine, &graph, &sites, &Silent).unwrap();
            assert_eq!(found, cells_by_relaxation(&fine, &graph, &sites));
        }
    }

    /// Bellman-Ford: every edge is relaxed until nothing becomes shorter.
    fn cells_by_relaxation(mesh: &SurfaceMesh, graph: &EdgeGraph, sites: &[u32]) -> Vec<u32> {
        let v = mesh.vertices();
        let mut best = vec![(f64::INFINITY, u32::MAX); v.len()];
        sites.iter().enumerate().for_each(|(k, &s)| best[s as usize] = (0.0, k as u32));
        loop {
            let before = best.clone();
            for i in 0..v.len() {
                for &j in graph.neighbors(i) {
                    let way = (best[i].0 + (v[i] - v[j as usize]).norm(), best[i].1);
                    if way < best[j as usize] {
                        best[j as usize] = way;
                    }
                }
            }
            if best == before {
                return best.into_iter().map(|(_, k)| k).collect();
            }
        }
    }

    #[test]
    fn a_surface_with_fewer_vertices_than_sites_has_no_coarse_level() {
        let fine = canonicalize(&ellipsoid(Vector3::new(9.0, 6.0, 4.0), 2)).mesh;
        assert_eq!(coarsen(&fine, fine.n_vertices()), None);
        assert_eq!(coarsen(&fine, 3), None);
    }
}
