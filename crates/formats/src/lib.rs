//! Readers and writers of meshes and label volumes, one module per format, and writers of the results of a match: pairs of
//! vertices as tables ([`npy`], [`arrow`]), per-vertex values with their mesh, and transforms ([`transform`]).
//!
//! Input is untrusted. Readers take the whole file as a slice, and [`ReadLimits`]; counts in a header are checked against
//! the length of the file before anything is allocated, and every list that grows with the content is charged to a budget of
//! memory (`budget`), so a small file cannot cause a large allocation or a long computation, whatever it inflates to. Compressed files are decompressed to their end, and every checksum is verified. [`read`] detects the format
//! from the bytes and uses the file's name only where they do not decide. Errors carry positions (lines, vertices,
//! voxels), never text of the file, which may name a patient.

mod archive;
mod budget;
mod detect;
mod dicom;
mod dicom_file;
mod element;
mod error;
mod gzip;
mod label_file;
mod lps;
mod nifti_labels;
mod pairs;
mod polygons;
mod text;
mod two_affines;
mod units;
mod unread;
mod vertex_arrays;
mod xml;

pub mod arrow;
pub mod csv_cell;
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
pub mod parquet;
pub mod ply;
pub mod segmentation;
pub mod spatial_registration;
pub mod stl;
pub mod transform;
pub mod vertex_table;
pub mod vtk;
pub mod vtp;

pub use archive::write_zip;
use budget::Budget;
pub use error::{FormatError, GzipFault};
pub use homolog_contract::input::{InputFormat, InputSpace, InputWarning};
pub use homolog_contract::parameters::LabelChoice;
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
    /// Largest size after decompression, as a multiple of what was received, above a mebibyte.
    pub max_inflation: usize,
    /// Most vertices of a mesh.
    pub max_vertices: usize,
    /// Most memory that reading may take beside the voxels that a header declares, bytes. [`read_with`] takes less: 64 times what was
    /// received, and 16 MiB.
    pub max_memory: usize,
}

/// The default of [`ReadLimits::max_inflation`]: deflate itself reaches 1032, so only archives that name the same bytes
/// several times, or that are compressed twice, inflate more.
pub const DEFAULT_INFLATION: usize = 1100;

impl Default for ReadLimits {
    fn default() -> Self {
        ReadLimits {
            max_inflated_bytes: 1 << 30,
            max_inflation: DEFAULT_INFLATION,
            max_vertices: 200_000,
            max_memory: usize::MAX,
        }
    }
}

/// A file as it was read.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadFile {
    /// Its format.
    pub format: InputFormat,
    /// Its content, in RAS.
    pub content: FileContent,
    /// The space of coordinates that it declares, before they were converted.
    pub space: InputSpace,
    /// Names of the labels of a volume, for formats that have them, as the file gives them.
    pub label_names: BTreeMap<u32, String>,
    /// What was done to coordinates or values, and whether the name promises another format: a sentence each, without text
    /// of the file.
    pub notes: Vec<String>,
    /// What the file contradicts itself in, so that what is made of it is in doubt.
    pub warnings: Vec<InputWarning>,
}

/// The content of a file.
#[derive(Debug, Clone, PartialEq)]
pub enum FileContent {
    /// A label volume.
    Labels(LabelVolume),
    /// A surface mesh.
    Mesh(MeshFile),
}

/// The default of the least share of the largest value from which a voxel of a fractional segmentation belongs to a segment.
pub const DEFAULT_FRACTION: f64 = 0.5;

/// What a sender decides where a file leaves a choice.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadOptions {
    /// Share of the largest value from which a voxel of a fractional segmentation belongs to a segment.
    pub fraction: f64,
    /// Whether the coordinate transform that a GIFTI file states is applied; `None`: if it is rigid.
    pub apply_transform: Option<bool>,
    /// The labels that will be used, where they are known: frames of other segments need not fit on their stack. All labels that
    /// can be read are read.
    pub labels: Option<Vec<LabelChoice>>,
}

impl Default for ReadOptions {
    fn default() -> Self {
        ReadOptions { fraction: DEFAULT_FRACTION, apply_transform: None, labels: None }
    }
}

impl ReadOptions {
    /// Whether a label will be used, whose name is that of the file.
    fn asks_for(&self, label: u32, name: Option<&String>) -> bool {
        let is_it = |choice: &LabelChoice| match choice {
            LabelChoice::Number(number) => *number == label,
            LabelChoice::Name(wanted) => {
                name.is_some_and(|name| name.trim().to_lowercase() == wanted.trim().to_lowercase())
            }
        };
        self.labels.as_ref().is_none_or(|labels| labels.iter().any(is_it))
    }
}

/// [`read_with`] with the defaults of [`ReadOptions`].
///
/// # Errors
/// Those of [`read_with`].
pub fn read(bytes: &[u8], file_name: Option<&str>, limits: &ReadLimits) -> Result<ReadFile, FormatError> {
    read_with(bytes, file_name, limits, &ReadOptions::default())
}

/// Reads a file of any of the [`InputFormat`]s, plain, compressed with gzip, or alone in a zip archive; or a zip archive of
/// DICOM segmentations, as one volume. The format is found from the content; the name decides only where that does not.
///
/// # Errors
/// [`FormatError::UnknownFormat`] if it is none of them; [`FormatError::Unsupported`] if it is one that is known and not
/// read; [`FormatError::NotAsNamed`] if only the name promises one; [`FormatError::Gzip`] or [`FormatError::Zip`] if what is
/// compressed is damaged or incomplete; else those of the format's reader.
///
/// # Cost
/// Linear in the inflated size.
pub fn read_with(
    bytes: &[u8],
    file_name: Option<&str>,
    limits: &ReadLimits,
    options: &ReadOptions,
) -> Result<ReadFile, FormatError> {
    let most = bytes.len().max(1 << 20).saturating_mul(limits.max_inflation);
    let limits = &ReadLimits {
        max_inflated_bytes: limits.max_inflated_bytes.min(most),
        max_memory: limits.max_memory.min(budget::for_file(bytes.len())),
        ..*limits
    };
    if !archive::is_zip(bytes) {
        return read_file(bytes, file_name, limits, options);
    }
    let budget = Budget::of(limits);
    let content = archive::content(bytes, limits, &budget)?;
    let limits = &ReadLimits { max_memory: budget.left(), ..*limits };
    match content {
        archive::Content::File(file, name) => read_file(&file, Some(&name), limits, options),
        archive::Content::Instances(instances, n_others) => {
            let files: Vec<&[u8]> = instances.iter().map(|file| &**file).collect();
            let mut read = ReadFile::labels(InputFormat::DicomSeg, dicom_seg::read_dicom_seg(&files, limits, options)?);
            read.notes.push(format!(
                "the archive has {} of DICOM, which were read as one volume, and {} that were not read",
                if files.len() == 1 { "1 segmentation".to_owned() } else { format!("{} segmentations", files.len()) },
                if n_others == 1 { "1 other file".to_owned() } else { format!("{n_others} other files") }
            ));
            Ok(read)
        }
    }
}

/// [`read_with`] for a file that is no archive.
fn read_file(
    bytes: &[u8],
    file_name: Option<&str>,
    limits: &ReadLimits,
    options: &ReadOptions,
) -> Result<ReadFile, FormatError> {
    let head = gzip::unverified_prefix(bytes, nifti::HEADER_BYTES)?;
    // A volume need not be inflated as a whole.
    if nifti::is_nifti(&head) {
        let mut read = ReadFile::labels(InputFormat::Nifti, nifti::read_nifti(bytes, limits)?);
        read.notes.extend(detect::misnamed(InputFormat::Nifti, file_name));
        return Ok(read);
    }
    let budget = Budget::of(limits);
    if gzip::is_gzip(bytes) {
        budget.grant(declared_voxels(bytes)?.min(limits.max_inflated_bytes));
    }
    let inflated = gzip::inflate(bytes, limits.max_inflated_bytes, &budget)?;
    let before = limits;
    let limits = &ReadLimits { max_memory: budget.left(), ..*limits };
    let (format, bytes) = detect::detect(&inflated, file_name)?;
    use InputFormat::{DicomSeg, MetaImage, Mgh, Nifti, Nrrd};
    if !matches!(format, Nifti | Mgh | Nrrd | MetaImage | DicomSeg) {
        Polygons::check_bytes(bytes.len() as u64, limits)?;
    }
    let mut read = match format {
        InputFormat::Nifti => ReadFile::labels(format, nifti::read_nifti(bytes, limits)?),
        InputFormat::Mgh => ReadFile::labels(format, mgh::read_mgh(bytes, limits)?),
        InputFormat::Nrrd => ReadFile::labels(format, nrrd::read_nrrd(bytes, limits)?),
        InputFormat::MetaImage => ReadFile::labels(format, metaimage::read_metaimage(bytes, limits)?),
        InputFormat::DicomSeg => ReadFile::labels(format, dicom_seg::read_dicom_seg(&[bytes], limits, options)?),
        InputFormat::Freesurfer => ReadFile::mesh(format, freesurfer::read_freesurfer(bytes, limits)?),
        InputFormat::Gifti => ReadFile::mesh(format, gifti::read_gifti(bytes, limits, options.apply_transform)?),
        InputFormat::Ply => ReadFile::declared(format, ply::read_ply(bytes, limits)?, bytes)?,
        InputFormat::Stl => {
            let (soup, head) = (stl::read_soup(bytes, limits)?, bytes[..bytes.len().min(DECLARATION_BYTES)].to_vec());
            // Text of facets is by far the largest part of what joining them takes.
            drop(inflated);
            ReadFile::declared(format, soup.joined(before)?, &head)?
        }
        InputFormat::Vtk => ReadFile::declared(format, vtk::read_vtk(bytes, limits)?, bytes)?,
        InputFormat::Vtp => ReadFile::mesh(format, vtp::read_vtp(bytes, limits)?),
        InputFormat::Obj => ReadFile::declared(format, obj::read_obj(bytes, limits)?, bytes)?,
        InputFormat::Off => ReadFile::mesh(format, off::read_off(bytes, limits)?),
        InputFormat::Mz3 => ReadFile::mesh(format, mz3::read_mz3(bytes, limits)?),
    };
    read.notes.extend(detect::misnamed(format, file_name));
    Ok(read)
}

/// As much of a file as is looked at for the size of its volume.
const HEAD_BYTES: usize = dicom::HEAD_BYTES;

/// Bytes of the voxels that the header of a volume declares, as they are stored; 0 for other files.
///
/// # Errors
/// `Gzip` if the stream is damaged where it begins.
fn declared_voxels(bytes: &[u8]) -> Result<usize, FormatError> {
    let head = gzip::unverified_prefix(bytes, HEAD_BYTES)?;
    Ok(match detect::by_content(&head) {
        Some(InputFormat::Nifti) => nifti::declared(&head),
        Some(InputFormat::Mgh) => mgh::declared(&head),
        Some(InputFormat::Nrrd) => nrrd::declared(&head),
        Some(InputFormat::MetaImage) => metaimage::declared(&head),
        Some(InputFormat::DicomSeg) => dicom::declared_pixels(&head),
        _ => 0,
    })
}

/// What a report says of bytes after everything that a header states.
fn trailing_note(n_bytes: usize) -> String {
    format!("{n_bytes} bytes after the end of what the header states were not read")
}

/// How much of a file's title, header or first comments is searched for a declared space.
const DECLARATION_BYTES: usize = 1024;

impl ReadFile {
    fn labels(format: InputFormat, file: LabelFile) -> Self {
        let LabelFile { volume, space, names, notes, warnings } = file;
        ReadFile { format, content: FileContent::Labels(volume), space, label_names: names, notes, warnings }
    }

    fn mesh(format: InputFormat, mut file: MeshFile) -> Self {
        let (space, notes) = (file.space, std::mem::take(&mut file.notes));
        let (label_names, warnings) = (BTreeMap::new(), Vec::new());
        ReadFile { format, content: FileContent::Mesh(file), space, label_names, notes, warnings }
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
