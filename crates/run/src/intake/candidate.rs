//! The surface made from an input, before it is accepted or refused.

use super::near;
use super::split::split;
use super::warnings::{self, UsedLabels};
use super::{Advice, IntakeError, RepairNote, counted};
use homolog_contract::input::InputWarning;
use homolog_contract::parameters::{InputParameters, Repair};
use homolog_formats::MeshFile;
use homolog_mesh::orientation::oriented;
use homolog_mesh::repair::RepairedMesh;
use homolog_mesh::simplify::{Simplified, simplify};
use homolog_mesh::topology::{Demand, SurfaceFault, TopologyReport, analyze_with, topology_report};
use homolog_mesh::tunnels::{ClosedTunnels, close_tunnels, count_tunnels};
use homolog_mesh::volume::Sampling;
use homolog_mesh::{FaceArity, MeshError, Numbering, SurfaceMesh, repair};
use nalgebra::Point3;

/// A surface made from an input, with its repairs and the remaining fault, if any.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Candidate {
    pub mesh: SurfaceMesh,
    /// For each vertex of `mesh`, its vertex in the upload.
    pub numbering: Numbering,
    /// Positions of vertices added by repairs, numbered after those of the upload.
    pub added: Vec<Point3<f64>>,
    /// The surface before simplification, and its vertices in the upload.
    pub whole: Option<(SurfaceMesh, Numbering)>,
    /// Topology before repairs.
    pub topology: TopologyReport,
    /// Topology after repairs.
    pub repaired: TopologyReport,
    /// The first remaining fault, in vertices of the upload.
    pub fault: Option<SurfaceFault>,
    /// Further remaining faults.
    pub others: Vec<SurfaceFault>,
    pub repairs: Vec<RepairNote>,
    pub turned_outward: bool,
    /// Requested repairs that were not made, with reasons.
    pub notes: Vec<String>,
    /// Changes that may have produced a structure other than the intended one.
    pub warnings: Vec<InputWarning>,
    /// The labels the surface was made from; `None` for meshes.
    pub labels: Option<UsedLabels>,
    /// Uncertainty due to voxel size; `None` for meshes.
    pub sampling: Option<Sampling>,
}

impl Candidate {
    pub(super) fn new(
        mesh: SurfaceMesh,
        numbering: Numbering,
        topology: TopologyReport,
        repairs: Vec<RepairNote>,
        allow_boundary: bool,
    ) -> Self {
        let demand = if allow_boundary { Demand::Any } else { Demand::NoBoundary };
        let analysis = analyze_with(&mesh, demand);
        let fault = analysis.fault.map(|fault| fault.renumbered(&numbering));
        let others = analysis.others.into_iter().map(|fault| fault.renumbered(&numbering)).collect();
        let repaired = analysis.report;
        Candidate {
            mesh,
            numbering,
            added: Vec::new(),
            whole: None,
            topology,
            repaired,
            fault,
            others,
            repairs,
            turned_outward: false,
            notes: Vec::new(),
            warnings: Vec::new(),
            labels: None,
            sampling: None,
        }
    }

    pub(super) fn triangulate(&mut self, parameters: &InputParameters) {
        let allowed = parameters.repair.iter().flatten().any(|repair| *repair == Repair::Triangulate);
        if allowed && self.mesh.arity() == FaceArity::Quad {
            let detail = format!("{} split into triangles", counted(self.mesh.n_faces() as u64, "quad", "quads"));
            self.repairs.push(RepairNote { repair: Repair::Triangulate, detail });
            self.mesh = repair::triangulated(&self.mesh);
            self.repaired = topology_report(&self.mesh);
        }
    }

    /// Simplifies the surface to `input.max_vertices` vertices.
    pub(super) fn simplify(&mut self, parameters: &InputParameters) {
        let Some(wanted) = parameters.max_vertices.map(|n| n as usize).filter(|&n| n < self.mesh.n_vertices()) else {
            return;
        };
        let before = self.mesh.n_vertices();
        let Simplified { repaired, largest_mm } = simplify(&self.mesh, wanted);
        let RepairedMesh { mesh, numbering } = repaired;
        self.repaired = topology_report(&mesh);
        let numbering = numbering.over(&self.numbering);
        let detail = format!(
            "{} of {before} vertices kept where they are; the others are at most {largest_mm:.3} mm from the new surface",
            mesh.n_vertices()
        );
        self.repairs.push(RepairNote { repair: Repair::Simplify, detail });
        let mesh = std::mem::replace(&mut self.mesh, mesh);
        self.whole = Some((mesh, std::mem::replace(&mut self.numbering, numbering)));
    }
}

pub(super) fn from_mesh(file: &MeshFile, parameters: &InputParameters) -> Result<Candidate, IntakeError> {
    let allowed = parameters.repair.as_deref().unwrap_or(&[Repair::Weld, Repair::Orient]);
    let topology = topology_report(&file.mesh);
    let weld = allowed.contains(&Repair::Weld);
    if let Some((face, vertex)) = file.first_degenerate.filter(|_| !weld) {
        let (n_faces, face) = (file.n_degenerate as u64, face as u64);
        let place_mm = file.mesh.vertices().get(vertex as usize).map_or([f64::NAN; 3], |p| (*p).into());
        let demand = if parameters.allow_boundary { Demand::Any } else { Demand::NoBoundary };
        let analysis = analyze_with(&file.mesh, demand);
        let others: Vec<SurfaceFault> = analysis.fault.into_iter().chain(analysis.others).collect();
        let twisted = others.iter().any(|fault| matches!(fault, SurfaceFault::Misoriented { .. }));
        let advice = Advice::Allow(if twisted { vec![Repair::Weld, Repair::Orient] } else { vec![Repair::Weld] });
        let topology = Box::new(topology);
        return Err(IntakeError::DegenerateFaces { n_faces, face, vertex, place_mm, others, advice, topology });
    }
    let numbering = Numbering::identity(file.mesh.n_vertices());
    let mut current = RepairedMesh { mesh: file.mesh.clone(), numbering };
    let mut repairs = Vec::new();
    if (topology.n_vertices as usize) < file.mesh.n_vertices() {
        current = followed(&current, repair::drop_unused(&file.mesh));
    }
    if weld {
        let vertices = current.mesh.n_vertices();
        let welded = repair::weld_reported(&current.mesh);
        let (welded, report) = welded.map_err(|e: MeshError| IntakeError::Unreadable(e.into()))?;
        current = followed(&current, welded);
        let n_degenerate = file.n_degenerate + report.n_degenerate;
        if report.n_merged + n_degenerate + report.n_duplicate > 0 {
            let detail = format!(
                "{} of {vertices} vertices joined to another{}; {} and {} dropped",
                report.n_merged,
                match (report.n_merged, report.largest_mm) {
                    (0, _) => String::new(),
                    (_, 0.0) => " at the same place".to_owned(),
                    (_, largest) => format!(", at most {largest:.3e} mm away"),
                },
                counted(n_degenerate as u64, "face that uses a vertex twice", "faces that use a vertex twice"),
                counted(report.n_duplicate as u64, "repeated face", "repeated faces")
            );
            repairs.push(RepairNote { repair: Repair::Weld, detail });
        }
    }
    let mut joined_in_part = false;
    if weld {
        let joined = near::weld_near(&current.mesh).map_err(|e: MeshError| IntakeError::Unreadable(e.into()))?;
        if let Some(joined) = joined {
            current = followed(&current, joined.welded);
            repairs.push(RepairNote { repair: Repair::Weld, detail: joined.detail });
            joined_in_part = joined.in_part;
        }
    }
    let n_uploaded = file.mesh.n_vertices();
    let mut added: Vec<Point3<f64>> = Vec::new();
    if allowed.contains(&Repair::Split)
        && let Some(found) = split(&current.mesh).map_err(|e: MeshError| IntakeError::Unreadable(e.into()))?
    {
        let numbering = extended(&current.numbering, n_uploaded + added.len(), found.copies.len());
        added.extend(found.copies.iter().map(|&v| current.mesh.vertices()[v as usize]));
        let detail = format!(
            "{} copied, where parts touched at {} or at a vertex only; no vertex moved",
            counted(found.copies.len() as u64, "vertex", "vertices"),
            counted(found.n_edges as u64, "edge with more than two faces", "edges with more than two faces")
        );
        repairs.push(RepairNote { repair: Repair::Split, detail });
        current = RepairedMesh { mesh: found.mesh, numbering };
    }
    let mut warnings = Vec::new();
    if allowed.contains(&Repair::LargestComponent) {
        let before = topology_report(&current.mesh);
        if before.n_components > 1 {
            current = followed(&current, repair::largest_component(&current.mesh));
            let detail = format!(
                "kept the largest of {} pieces, {} of {} vertices",
                before.n_components,
                current.mesh.n_vertices(),
                before.n_vertices
            );
            let share = 1.0 - topology_report(&current.mesh).area_mm2 / before.area_mm2;
            // A mesh loses pieces only on request.
            warnings.push(warnings::piece_dropped(before.n_components as usize, share, "area", true));
            repairs.push(RepairNote { repair: Repair::LargestComponent, detail });
        }
    }
    if allowed.contains(&Repair::Orient)
        && let Some((mesh, reversed)) = oriented(&current.mesh).filter(|(_, reversed)| *reversed > 0)
    {
        current.mesh = mesh;
        let detail = format!("{} reversed", counted(reversed as u64, "face", "faces"));
        repairs.push(RepairNote { repair: Repair::Orient, detail });
    }
    let mut notes = Vec::new();
    if allowed.contains(&Repair::Fill) {
        if let Some((kept, n_dropped)) = repair::without_inner_pieces(&current.mesh) {
            current = followed(&current, kept);
            let detail = format!("{} inside another dropped", counted(n_dropped as u64, "piece", "pieces"));
            repairs.push(RepairNote { repair: Repair::Fill, detail });
        }
        let closed = close_tunnels(&current.mesh).map_err(|e: MeshError| IntakeError::Unreadable(e.into()))?;
        if closed.is_none() && count_tunnels(&current.mesh).is_none() {
            notes.push(
                "tunnels were not looked for: the surface has edges of more than two faces, vertices where parts only touch, or \
                 faces that disagree in orientation; allow the repairs weld, split and orient too"
                    .to_owned(),
            );
        }
        if let Some(closed) = closed {
            let n_new = closed.mesh.n_vertices() - current.mesh.n_vertices();
            let numbering = extended(&current.numbering, n_uploaded + added.len(), n_new);
            added.extend(&closed.mesh.vertices()[current.mesh.n_vertices()..]);
            repairs.push(RepairNote { repair: Repair::Fill, detail: tunnels_note(&closed) });
            current = RepairedMesh { mesh: closed.mesh, numbering };
        }
    }
    let mut candidate = Candidate::new(current.mesh, current.numbering, topology, repairs, parameters.allow_boundary);
    let in_part = joined_in_part.then(|| near::soup_fault(&candidate.repaired));
    if let Some(soup) = near::soup(&candidate.repaired).or(in_part) {
        // All other faults follow from this one.
        candidate.others.splice(0..0, candidate.fault.replace(soup));
    }
    Ok(Candidate { added, notes, warnings, ..candidate })
}

/// `numbering` with `n_new` further vertices, numbered from `first` on.
fn extended(numbering: &Numbering, first: usize, n_new: usize) -> Numbering {
    let new = first as u32..(first + n_new) as u32;
    let originals: Vec<u32> = numbering.originals().iter().copied().chain(new).collect();
    Numbering::identity(first + n_new).select(&originals)
}

fn tunnels_note(closed: &ClosedTunnels) -> String {
    let ClosedTunnels { n_tunnels, n_closed, n_copied, n_added, longest_loop_mm, largest_mm, .. } = closed;
    format!(
        "closed {n_closed} of {}, cut along loops of at most {longest_loop_mm:.3} mm; {n_copied} vertices copied and \
         {n_added} added, none moved more than {largest_mm:.3} mm",
        counted((*n_tunnels).into(), "tunnel", "tunnels")
    )
}

/// `next`, a repair of `current.mesh`, expressed as a repair of the mesh that `current` repairs.
fn followed(current: &RepairedMesh, next: RepairedMesh) -> RepairedMesh {
    RepairedMesh { numbering: next.numbering.over(&current.numbering), mesh: next.mesh }
}
