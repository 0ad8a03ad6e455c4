//! Closes the tunnels of a mesh: cuts along its shortest handle and caps both rims, until the genus is 0.
//!
//! A loop that does not separate the surface runs either around a handle, which the cut then severs, or through a
//! tunnel, which the caps then close like a membrane. The shortest loop is the smaller change. Both rims of a cut are
//! capped with a fan around a new vertex at their mean. The rims are drawn apart a little, so that the caps do not
//! coincide and welding does not join them again.
//!
//! During the search a fan covers each boundary of an open mesh; no loop may cross it, and it is removed afterwards.
//! The genus is therefore that of the closed surface of which the mesh is a part, and the boundaries stay in place.
//!
//! # Source
//! Loops: [`mod@shortest_loop`]. Closing tunnels by cutting shortest non-separating loops: Guskov and Wood, "Topological noise
//! removal", Graphics Interface 2001; Wood, Hoppe, Desbrun and Schröder, "Removing excess topology from isosurfaces", ACM
//! Transactions on Graphics 23(2), 2004.

mod shortest_loop;

use super::elements::topology_report;
use super::{FaceArity, MeshError, SurfaceMesh};
use nalgebra::{Point3, Vector3};
use shortest_loop::{Loop, shortest_loop};
use std::collections::{BTreeMap, HashMap};
use std::ops::Range;

/// Distance by which the rims of a cut are drawn apart, as a share of the way from a vertex of the rim to the mean of
/// its neighbors beside the rim. Enough for vertices to have distinct positions, too little to turn a triangle over.
const DRAWN_APART: f64 = 0.1;

/// A mesh whose tunnels were closed.
#[derive(Debug, Clone, PartialEq)]
pub struct ClosedTunnels {
    /// The mesh, of triangles: the vertices of the input (vertices on rims have moved), then the new ones.
    pub mesh: SurfaceMesh,
    /// Number of tunnels in the input.
    pub n_tunnels: u32,
    /// Number of tunnels that were closed.
    pub n_closed: u32,
    /// Vertices that were copied, because a cut goes through them.
    pub n_copied: usize,
    /// Vertices that were added, one in the middle of each cap.
    pub n_added: usize,
    /// Length of the longest loop that was cut, mm.
    pub longest_loop_mm: f64,
    /// Largest distance by which a vertex moved, mm.
    pub largest_mm: f64,
}

/// A tunnel, or a handle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tunnel {
    /// The middle of the shortest loop through or around it, mm.
    pub place_mm: [f64; 3],
    /// The length of that loop, mm.
    pub length_mm: f64,
}

/// The number of tunnels of an oriented manifold, closed or open; `None` if the mesh is not an oriented manifold.
pub fn count_tunnels(mesh: &SurfaceMesh) -> Option<u32> {
    covered(mesh)?.1
}

/// The narrowest tunnel or thinnest handle of an oriented manifold, closed or open; `None` if the mesh is not an
/// oriented manifold or has no tunnel. For large surfaces the search ends early and may return another tunnel.
pub(crate) fn narrowest_tunnel(mesh: &SurfaceMesh) -> Option<Tunnel> {
    let (surface, n_tunnels) = covered(mesh)?;
    n_tunnels.filter(|&n| n > 0)?;
    let mut effort = EFFORT_TO_NAME;
    let found = shortest_loop(&surface.vertices, &surface.triangles, &surface.caps, &mut effort)?;
    let sum: Vector3<f64> = found.vertices.iter().map(|&v| surface.vertices[v as usize].coords).sum();
    Some(Tunnel { place_mm: (sum / found.vertices.len() as f64).into(), length_mm: found.length_mm })
}

/// The mesh with its boundaries covered and, if it is an oriented manifold, the number of its tunnels. `None` if its
/// boundaries are not simple loops.
fn covered(mesh: &SurfaceMesh) -> Option<(Cutting, Option<u32>)> {
    let mut triangles = mesh.triangles();
    let mut vertices = mesh.vertices().to_vec();
    let first = vertices.len() as u32;
    let mut uses: HashMap<[u32; 2], (u32, [u32; 2])> = HashMap::new();
    for t in &triangles {
        for k in 0..3 {
            let (a, b) = (t[k], t[(k + 1) % 3]);
            uses.entry([a.min(b), a.max(b)]).or_insert((0, [a, b])).0 += 1;
        }
    }
    // Each boundary vertex and its successor along the faces; ordered, so that caps get the same numbers in every run.
    let mut next: BTreeMap<u32, u32> = BTreeMap::new();
    for &(_, [a, b]) in uses.values().filter(|(n, _)| *n == 1) {
        if next.insert(a, b).is_some() {
            return None;
        }
    }
    while let Some((start, mut at)) = next.pop_first() {
        let mut rim = vec![start];
        while at != start {
            rim.push(at);
            at = next.remove(&at)?;
        }
        let cap = vertices.len() as u32;
        let sum: Vector3<f64> = rim.iter().map(|&v| vertices[v as usize].coords).sum();
        vertices.push(Point3::from(sum / rim.len() as f64));
        triangles.extend((0..rim.len()).map(|k| [rim[(k + 1) % rim.len()], rim[k], cap]));
    }
    let caps = first..vertices.len() as u32;
    let closed = SurfaceMesh::new(vertices.clone(), FaceArity::Triangle, triangles.concat()).ok()?;
    let n_tunnels = topology_report(&closed).genus;
    Some((Cutting { before: vertices.clone(), vertices, triangles, caps }, n_tunnels))
}

/// Closes the tunnels of an oriented manifold, closed or open, shortest loop first. `None` if the mesh is not an
/// oriented manifold or has no tunnel. The search has a bounded effort; tunnels beyond it stay open
/// ([`ClosedTunnels::n_closed`]).
///
/// # Errors
/// None for a valid mesh.
///
/// # Cost
/// For each tunnel `O(n log n)`, plus a search within half the length of the loop around `O(√n)` vertices.
pub fn close_tunnels(mesh: &SurfaceMesh) -> Result<Option<ClosedTunnels>, MeshError> {
    let Some((mut surface, Some(n_tunnels))) = covered(mesh).filter(|(_, n)| n.is_some_and(|n| n > 0)) else {
        return Ok(None);
    };
    let mut effort = EFFORT_PER_VERTEX * mesh.n_vertices() as u64;
    let mut closed = ClosedTunnels {
        mesh: mesh.clone(),
        n_tunnels,
        n_closed: 0,
        n_copied: 0,
        n_added: 0,
        longest_loop_mm: 0.0,
        largest_mm: 0.0,
    };
    while closed.n_closed < n_tunnels && effort > 0 {
        let found = shortest_loop(&surface.vertices, &surface.triangles, &surface.caps, &mut effort);
        let crosses_cap = |found: &Loop| found.vertices.iter().any(|v| surface.caps.contains(v));
        let Some(found) = found.filter(|found| !crosses_cap(found)) else { break };
        surface.cut(&found.vertices);
        closed.n_closed += 1;
        closed.n_copied += found.vertices.len();
        closed.n_added += 2;
        closed.longest_loop_mm = closed.longest_loop_mm.max(found.length_mm);
    }
    surface.uncover();
    let moved = surface.before.iter().zip(&surface.vertices).map(|(before, after)| (after - before).norm());
    closed.largest_mm = moved.fold(0.0, f64::max);
    closed.mesh = SurfaceMesh::new(surface.vertices, FaceArity::Triangle, surface.triangles.concat())?;
    Ok(Some(closed))
}

/// Limit of the vertices reached by all searches together, per vertex of the mesh: about a minute for 200,000 vertices.
const EFFORT_PER_VERTEX: u64 = 1000;
/// Limit of the vertices reached by a search that only names a tunnel: a second or two.
const EFFORT_TO_NAME: u64 = 5_000_000;

struct Cutting {
    vertices: Vec<Point3<f64>>,
    /// Original positions of the vertices: of the mesh, of the copies, and of the middles of caps.
    before: Vec<Point3<f64>>,
    triangles: Vec<[u32; 3]>,
    /// Middle vertices of the fans that cover boundaries.
    caps: Range<u32>,
}

impl Cutting {
    /// Removes the fans that cover boundaries.
    fn uncover(&mut self) {
        let caps = std::mem::replace(&mut self.caps, 0..0);
        let n = caps.end - caps.start;
        self.triangles.retain(|t| !t.iter().any(|v| caps.contains(v)));
        self.triangles.iter_mut().flatten().filter(|v| **v >= caps.end).for_each(|v| *v -= n);
        let places = caps.start as usize..caps.end as usize;
        self.vertices.drain(places.clone());
        self.before.drain(places);
    }

    /// Cuts along a simple loop of edges and caps both rims.
    fn cut(&mut self, around: &[u32]) {
        let n = around.len();
        let place: HashMap<u32, usize> = around.iter().copied().zip(0..).collect();
        let copies = self.copied(around, &place);
        let moved: Vec<_> = [around, &copies].into_iter().flat_map(|rim| self.drawn_in(rim)).collect();
        for (v, to) in moved {
            self.vertices[v as usize] = to;
        }
        // The faces left of the loop have its edges in its direction, so the cap has them reversed.
        for (rim, left) in [(around, true), (&copies, false)] {
            let middle = self.vertices.len() as u32;
            let sum: Vector3<f64> = rim.iter().map(|&v| self.vertices[v as usize].coords).sum();
            let mean = Point3::from(sum / n as f64);
            self.vertices.push(mean);
            self.before.push(mean);
            for k in 0..n {
                let (a, b) = (rim[k], rim[(k + 1) % n]);
                self.triangles.push(if left { [b, a, middle] } else { [a, b, middle] });
            }
        }
    }

    /// Gives the faces right of the loop their own vertices, and returns these in the order of the loop.
    fn copied(&mut self, around: &[u32], place: &HashMap<u32, usize>) -> Vec<u32> {
        let n = around.len();
        let first_copy = self.vertices.len() as u32;
        let is_cut = |a: u32, b: u32| {
            place.get(&a).zip(place.get(&b)).is_some_and(|(&i, &j)| (i + 1) % n == j || (j + 1) % n == i)
        };
        // Faces around the loop, by their directed edges at it: the next face around a vertex has the edge reversed.
        let mut face_of: HashMap<(u32, u32), usize> = HashMap::new();
        for (f, t) in self.triangles.iter().enumerate().filter(|(_, t)| t.iter().any(|v| place.contains_key(v))) {
            (0..3).for_each(|k| {
                face_of.insert((t[k], t[(k + 1) % 3]), f);
            });
        }
        let mut changes = Vec::new();
        for (k, &v) in around.iter().enumerate() {
            // The face right of the edge from `v` to the next has the reversed edge; from there around `v` to the cut edge that
            // leads to `v`.
            let mut from = around[(k + 1) % n];
            while let Some(&f) = face_of.get(&(from, v)) {
                changes.push((f, v, first_copy + k as u32));
                let t = self.triangles[f];
                let at = t.iter().position(|&c| c == v).unwrap_or(0);
                // The face runs from → v → next.
                let next = t[(at + 1) % 3];
                if is_cut(v, next) {
                    break;
                }
                from = next;
            }
        }
        for (f, v, copy) in changes {
            self.triangles[f].iter_mut().filter(|c| **c == v).for_each(|c| *c = copy);
        }
        for &v in around {
            self.vertices.push(self.vertices[v as usize]);
            self.before.push(self.before[v as usize]);
        }
        (0..n as u32).map(|k| first_copy + k).collect()
    }

    /// New positions of the vertices of an open rim: moved a little towards their neighbors beside the rim.
    fn drawn_in(&self, rim: &[u32]) -> Vec<(u32, Point3<f64>)> {
        let place: HashMap<u32, usize> = rim.iter().copied().zip(0..).collect();
        let mut sums = vec![(Vector3::zeros(), 0.0); rim.len()];
        for t in &self.triangles {
            for (k, v) in t.iter().enumerate() {
                let Some(&at) = place.get(v) else { continue };
                let beside = |other: &&u32| !place.contains_key(*other) && !self.caps.contains(*other);
                for other in [t[(k + 1) % 3], t[(k + 2) % 3]].iter().filter(beside) {
                    sums[at].0 += self.vertices[*other as usize].coords;
                    sums[at].1 += 1.0;
                }
            }
        }
        let moved = |(&v, (sum, n)): (&u32, (Vector3<f64>, f64))| {
            let here = self.vertices[v as usize];
            (n > 0.0).then(|| (v, here + (sum / n - here.coords) * DRAWN_APART))
        };
        rim.iter().zip(sums).filter_map(moved).collect()
    }
}

#[cfg(test)]
mod tests;
