//! A pair of surfaces on the command line: its match, and the files that are written of it.

use super::error::CliError;
use super::files::{OutputFolder, file_name, write_file};
use super::interrupt::Interrupt;
use super::output::note;
use super::progress::{Progress, WithoutTerminal};
use crate::jobs::GivenUids;
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
use parking_lot::Mutex;
use serde::Serialize;
use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

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
        let observer = MatchObserver::new(interrupt.clone(), title);
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
struct MatchObserver {
    started: Instant,
    progress: Progress,
    interrupt: Interrupt,
    trace: Mutex<Vec<TimedPoint>>,
}

impl MatchObserver {
    fn new(interrupt: Interrupt, title: Option<&str>) -> Self {
        let progress = Progress::new(WithoutTerminal::Silent);
        progress.title(title.unwrap_or_default());
        MatchObserver { started: Instant::now(), progress, interrupt, trace: Mutex::default() }
    }

    fn finish(self) -> Vec<TimedPoint> {
        self.trace.into_inner()
    }
}

impl Observer for MatchObserver {
    fn phase(&self, phase: Phase) {
        self.progress.phase(phase.name());
    }
    fn progress(&self, fraction: f64) {
        self.progress.fraction(fraction);
    }
    fn trace(&self, point: &TracePoint) {
        let elapsed_ms = (self.started.elapsed().as_secs_f64() * 1e6).round() / 1e3;
        let mut trace = self.trace.lock();
        let seq = trace.len() as u64 + 1;
        trace.push(TimedPoint { seq, point: point.clone(), elapsed_ms });
    }
    fn is_cancelled(&self) -> bool {
        self.interrupt.is_set()
    }
}
