//! Why a file cannot be read: what, where, and what to do about it.

use homolog_mesh::MeshError;
use homolog_mesh::volume::VolumeError;

/// Why a file cannot be read. No text of the file is repeated, only places and numbers.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FormatError {
    /// No bytes.
    #[error("the file is empty; write it again with the program that made it, or upload it again")]
    Empty,
    /// None of the formats that are read.
    #[error("the file is none of NIfTI-1, PLY, STL, legacy VTK; convert it to one of them")]
    UnknownFormat,
    /// A limit of the service is exceeded.
    #[error("the file has {found} {what}, but at most {limit} are accepted; send a smaller one")]
    TooLarge {
        /// What is counted, plural.
        what: &'static str,
        /// How many there are, at least.
        found: u64,
        /// How many are accepted.
        limit: u64,
    },
    /// The compressed stream is damaged or cut off.
    #[error("the gzip stream is damaged after {n_bytes} inflated bytes; compress and send the file again")]
    Gzip {
        /// Bytes that could be inflated.
        n_bytes: usize,
    },
    /// The file ends too early for what it announces.
    #[error(
        "{part} needs {needed} bytes, but only {available} are left in the file; it is cut off or its header is wrong"
    )]
    Truncated {
        /// Which part.
        part: &'static str,
        /// Bytes it needs.
        needed: u64,
        /// Bytes there are.
        available: u64,
    },
    /// A text line is not what the format says.
    #[error("line {line}: {expected} is expected here; write the file again with the program that made it")]
    Syntax {
        /// The line, from 1.
        line: usize,
        /// What should be there.
        expected: &'static str,
    },
    /// A part of the header has a value that is not valid.
    #[error("the header's {field} is {value}; {advice}")]
    Header {
        /// Which field.
        field: &'static str,
        /// Its value, a number or a list of numbers.
        value: String,
        /// What would be right.
        advice: &'static str,
    },
    /// A variant of the format that is not read.
    #[error("{what} is not read; {advice}")]
    Unsupported {
        /// Which variant.
        what: &'static str,
        /// What to do.
        advice: &'static str,
    },
    /// A voxel holds no label.
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
    /// A face names a vertex by a negative number.
    #[error("face {face} names vertex {vertex}; vertices are counted from 0")]
    NegativeIndex {
        /// Index of the face.
        face: usize,
        /// The index it names.
        vertex: i64,
    },
    /// The parser of the format refused the payload.
    #[error("the {format} payload is damaged{}; write the file again", line.map(|l| format!(" at line {l}")).unwrap_or_default())]
    Payload {
        /// Which format.
        format: &'static str,
        /// The line, from 1, of text files.
        line: Option<usize>,
    },
    /// Vertices and faces make no mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// Labels and affine make no volume.
    #[error(transparent)]
    Volume(#[from] VolumeError),
}
