//! Makes a surface from a label volume: selects the labels, repairs their voxels, and extracts the surface.

use super::candidate::Candidate;
use super::label_names::chosen;
use super::warnings::{self, UsedLabels};
use super::{IntakeError, IntakeLimits, RepairNote, counted};
use homolog_contract::input::InputWarning;
use homolog_contract::parameters::{InputParameters, Repair, SurfaceKind};
use homolog_mesh::topology::{TopologyReport, topology_report};
use homolog_mesh::volume::smooth_surface::FieldRepair;
use homolog_mesh::volume::{
    self, BettiNumbers, Contacts, FillChange, LabelVolume, Sampling, ValueStatistics, VoxelMask,
};
use homolog_mesh::{Numbering, SurfaceMesh};
use std::collections::BTreeMap;

/// Largest number of labels that a refusal lists.
pub(super) const MAX_NAMED_LABELS: usize = 50;

/// The surface of the selected labels of `volume`, whose labels have these `names`.
///
/// # Errors
/// [`IntakeError`] if the values are not labels, no selected label occurs, a limit is exceeded, or smoothing leaves
/// nothing.
pub(super) fn from_labels(
    volume: &LabelVolume,
    names: &BTreeMap<u32, String>,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Result<Candidate, IntakeError> {
    let chosen = parameters.labels.as_deref().map(|labels| chosen(labels, names, volume)).transpose()?;
    let (requested, notes) = chosen.map_or((None, Vec::new()), |chosen| (Some(chosen.numbers), chosen.notes));
    // Names of labels, and a request that selects labels, confirm that the values are labels.
    if requested.is_none() && names.is_empty() && !parameters.image_is_labels {
        refuse_image(volume)?;
    }
    let Some(mask) = volume.mask(requested.as_deref()) else {
        let labels: Vec<u32> = volume.label_counts().into_keys().collect();
        let n_present = labels.len();
        let present = labels.into_iter().take(MAX_NAMED_LABELS).collect();
        return Err(IntakeError::EmptyStructure { requested, present, n_present });
    };
    let labels = UsedLabels::new(volume, requested.as_deref());
    let of_all = labels.are_joined_unasked();
    check_size(&mask, limits, 2.0, of_all)?;
    let (raw, _) = surface_of(&mask, parameters, FieldRepair::default())?;
    let mut work = Work {
        parameters,
        // Repairs named in a request are intended by its sender.
        asked: parameters.repair.is_some(),
        topology: topology_report(&raw),
        repairs: Vec::new(),
        warnings: labels.joined_warning(names).into_iter().collect(),
    };
    let allowed = parameters.repair.as_deref().unwrap_or(&[Repair::LargestComponent, Repair::Fill]);
    let one_piece = allowed.contains(&Repair::LargestComponent);
    let repaired = if one_piece { work.one_piece(&mask) } else { None };
    let is_changed = repaired.is_some();
    let repaired = repaired.unwrap_or(mask);
    check_size(&repaired, limits, 1.25, of_all)?;
    let may_fill = allowed.contains(&Repair::Fill) && (one_piece || volume::largest_component(&repaired).1 == 1);
    let field_repair = FieldRepair { largest_component: one_piece, fill: allowed.contains(&Repair::Fill) };
    let candidate = match work.filled(&repaired, may_fill, field_repair)? {
        Some(candidate) => candidate,
        // The surface of a mask that no repair changed already exists.
        None if !is_changed && is_exact(parameters) => work.candidate(raw),
        None => {
            let (mesh, notes) = surface_of(&repaired, parameters, field_repair)?;
            work.repairs.extend(notes);
            work.warnings.extend(smoothing_warning(&mesh, &repaired, parameters));
            work.candidate(mesh)
        }
    };
    let sampling = Some(Sampling::of(&candidate.mesh, repaired.affine()));
    Ok(Candidate { labels: Some(labels), notes, sampling, ..candidate })
}

/// Findings and repairs on the way to a surface.
struct Work<'a> {
    parameters: &'a InputParameters,
    asked: bool,
    /// Topology of the surface before repairs.
    topology: TopologyReport,
    repairs: Vec<RepairNote>,
    warnings: Vec<InputWarning>,
}

impl Work<'_> {
    /// The largest piece, after touching pieces were joined. `None` if there is only one piece.
    fn one_piece(&mut self, mask: &VoxelMask) -> Option<VoxelMask> {
        let joined = volume::join_touching(mask);
        if let Some(joined) = &joined {
            let detail = format!(
                "joined {} that touched only along an edge or at a corner; {} added",
                counted(joined.n_joined as u64 + 1, "piece", "pieces"),
                counted(joined.n_added as u64, "voxel", "voxels")
            );
            self.repairs.push(RepairNote { repair: Repair::LargestComponent, detail });
        }
        let joined = joined.map(|joined| joined.mask);
        let whole = joined.as_ref().unwrap_or(mask);
        let (piece, n_pieces, n_dropped) = volume::largest_component(whole);
        if n_pieces < 2 {
            return joined;
        }
        let n = whole.n_voxels();
        let detail = format!("kept the largest of {n_pieces} pieces; {n_dropped} of {n} voxels dropped");
        self.repairs.push(RepairNote { repair: Repair::LargestComponent, detail });
        self.warnings.push(warnings::piece_dropped(n_pieces, n_dropped as f64 / n as f64, "volume", self.asked));
        Some(piece)
    }

    /// The surface of `repaired` with its tunnels and cavities closed; `None` if it has none, or if smoothing opens
    /// others.
    fn filled(
        &mut self,
        repaired: &VoxelMask,
        may_fill: bool,
        field_repair: FieldRepair,
    ) -> Result<Option<Candidate>, IntakeError> {
        if !may_fill {
            return Ok(None);
        }
        let contacts = match self.parameters.surface {
            SurfaceKind::Smooth => Contacts::Allow,
            SurfaceKind::Voxel => Contacts::Resolve,
        };
        let filled = volume::fill(repaired, contacts);
        if filled.change.n_changed() == 0 {
            return Ok(None);
        }
        let not_again = FieldRepair { fill: false, ..field_repair };
        let (mesh, notes) = surface_of(&filled.mask, self.parameters, not_again)?;
        // Smoothing may bridge a thin gap or break a thin membrane again; in that case only the smoothed structure is
        // filled.
        if topology_report(&mesh).genus != Some(0) {
            return Ok(None);
        }
        self.repairs.push(fill_note(filled.change, ""));
        self.repairs.extend(notes);
        self.warnings.extend(warnings::filled(
            filled.change,
            volume::n_enclosed(repaired),
            repaired.n_voxels(),
            self.asked,
        ));
        self.warnings.extend(smoothing_warning(&mesh, &filled.mask, self.parameters));
        Ok(Some(self.candidate(mesh)))
    }

    /// The upload has no vertices, so answers refer to the vertices of the surface.
    fn candidate(&mut self, mesh: SurfaceMesh) -> Candidate {
        let numbering = Numbering::identity(mesh.n_vertices());
        let repairs = std::mem::take(&mut self.repairs);
        let warnings = std::mem::take(&mut self.warnings);
        Candidate { warnings, ..Candidate::new(mesh, numbering, self.topology.clone(), repairs, false) }
    }
}

/// Refuses a volume whose values are measurements.
fn refuse_image(volume: &LabelVolume) -> Result<(), IntakeError> {
    let statistics = ValueStatistics::of(volume);
    if !statistics.look_like_an_image() {
        return Ok(());
    }
    let ValueStatistics { n_values, n_together, equal_share, border_share } = statistics;
    Err(IntakeError::LooksLikeImage { n_values, n_together, equal_share, border_share })
}

/// Refuses structures whose box or surface would be too large, before any surface is made.
///
/// A closed surface has about as many vertices as the structure has boundary faces. `slack` leaves room for the parts
/// that repairs and smoothing will remove; the vertices of the surface are counted exactly later. `of_all`: several
/// labels were used without a selection, which is the likely reason.
fn check_size(mask: &VoxelMask, limits: &IntakeLimits, slack: f64, of_all: bool) -> Result<(), IntakeError> {
    let found = mask.dims().iter().map(|&d| d as u64).product();
    let limit = limits.max_voxels;
    if found > limit {
        let what = if of_all {
            "voxels in the box around all its labels (choose a structure: input.labels, a number or a name)"
        } else {
            "voxels in the box around the structure"
        };
        return Err(IntakeError::TooLarge { what, found, limit });
    }
    let (found, limit) = (mask.n_boundary_faces() as u64, (slack * limits.max_vertices as f64) as u64);
    if found > limit {
        let what = if of_all {
            "boundary faces of all its labels together (choose a structure: input.labels, a number or a name)"
        } else {
            "boundary faces of the structure"
        };
        return Err(IntakeError::TooLarge { what, found, limit });
    }
    Ok(())
}

/// Whether the surface has the topology of the voxels, so that it needs no further repair.
fn is_exact(parameters: &InputParameters) -> bool {
    parameters.surface == SurfaceKind::Voxel || parameters.smoothing_mm.is_none()
}

/// The surface of a structure, and the repairs of the smoothed structure.
fn surface_of(
    mask: &VoxelMask,
    parameters: &InputParameters,
    field_repair: FieldRepair,
) -> Result<(SurfaceMesh, Vec<RepairNote>), IntakeError> {
    let vanished = |smoothing_mm: f64| IntakeError::Vanished { smoothing_mm, n_voxels: mask.n_voxels() as u64 };
    let smoothing_mm = match (parameters.surface, parameters.smoothing_mm) {
        (SurfaceKind::Voxel, _) => return Ok((volume::voxel_surface(mask).map_err(|_| vanished(0.0))?, Vec::new())),
        (SurfaceKind::Smooth, None) => {
            return Ok((volume::constrained_surface(mask).map_err(|_| vanished(0.0))?, Vec::new()));
        }
        (SurfaceKind::Smooth, Some(smoothing_mm)) => smoothing_mm,
    };
    let surface = volume::smooth_surface(mask, smoothing_mm, field_repair).map_err(|_| vanished(smoothing_mm))?;
    let mut notes = Vec::new();
    if surface.n_dropped > 0 {
        let detail =
            format!("smoothing had split the structure; {} voxels of smaller pieces dropped", surface.n_dropped);
        notes.push(RepairNote { repair: Repair::LargestComponent, detail });
    }
    notes.extend(surface.fill.map(|change| fill_note(change, " of the smoothed structure")));
    Ok((surface.mesh, notes))
}

/// A warning on the volume lost by requested smoothing.
fn smoothing_warning(mesh: &SurfaceMesh, mask: &VoxelMask, parameters: &InputParameters) -> Option<InputWarning> {
    let smoothing_mm = parameters.smoothing_mm.filter(|mm| *mm > 0.0 && parameters.surface == SurfaceKind::Smooth)?;
    Some(warnings::smoothed(smoothing_mm, mesh.signed_volume() / mask.volume_mm3()))
}

fn fill_note(change: FillChange, of_what: &str) -> RepairNote {
    let BettiNumbers { n_tunnels, n_cavities, .. } = change.before;
    let what = if n_tunnels + n_cavities > 0 {
        let tunnels = counted(n_tunnels.into(), "tunnel", "tunnels");
        format!("closed {tunnels} and {}{of_what}", counted(n_cavities.into(), "cavity", "cavities"))
    } else {
        format!("separated or joined voxels{of_what} that touched only along an edge or at a corner")
    };
    let detail = format!("{what}; {} voxels added, {} removed", change.n_added, change.n_removed);
    RepairNote { repair: Repair::Fill, detail }
}
