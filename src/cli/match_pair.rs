//! `homolog match SOURCE TARGET`: a match without the service.

use super::companions::with_numbers;
use super::error::CliError;
use super::files::{OutputFolder, check_writable, file_name, read_input, write_file};
use super::interrupt::Interrupt;
use super::match_many;
use super::output::{note, print, print_json};
use super::parameters::{LimitArgs, ParameterArgs};
use super::progress::{Progress, WithoutTerminal};
use super::summary::summary;
use crate::jobs::{GivenUids, Uid};
use clap::Args;
use homolog_contract::parameters::MatchParameters;
use homolog_contract::result::{Correspondences, WarpDirection};
use homolog_formats::ReadLimits;
use homolog_formats::gifti::write_gifti;
use homolog_formats::ply::{write_ply, write_ply_with};
use homolog_formats::segmentation::{SegmentationError, SegmentedFiles, write_segmentation};
use homolog_formats::spatial_registration::{RegisteredFiles, write_spatial_registration};
use homolog_formats::transform::write_itk_transform;
use homolog_formats::vertex_table::write_csv;
use homolog_formats::vtp::write_vtp_with;
use homolog_primitives::observe::{Observer, Phase, TracePoint};
use homolog_run::intake::IntakeLimits;
use homolog_run::{
    InputFile, ReportInputs, RunError, RunOutput, SurfaceCache, WarpedSurface, lta, run_match_with, segment_label,
    write_report,
};
use serde::Serialize;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

/// Match surfaces: compute the dense correspondence and the rigid transform
///
/// With one target, the verdict and the numbers of the pair are printed. With several targets, the source, such as a
/// template, is matched to each target, so the rows of all answers are the vertices of the source; a table with a line
/// for each target is printed.
#[derive(Debug, Clone, Args)]
pub(super) struct MatchArgs {
    /// Source: the surface that is moved; a surface (GIFTI, FreeSurfer, PLY, STL, VTK, VTP, OBJ, OFF, MZ3) or a label volume
    /// (NIfTI, MGZ, NRRD, MetaImage, DICOM SEG)
    pub(super) source: PathBuf,
    /// Target: the surface that stays in place; with several targets, the source is matched to each of them
    #[arg(required = true, value_name = "TARGET")]
    pub(super) targets: Vec<PathBuf>,
    #[command(flatten)]
    pub(super) parameters: ParameterArgs,
    #[command(flatten)]
    pub(super) limits: LimitArgs,
    /// Folder for result.json, correspondences.csv, source.ply, target.ply, aligned.ply (moved rigidly), warped.ply, .vtp,
    /// .surf.gii and .csv (the source deformed onto the target), transform.tfm, .lta and, for DICOM inputs,
    /// transform.dcm and warped.dcm, and trace.jsonl; with several targets, for a folder with these and a report.html for each,
    /// and summary.csv
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,
    /// UID of the DICOM study for transform.dcm and warped.dcm, if neither input is a DICOM object
    #[arg(long, value_name = "UID", requires = "out")]
    pub(super) study_uid: Option<Uid>,
    /// UID of the frame of reference of the source, if it is not a DICOM object
    #[arg(long, value_name = "UID", requires = "out")]
    pub(super) source_frame_uid: Option<Uid>,
    /// UID of the frame of reference of the target, if it is not a DICOM object
    #[arg(long, value_name = "UID", requires = "out")]
    pub(super) target_frame_uid: Option<Uid>,
    /// File for a page with the verdict, both surfaces to rotate with the mouse, and all numbers; it contains no file
    /// names
    #[arg(long, value_name = "PAGE.html")]
    pub(super) html: Option<PathBuf>,
    /// Print the result document, and nothing else, as JSON; with several targets a line for each: target, result or error
    #[arg(long)]
    pub(super) json: bool,
}

/// Runs the command.
///
/// # Errors
/// [`CliError`].
pub(super) fn run(args: &MatchArgs) -> Result<(), CliError> {
    let [target] = args.targets.as_slice() else { return match_many::run(args) };
    let limits = args.limits.limits();
    let parameters = with_numbers(&args.parameters.resolve()?, [&args.source, target]);
    let source = read_input(&args.source, &limits)?;
    let target_bytes = read_input(target, &limits)?;
    // Created before the computation, so that an unwritable folder is reported at once.
    let folder = args.out.as_deref().map(OutputFolder::create).transpose()?;
    if let Some(page) = &args.html {
        let folder = page.parent().filter(|folder| !folder.as_os_str().is_empty());
        check_writable(folder.unwrap_or(Path::new(".")))?;
    }
    let pair = Pair { source: (&args.source, &source), target: (target, &target_bytes) };
    let (output, trace) = pair.matched(&SurfaceCache::none(), (&parameters, &limits), &Interrupt::listen(), None)?;
    if let Some(folder) = &folder {
        pair.write(folder, &output, &trace, &args.uids())?;
    }
    if let Some(page) = &args.html {
        write_page(page, &output, &trace)?;
    }
    if args.json {
        return print_json(&output.document);
    }
    print(&summary(&output.document))?;
    if let Some(folder) = &folder {
        note(&format!("written to {}", folder.path().display()));
    }
    Ok(())
}

/// Two inputs, each with its bytes.
pub(super) struct Pair<'a> {
    pub(super) source: (&'a Path, &'a [u8]),
    pub(super) target: (&'a Path, &'a [u8]),
}

impl Pair<'_> {
    /// Computes the match; `title` is shown before the phase.
    pub(super) fn matched(
        &self,
        surfaces: &SurfaceCache,
        (parameters, limits): (&MatchParameters, &IntakeLimits),
        interrupt: &Interrupt,
        title: Option<&str>,
    ) -> Result<(RunOutput, Vec<TimedPoint>), CliError> {
        let observer = StudyObserver::new(interrupt.clone(), title);
        let file = |(path, bytes)| InputFile { bytes, name: file_name(path) };
        let outcome = run_match_with(surfaces, file(self.source), file(self.target), parameters, limits, &observer);
        let trace = observer.finish();
        let mut output = outcome.map_err(|error| match error {
            RunError::Input { side, error } => {
                let (path, _) = if side.name() == "source" { self.source } else { self.target };
                CliError::BadInput(format!("{} {}: {}", side.name(), path.display(), error.for_command_line()))
            }
            RunError::TooLarge { .. } => CliError::BadInput(error.to_string()),
            error if error.is_cancelled() => CliError::Interrupted,
            error => CliError::Failed(error.to_string()),
        })?;
        env!("HOMOLOG_COMMIT").clone_into(&mut output.document.provenance.commit);
        Ok((output, trace))
    }

    /// Writes all files of the match except the page.
    pub(super) fn write(
        &self,
        folder: &OutputFolder,
        output: &RunOutput,
        trace: &[TimedPoint],
        uids: &GivenUids,
    ) -> Result<(), CliError> {
        write_files(folder, output, trace)?;
        write_transforms(folder, output, [self.source.1, self.target.1], uids)
    }
}

fn write_files(folder: &OutputFolder, output: &RunOutput, trace: &[TimedPoint]) -> Result<(), CliError> {
    let document = &output.document;
    folder.write_json("result.json", document)?;
    if let Some(correspondences) = &document.correspondences {
        folder.write("correspondences.csv", correspondences.to_csv().as_bytes())?;
        if let Some(inverse) = &correspondences.inverse {
            folder.write("correspondences-inverse.csv", inverse.to_csv().as_bytes())?;
        }
    }
    folder.write("source.ply", &write_ply(&output.source))?;
    folder.write("target.ply", &write_ply(&output.target))?;
    let aligned = output.aligned().map_err(|e| CliError::Failed(format!("cannot compute the aligned surface: {e}")))?;
    folder.write("aligned.ply", &write_ply(&aligned))?;
    write_warped(folder, output, WarpDirection::Forward, "warped")?;
    if document.correspondences.as_ref().is_some_and(|pairs| pairs.inverse.is_some()) {
        write_warped(folder, output, WarpDirection::Inverse, "warped-inverse")?;
    }
    let mut lines = String::new();
    for point in trace {
        let line = serde_json::to_string(point)
            .map_err(|e| CliError::Failed(format!("cannot write the trace as JSON: {e}")))?;
        let _ = writeln!(lines, "{line}");
    }
    folder.write("trace.jsonl", lines.as_bytes())?;
    Ok(())
}

impl MatchArgs {
    pub(super) fn uids(&self) -> GivenUids {
        let (study, source_frame) = (self.study_uid.clone(), self.source_frame_uid.clone());
        GivenUids { study, source_frame, target_frame: self.target_frame_uid.clone() }
    }
}

/// Writes the rigid transform for other programs. If an input is a DICOM object or a study is given, also writes it and
/// the bent surfaces as DICOM.
fn write_transforms(
    folder: &OutputFolder,
    output: &RunOutput,
    [source, target]: [&[u8]; 2],
    uids: &GivenUids,
) -> Result<(), CliError> {
    let matrix = &output.document.transform.matrix;
    if let Some(text) = write_itk_transform(matrix) {
        folder.write("transform.tfm", text.as_bytes())?;
    }
    folder.write("transform.lta", lta(matrix, [source, target]).as_bytes())?;
    let now = jiff::Timestamp::now().strftime("%Y%m%d%H%M%S").to_string();
    let [study_uid, source_frame, target_frame] = uids.texts();
    let max_inflated_bytes = ReadLimits::default().max_inflated_bytes;
    let frame_uids = [source_frame, target_frame];
    let files = RegisteredFiles { source, target, study_uid, frame_uids, max_inflated_bytes };
    let registration = write_spatial_registration(matrix, &files, &now)
        .map_err(|e| CliError::Failed(format!("cannot write the transform as DICOM: {e}")))?;
    if let Some(registration) = registration {
        folder.write("transform.dcm", &registration)?;
    }
    let has_inverse = output.document.correspondences.as_ref().is_some_and(|pairs| pairs.inverse.is_some());
    let inverse = has_inverse.then_some((WarpDirection::Inverse, "warped-inverse.dcm"));
    for (direction, name) in [(WarpDirection::Forward, "warped.dcm")].into_iter().chain(inverse) {
        let (own, other, frame_uid) = match direction {
            WarpDirection::Forward => (target, source, target_frame),
            WarpDirection::Inverse => (source, target, source_frame),
        };
        let files = SegmentedFiles { own, other, study_uid, frame_uid, max_inflated_bytes };
        let mesh =
            output.warped(direction).map_err(|e| CliError::Failed(format!("cannot bend the surface: {e}")))?.mesh;
        match write_segmentation(&mesh, segment_label(direction), &files, &now) {
            Ok(segmentation) => folder.write(name, &segmentation).map(|_| ())?,
            Err(SegmentationError::NotDicom) => break,
            Err(error) => note(&format!("{name} is not written: {error}")),
        }
    }
    Ok(())
}

/// The report as an HTML page.
pub(super) fn write_page(path: &Path, output: &RunOutput, trace: &[TimedPoint]) -> Result<(), CliError> {
    let trace: Vec<TracePoint> = trace.iter().map(|timed| timed.point.clone()).collect();
    let none = Correspondences::default();
    let page = write_report(&ReportInputs {
        document: &output.document,
        correspondences: output.document.correspondences.as_ref().unwrap_or(&none),
        source: &output.source,
        target: &output.target,
        trace: &trace,
    });
    let page = page.map_err(|e| CliError::Failed(format!("cannot make the report: {e}")))?;
    write_file(path, page.as_bytes())
}

/// A bent surface with the deformation at each vertex, in the formats that hold both.
fn write_warped(
    folder: &OutputFolder,
    output: &RunOutput,
    direction: WarpDirection,
    name: &str,
) -> Result<(), CliError> {
    let warped = output.warped(direction);
    let WarpedSurface { mesh, arrays } =
        warped.map_err(|e| CliError::Failed(format!("cannot compute the bent surface: {e}")))?;
    folder.write(&format!("{name}.ply"), &write_ply_with(&mesh, &arrays))?;
    folder.write(&format!("{name}.vtp"), &write_vtp_with(&mesh, &arrays))?;
    folder.write(&format!("{name}.surf.gii"), &write_gifti(&mesh, &arrays))?;
    folder.write(&format!("{name}.csv"), &write_csv(&arrays))?;
    Ok(())
}

/// A trace point with its number and time, in the form of the service.
#[derive(Debug, Clone, Serialize)]
pub(super) struct TimedPoint {
    seq: u64,
    #[serde(flatten)]
    point: TracePoint,
    elapsed_ms: f64,
}

/// Shows progress, records the trace and forwards an interrupt.
struct StudyObserver {
    started: Instant,
    progress: Progress,
    interrupt: Interrupt,
    trace: Mutex<Vec<TimedPoint>>,
}

impl StudyObserver {
    fn new(interrupt: Interrupt, title: Option<&str>) -> Self {
        let progress = Progress::new(WithoutTerminal::Silent);
        progress.title(title.unwrap_or_default());
        StudyObserver { started: Instant::now(), progress, interrupt, trace: Mutex::default() }
    }

    fn finish(self) -> Vec<TimedPoint> {
        self.trace.into_inner().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Observer for StudyObserver {
    fn phase(&self, phase: Phase) {
        self.progress.phase(phase.name());
    }
    fn progress(&self, fraction: f64) {
        self.progress.fraction(fraction);
    }
    fn trace(&self, point: &TracePoint) {
        let elapsed_ms = (self.started.elapsed().as_secs_f64() * 1e6).round() / 1e3;
        let mut trace = self.trace.lock().unwrap_or_else(PoisonError::into_inner);
        let seq = trace.len() as u64 + 1;
        trace.push(TimedPoint { seq, point: point.clone(), elapsed_ms });
    }
    fn is_cancelled(&self) -> bool {
        self.interrupt.is_set()
    }
}
