//! Edges, fans and pieces of a mesh, and the report that counts them.
//!
//! Edges are grouped by sorting half-edges, and fans around a vertex by joining the face corners that share an edge: no
//! pointers, no hashing, the same order in every run.

use super::SurfaceMesh;

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

/// Counts and elements from which faults are derived.
pub(super) struct Examined {
    pub report: TopologyReport,
    pub faults: EdgeFaults,
    pub torn: Vec<u32>,
    pub n_fans: Vec<u32>,
    pub components: Components,
}

impl Examined {
    pub(super) fn new(mesh: &SurfaceMesh) -> Self {
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

/// Counts of vertices, edges, faces, components and faults of `mesh`, its genus, area (mm²) and volume (mm³).
///
/// Vertices that no face uses are not counted. Cost `O(faces log faces)`.
pub fn topology_report(mesh: &SurfaceMesh) -> TopologyReport {
    Examined::new(mesh).report
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
pub(super) struct EdgeFault {
    pub n: u32,
    pub first: Option<[u32; 2]>,
    /// Number of faces at the first such edge.
    pub n_faces: u32,
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
pub(super) struct EdgeFaults {
    pub n_edges: u32,
    pub boundary: EdgeFault,
    pub many: EdgeFault,
    pub twisted: EdgeFault,
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
