//! `homolog demo`: one match over HTTP, with a service that the command starts and stops.

pub(super) mod client;
mod plot;
mod service;
mod truth;

use super::error::CliError;
use super::files::{OutputFolder, file_name, read_input};
use super::interrupt::Interrupt;
use super::output::{note, print};
use super::phantom::{Kind, write_pair};
use super::progress::{Progress, WithoutTerminal};
use super::summary::summary;
use clap::Args;
use client::{FormPart, ServiceClient};
use homolog_contract::result::ResultDocument;
use homolog_formats::ReadLimits;
use homolog_formats::ply::read_ply;
use homolog_laboratory::phantom::{DEFAULT_EDGE_MM, PairRecipe};
use homolog_mesh::SurfaceMesh;
use homolog_run::intake::IntakeLimits;
use plot::plot;
use serde_json::Value;
use service::ServiceProcess;
use std::path::{Path, PathBuf};
use std::time::Duration;
use truth::compared_with_truth;

/// Start a service, match a pair over HTTP and show the result
#[derive(Debug, Clone, Args)]
pub(super) struct DemoArgs {
    /// Source: the surface that is moved; absent: a synthetic structure and a bent and rotated copy of it are matched
    #[arg(requires = "target")]
    pub(super) source: Option<PathBuf>,
    /// Target: the surface that stays in place
    pub(super) target: Option<PathBuf>,
    /// Keep the service running after the match, until Ctrl-C
    #[arg(long)]
    pub(super) keep: bool,
    /// Folder for the synthetic inputs, the results and the data of the service
    #[arg(long, value_name = "DIR", default_value = "homolog-demo")]
    pub(super) out: PathBuf,
}

/// Interval between requests for the job.
const POLL_EVERY: Duration = Duration::from_millis(100);
/// Timeout of a request.
const REQUEST_TIMEOUT: Duration = Duration::from_secs(60);
/// A structure, bent and rotated, so that every true corresponding point is known. The choice is arbitrary.
const DEMO_PAIR: PairRecipe = PairRecipe {
    subject: 1,
    target_subject: 1,
    deform_share: 0.04,
    deform_seed: 1,
    pose_seed: Some(7),
    permute_seed: None,
};

/// Runs the command.
///
/// # Errors
/// [`CliError`].
pub(super) fn run(args: &DemoArgs) -> Result<(), CliError> {
    let interrupt = Interrupt::listen();
    let folder = OutputFolder::create(&args.out)?;
    let (source, target, recipe) = match (&args.source, &args.target) {
        (Some(source), Some(target)) => (source.clone(), target.clone(), None),
        _ => {
            note("generating a synthetic structure, and a bent and rotated copy of it");
            let written = write_pair(&DEMO_PAIR, Kind::Volume, 1.0, DEFAULT_EDGE_MM, &folder)?;
            (written[0].clone(), written[1].clone(), Some(&DEMO_PAIR))
        }
    };
    let data_dir = folder.path().join(format!("service-data-{}", std::process::id()));
    note("starting the service");
    let mut service = ServiceProcess::start(&data_dir, &folder.path().join("service.log"), &interrupt)?;
    let url = service.url();
    note(&format!("the service listens on {url}"));
    let client = ServiceClient::new(&url, REQUEST_TIMEOUT);
    let shown = match_over_http(&client, &mut service, [&source, &target], recipe, &folder, &interrupt);
    if let Ok(job) = &shown
        && args.keep
    {
        print(&format!(
            "\nthe service runs (data in {}); Ctrl-C stops it\nthe match in 3D: {url}/#/jobs/{job}",
            data_dir.display()
        ))?;
        while !interrupt.is_set() {
            service.check_running()?;
            std::thread::sleep(POLL_EVERY);
        }
    }
    service.stop();
    // The data of the demo are not needed any more; a service that was kept may hold other jobs.
    if !args.keep {
        let _ = std::fs::remove_dir_all(&data_dir);
    }
    shown.map(drop)
}

/// Submits the pair and shows and saves its result; returns the id of the job.
fn match_over_http(
    client: &ServiceClient,
    service: &mut ServiceProcess,
    [source, target]: [&Path; 2],
    recipe: Option<&PairRecipe>,
    folder: &OutputFolder,
    interrupt: &Interrupt,
) -> Result<String, CliError> {
    let limits = IntakeLimits::default();
    let source_bytes = read_input(source, &limits)?;
    let target_bytes = read_input(target, &limits)?;
    let job = submit(client, (source, &source_bytes), (target, &target_bytes))?;
    note(&format!("job {job}"));
    let trace = follow(client, service, &job, interrupt)?;
    let result = client.get_json(&format!("/v1/jobs/{job}/result"))?;
    let document: ResultDocument = serde_json::from_value(result.clone())
        .map_err(|e| CliError::Failed(format!("unexpected form of the result: {e}")))?;
    print(&summary(&document))?;
    if let Some(recipe) = recipe {
        let [source, warped] = ["source_surface", "warped"].map(|name| fetch_surface(client, &result, name));
        let text = compared_with_truth(recipe, &source?, &warped?, &document.transform)?;
        print(&format!("\n{text}"))?;
    }
    show_energy(&trace)?;
    print(&format!("\nwritten to {}", folder.path().display()))?;
    folder.write_json("result.json", &result)?;
    print(&format!("  {:<22}everything above and more, as JSON", "result.json"))?;
    for (name, link, format, programs) in DOWNLOADS {
        let content = fetch_link(client, &result, link, &format!("?format={format}"))?;
        folder.write(name, &content)?;
        print(&format!("  {name:<22}{programs}"))?;
    }
    Ok(job)
}

/// The downloads of the demo: name of the file, link of the result, format, and programs that open it.
const DOWNLOADS: [(&str, &str, &str, &str); 7] = [
    ("report.html", "report", "html", "a page with the verdict and both surfaces to turn: any browser"),
    ("aligned.ply", "aligned", "ply", "the source moved rigidly: MeshLab, Blender, ParaView, 3D Slicer"),
    ("warped.vtp", "warped", "vtp", "the source deformed onto the target, with arrays: ParaView, 3D Slicer"),
    ("warped.surf.gii", "warped", "gifti", "the same: Connectome Workbench, FreeSurfer's freeview, nibabel"),
    ("correspondences.csv", "correspondences", "csv", "a row for each source vertex: R, pandas, spreadsheets"),
    ("transform.tfm", "transform", "tfm", "the rigid transform: 3D Slicer, ITK-SNAP, ANTs"),
    ("transform.lta", "transform", "lta", "the same: FreeSurfer"),
];

/// The surface behind a link of the result.
fn fetch_surface(client: &ServiceClient, result: &Value, name: &str) -> Result<SurfaceMesh, CliError> {
    let file = read_ply(&fetch_link(client, result, name, "")?, &ReadLimits::default());
    file.map(|file| file.mesh).map_err(|error| CliError::Failed(format!("the surface {name} cannot be read: {error}")))
}

/// The body behind a link of the result, with this query.
fn fetch_link(client: &ServiceClient, result: &Value, name: &str, query: &str) -> Result<Vec<u8>, CliError> {
    let link = result.pointer(&format!("/links/{name}")).and_then(Value::as_str);
    let link = link.ok_or_else(|| CliError::Failed(format!("the result has no link named {name}")))?;
    let answer = client.get(&format!("{link}{query}"))?;
    match answer.status {
        200 => Ok(answer.body),
        status => Err(CliError::Failed(format!("GET {link} answered {status}: {}", answer.problem()))),
    }
}

/// Submits the pair in one request; returns the id of the job.
fn submit(client: &ServiceClient, source: (&Path, &[u8]), target: (&Path, &[u8])) -> Result<String, CliError> {
    let file = |name, (path, bytes): (&'_ Path, &'_ [u8])| (name, file_name(path).map(str::to_owned), bytes.to_vec());
    let files = [file("source", source), file("target", target)];
    let mut parts: Vec<FormPart<'_>> = files
        .iter()
        .map(|(name, file_name, bytes)| FormPart {
            name,
            file_name: Some(file_name.as_deref().unwrap_or(name)),
            content_type: "application/octet-stream",
            bytes,
        })
        .collect();
    parts.push(FormPart { name: "parameters", file_name: None, content_type: "application/json", bytes: b"{}" });
    let answer = client.post_form("/v1/jobs", &parts)?;
    match answer.status {
        200 | 202 => {}
        400..=499 => return Err(CliError::BadInput(answer.problem())),
        status => return Err(CliError::Failed(format!("the service answered {status}: {}", answer.problem()))),
    }
    let job = answer.json()?;
    job.get("id")
        .and_then(Value::as_str)
        .map(str::to_owned)
        .ok_or_else(|| CliError::Failed("the answer of the service has no job id".to_owned()))
}

/// Shows progress until the job is finished; returns its energy trace.
fn follow(
    client: &ServiceClient,
    service: &mut ServiceProcess,
    id: &str,
    interrupt: &Interrupt,
) -> Result<Vec<Value>, CliError> {
    let progress = Progress::new(WithoutTerminal::Lines);
    let mut trace = Vec::new();
    let mut after_seq = None;
    loop {
        if interrupt.is_set() {
            return Err(CliError::Interrupted);
        }
        service.check_running()?;
        // The job is read first: once it is finished, a trace read after it is complete.
        let job = client.get_json(&format!("/v1/jobs/{id}"))?;
        let query = after_seq.map(|seq: u64| format!("?after_seq={seq}")).unwrap_or_default();
        let page = client.get_json(&format!("/v1/jobs/{id}/trace{query}"))?;
        after_seq = page.get("next_after_seq").and_then(Value::as_u64).or(after_seq);
        let points = page.get("points").and_then(Value::as_array).cloned().unwrap_or_default();
        let complete = page.get("complete").and_then(Value::as_bool).unwrap_or(true);
        trace.extend(points);
        let text = |at: &str| job.pointer(at).and_then(Value::as_str).unwrap_or_default().to_owned();
        progress.fraction(job.pointer("/progress/fraction").and_then(Value::as_f64).unwrap_or_default());
        let state = text("/state");
        let phase = text("/progress/phase");
        progress.phase(if phase.is_empty() { &state } else { &phase });
        match state.as_str() {
            "queued" | "running" => std::thread::sleep(POLL_EVERY),
            // The trace may have more than one page.
            "succeeded" if !complete => {}
            "succeeded" => return Ok(trace),
            _ => {
                let error = job.get("error").cloned().unwrap_or_default();
                let reason =
                    error.get("detail").and_then(Value::as_str).map_or_else(|| error.to_string(), str::to_owned);
                return Err(CliError::Failed(format!("the job is {state}: {reason}")));
            }
        }
    }
}

/// Plots the energy of the displacement field over the iterations of all its fits.
fn show_energy(trace: &[Value]) -> Result<(), CliError> {
    let of_field = |point: &&Value| point.get("phase").and_then(Value::as_str) == Some("displacement");
    let points: Vec<(f64, u64)> = trace
        .iter()
        .filter(of_field)
        .filter_map(|p| Some((p.get("energy")?.as_f64()?, p.get("round").and_then(Value::as_u64).unwrap_or(0))))
        .collect();
    // A gap between two fits, whose energies are not comparable.
    let (mut starts, mut energies) = (Vec::new(), Vec::new());
    for (k, (energy, fit)) in points.iter().enumerate() {
        if k == 0 || points[k - 1].1 != *fit {
            energies.extend((k > 0).then_some(f64::NAN));
            starts.push(energies.len());
        }
        energies.push(*energy);
    }
    let lines = plot(&energies, &starts, 60, 10);
    if lines.is_empty() {
        return Ok(());
    }
    print(&format!(
        "\nenergy of the field over {} iterations of {} fits (┴ start of a fit)",
        points.len(),
        starts.len()
    ))?;
    lines.iter().try_for_each(|line| print(line))
}
