//! Errors of reading files: the fault, its position, and a remedy.

use homolog_mesh::MeshError;
use homolog_mesh::volume::VolumeError;

/// Reasons why a file cannot be read. Messages contain positions and numbers, never text of the file, which may name a
/// patient.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FormatError {
    /// No bytes.
    #[error("the file is empty; export it again, or repeat the upload")]
    Empty,
    /// None of the supported formats matches.
    #[error(
        "the file format is not recognized; convert surfaces to GIFTI, PLY, STL, VTK, VTP, OBJ, OFF, MZ3 or \
         FreeSurfer, label volumes to NIfTI, MGZ, NRRD, MetaImage or DICOM SEG"
    )]
    UnknownFormat,
    /// A size limit is exceeded.
    #[error("the file has {found} {what}, but at most {limit} are accepted; send a smaller one")]
    TooLarge {
        /// The counted items, plural.
        what: &'static str,
        /// Number found, at least.
        found: u64,
        /// Number accepted.
        limit: u64,
    },
    /// The compressed stream is damaged or incomplete.
    #[error(
        "the gzip stream {fault} (after {n_bytes} inflated bytes); compress the file again, or repeat the transfer that cut it off"
    )]
    Gzip {
        /// The fault.
        fault: GzipFault,
        /// Number of bytes inflated before the fault.
        n_bytes: usize,
    },
    /// The zip archive is damaged or incomplete.
    #[error("the zip archive {what}; pack it again, or repeat the upload")]
    Zip {
        /// The fault.
        what: &'static str,
    },
    /// The file is shorter than its header states.
    #[error(
        "{part} needs {needed} bytes, but only {available} are left; the file is truncated or its header is wrong, so export \
         it again or repeat the upload"
    )]
    Truncated {
        /// The incomplete part.
        part: &'static str,
        /// Bytes required.
        needed: u64,
        /// Bytes available.
        available: u64,
    },
    /// A count in the header disagrees with the content of the file.
    #[error(
        "the header states {stated} {what}, but the file holds {found}; one of the two is wrong, so that a part would be lost: \
         export the file again or repeat the upload"
    )]
    CountMismatch {
        /// The counted items, plural.
        what: &'static str,
        /// Number stated in the header.
        stated: u64,
        /// Number according to the length of the file.
        found: u64,
    },
    /// The file continues after everything that its header states.
    #[error(
        "the header states {stated} bytes of {what}, but {found} bytes are there, and those beyond are not empty; the sizes in \
         the header are wrong, or the file holds something else too: export it again"
    )]
    Overlong {
        /// The part that the header describes.
        what: &'static str,
        /// Bytes that the header states.
        stated: u64,
        /// Bytes found.
        found: u64,
    },
    /// The name of the file is the only evidence of a format, and the content does not have it.
    #[error(
        "the name promises {promised}, but the content is neither that nor another format that can be read; export it again, or \
         repeat the download that it comes from"
    )]
    NotAsNamed {
        /// The format that the name indicates.
        promised: &'static str,
    },
    /// A line of text does not follow the format.
    #[error("line {line}: expected {expected}; export the file again with the program that wrote it")]
    Syntax {
        /// The line, from 1.
        line: usize,
        /// The expected content.
        expected: &'static str,
    },
    /// A header field has an invalid value.
    #[error("the header's {field} is {value}; {advice}")]
    Header {
        /// The field.
        field: &'static str,
        /// Its value, a number or a list of numbers.
        value: String,
        /// The remedy.
        advice: &'static str,
    },
    /// An unsupported variant of the format.
    #[error("{what} is not supported; {advice}")]
    Unsupported {
        /// The variant.
        what: &'static str,
        /// The remedy.
        advice: &'static str,
    },
    /// The value of a voxel is not a label.
    #[error(
        "voxel ({}, {}, {}) has the value {value}, but labels are whole numbers from 0 to 4294967295; \
         send a label volume, not an image",
        voxel[0], voxel[1], voxel[2]
    )]
    NotALabel {
        /// Index of the voxel.
        voxel: [usize; 3],
        /// Its value after scaling.
        value: f64,
    },
    /// A face refers to a vertex by a negative index.
    #[error("face {face} refers to vertex {vertex}, but vertex indices start at 0; export the file again")]
    NegativeIndex {
        /// Index of the face.
        face: usize,
        /// The negative index.
        vertex: i64,
    },
    /// The parser of the format rejected the data.
    #[error("the data of the {format} file are damaged{}; export the file again", line.map(|l| format!(" at line {l}")).unwrap_or_default())]
    Payload {
        /// The format.
        format: &'static str,
        /// The line, from 1, of text files.
        line: Option<usize>,
    },
    /// Vertices and faces do not form a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// Labels and affine do not form a volume.
    #[error(transparent)]
    Volume(#[from] VolumeError),
}

/// Fault of a gzip stream, worded as the predicate of "the gzip stream".
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum GzipFault {
    /// The header of a member has a compression method or flags that RFC 1952 does not define, or a wrong checksum.
    #[error("is damaged: the header of a member is not valid")]
    Header,
    /// The bytes between header and trailer are not a deflate stream.
    #[error("is damaged: its compressed data are not valid")]
    Data,
    /// The CRC-32 in the trailer does not match the inflated bytes.
    #[error("is damaged: its checksum does not match")]
    Checksum,
    /// The length in the trailer does not match the inflated bytes.
    #[error("is damaged: its length does not match")]
    Length,
    /// The stream ends within the header of a member.
    #[error("ends within a header")]
    EndsInHeader,
    /// The stream ends within the compressed data.
    #[error("ends within its compressed data")]
    EndsInData,
    /// The compressed data are complete, but the eight bytes of checksum and length after them are not.
    #[error("ends before its trailer")]
    EndsBeforeTrailer,
    /// Bytes other than zero follow the last member.
    #[error("is followed by data that are not compressed")]
    TrailingData,
}
