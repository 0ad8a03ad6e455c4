//! Topology of a mesh: whether it is closed, manifold and oriented, its genus, and the places of its faults.
//!
//! [`topology_report`] counts; [`analyze`] also returns the first [`SurfaceFault`] with its position, so that an error
//! tells what to fix. Both work on triangles and quads, and find faults in the same order in every run.

pub use super::elements::{TopologyReport, topology_report};

use super::elements::Examined;
use super::tunnels::{Tunnel, narrowest_tunnel};
use super::{Numbering, SurfaceMesh};

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

#[cfg(test)]
#[path = "topology_tests.rs"]
mod tests;
