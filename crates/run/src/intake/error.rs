//! Refusals of files: the fault, its position, and a remedy for the sender.

use super::label_names::{NearName, table_of};
use super::{counted, repair_name};
use homolog_contract::parameters::Repair;
use homolog_formats::FormatError;
use homolog_mesh::topology::{SurfaceFault, TopologyReport};

/// Reasons for refusing a file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum IntakeError {
    /// None of the readable formats.
    #[error(
        "the file format is not recognized; send a surface as GIFTI, PLY, STL, VTK, VTP, OBJ, OFF, MZ3 or FreeSurfer, or \
         labels as NIfTI, MGZ, NRRD, MetaImage or DICOM SEG"
    )]
    UnknownFormat,
    /// The format is recognized, but the content is wrong.
    #[error(transparent)]
    Unreadable(FormatError),
    /// A limit of the service is exceeded.
    #[error("the file has {found} {what}, but at most {limit} are accepted; {}", smaller(what))]
    TooLarge {
        /// The counted items, plural.
        what: &'static str,
        /// Number found; reading may have ended before all were counted.
        found: u64,
        /// Number accepted.
        limit: u64,
    },
    /// No voxel has one of the requested labels.
    #[error("no voxel has {}; {}", requested_labels(requested.as_deref()), present_labels(present, *n_present))]
    EmptyStructure {
        /// The requested labels; `None` for any label other than 0.
        requested: Option<Vec<u32>>,
        /// Labels of the volume other than 0, ascending; only the lowest if there are many.
        present: Vec<u32>,
        /// Number of labels other than 0 in the volume.
        n_present: usize,
    },
    /// A label was requested by an unknown name.
    #[error("no label is called {name}{}; {}", near_names(nearest), without_name(*has_names))]
    UnknownLabelName {
        /// Position among the requested labels, from 0.
        place: usize,
        /// The name, in quotation marks.
        name: String,
        /// The most similar names.
        nearest: Vec<NearName>,
        /// Whether the file has names.
        has_names: bool,
    },
    /// A label was requested by a name with different numbers in the tables that know the volume.
    #[error("{name} is {}; name the table", ambiguous(name, meanings))]
    AmbiguousLabelName {
        /// Position among the requested labels, from 0.
        place: usize,
        /// The name, in quotation marks.
        name: String,
        /// The name of each table, with the label's numbers in it.
        meanings: Vec<(&'static str, Vec<u32>)>,
    },
    /// The values of a volume look like measurements, and the request does not confirm that they are labels.
    #[error(
        "the file looks like an image, not like labels: {} of its {n_values} values other than 0 keep together, {:.0} % of \
         neighboring voxels have equal values, and {:.0} % of the voxels at the border are not 0; send a segmentation of it, \
         choose labels with input.labels, or set input.image_is_labels to true",
        if *n_together == 0 { "none".to_owned() } else { format!("only {n_together}") },
        100.0 * equal_share,
        100.0 * border_share
    )]
    LooksLikeImage {
        /// Number of different values other than 0.
        n_values: usize,
        /// Number of values most of whose voxels lie beside another voxel of the same value.
        n_together: usize,
        /// Share of equal pairs among neighboring voxels other than 0.
        equal_share: f64,
        /// Share of voxels other than 0 on the faces of the volume.
        border_share: f64,
    },
    /// Smoothing removes the whole structure.
    #[error(
        "smoothing by {smoothing_mm} mm leaves nothing of a structure of {}; \
         lower input.smoothing_mm, or set input.surface to \"voxel\"",
        counted(*n_voxels, "voxel", "voxels")
    )]
    Vanished {
        /// Standard deviation of the smoothing filter, mm.
        smoothing_mm: f64,
        /// Voxels of the structure.
        n_voxels: u64,
    },
    /// Faces use a vertex twice, and the repair that drops them was not allowed.
    #[error(
        "{} a vertex twice; the first is face {face} with vertex {vertex} (both counted from 0) at \
         ({:.2}, {:.2}, {:.2}) mm{}; {advice}",
        counted(*n_faces, "face uses", "faces use"), place_mm[0], place_mm[1], place_mm[2], also(others)
    )]
    DegenerateFaces {
        /// Number of such faces.
        n_faces: u64,
        /// The first such face, counted from 0 in the order of the file.
        face: u64,
        /// The repeated vertex.
        vertex: u32,
        /// Its position.
        place_mm: [f64; 3],
        /// Further faults.
        others: Vec<SurfaceFault>,
        /// The remedy.
        advice: Advice,
        /// Topology of the surface without these faces.
        topology: Box<TopologyReport>,
    },
    /// The surface has no consistent orientation, encloses no volume, or has a boundary that was not allowed.
    #[error("{fault}{}; {advice}", also(others))]
    UnsuitableSurface {
        /// The fault and its position, in vertices of the uploaded mesh.
        fault: SurfaceFault,
        /// Further faults.
        others: Vec<SurfaceFault>,
        /// The remedy.
        advice: Advice,
        /// Topology of the surface after the allowed repairs.
        topology: Box<TopologyReport>,
    },
}

/// Remedies for an unsuitable surface.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Advice {
    /// These repairs together make the surface suitable, if allowed.
    Allow(Vec<Repair>),
    /// The surface is suitable if a boundary is allowed.
    Open,
    /// No available repair makes the surface suitable.
    Edit,
}

/// Displays the JSON of an API request; the alternate form displays the option of the command line.
impl std::fmt::Display for Advice {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Advice::Allow(repairs) => {
                let names: Vec<String> = repairs.iter().map(|&r| format!("\"{}\"", repair_name(r))).collect();
                let names = names.join(", ");
                match f.alternate() {
                    false => write!(f, "to have this repaired, send the parameters {{\"input\": {{\"repair\": [{names}]}}}}"),
                    true => write!(f, "to have this repaired, add --set 'input.repair=[{names}]'"),
                }
            }
            Advice::Open if f.alternate() => {
                f.write_str("to match it as an open surface, add --set input.allow_boundary=true; otherwise close it")
            }
            Advice::Open => f.write_str(
                "to match it as an open surface, send the parameters {\"input\": {\"allow_boundary\": true}}; otherwise close it",
            ),
            Advice::Edit => {
                f.write_str("no available repair makes it suitable; correct it in the program that made it")
            }
        }
    }
}

/// Advice for coming below a limit.
fn smaller(what: &str) -> &'static str {
    if what.contains("vertices") {
        "have it simplified (input.max_vertices), crop it or reduce its resolution"
    } else {
        "crop it or reduce its resolution"
    }
}

/// Further faults, after the first.
fn also(others: &[SurfaceFault]) -> String {
    others.iter().map(|fault| format!("; also, {fault}")).collect()
}

fn without_name(has_names: bool) -> &'static str {
    if has_names {
        "numbers are taken too, and homolog inspect lists the labels of a file with their names"
    } else {
        "the file has no names of labels, and no table of a well-known segmentation has both this name and all labels of the \
         volume; numbers are taken too, and freesurfer:NAME, totalsegmentator:NAME, totalsegmentator-mr:NAME, aal:NAME or aal-spm:NAME name a table"
    }
}

fn ambiguous(name: &str, meanings: &[(&'static str, Vec<u32>)]) -> String {
    let meaning = |(table, numbers): &(&str, Vec<u32>)| {
        let numbers: Vec<String> = numbers.iter().map(u32::to_string).collect();
        format!("label {} as {table}:{}", numbers.join(", "), name.trim_matches('"'))
    };
    meanings.iter().map(meaning).collect::<Vec<_>>().join(", and ")
}

fn near_names(nearest: &[NearName]) -> String {
    let listed: Vec<String> = nearest.iter().map(NearName::to_string).collect();
    if listed.is_empty() { String::new() } else { format!("; most like it: {}", listed.join(", ")) }
}

fn requested_labels(requested: Option<&[u32]>) -> String {
    match requested {
        None => "a label other than 0".to_owned(),
        Some(labels) => format!("any of the labels {labels:?}"),
    }
}

fn present_labels(present: &[u32], n_present: usize) -> String {
    if present.is_empty() {
        return "all voxels are 0: send a volume in which the structure is labeled".to_owned();
    }
    let more =
        if n_present > present.len() { format!(" and {} more", n_present - present.len()) } else { String::new() };
    let table = if more.is_empty() { table_of(&present.iter().copied().collect()) } else { None };
    let named = |label: &u32| match table.and_then(|table| table.name_of(*label)) {
        Some(name) => format!("{label} {name}"),
        None => label.to_string(),
    };
    let listed: Vec<String> = present.iter().map(named).collect();
    format!("the volume has the labels [{}]{more}: set input.labels to those of the structure", listed.join(", "))
}

/// Parameters of an API request, with their names on the command line.
const ON_COMMAND_LINE: [(&str, &str); 6] = [
    (
        "set input.labels to those of the structure",
        "add --label N, by number or name, for each of those of the structure",
    ),
    ("choose labels with input.labels", "choose labels with --label N"),
    ("(choose a structure: input.labels, a number or a name)", "(choose a structure: --label NUMBER or NAME)"),
    ("set input.image_is_labels to true", "add --set input.image_is_labels=true"),
    ("lower input.smoothing_mm", "lower --set input.smoothing_mm=X"),
    ("set input.surface to \"voxel\"", "add --set input.surface=voxel"),
];

impl IntakeError {
    /// The message, with advice in terms of the command line.
    pub fn for_command_line(&self) -> String {
        let message = self.to_string();
        match self {
            IntakeError::DegenerateFaces { advice, .. } | IntakeError::UnsuitableSurface { advice, .. } => {
                message.replace(&advice.to_string(), &format!("{advice:#}"))
            }
            IntakeError::TooLarge { what, .. } if what.contains("vertices") => {
                let options = "have it simplified (--simplify N), raise the limit (--max-vertices N)";
                message.replace("have it simplified (input.max_vertices)", options)
            }
            _ => ON_COMMAND_LINE.iter().fold(message, |said, (member, option)| said.replace(member, option)),
        }
    }

    /// The stable name of this kind of refusal, used as the problem type in HTTP answers: `unknown-format`,
    /// `unreadable-file`, `too-large`, `empty-structure`, `not-labels` or `unsuitable-surface`.
    pub fn code(&self) -> &'static str {
        match self {
            IntakeError::UnknownFormat => "unknown-format",
            IntakeError::Unreadable(_) => "unreadable-file",
            IntakeError::TooLarge { .. } => "too-large",
            IntakeError::EmptyStructure { .. }
            | IntakeError::UnknownLabelName { .. }
            | IntakeError::AmbiguousLabelName { .. }
            | IntakeError::Vanished { .. } => "empty-structure",
            IntakeError::LooksLikeImage { .. } => "not-labels",
            IntakeError::DegenerateFaces { .. } | IntakeError::UnsuitableSurface { .. } => "unsuitable-surface",
        }
    }

    /// Position of the first fault of the refused surface, mm, if it has one.
    pub fn place_mm(&self) -> Option<[f64; 3]> {
        match self {
            IntakeError::DegenerateFaces { place_mm, .. } => Some(*place_mm),
            IntakeError::UnsuitableSurface { fault, .. } => fault.place_mm(),
            _ => None,
        }
    }

    /// The topology of the refused surface, if there is a surface.
    pub fn topology(&self) -> Option<&TopologyReport> {
        match self {
            IntakeError::DegenerateFaces { topology, .. } | IntakeError::UnsuitableSurface { topology, .. } => {
                Some(topology)
            }
            _ => None,
        }
    }
}
