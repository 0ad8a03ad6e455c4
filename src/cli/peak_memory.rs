//! `homolog peak-memory SOURCE TARGET`: one match, and the peak memory of its process. `homolog experiment` runs this
//! command for each pair and method: a process that has matched before keeps memory, which would hide the need of the
//! next match.

use super::error::CliError;
use super::files::{file_name, read_input};
use super::output::print;
use super::parameters::ParameterArgs;
use clap::Args;
use homolog_formats::ply::write_ply;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::Silent;
use homolog_run::intake::IntakeLimits;
use homolog_run::{InputFile, run_match};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{fs, io};

/// Match two surfaces and print the peak memory of the process, bytes
#[derive(Debug, Clone, Args)]
pub(super) struct PeakMemoryArgs {
    /// Source
    pub(super) source: PathBuf,
    /// Target
    pub(super) target: PathBuf,
    #[command(flatten)]
    pub(super) parameters: ParameterArgs,
}

/// Runs the command.
pub(super) fn run(args: &PeakMemoryArgs) -> Result<(), CliError> {
    let limits = IntakeLimits::default();
    let parameters = args.parameters.resolve()?;
    let [source, target] = [read_input(&args.source, &limits)?, read_input(&args.target, &limits)?];
    let file = |path, bytes| InputFile { bytes, name: file_name(path) };
    run_match(file(&args.source, &source), file(&args.target, &target), &parameters, &limits, &Silent)
        .map_err(|error| CliError::Failed(error.to_string()))?;
    let bytes = own_peak().ok_or_else(|| CliError::Failed("the system does not tell the peak memory".to_owned()))?;
    print(&bytes.to_string())
}

/// Largest resident set of this process so far, bytes; `None` on systems other than Linux.
fn own_peak() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    line.trim().strip_suffix(" kB")?.trim().parse::<u64>().ok().map(|kib| kib << 10)
}

/// Peak memory, bytes, of matching `source` to `target` with these request parameters, in a separate process of this
/// program. `folder` is for temporary files; it is created and removed.
///
/// # Errors
/// One line with the reason.
pub(super) fn of_match(
    folder: &Path,
    source: &SurfaceMesh,
    target: &SurfaceMesh,
    request: &Value,
) -> Result<u64, String> {
    let failed = |error: io::Error| format!("the memory of a match cannot be measured: {error}");
    fs::create_dir_all(folder).map_err(failed)?;
    let [first, second, parameters] = ["source.ply", "target.ply", "parameters.json"].map(|name| folder.join(name));
    fs::write(&first, write_ply(source)).map_err(failed)?;
    fs::write(&second, write_ply(target)).map_err(failed)?;
    fs::write(&parameters, request.to_string()).map_err(failed)?;
    let program = std::env::current_exe().map_err(failed)?;
    let mut command = Command::new(program);
    command.arg("peak-memory").args([&first, &second]).arg("--params").arg(&parameters).stdin(Stdio::null());
    let done = command.output().map_err(failed)?;
    fs::remove_dir_all(folder).map_err(failed)?;
    let said = |bytes: &[u8]| String::from_utf8_lossy(bytes).trim().to_owned();
    match said(&done.stdout).parse() {
        Ok(bytes) if done.status.success() => Ok(bytes),
        _ => Err(said(&done.stderr)),
    }
}
