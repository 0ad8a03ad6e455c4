//! Turns the bytes of an uploaded file into a surface that can be matched, or into a refusal with the fault and its
//! position.
//!
//! [`prepare_surface`] reads the file, makes a surface, repairs it as far as the parameters allow and checks the
//! result. [`inspect`] does the same and reports findings instead of refusing. [`shown_surface`] is a surface to look
//! at, also of a refused file, [`shown_volume`] the volume behind it. None of them repeats the file's name or text from the file: both may name a patient.

mod candidate;
mod error;
mod inspection;
mod label_names;
mod label_surface;
mod made;
mod near;
mod shown;
mod split;
mod warnings;

pub use error::{Advice, IntakeError};
pub use homolog_contract::input::{InputFormat, InputKind, InputReport, Inspection};
pub use inspection::{LabelShape, inspect, label_shapes};
pub use label_names::{LabelTable, NearName, are_one_name, chosen_numbers, label_tables};
pub use shown::{shown_surface, shown_volume};

use crate::mirror_plane::MirrorPlane;
use candidate::Candidate;
use homolog_contract::input::{LabelCount, Refusal, RepairNote, SamplingReport, VolumeInspection};
use homolog_contract::parameters::{InputParameters, Repair};
pub use homolog_formats::DEFAULT_INFLATION;
use homolog_formats::{FileContent, FormatError, ReadFile, ReadLimits, ReadOptions};
use homolog_mesh::volume::Sampling;
use homolog_mesh::{ClosestPointIndex, Numbering, SurfaceMesh};
use serde::{Deserialize, Serialize};
use std::collections::HashSet;
pub(crate) use warnings::UsedLabels;

/// A vertex dropped by simplification, and its place on the simplified surface; all in the numbering of the upload.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Dropped {
    pub(crate) vertex: u32,
    pub(crate) triangle: [u32; 3],
    pub(crate) barycentric: [f64; 3],
}

/// A surface that is ready to be matched: its faces agree in orientation and look outwards.
#[derive(Debug, Clone, PartialEq)]
pub struct PreparedSurface {
    /// The surface to be matched, mm; mirrored on request.
    pub mesh: SurfaceMesh,
    /// For each vertex of `mesh`, its vertex in the upload. For a label volume the upload is the surface made from it,
    /// which is `mesh` itself.
    pub numbering: Numbering,
    /// The faces of `mesh` over the vertices of the upload, before simplification; present if repairs dropped or merged
    /// vertices. Always present for a mirrored surface, in its original place.
    restored: Option<SurfaceMesh>,
    /// The plane in which the surface was mirrored.
    mirror: Option<MirrorPlane>,
    /// Vertices that simplification dropped.
    dropped: Vec<Dropped>,
    /// The labels the surface was made from; `None` for meshes.
    labels: Option<UsedLabels>,
    /// Report on the input and on its changes.
    pub report: InputReport,
}

impl PreparedSurface {
    /// The surface whose vertices an answer refers to, in the coordinates of the file: the matched faces, or the faces
    /// before simplification, over all vertices of the upload, including unused ones.
    pub fn uploaded(&self) -> &SurfaceMesh {
        self.restored.as_ref().unwrap_or(&self.mesh)
    }

    /// Vertices dropped by simplification, with their places on `mesh`.
    pub(crate) fn dropped(&self) -> &[Dropped] {
        &self.dropped
    }

    /// The surface mirrored along the left-right axis declared by its file, or else in its best plane. The mirrored
    /// surface is matched, and the answer refers to the original place.
    ///
    /// # Errors
    /// [`IntakeError::Unreadable`] if a coordinate overflows.
    pub(crate) fn mirrored(mut self) -> Result<Self, IntakeError> {
        let plane = MirrorPlane::of(&self.mesh, self.report.space);
        let mesh = plane.surface(&self.mesh).map_err(|e| IntakeError::Unreadable(e.into()))?;
        let before = std::mem::replace(&mut self.mesh, mesh);
        self.restored.get_or_insert(before);
        self.mirror = Some(plane);
        self.report.notes.push(plane.note());
        Ok(self)
    }

    pub(crate) fn mirror(&self) -> Option<MirrorPlane> {
        self.mirror
    }

    pub(crate) fn labels(&self) -> Option<&UsedLabels> {
        self.labels.as_ref()
    }

    pub(crate) fn heap_bytes(&self) -> usize {
        let restored = self.restored.as_ref().map_or(0, SurfaceMesh::heap_bytes);
        self.mesh.heap_bytes() + self.numbering.heap_bytes() + restored + size_of_val(self.dropped.as_slice())
    }
}

/// Limits on inputs, so that no file can use more memory than the operator allows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct IntakeLimits {
    /// Largest file as uploaded, bytes.
    pub max_bytes: usize,
    /// Largest file after decompression, bytes.
    pub max_inflated_bytes: usize,
    /// Largest inflation above one mebibyte, as a multiple of the size as uploaded.
    pub max_inflation: usize,
    /// Largest number of vertices of a matched surface; with `input.max_vertices` it applies to the simplified surface.
    pub max_vertices: usize,
    /// Largest number of faces of an uploaded mesh, and of vertices of a surface to be simplified; the surface of a
    /// volume is bounded by its vertices.
    pub max_faces: usize,
    /// Largest number of voxels of the box around a structure: filling and smoothing work on the whole box.
    pub max_voxels: u64,
    /// Largest memory of one match, bytes; it grows with the product of both sizes.
    pub max_match_bytes: u64,
}

/// Default of [`IntakeLimits::max_faces`]: a closed surface of triangles has two per vertex.
pub const DEFAULT_FACES: usize = 1_000_000;

/// Default of [`IntakeLimits::max_voxels`].
pub const DEFAULT_VOXELS: u64 = 1 << 23;

/// Default of [`IntakeLimits::max_match_bytes`]: enough for two surfaces of about 12,000 vertices each.
pub const DEFAULT_MATCH_BYTES: u64 = 8 << 30;

impl Default for IntakeLimits {
    fn default() -> Self {
        IntakeLimits {
            max_bytes: 256 << 20,
            max_inflated_bytes: 1 << 30,
            max_inflation: DEFAULT_INFLATION,
            max_vertices: 200_000,
            max_faces: DEFAULT_FACES,
            max_voxels: DEFAULT_VOXELS,
            max_match_bytes: DEFAULT_MATCH_BYTES,
        }
    }
}

/// Reads `bytes`, makes a surface, and repairs it as far as `parameters` allow. Refuses the result if it has no
/// consistent orientation, is closed but encloses no volume, or has a boundary that `parameters` do not allow.
/// `file_name` is used only if the bytes alone do not determine the format.
///
/// # Errors
/// [`IntakeError`].
///
/// # Cost
/// Linear in the file; filling a label volume adds `O(n log n)` in the box around the structure. An unsuitable surface
/// costs up to four times as much, for the search for the recommended repair.
pub fn prepare_surface(
    bytes: &[u8],
    file_name: Option<&str>,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Result<PreparedSurface, IntakeError> {
    let file = read(bytes, file_name, parameters, limits)?;
    let candidate = made::from_file(&file, parameters, limits)?;
    if let Some(refusal) = made::refusal(&candidate, &file, parameters, limits) {
        return Err(refusal);
    }
    let ReadFile { format, content, space, mut notes, mut warnings, .. } = file;
    let Candidate {
        mesh,
        numbering,
        added,
        whole,
        topology,
        repairs,
        turned_outward,
        notes: of_repairs,
        warnings: of_surface,
        labels,
        sampling,
        ..
    } = candidate;
    notes.extend(of_repairs);
    warnings.extend(of_surface);
    let sampling = sampling.map(sampling_report);
    let report =
        InputReport { format, space: Some(space), topology, repairs, turned_outward, notes, warnings, sampling };
    let dropped = whole.as_ref().map(|whole| dropped(&mesh, &numbering, whole)).unwrap_or_default();
    // Answers refer to the vertices before simplification.
    let (faces, names) = whole.as_ref().map_or((&mesh, &numbering), |(faces, names)| (faces, names));
    let restored = match &content {
        // Repairs keep the order of vertices, so a mesh with as many vertices has the numbering of the file.
        FileContent::Mesh(file) if names.n_vertices() < file.mesh.n_vertices() + added.len() => {
            let mut vertices: Vec<_> = file.mesh.vertices().iter().copied().chain(added).collect();
            // Closing a tunnel moves some vertices.
            for (&original, place) in names.originals().iter().zip(faces.vertices()) {
                vertices[original as usize] = *place;
            }
            let restored = names.restored(faces, &vertices);
            Some(restored.map_err(|e| IntakeError::Unreadable(e.into()))?)
        }
        _ => whole.map(|(faces, _)| faces),
    };
    Ok(PreparedSurface { mesh, numbering, restored, mirror: None, dropped, labels, report })
}

fn read(
    bytes: &[u8],
    file_name: Option<&str>,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Result<ReadFile, IntakeError> {
    if bytes.len() > limits.max_bytes {
        let (found, limit) = (bytes.len() as u64, limits.max_bytes as u64);
        return Err(IntakeError::TooLarge { what: "bytes", found, limit });
    }
    if bytes.is_empty() {
        return Err(IntakeError::Unreadable(FormatError::Empty));
    }
    let IntakeLimits { max_inflated_bytes, max_inflation, max_vertices, max_faces, .. } = *limits;
    // A mesh that will be simplified is bounded by its faces alone, about two per vertex.
    let max_vertices = if parameters.max_vertices.is_some() { max_vertices.max(max_faces) } else { max_vertices };
    let read_limits = ReadLimits { max_inflated_bytes, max_inflation, max_vertices, ..ReadLimits::default() };
    let InputParameters { fraction, apply_transform, labels, .. } = parameters;
    let options = ReadOptions { fraction: *fraction, apply_transform: *apply_transform, labels: labels.clone() };
    homolog_formats::read_with(bytes, file_name, &read_limits, &options).map_err(|error| match error {
        FormatError::UnknownFormat => IntakeError::UnknownFormat,
        FormatError::TooLarge { what, found, limit } => IntakeError::TooLarge { what, found, limit },
        error => IntakeError::Unreadable(error),
    })
}

/// The sampling in degrees, with a finite bound for an undetermined rotation.
fn sampling_report(Sampling { noise_mm, rotation_rad }: Sampling) -> SamplingReport {
    SamplingReport { noise_mm, rotation_deg: rotation_rad.to_degrees().min(180.0) }
}

/// Places of the vertices dropped by simplification on the simplified surface.
fn dropped(mesh: &SurfaceMesh, numbering: &Numbering, (whole, of_whole): &(SurfaceMesh, Numbering)) -> Vec<Dropped> {
    let kept: HashSet<u32> = numbering.originals().iter().copied().collect();
    let index = ClosestPointIndex::new(mesh);
    let all = of_whole.originals().iter().zip(whole.vertices());
    all.filter(|(vertex, _)| !kept.contains(vertex))
        .map(|(&vertex, place)| {
            let at = index.closest(place);
            let triangle = at.triangle.map(|corner| numbering.original(corner));
            Dropped { vertex, triangle, barycentric: at.barycentric }
        })
        .collect()
}

/// The name of a repair in JSON.
fn repair_name(repair: Repair) -> &'static str {
    match repair {
        Repair::Weld => "weld",
        Repair::Orient => "orient",
        Repair::Split => "split",
        Repair::LargestComponent => "largest_component",
        Repair::Fill => "fill",
        Repair::Triangulate => "triangulate",
        Repair::Simplify => "simplify",
    }
}

/// `n` and its noun, in the singular or the plural.
fn counted(n: u64, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}
