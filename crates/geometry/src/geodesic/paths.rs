//! Shortest paths from a few sites to all vertices: along edges and across the two triangles of an edge.
//!
//! On even meshes they exceed the geodesic distance by a few percent at most, and cost much less than the exact
//! distances of `local.rs`, which serve neighborhoods. Source: Dijkstra 1959.

use homolog_mesh::SurfaceMesh;
use multiversion::multiversion;
use rayon::prelude::*;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

/// For each of `sites` the distances to all vertices of `mesh`, mm; Euclidean between pieces that no path joins.
///
/// # Cost
/// `O(sites · n log n)`, on all threads; any number of threads gives the same bits.
pub fn distances_from(mesh: &SurfaceMesh, sites: &[u32]) -> Vec<Vec<f64>> {
    let paths = Paths::new(mesh);
    let v = mesh.vertices();
    sites
        .par_iter()
        .map(|&from| {
            let mut row = paths.from(from as usize);
            for (d, p) in row.iter_mut().zip(v) {
                if !d.is_finite() {
                    *d = (p - v[from as usize]).norm();
                }
            }
            row
        })
        .collect()
}

/// Number of sources whose distances are relaxed side by side.
const LANES: usize = 64;

/// Distances between all vertices of `mesh` along its surface, mm, `n × n` and symmetric; Euclidean between pieces that
/// no path joins. For meshes of some hundred vertices: distances from many sources are relaxed side by side along every
/// edge, back and forth through the vertices, until none decreases.
///
/// # Cost
/// `O(n² · degree)` per sweep, and about ten sweeps if vertices that are close in space have close indices; memory `8
/// n²` bytes. On one thread.
pub fn distances_among(mesh: &SurfaceMesh) -> Vec<f32> {
    let (paths, v) = (Paths::new(mesh), mesh.vertices());
    let n = v.len();
    let mut by_source: Vec<Vec<[f32; LANES]>> = (0..n.div_ceil(LANES))
        .map(|block| {
            let mut distances = vec![[f32::INFINITY; LANES]; n];
            for lane in 0..LANES.min(n - block * LANES) {
                distances[block * LANES + lane][lane] = 0.0;
            }
            while relax(&paths, &mut distances, false) | relax(&paths, &mut distances, true) {}
            distances
        })
        .collect();
    for (block, distances) in by_source.iter_mut().enumerate() {
        for (i, row) in distances.iter_mut().enumerate() {
            for (lane, d) in row.iter_mut().enumerate().filter(|(_, d)| !d.is_finite()) {
                if let Some(source) = v.get(block * LANES + lane) {
                    *d = (v[i] - source).norm() as f32;
                }
            }
        }
    }
    let at = |i: usize, j: usize| by_source[j / LANES][i][j % LANES];
    // Sums along a path in its two directions differ by rounding.
    (0..n * n).map(|k| at(k / n, k % n).min(at(k % n, k / n))).collect()
}

/// Edges of a mesh, and the straight lines across the two unfolded triangles of an edge.
struct Paths {
    offsets: Vec<usize>,
    steps: Vec<(u32, f64)>,
}

impl Paths {
    fn new(mesh: &SurfaceMesh) -> Self {
        let v = mesh.vertices();
        let mut opposite: BTreeMap<[u32; 2], Vec<u32>> = BTreeMap::new();
        for t in mesh.triangles() {
            for k in 0..3 {
                let (a, b, c) = (t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
                opposite.entry([a.min(b), a.max(b)]).or_default().push(c);
            }
        }
        let mut steps: Vec<Vec<(u32, f64)>> = vec![Vec::new(); v.len()];
        let mut join = |a: u32, b: u32, length: f64| {
            steps[a as usize].push((b, length));
            steps[b as usize].push((a, length));
        };
        for (&[a, b], ends) in &opposite {
            let (p, q) = (v[a as usize], v[b as usize]);
            let length = (q - p).norm();
            join(a, b, length);
            let (&[c, e], true) = (ends.as_slice(), length > 0.0) else { continue };
            if c == e {
                continue;
            }
            // Both opposite corners in the plane of the unfolded triangles, `p` at the origin and `q` along the first
            // axis.
            let axis = (q - p) / length;
            let unfolded = |k: u32| {
                let d = v[k as usize] - p;
                let along = d.dot(&axis);
                (along, (d - axis * along).norm())
            };
            let ((x, y), (x2, y2)) = (unfolded(c), unfolded(e));
            // The straight line must cross the edge itself.
            let crossing = if y + y2 > 0.0 { x + (x2 - x) * y / (y + y2) } else { -1.0 };
            if (0.0..=length).contains(&crossing) {
                join(c, e, (x - x2).hypot(y + y2));
            }
        }
        let mut offsets = vec![0];
        for row in &steps {
            offsets.push(offsets[offsets.len() - 1] + row.len());
        }
        Paths { offsets, steps: steps.concat() }
    }

    /// Distances of all vertices from `from`, mm; infinite for unreachable vertices.
    fn from(&self, from: usize) -> Vec<f64> {
        let mut distance = vec![f64::INFINITY; self.offsets.len() - 1];
        distance[from] = 0.0;
        // Non-negative lengths compare like their bits.
        let mut queue = BinaryHeap::from([Reverse((0u64, from as u32))]);
        while let Some(Reverse((bits, i))) = queue.pop() {
            let d = f64::from_bits(bits);
            if d > distance[i as usize] {
                continue;
            }
            for &(j, length) in &self.steps[self.offsets[i as usize]..self.offsets[i as usize + 1]] {
                if d + length < distance[j as usize] {
                    distance[j as usize] = d + length;
                    queue.push(Reverse(((d + length).to_bits(), j)));
                }
            }
        }
        distance
    }
}

/// Shortens the `distances` of all vertices through their neighbors, from the first vertex on or `backwards`; returns
/// whether any decreased.
#[allow(unsafe_code)] // the dispatch that `multiversion` generates; the body is safe code
#[multiversion(targets("x86_64+avx512f+avx512vl+avx512bw+avx512dq", "x86_64+avx2"))]
fn relax(paths: &Paths, distances: &mut [[f32; LANES]], backwards: bool) -> bool {
    let n = distances.len();
    let mut any = false;
    for k in 0..n {
        let i = if backwards { n - 1 - k } else { k };
        let mut own = distances[i];
        for &(j, length) in &paths.steps[paths.offsets[i]..paths.offsets[i + 1]] {
            let length = length as f32;
            for (d, o) in own.iter_mut().zip(&distances[j as usize]) {
                let by_way = o + length;
                *d = if by_way < *d { by_way } else { *d };
            }
        }
        any |= own != distances[i];
        distances[i] = own;
    }
    any
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::FaceArity;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Point3;

    #[test]
    fn paths_across_an_edge_are_straight_in_the_plane() {
        // A square of two triangles: the diagonal that is not an edge.
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
        let mesh = SurfaceMesh::new(square.to_vec(), FaceArity::Triangle, vec![0, 1, 2, 0, 2, 3]).unwrap();
        let distance = Paths::new(&mesh).from(1);
        assert!((distance[3] - 2f64.sqrt()).abs() < 1e-12, "{distance:?}");
    }

    #[test]
    fn distances_among_all_vertices_are_those_from_each() {
        let one = ellipsoid(nalgebra::Vector3::new(9.0, 5.0, 4.0), 3);
        // Two pieces: no path joins them.
        let mut points = one.vertices().to_vec();
        points.extend(one.vertices().iter().map(|p| p + nalgebra::Vector3::new(30.0, 0.0, 0.0)));
        let n = one.n_vertices() as u32;
        let corners = one.indices().iter().copied().chain(one.indices().iter().map(|k| k + n)).collect();
        let two = SurfaceMesh::new(points, FaceArity::Triangle, corners).unwrap();
        for mesh in [one, two] {
            let all: Vec<u32> = (0..mesh.n_vertices() as u32).collect();
            let expected = distances_from(&mesh, &all);
            let found = distances_among(&mesh);
            for (row, expected) in found.chunks_exact(all.len()).zip(&expected) {
                for (found, expected) in row.iter().zip(expected) {
                    assert!((f64::from(*found) - expected).abs() < 1e-4, "{found} {expected}");
                }
            }
        }
    }
}
