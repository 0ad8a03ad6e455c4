//! Inspection of an input and its suitability for matching: reports where [`super::prepare_surface`] would refuse.

use super::label_names::table_of;
use super::{
    InputKind, Inspection, IntakeError, IntakeLimits, LabelCount, Refusal, VolumeInspection, read, sampling_report,
};
use homolog_contract::parameters::{InputParameters, Method, preset};
use homolog_formats::FileContent;
use homolog_mesh::volume::{BettiNumbers, LabelVolume};
use std::collections::BTreeMap;

/// Largest number of listed labels.
const MAX_LISTED_LABELS: usize = 1000;

/// Reads `bytes` and reports the content of the file, the surface that would be made from it, and its suitability for
/// matching.
///
/// # Errors
/// [`IntakeError`] if the file cannot be read. An input that can be read but not matched is not an error: the
/// inspection contains the refusal.
///
/// # Cost
/// The cost of [`super::prepare_surface`].
pub fn inspect(
    bytes: &[u8],
    file_name: Option<&str>,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Result<Inspection, IntakeError> {
    let file = read(bytes, file_name, parameters, limits)?;
    let (kind, volume) = match &file.content {
        FileContent::Labels(volume) => (InputKind::LabelVolume, Some(describe(volume, &file.label_names))),
        FileContent::Mesh(_) => (InputKind::Mesh, None),
    };
    let mut inspection = Inspection {
        format: file.format,
        kind,
        space: file.space,
        volume,
        topology: None,
        repaired_topology: None,
        repairs: Vec::new(),
        turned_outward: false,
        notes: file.notes.clone(),
        warnings: file.warnings.clone(),
        sampling: None,
        suitable: false,
        refusal: None,
    };
    let refusal = match super::made::from_file(&file, parameters, limits) {
        Ok(candidate) => {
            let refusal = super::made::refusal(&candidate, &file, parameters, limits);
            inspection.topology = Some(candidate.topology);
            inspection.repaired_topology = Some(candidate.repaired);
            inspection.repairs = candidate.repairs;
            inspection.notes.extend(candidate.notes);
            inspection.warnings.extend(candidate.warnings);
            inspection.sampling = candidate.sampling.map(sampling_report);
            inspection.turned_outward = candidate.turned_outward;
            refusal
        }
        Err(error) => {
            inspection.topology = error.topology().cloned();
            Some(error)
        }
    };
    inspection.suitable = refusal.is_none();
    inspection.refusal = refusal.map(|e| Refusal { code: e.code().to_owned(), detail: e.to_string() });
    Ok(inspection)
}

/// The shape of a label's voxels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LabelShape {
    /// Pieces without a common voxel face.
    pub n_pieces: u32,
    /// Tunnels through the pieces.
    pub n_tunnels: u32,
}

/// The shapes of the first `most` labels of a volume, by label; empty if `bytes` are not a readable volume. A label
/// whose box exceeds [`IntakeLimits::max_voxels`] is left out.
///
/// # Cost
/// One pass over the volume per label, and linear in its box.
pub fn label_shapes(
    bytes: &[u8],
    file_name: Option<&str>,
    limits: &IntakeLimits,
    most: usize,
) -> BTreeMap<u32, LabelShape> {
    let file = read(bytes, file_name, &preset(Method::Balanced).input, limits);
    let Ok(FileContent::Labels(volume)) = file.map(|file| file.content) else { return BTreeMap::new() };
    let labels = volume.label_counts().into_keys().take(most);
    let shape = |label: u32| {
        let mask = volume.mask(Some(&[label]))?;
        let in_box: u64 = mask.dims().iter().map(|&d| d as u64).product();
        if in_box > limits.max_voxels {
            return None;
        }
        let BettiNumbers { n_pieces, n_tunnels, .. } = BettiNumbers::of(&mask);
        Some((label, LabelShape { n_pieces, n_tunnels }))
    };
    labels.filter_map(shape).collect()
}

fn describe(volume: &LabelVolume, names: &BTreeMap<u32, String>) -> VolumeInspection {
    let counts = volume.label_counts();
    let table = if names.is_empty() { table_of(&counts.keys().copied().collect()) } else { None };
    let name = |label: u32| {
        names.get(&label).cloned().or_else(|| table.and_then(|table| table.name_of(label)).map(str::to_owned))
    };
    VolumeInspection {
        dims: volume.dims().map(|d| d as u32),
        spacing_mm: volume.spacing_mm(),
        n_labels: counts.len() as u32,
        labels: counts
            .into_iter()
            .take(MAX_LISTED_LABELS)
            .map(|(label, n_voxels)| LabelCount { label, name: name(label), n_voxels })
            .collect(),
    }
}
