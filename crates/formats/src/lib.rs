#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_types))]

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

/// Limits on the size of files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ReadLimits {
    /// Largest size after decompression, bytes; also the largest memory for the labels of a volume.
    pub max_inflated_bytes: usize,
    /// Largest inflation above one mebibyte, as a multiple of the received bytes.
    pub max_inflation: usize,
    /// Largest number of vertices of a mesh.
    pub max_vertices: usize,
    /// Largest memory for reading besides the voxels that a header declares, bytes. [`read_with`] uses less: 64 times
    /// the received bytes, plus 16 MiB.
    pub max_memory: usize,
}

/// Default of [`ReadLimits::max_inflation`]: deflate itself reaches 1032, so only archives that name the same bytes
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

/// The result of reading a file.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadFile {
    /// Its format.
    pub format: InputFormat,
    /// Its content, in RAS.
    pub content: FileContent,
    /// The declared coordinate space, before conversion.
    pub space: InputSpace,
    /// Names of the labels of a volume as given in the file, for formats with names.
    pub label_names: BTreeMap<u32, String>,
    /// Changes of coordinates or values, and a mismatch between name and format: a sentence each, without text of the
    /// file.
    pub notes: Vec<String>,
    /// Contradictions within the file that put the content in doubt.
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

/// Default of [`ReadOptions::fraction`].
pub const DEFAULT_FRACTION: f64 = 0.5;

/// Choices of the sender where a file leaves them open.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadOptions {
    /// Least share of the largest value from which a voxel of a fractional segmentation belongs to a segment.
    pub fraction: f64,
    /// Whether to apply the coordinate transform of a GIFTI file; `None` applies rigid ones.
    pub apply_transform: Option<bool>,
    /// The labels that will be used, if known: frames of other segments need not lie on their stack. All readable
    /// labels are read.
    pub labels: Option<Vec<LabelChoice>>,
}

impl Default for ReadOptions {
    fn default() -> Self {
        ReadOptions { fraction: DEFAULT_FRACTION, apply_transform: None, labels: None }
    }
}

impl ReadOptions {
    /// Whether a label, with its name in the file, will be used.
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
/// The errors of [`read_with`].
pub fn read(bytes: &[u8], file_name: Option<&str>, limits: &ReadLimits) -> Result<ReadFile, FormatError> {
    read_with(bytes, file_name, limits, &ReadOptions::default())
}

/// Reads a file of any of the [`InputFormat`]s, plain, compressed with gzip, or alone in a zip archive; or a zip
/// archive of DICOM segmentations, as one volume. The content determines the format; the name decides only where the
/// content does not.
///
/// # Errors
/// [`FormatError::UnknownFormat`] for an unrecognized format; [`FormatError::Unsupported`] for a recognized format that
/// is not read; [`FormatError::NotAsNamed`] if only the name indicates a format; [`FormatError::Gzip`] or
/// [`FormatError::Zip`] if compressed data are damaged or incomplete; otherwise the errors of the format's reader.
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

/// [`read_with`] for files that are not archives.
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
            // The text of the facets takes by far the largest part of the memory while they are joined.
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

/// Bytes of a file that are searched for the size of its volume.
const HEAD_BYTES: usize = dicom::HEAD_BYTES;

/// Size of the voxels declared by the header of a volume, bytes as stored; 0 for other files.
///
/// # Errors
/// `Gzip` if the start of the stream is damaged.
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

/// Note of a report on bytes after everything that a header states.
fn trailing_note(n_bytes: usize) -> String {
    format!("{n_bytes} bytes after the end of what the header states were not read")
}

/// Bytes of a file's title, header or first comments that are searched for a declared space.
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

    /// A mesh in a format whose free text may declare the coordinate space, as written by 3D Slicer.
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
