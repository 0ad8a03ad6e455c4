//! Readers and writers of meshes and label volumes, one module per format, and writers of the results of a match: pairs of
//! vertices as tables ([`npy`], [`arrow`]), per-vertex values with their mesh, and transforms ([`transform`]).
//!
//! Input is untrusted. Readers take the whole file as a slice, and [`ReadLimits`]; counts in a header are checked against
//! the length of the file before anything is allocated, so a small file cannot cause a large allocation or a long
//! computation. Compressed files are decompressed to their end, and every checksum is verified. [`read`] detects the format
//! from the bytes and uses the file's name only where they do not decide. Errors carry positions (lines, vertices,
//! voxels), never text of the file, which may name a patient.

mod detect;
mod dicom;
mod element;
mod error;
mod gzip;
mod label_file;
mod lps;
mod pairs;
mod polygons;
mod text;
mod vertex_arrays;
mod xml;

pub mod arrow;
pub mod dicom_seg;
pub mod freesurfer;
pub mod gifti;
pub mod glb;
pub mod metaimage;
pub mod mgh;
pub mod mz3;
pub mod nifti;
pub mod npy;
pub mod npz;
pub mod nrrd;
pub mod obj;
pub mod off;
pub mod ply;
pub mod spatial_registration;
pub mod stl;
pub mod transform;
pub mod vertex_table;
pub mod vtk;
pub mod vtp;

pub use error::{FormatError, GzipFault};
pub use homolog_contract::input::InputFormat;
pub use label_file::LabelFile;
pub use nifti::{write_nifti, write_nifti_gz};
pub use pairs::PairColumns;
pub use ply::write_ply;
pub use polygons::MeshFile;
use polygons::Polygons;
pub use stl::write_stl;
pub use vertex_arrays::{VertexArray, VertexValues};
pub use vtk::write_vtk;
pub use vtp::write_vtp;

use homolog_mesh::volume::LabelVolume;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Bounds on the size of what is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ReadLimits {
    /// Largest size after decompression, bytes; also the most memory that the labels of a volume may take.
    pub max_inflated_bytes: usize,
    /// Most vertices of a mesh.
    pub max_vertices: usize,
}

impl Default for ReadLimits {
    fn default() -> Self {
        ReadLimits { max_inflated_bytes: 1 << 30, max_vertices: 200_000 }
    }
}

/// A file as it was read.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadFile {
    /// Its format.
    pub format: InputFormat,
    /// Its content, in RAS.
    pub content: FileContent,
    /// Names of the labels of a volume, for formats that have them, as the file gives them.
    pub label_names: BTreeMap<u32, String>,
    /// What was done to coordinates or values, and whether the name promises another format: a sentence each, without text
    /// of the file.
    pub notes: Vec<String>,
}

/// The content of a file.
#[derive(Debug, Clone, PartialEq)]
pub enum FileContent {
    /// A label volume.
    Labels(LabelVolume),
    /// A surface mesh.
    Mesh(MeshFile),
}

/// Reads a file of any of the [`InputFormat`]s, plain or compressed with gzip. The format is found from the content; the
/// name decides only where that does not.
///
/// # Errors
/// [`FormatError::UnknownFormat`] if it is none of them; [`FormatError::Unsupported`] if it is one that is known and not
/// read; [`FormatError::Gzip`] if the compressed stream is damaged or incomplete; else those of the format's reader.
///
/// # Cost
/// Linear in the inflated size.
pub fn read(bytes: &[u8], file_name: Option<&str>, limits: &ReadLimits) -> Result<ReadFile, FormatError> {
    let head = gzip::unverified_prefix(bytes, nifti::HEADER_BYTES)?;
    // A volume need not be inflated as a whole.
    let inflated =
        if nifti::is_nifti(&head) { Plain::Borrowed(bytes) } else { gzip::inflate(bytes, limits.max_inflated_bytes)? };
    let format = if nifti::is_nifti(&head) { InputFormat::Nifti } else { detect::detect(&inflated, file_name)? };
    let bytes: &[u8] = &inflated;
    use InputFormat::{DicomSeg, MetaImage, Mgh, Nifti, Nrrd};
    if !matches!(format, Nifti | Mgh | Nrrd | MetaImage | DicomSeg) {
        Polygons::check_bytes(bytes.len() as u64, limits)?;
    }
    let mut read = match format {
        InputFormat::Nifti => ReadFile::volume(format, nifti::read_nifti(bytes, limits)?),
        InputFormat::Mgh => ReadFile::labels(format, mgh::read_mgh(bytes, limits)?),
        InputFormat::Nrrd => ReadFile::labels(format, nrrd::read_nrrd(bytes, limits)?),
        InputFormat::MetaImage => ReadFile::labels(format, metaimage::read_metaimage(bytes, limits)?),
        InputFormat::DicomSeg => ReadFile::labels(format, dicom_seg::read_dicom_seg(bytes, limits)?),
        InputFormat::Freesurfer => ReadFile::mesh(format, freesurfer::read_freesurfer(bytes, limits)?),
        InputFormat::Gifti => ReadFile::mesh(format, gifti::read_gifti(bytes, limits)?),
        InputFormat::Ply => ReadFile::declared(format, ply::read_ply(bytes, limits)?, bytes)?,
        InputFormat::Stl => ReadFile::declared(format, stl::read_stl(bytes, limits)?, bytes)?,
        InputFormat::Vtk => ReadFile::declared(format, vtk::read_vtk(bytes, limits)?, bytes)?,
        InputFormat::Vtp => ReadFile::mesh(format, vtp::read_vtp(bytes, limits)?),
        InputFormat::Obj => ReadFile::declared(format, obj::read_obj(bytes, limits)?, bytes)?,
        InputFormat::Off => ReadFile::mesh(format, off::read_off(bytes, limits)?),
        InputFormat::Mz3 => ReadFile::mesh(format, mz3::read_mz3(bytes, limits)?),
    };
    read.notes.extend(detect::misnamed(format, file_name));
    Ok(read)
}

/// How much of a file's title, header or first comments is searched for a declared space.
const DECLARATION_BYTES: usize = 1024;

impl ReadFile {
    fn volume(format: InputFormat, volume: LabelVolume) -> Self {
        ReadFile { format, content: FileContent::Labels(volume), label_names: BTreeMap::new(), notes: Vec::new() }
    }

    fn labels(format: InputFormat, file: LabelFile) -> Self {
        let LabelFile { volume, names, notes } = file;
        ReadFile { format, content: FileContent::Labels(volume), label_names: names, notes }
    }

    fn mesh(format: InputFormat, mut file: MeshFile) -> Self {
        let notes = std::mem::take(&mut file.notes);
        ReadFile { format, content: FileContent::Mesh(file), label_names: BTreeMap::new(), notes }
    }

    /// A mesh of a format in which 3D Slicer declares the space of the coordinates in free text.
    fn declared(format: InputFormat, mut file: MeshFile, bytes: &[u8]) -> Result<Self, FormatError> {
        if lps::is_declared(&bytes[..bytes.len().min(DECLARATION_BYTES)]) {
            lps::to_ras(&mut file)?;
        }
        Ok(ReadFile::mesh(format, file))
    }
}

/// The decompressed bytes of a file, borrowed if it was not compressed.
type Plain<'a> = Cow<'a, [u8]>;

#[cfg(test)]
mod export_tests;
#[cfg(test)]
mod gzip_tests;
#[cfg(test)]
mod tests;
