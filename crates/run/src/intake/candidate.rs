//! The surface that is made of an input, before it is judged.

use super::{Advice, IntakeError, IntakeLimits, RepairNote};
use homolog_contract::parameters::{InputParameters, Repair, SurfaceKind};
use homolog_formats::{FileContent, MeshFile};
use homolog_mesh::topology::{SurfaceFault, TopologyReport, analyze_with, topology_report};
use homolog_mesh::volume::smooth_surface::FieldRepair;
use homolog_mesh::volume::{self, BettiNumbers, Contacts, FillChange, LabelVolume, VoxelMask};
use homolog_mesh::{MeshError, SurfaceMesh, repair};

/// Voxels of the box around a structure at most, 8 million: filling and filtering work on the whole box.
const MAX_BOX_VOXELS: u64 = 1 << 23;

/// Labels named in a refusal at most.
pub(super) const MAX_NAMED_LABELS: usize = 50;

/// A surface made of an input, with what was done and what is still wrong.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Candidate {
    pub mesh: SurfaceMesh,
    pub uploaded_vertex: Option<Vec<u32>>,
    /// Before repairs.
    pub topology: TopologyReport,
    /// After repairs.
    pub repaired: TopologyReport,
    pub fault: Option<SurfaceFault>,
    pub repairs: Vec<RepairNote>,
    pub turned_outward: bool,
}

impl Candidate {
    pub fn from_content(
        content: &FileContent,
        parameters: &InputParameters,
        limits: &IntakeLimits,
    ) -> Result<Self, IntakeError> {
        let mut candidate = match content {
            FileContent::Labels(volume) => from_labels(volume, parameters, limits)?,
            FileContent::Mesh(file) => from_mesh(file, parameters)?,
        };
        if let Some(SurfaceFault::InsideOut { .. }) = candidate.fault {
            candidate.mesh = repair::reversed(&candidate.mesh);
            candidate.turned_outward = true;
            candidate.fault = None;
            candidate.repaired.volume_mm3 = candidate.repaired.volume_mm3.map(|v| -v);
        }
        let (found, limit) = (candidate.mesh.n_vertices() as u64, limits.max_vertices as u64);
        if found > limit {
            return Err(IntakeError::TooLarge { what: "surface vertices", found, limit });
        }
        Ok(candidate)
    }

    fn new(
        mesh: SurfaceMesh,
        uploaded_vertex: Option<Vec<u32>>,
        topology: TopologyReport,
        repairs: Vec<RepairNote>,
        allow_boundary: bool,
    ) -> Self {
        let analysis = analyze_with(&mesh, allow_boundary);
        let fault = match &uploaded_vertex {
            Some(original) => analysis.fault.map(|f| f.renumbered(original)),
            None => analysis.fault,
        };
        let repaired = analysis.report;
        Candidate { mesh, uploaded_vertex, topology, repaired, fault, repairs, turned_outward: false }
    }

    /// The refusal, if this surface is not suitable, with the smallest set of repairs that would have made it so.
    pub fn refusal(
        &self,
        content: &FileContent,
        parameters: &InputParameters,
        limits: &IntakeLimits,
    ) -> Option<IntakeError> {
        let fault = self.fault.clone()?;
        let sets: &[&[Repair]] = match content {
            FileContent::Labels(_) => {
                &[&[Repair::Fill], &[Repair::LargestComponent], &[Repair::LargestComponent, Repair::Fill]]
            }
            FileContent::Mesh(_) => {
                &[&[Repair::Weld], &[Repair::LargestComponent], &[Repair::Weld, Repair::LargestComponent]]
            }
        };
        let helps = |set: &&&[Repair]| {
            let parameters = InputParameters { repair: Some(set.to_vec()), ..parameters.clone() };
            Candidate::from_content(content, &parameters, limits).is_ok_and(|c| c.fault.is_none())
        };
        let advice = sets.iter().find(helps).map_or(Advice::Edit, |set| Advice::Allow(set.to_vec()));
        Some(IntakeError::UnsuitableSurface { fault, advice, topology: Box::new(self.repaired.clone()) })
    }
}

fn from_mesh(file: &MeshFile, parameters: &InputParameters) -> Result<Candidate, IntakeError> {
    let allowed = parameters.repair.as_deref().unwrap_or(&[]);
    let topology = topology_report(&file.mesh);
    let weld = allowed.contains(&Repair::Weld);
    if let Some((face, vertex)) = file.first_degenerate.filter(|_| !weld) {
        let (n_faces, face) = (file.n_degenerate as u64, face as u64);
        return Err(IntakeError::DegenerateFaces { n_faces, face, vertex, topology: Box::new(topology) });
    }
    let mut steps = Steps { mesh: file.mesh.clone(), uploaded_vertex: None, repairs: Vec::new() };
    if (topology.n_vertices as usize) < file.mesh.n_vertices() {
        steps.advance(repair::drop_unused(&file.mesh));
    }
    if weld {
        let (vertices, faces) = (steps.mesh.n_vertices(), steps.mesh.n_faces());
        steps.advance(repair::weld(&steps.mesh).map_err(|e: MeshError| IntakeError::Unreadable(e.into()))?);
        let merged = vertices - steps.mesh.n_vertices();
        let dropped = file.n_degenerate + faces.saturating_sub(steps.mesh.n_faces());
        if merged + dropped > 0 {
            let detail = format!(
                "{merged} of {vertices} vertices joined to another; {} dropped",
                counted(dropped as u32, "face", "faces")
            );
            steps.repairs.push(RepairNote { repair: Repair::Weld, detail });
        }
    }
    if allowed.contains(&Repair::LargestComponent) {
        let before = topology_report(&steps.mesh);
        if before.n_components > 1 {
            steps.advance(repair::largest_component(&steps.mesh));
            let detail = format!(
                "kept the largest of {} pieces, {} of {} vertices",
                before.n_components,
                steps.mesh.n_vertices(),
                before.n_vertices
            );
            steps.repairs.push(RepairNote { repair: Repair::LargestComponent, detail });
        }
    }
    Ok(Candidate::new(steps.mesh, steps.uploaded_vertex, topology, steps.repairs, parameters.allow_boundary))
}

/// A mesh under repair, with the way back to the file's vertices once it is no longer the identity.
struct Steps {
    mesh: SurfaceMesh,
    uploaded_vertex: Option<Vec<u32>>,
    repairs: Vec<RepairNote>,
}

impl Steps {
    fn advance(&mut self, next: repair::RepairedMesh) {
        if next.original.len() < self.mesh.n_vertices() {
            self.uploaded_vertex = Some(match self.uploaded_vertex.take() {
                None => next.original,
                Some(before) => next.original.iter().map(|&v| before[v as usize]).collect(),
            });
        }
        self.mesh = next.mesh;
    }
}

fn from_labels(
    volume: &LabelVolume,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Result<Candidate, IntakeError> {
    let Some(mask) = volume.mask(parameters.labels.as_deref()) else {
        let labels: Vec<u32> = volume.label_counts().into_keys().collect();
        let n_present = labels.len();
        let present = labels.into_iter().take(MAX_NAMED_LABELS).collect();
        return Err(IntakeError::EmptyStructure { wanted: parameters.labels.clone(), present, n_present });
    };
    check_size(&mask, limits, 2.0)?;
    let both = [Repair::LargestComponent, Repair::Fill];
    let allowed = parameters.repair.as_deref().unwrap_or(&both);
    let (raw, _) = surface_of(&mask, parameters, FieldRepair::default())?;
    let topology = topology_report(&raw);
    drop(raw);

    let mut repairs = Vec::new();
    let mut repaired = mask;
    let one_piece = allowed.contains(&Repair::LargestComponent);
    if one_piece {
        let (piece, n_pieces, n_dropped) = volume::largest_component(&repaired);
        if n_pieces > 1 {
            let n = repaired.n_voxels();
            let detail = format!("kept the largest of {n_pieces} pieces; {n_dropped} of {n} voxels dropped");
            repairs.push(RepairNote { repair: Repair::LargestComponent, detail });
            repaired = piece;
        }
    }
    check_size(&repaired, limits, 1.25)?;
    let may_fill = allowed.contains(&Repair::Fill);
    let field_repair = FieldRepair { largest_component: one_piece, fill: may_fill };
    // Filling several pieces would join them.
    if may_fill && (one_piece || volume::largest_component(&repaired).1 == 1) {
        let contacts = match parameters.surface {
            SurfaceKind::Smooth => Contacts::Allow,
            SurfaceKind::Voxel => Contacts::Resolve,
        };
        let filled = volume::fill(&repaired, contacts);
        if filled.change.n_changed() > 0 {
            let not_again = FieldRepair { fill: false, ..field_repair };
            let (mesh, notes) = surface_of(&filled.mask, parameters, not_again)?;
            let notes = [repairs.clone(), vec![fill_note(filled.change, "")], notes].concat();
            let candidate = Candidate::new(mesh, None, topology.clone(), notes, false);
            // The filter may bridge a thin cut or part a membrane again. Then only what it leaves is filled.
            if candidate.repaired.genus == Some(0) {
                return Ok(candidate);
            }
        }
    }
    let (mesh, notes) = surface_of(&repaired, parameters, field_repair)?;
    repairs.extend(notes);
    Ok(Candidate::new(mesh, None, topology, repairs, false))
}

/// Refuses structures whose box or surface would be too large before anything is made of them.
///
/// A closed surface has about as many vertices as boundary faces. `slack` leaves room for what repairs and the filter
/// will take away; what remains is counted exactly later.
fn check_size(mask: &VoxelMask, limits: &IntakeLimits, slack: f64) -> Result<(), IntakeError> {
    let found = mask.dims().iter().map(|&d| d as u64).product();
    if found > MAX_BOX_VOXELS {
        let what = "voxels in the box around the structure";
        return Err(IntakeError::TooLarge { what, found, limit: MAX_BOX_VOXELS });
    }
    let (found, limit) = (mask.n_boundary_faces() as u64, (slack * limits.max_vertices as f64) as u64);
    if found > limit {
        return Err(IntakeError::TooLarge { what: "boundary faces", found, limit });
    }
    Ok(())
}

fn surface_of(
    mask: &VoxelMask,
    parameters: &InputParameters,
    field_repair: FieldRepair,
) -> Result<(SurfaceMesh, Vec<RepairNote>), IntakeError> {
    let smoothing_mm = parameters.smoothing_mm;
    let vanished = |_| IntakeError::Vanished { smoothing_mm, n_voxels: mask.n_voxels() as u64 };
    if parameters.surface == SurfaceKind::Voxel {
        return Ok((volume::voxel_surface(mask).map_err(vanished)?, Vec::new()));
    }
    let surface = volume::smooth_surface(mask, smoothing_mm, field_repair).map_err(vanished)?;
    let mut notes = Vec::new();
    if surface.n_dropped > 0 {
        let detail =
            format!("smoothing had parted the structure; {} voxels of smaller pieces dropped", surface.n_dropped);
        notes.push(RepairNote { repair: Repair::LargestComponent, detail });
    }
    notes.extend(surface.fill.map(|change| fill_note(change, " of the smoothed structure")));
    Ok((surface.mesh, notes))
}

fn fill_note(change: FillChange, of_what: &str) -> RepairNote {
    let BettiNumbers { n_tunnels, n_cavities, .. } = change.before;
    let what = if n_tunnels + n_cavities > 0 {
        let tunnels = counted(n_tunnels, "tunnel", "tunnels");
        format!("closed {tunnels} and {}{of_what}", counted(n_cavities, "cavity", "cavities"))
    } else {
        format!("parted or joined voxels{of_what} that touched only along an edge or at a corner")
    };
    let detail = format!("{what}; {} voxels added, {} removed", change.n_added, change.n_removed);
    RepairNote { repair: Repair::Fill, detail }
}

fn counted(n: u32, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}
