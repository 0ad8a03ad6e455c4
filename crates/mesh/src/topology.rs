//! Topology of a mesh: whether it is closed, manifold and oriented, its genus, and the places of its faults.
//!
//! [`topology_report`] counts; [`analyze`] also returns the first [`SurfaceFault`] with its position, so that an error
//! tells what to fix. Both work on triangles and quads. Edges are grouped by sorting half-edges, and fans around a
//! vertex by joining the face corners that share an edge: no pointers, no hashing, the same order of faults in every
//! run.

use super::tunnels::{Tunnel, narrowest_tunnel};
use super::{Numbering, SurfaceMesh};

/// Counts of the elements and faults of a mesh, with its genus, area and volume.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "openapi", derive(utoipa::ToSchema))]
pub struct TopologyReport {
    /// Vertices that a face uses.
    pub n_vertices: u32,
    /// Edges.
    pub n_edges: u32,
    /// Faces.
    pub n_faces: u32,
    /// Connected components (by shared vertices).
    pub n_components: u32,
    /// Edges with one face.
    pub n_boundary_edges: u32,
    /// Edges with more than two faces.
    pub n_nonmanifold_edges: u32,
    /// Vertices whose faces form more than one fan.
    pub n_nonmanifold_vertices: u32,
    /// `V − E + F`.
    pub euler_characteristic: i64,
    /// Genus summed over components; `None` where the surface is not a closed oriented manifold.
    pub genus: Option<u32>,
    /// Whether neighboring faces agree in orientation everywhere.
    pub oriented: bool,
    /// Area, mm².
    pub area_mm2: f64,
    /// Enclosed volume, mm³, positive if faces look outwards; `None` for open surfaces.
    pub volume_mm3: Option<f64>,
}

/// The first reason, in the order of the variants, why a mesh does not meet the demand.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SurfaceFault {
    /// Neighboring faces do not share vertices.
    #[error(
        "the faces do not hold together: {n_faces} faces are {n_components} separate pieces with {n_edges} edges that have only \
         one face, because neighboring faces do not share vertices"
    )]
    Soup {
        /// Faces.
        n_faces: u32,
        /// Pieces.
        n_components: u32,
        /// Edges with one face.
        n_edges: u32,
    },
    /// More than two faces meet at an edge.
    #[error(
        "{} more than two faces; the first joins vertices {} and {} near {}, with {n_faces} faces",
        counted(*n_edges, "edge has", "edges have"), edge[0], edge[1], at(place_mm)
    )]
    NonManifoldEdge {
        /// How many such edges.
        n_edges: u32,
        /// Vertices of the first such edge.
        edge: [u32; 2],
        /// Faces at it.
        n_faces: u32,
        /// Midpoint of that edge, mm.
        place_mm: [f64; 3],
    },
    /// The surface has a boundary.
    #[error(
        "the surface is open: {} only one face; the first joins vertices {} and {} near {}",
        counted(*n_edges, "edge has", "edges have"), edge[0], edge[1], at(place_mm)
    )]
    Boundary {
        /// How many boundary edges.
        n_edges: u32,
        /// Vertices of the first such edge.
        edge: [u32; 2],
        /// Midpoint of that edge, mm.
        place_mm: [f64; 3],
    },
    /// Parts of the surface touch at one vertex only.
    #[error(
        "{} parts that touch nowhere else; the first is vertex {vertex} at {}, with {n_fans} fans of faces",
        counted(*n_vertices, "vertex joins", "vertices join"), at(place_mm)
    )]
    NonManifoldVertex {
        /// How many such vertices.
        n_vertices: u32,
        /// The first.
        vertex: u32,
        /// Fans of faces around it.
        n_fans: u32,
        /// Its position, mm.
        place_mm: [f64; 3],
    },
    /// Two neighboring faces disagree in orientation.
    #[error(
        "{} between faces of opposite orientation; the first joins vertices {} and {} near {}",
        counted(*n_edges, "edge lies", "edges lie"), edge[0], edge[1], at(place_mm)
    )]
    Misoriented {
        /// How many such edges.
        n_edges: u32,
        /// Vertices of the first such edge.
        edge: [u32; 2],
        /// Midpoint of that edge, mm.
        place_mm: [f64; 3],
    },
    /// More than one connected piece.
    #[error(
        "the surface has {n_components} separate pieces; the largest has {largest} of {n_vertices} vertices, \
         another one is near {}",
        at(place_mm)
    )]
    Pieces {
        /// How many pieces.
        n_components: u32,
        /// Vertices of the largest.
        largest: u32,
        /// Vertices of all.
        n_vertices: u32,
        /// Position of a vertex of another piece, mm.
        place_mm: [f64; 3],
    },
    /// Tunnels through the surface.
    #[error(
        "the surface has {genus} {} (genus {genus}){}; genus 0, as of a sphere, is needed, and the repair fill closes tunnels",
        tunnels(*genus), narrowest(*genus, *tunnel)
    )]
    Genus {
        /// The genus.
        genus: u32,
        /// The narrowest tunnel, or the thinnest handle.
        tunnel: Option<Tunnel>,
    },
    /// No area: all vertices on a line or at a point.
    #[error("the surface has no area ({area_mm2} mm²)")]
    NoArea {
        /// Its area, mm².
        area_mm2: f64,
    },
    /// No enclosed volume: flat, or parts of opposite orientation cancel.
    #[error("the surface encloses no volume ({volume_mm3} mm³)")]
    NoVolume {
        /// Enclosed volume, mm³.
        volume_mm3: f64,
    },
    /// All faces face inwards.
    #[error("all faces look inwards (volume {volume_mm3} mm³)")]
    InsideOut {
        /// Enclosed volume, mm³, negative.
        volume_mm3: f64,
    },
}

/// A number with its noun and verb.
fn counted(n: u32, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}

fn at(place: &[f64; 3]) -> String {
    format!("({:.2}, {:.2}, {:.2}) mm", place[0], place[1], place[2])
}

fn tunnels(n: u32) -> &'static str {
    if n == 1 { "tunnel" } else { "tunnels" }
}

fn narrowest(genus: u32, tunnel: Option<Tunnel>) -> String {
    let Some(Tunnel { place_mm, length_mm }) = tunnel else { return String::new() };
    let which = if genus == 1 { "it is" } else { "the narrowest is" };
    format!("; {which} near {}, where a loop of {length_mm:.2} mm runs around or through it", at(&place_mm))
}

impl SurfaceFault {
    /// Position of the first occurrence, mm; `None` for a fault of the whole surface.
    pub fn place_mm(&self) -> Option<[f64; 3]> {
        match self {
            SurfaceFault::NonManifoldEdge { place_mm, .. }
            | SurfaceFault::Boundary { place_mm, .. }
            | SurfaceFault::NonManifoldVertex { place_mm, .. }
            | SurfaceFault::Misoriented { place_mm, .. }
            | SurfaceFault::Pieces { place_mm, .. } => Some(*place_mm),
            SurfaceFault::Soup { .. }
            | SurfaceFault::Genus { .. }
            | SurfaceFault::NoArea { .. }
            | SurfaceFault::NoVolume { .. }
            | SurfaceFault::InsideOut { .. } => None,
        }
    }

    /// The fault of a mesh with this `numbering`, expressed in vertices of the original mesh.
    pub fn renumbered(mut self, numbering: &Numbering) -> Self {
        let name = |v: &mut u32| *v = numbering.original(*v);
        match &mut self {
            SurfaceFault::NonManifoldEdge { edge, .. }
            | SurfaceFault::Boundary { edge, .. }
            | SurfaceFault::Misoriented { edge, .. } => edge.iter_mut().for_each(name),
            SurfaceFault::NonManifoldVertex { vertex, .. } => name(vertex),
            _ => {}
        }
        self
    }
}

/// A report and the first fault, if there is one.
#[derive(Debug, Clone, PartialEq)]
pub struct Analysis {
    /// The counts.
    pub report: TopologyReport,
    /// The first fault, if the mesh does not meet the demand.
    pub fault: Option<SurfaceFault>,
    /// Further faults, if there are several.
    pub others: Vec<SurfaceFault>,
}

/// Volumes below this share of `area^1.5` count as 0, and so do areas below this share of the squared diagonal. For
/// comparison: a sphere has 0.094; a needle of aspect 1 : 10⁴ has 1e-3.
const FLAT_RTOL: f64 = 1e-9;

/// Counts of vertices, edges, faces, components and faults of `mesh`, its genus, area (mm²) and volume (mm³).
///
/// Vertices that no face uses are not counted. Cost `O(faces log faces)`.
pub fn topology_report(mesh: &SurfaceMesh) -> TopologyReport {
    Examined::new(mesh).report
}

/// [`topology_report`] and, if `mesh` is not a closed surface of genus 0 with outward faces, the first fault.
///
/// Cost `O(faces log faces)`, plus up to seconds for the search for a tunnel.
pub fn analyze(mesh: &SurfaceMesh) -> Analysis {
    analyze_with(mesh, Demand::Sphere)
}

/// Requirements on a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Demand {
    /// Any surface whose faces agree in orientation and, where it is closed, enclose a volume. Faces of an open surface count
    /// as outward if the signed volume relative to the centroid is not negative.
    Any,
    /// Like [`Demand::Any`], without a boundary.
    NoBoundary,
    /// A closed manifold in one piece, of genus 0.
    Sphere,
}

/// Like [`analyze`], with the first fault of a surface that does not meet `demand`.
///
/// Cost `O(faces log faces)`; with [`Demand::Sphere`] plus up to seconds for the search for a tunnel.
pub fn analyze_with(mesh: &SurfaceMesh, demand: Demand) -> Analysis {
    let examined = Examined::new(mesh);
    let mut found = all_faults(mesh, &examined, demand).into_iter();
    Analysis { fault: found.next(), others: found.collect(), report: examined.report }
}

/// Counts and elements from which faults are derived.
struct Examined {
    report: TopologyReport,
    faults: EdgeFaults,
    torn: Vec<u32>,
    n_fans: Vec<u32>,
    components: Components,
}

impl Examined {
    fn new(mesh: &SurfaceMesh) -> Self {
        let edges = EdgeUses::new(mesh);
        let mut fans = DisjointSets::new(mesh.indices().len());
        let mut faults = EdgeFaults::default();
        for uses in edges.groups() {
            for pair in uses.windows(2) {
                fans.join(pair[0].corner_low, pair[1].corner_low);
                fans.join(pair[0].corner_high, pair[1].corner_high);
            }
            faults.count(uses);
        }
        let n_fans = fan_counts(mesh, &mut fans);
        let components = vertex_components(mesh);
        let used = n_fans.iter().filter(|&&n| n > 0).count();
        let torn: Vec<u32> = (0..n_fans.len() as u32).filter(|&v| n_fans[v as usize] > 1).collect();
        let euler = used as i64 - faults.n_edges as i64 + mesh.n_faces() as i64;
        let closed = faults.boundary.n == 0 && faults.many.n == 0;
        let oriented = faults.twisted.n == 0;
        let n_components = components.sizes.len() as u32;
        let manifold = closed && oriented && torn.is_empty();
        // Each component has χ = 2 − 2g.
        let genus = manifold.then(|| (i64::from(n_components) - euler / 2).max(0) as u32);
        let report = TopologyReport {
            n_vertices: used as u32,
            n_edges: faults.n_edges,
            n_faces: mesh.n_faces() as u32,
            n_components,
            n_boundary_edges: faults.boundary.n,
            n_nonmanifold_edges: faults.many.n,
            n_nonmanifold_vertices: torn.len() as u32,
            euler_characteristic: euler,
            genus,
            oriented,
            area_mm2: mesh.area(),
            volume_mm3: closed.then(|| mesh.signed_volume()),
        };
        Examined { report, faults, torn, n_fans, components }
    }
}

fn all_faults(mesh: &SurfaceMesh, examined: &Examined, demand: Demand) -> Vec<SurfaceFault> {
    let Examined { report, faults, torn, n_fans, components } = examined;
    let mut found = Vec::new();
    let v = mesh.vertices();
    let middle = |e: [u32; 2]| -> [f64; 3] { nalgebra::center(&v[e[0] as usize], &v[e[1] as usize]).into() };
    if let Some(edge) = faults.many.first.filter(|_| demand == Demand::Sphere) {
        let (n_edges, n_faces) = (faults.many.n, faults.many.n_faces);
        found.push(SurfaceFault::NonManifoldEdge { n_edges, edge, n_faces, place_mm: middle(edge) });
    }
    if let Some(edge) = faults.boundary.first.filter(|_| demand != Demand::Any) {
        found.push(SurfaceFault::Boundary { n_edges: faults.boundary.n, edge, place_mm: middle(edge) });
    }
    if let Some(&vertex) = torn.first().filter(|_| demand == Demand::Sphere) {
        let (n_vertices, n_fans) = (torn.len() as u32, n_fans[vertex as usize]);
        let place_mm = v[vertex as usize].into();
        found.push(SurfaceFault::NonManifoldVertex { n_vertices, vertex, n_fans, place_mm });
    }
    if let Some(edge) = faults.twisted.first {
        found.push(SurfaceFault::Misoriented { n_edges: faults.twisted.n, edge, place_mm: middle(edge) });
    }
    if report.n_components > 1 && demand == Demand::Sphere {
        let largest = components.largest();
        let other = components.of_vertex.iter().position(|&c| c != u32::MAX && c != largest).unwrap_or(0);
        found.push(SurfaceFault::Pieces {
            n_components: report.n_components,
            largest: components.sizes[largest as usize],
            n_vertices: report.n_vertices,
            place_mm: v[other].into(),
        });
    }
    if let Some(genus) = report.genus.filter(|&g| g > 0 && demand == Demand::Sphere) {
        found.push(SurfaceFault::Genus { genus, tunnel: narrowest_tunnel(mesh) });
    }
    let (low, high) = mesh.bounding_box();
    if report.area_mm2 <= FLAT_RTOL * (high - low).norm_squared() {
        found.push(SurfaceFault::NoArea { area_mm2: report.area_mm2 });
        return found;
    }
    // The volume is meaningless where faces disagree in orientation, and fixing another fault may correct it.
    if !found.is_empty() {
        return found;
    }
    let volume_mm3 = report.volume_mm3.unwrap_or_else(|| mesh.signed_volume());
    // An open surface may be nearly flat.
    if report.volume_mm3.is_some() && volume_mm3.abs() <= FLAT_RTOL * report.area_mm2.powf(1.5) {
        found.push(SurfaceFault::NoVolume { volume_mm3 });
    } else if volume_mm3 < 0.0 {
        found.push(SurfaceFault::InsideOut { volume_mm3 });
    }
    found
}

/// One face's use of an edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct EdgeUse {
    pub edge: [u32; 2],
    /// Position in the indices of the mesh of the corner at the lower vertex.
    pub corner_low: u32,
    /// Position in the indices of the mesh of the corner at the higher vertex.
    pub corner_high: u32,
    /// Whether the face runs from the lower to the higher vertex.
    pub ascending: bool,
}

/// All uses of all edges, grouped by edge, edges ascending.
pub(crate) struct EdgeUses(Vec<EdgeUse>);

impl EdgeUses {
    pub(crate) fn new(mesh: &SurfaceMesh) -> Self {
        let n = mesh.arity().n_corners();
        let mut uses = Vec::with_capacity(mesh.indices().len());
        for (f, face) in mesh.faces().enumerate() {
            for k in 0..n {
                let next = (k + 1) % n;
                let (a, b) = (face[k], face[next]);
                let (here, there) = ((f * n + k) as u32, (f * n + next) as u32);
                let ascending = a < b;
                let (corner_low, corner_high) = if ascending { (here, there) } else { (there, here) };
                uses.push(EdgeUse { edge: [a.min(b), a.max(b)], corner_low, corner_high, ascending });
            }
        }
        uses.sort_unstable();
        EdgeUses(uses)
    }

    pub(crate) fn groups(&self) -> impl Iterator<Item = &[EdgeUse]> {
        self.0.chunk_by(|a, b| a.edge == b.edge)
    }
}

#[derive(Debug, Default)]
struct EdgeFault {
    n: u32,
    first: Option<[u32; 2]>,
    /// Number of faces at the first such edge.
    n_faces: u32,
}

impl EdgeFault {
    fn add(&mut self, uses: &[EdgeUse]) {
        self.n += 1;
        if self.first.is_none() {
            self.first = Some(uses[0].edge);
            self.n_faces = uses.len() as u32;
        }
    }
}

#[derive(Debug, Default)]
struct EdgeFaults {
    n_edges: u32,
    boundary: EdgeFault,
    many: EdgeFault,
    twisted: EdgeFault,
}

impl EdgeFaults {
    fn count(&mut self, uses: &[EdgeUse]) {
        self.n_edges += 1;
        match uses {
            [_] => self.boundary.add(uses),
            [a, b] if a.ascending == b.ascending => self.twisted.add(uses),
            [_, _] => {}
            _ => self.many.add(uses),
        }
    }
}

/// Number of fans that the faces around each vertex form; 0 for unused vertices.
fn fan_counts(mesh: &SurfaceMesh, fans: &mut DisjointSets) -> Vec<u32> {
    let mut n_fans = vec![0; mesh.n_vertices()];
    for (corner, &v) in mesh.indices().iter().enumerate() {
        if fans.root(corner as u32) == corner as u32 {
            n_fans[v as usize] += 1;
        }
    }
    n_fans
}

/// The connected pieces of a mesh, by shared vertices, numbered by their first vertex.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Components {
    /// Piece of every vertex; `u32::MAX` for unused vertices.
    pub of_vertex: Vec<u32>,
    /// Vertices of every piece.
    pub sizes: Vec<u32>,
}

impl Components {
    /// The piece with the most vertices; ties go to the first.
    pub(crate) fn largest(&self) -> u32 {
        let mut best = 0;
        for (k, &size) in self.sizes.iter().enumerate() {
            if size > self.sizes[best] {
                best = k;
            }
        }
        best as u32
    }
}

pub(super) fn vertex_components(mesh: &SurfaceMesh) -> Components {
    let mut sets = DisjointSets::new(mesh.n_vertices());
    let mut used = vec![false; mesh.n_vertices()];
    for face in mesh.faces() {
        for &v in face {
            used[v as usize] = true;
            sets.join(face[0], v);
        }
    }
    let mut number = vec![u32::MAX; mesh.n_vertices()];
    let mut of_vertex = vec![u32::MAX; mesh.n_vertices()];
    let mut sizes: Vec<u32> = Vec::new();
    for v in 0..mesh.n_vertices() {
        if !used[v] {
            continue;
        }
        let root = sets.root(v as u32) as usize;
        if number[root] == u32::MAX {
            number[root] = sizes.len() as u32;
            sizes.push(0);
        }
        of_vertex[v] = number[root];
        sizes[number[root] as usize] += 1;
    }
    Components { of_vertex, sizes }
}

/// Disjoint sets with path halving; the root of a set is its lowest member.
pub(super) struct DisjointSets(Vec<u32>);

impl DisjointSets {
    pub(super) fn new(n: usize) -> Self {
        DisjointSets((0..n as u32).collect())
    }

    pub(super) fn root(&mut self, mut k: u32) -> u32 {
        while self.0[k as usize] != k {
            let up = self.0[self.0[k as usize] as usize];
            self.0[k as usize] = up;
            k = up;
        }
        k
    }

    pub(super) fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}

#[cfg(test)]
#[path = "topology_tests.rs"]
mod tests;
