//! `homolog inspect FILE`: the contents of a file on one screen: its labels, the surface that a match would use, and
//! whether a match would accept it.

use super::companions::{companion, numbers};
use super::error::CliError;
use super::files::{file_name, read_input};
use super::output::{print, print_json};
use super::parameters::{InputArgs, LimitArgs};
use super::words::on_command_line;
use clap::Args;
use homolog_contract::input::{InputKind, InputSpace, Inspection};
use homolog_mesh::topology::TopologyReport;
use homolog_run::intake::{LabelShape, inspect, label_shapes, prepare_surface};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::PathBuf;

/// Most labels shown on a screen.
const MAX_LABELS: usize = 30;
/// Longest name shown on a screen, characters.
const MAX_NAME: usize = 32;

/// Show format, labels, topology and repairs of a surface or label volume
#[derive(Debug, Clone, Args)]
pub(super) struct InspectArgs {
    /// File to inspect: a surface (GIFTI, FreeSurfer, PLY, STL, VTK, VTP, OBJ, OFF, MZ3) or a label volume (NIfTI, MGZ, NRRD,
    /// MetaImage, DICOM SEG)
    pub(super) file: PathBuf,
    /// Print everything as JSON
    #[arg(long)]
    pub(super) json: bool,
    #[command(flatten)]
    pub(super) parameters: InputArgs,
    #[command(flatten)]
    pub(super) limits: LimitArgs,
}

/// Runs the command.
///
/// # Errors
/// [`CliError::BadInput`] for a file that cannot be read. A surface that a match would refuse is not an error.
pub(super) fn run(args: &InspectArgs) -> Result<(), CliError> {
    let limits = args.limits.limits();
    let mut input = args.parameters.resolve()?.input;
    input.labels = numbers(&input, &args.file).or(input.labels);
    let bytes = read_input(&args.file, &limits)?;
    let name = file_name(&args.file);
    let mut report = inspect(&bytes, name, &input, &limits)
        .map_err(|e| CliError::BadInput(format!("{}: {e}", args.file.display())))?;
    let beside = companion(&args.file).map(|companion| companion.names).unwrap_or_default();
    for label in report.volume.iter_mut().flat_map(|volume| &mut volume.labels) {
        if let Some(name) = beside.get(&label.label) {
            label.name = Some(name.clone());
        }
    }
    if args.json {
        return print_json(&report);
    }
    // The report names parameters of an API request; on a terminal they are replaced by the options that set them.
    if let Some(refusal) = &mut report.refusal
        && let Err(error) = prepare_surface(&bytes, name, &input, &limits)
    {
        refusal.detail = error.for_command_line();
    }
    let shapes = label_shapes(&bytes, name, &limits, MAX_LABELS);
    print(screen(&report, &shapes).trim_end())
}

fn screen(report: &Inspection, shapes: &BTreeMap<u32, LabelShape>) -> String {
    let mut text = String::new();
    let kind = match report.kind {
        InputKind::LabelVolume => "label volume",
        InputKind::Mesh => "surface",
    };
    let space = match report.space {
        InputSpace::ScannerRas => "scanner RAS",
        InputSpace::FreesurferRas => "surface RAS of FreeSurfer",
        InputSpace::Lps => "LPS, converted to RAS",
        InputSpace::Unknown => "space not declared",
    };
    let _ = writeln!(text, "format    {}, {kind}, {space}", report.format.title());
    if let Some(volume) = &report.volume {
        let [x, y, z] = volume.dims;
        let [a, b, c] = volume.spacing_mm;
        let _ = writeln!(text, "grid      {x} × {y} × {z} voxels of {a:.3} × {b:.3} × {c:.3} mm");
        text.push_str(&labels(report, shapes));
    }
    let topology = [("as it is", &report.topology), ("repaired", &report.repaired_topology)];
    let mut said = String::new();
    for (when, topology) in topology {
        let Some(topology) = topology else { continue };
        let words = surface(topology);
        if words != said {
            let _ = writeln!(text, "{when:<9} {words}");
            said = words;
        }
    }
    for repair in &report.repairs {
        let _ = writeln!(text, "repair    {}", repair.detail);
    }
    for note in &report.notes {
        let _ = writeln!(text, "note      {note}");
    }
    for warning in &report.warnings {
        let _ = writeln!(text, "warning   {}", on_command_line(&warning.detail));
    }
    let _ = match &report.refusal {
        None => writeln!(text, "verdict   It can be matched."),
        Some(refusal) => writeln!(text, "verdict   It is refused ({}): {}", refusal.code, refusal.detail),
    };
    text
}

/// A row for each label.
fn labels(report: &Inspection, shapes: &BTreeMap<u32, LabelShape>) -> String {
    let Some(volume) = &report.volume else { return String::new() };
    let shown = |name: &Option<String>| {
        let name: String = name.iter().flat_map(|name| name.chars()).filter(|c| !c.is_control()).collect();
        if name.chars().count() > MAX_NAME {
            format!("{}…", name.chars().take(MAX_NAME - 1).collect::<String>())
        } else {
            name
        }
    };
    let rows: Vec<_> = volume.labels.iter().take(MAX_LABELS).collect();
    let width = rows.iter().map(|row| shown(&row.name).chars().count()).max().unwrap_or(0).max("name".len());
    let mm3: f64 = volume.spacing_mm.iter().product();
    let mut text = format!(
        "\n{:>7}  {:<width$}  {:>10}  {:>12}  {:>6}  {:>7}\n",
        "label", "name", "voxels", "volume, mm³", "pieces", "tunnels"
    );
    for row in &rows {
        let number = |value: Option<u32>| value.map_or_else(|| "-".to_owned(), |n| n.to_string());
        let shape = shapes.get(&row.label);
        let _ = writeln!(
            text,
            "{:>7}  {:<width$}  {:>10}  {:>12.1}  {:>6}  {:>7}",
            row.label,
            shown(&row.name),
            row.n_voxels,
            row.n_voxels as f64 * mm3,
            number(shape.map(|shape| shape.n_pieces)),
            number(shape.map(|shape| shape.n_tunnels)),
        );
    }
    let more = volume.n_labels as usize - rows.len();
    if more > 0 {
        let _ = writeln!(text, "{more} more labels: --json lists them");
    }
    text.push('\n');
    text
}

/// A surface in one line.
fn surface(report: &TopologyReport) -> String {
    let mut words = format!("{} vertices, {} faces", report.n_vertices, report.n_faces);
    let parts = [
        (report.n_components > 1, format!("{} pieces", report.n_components)),
        (report.n_boundary_edges > 0, format!("open ({} edges of one face)", report.n_boundary_edges)),
        (report.n_nonmanifold_edges > 0, format!("{} edges of more than two faces", report.n_nonmanifold_edges)),
        (!report.oriented, "faces that disagree in orientation".to_owned()),
    ];
    for (_, part) in parts.iter().filter(|(holds, _)| *holds) {
        let _ = write!(words, ", {part}");
    }
    if let Some(genus) = report.genus {
        let _ = write!(words, ", closed, genus {genus}");
    }
    let _ = write!(words, ", {:.1} mm²", report.area_mm2);
    if let Some(volume) = report.volume_mm3 {
        let _ = write!(words, ", {:.1} mm³", volume.abs());
    }
    words
}
