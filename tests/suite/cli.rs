//! The command line: exit codes, standard output and standard error, and the files that commands write.

use homolog_formats::ply::write_ply;
use homolog_formats::{FileContent, ReadLimits, read};
use nalgebra::Point3;
use serde_json::Value;
use std::fs;
use std::io::{BufRead as _, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The program that was built for these tests.
pub(crate) fn homolog() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_homolog"));
    command.stdin(Stdio::null());
    command
}

/// A JSON file.
pub(crate) fn read_json(path: &Path) -> Value {
    serde_json::from_slice(&fs::read(path).unwrap()).unwrap()
}

/// A pair of small phantom surfaces.
fn small_pair(folder: &Path) -> (PathBuf, PathBuf) {
    let done = homolog()
        .args(["phantom", "--kind", "surface", "--edge", "1.6", "--rotate-seed", "4", "--out"])
        .arg(folder)
        .output()
        .unwrap();
    assert!(done.status.success());
    (folder.join("source.ply"), folder.join("target.ply"))
}

#[test]
fn help_and_version_exit_with_0_and_usage_errors_with_2() {
    let code = |arguments: &[&str]| homolog().args(arguments).output().unwrap().status.code();
    assert_eq!(code(&["--version"]), Some(0));
    assert_eq!(code(&["match", "--help"]), Some(0));
    assert_eq!(code(&["nonsense"]), Some(2));
    assert_eq!(code(&["match", "one-file-only"]), Some(2));
    assert_eq!(code(&["demo", "one-file-only"]), Some(2));
}

#[test]
fn errors_in_files_and_parameters_name_them_and_exit_with_2() {
    let folder = tempfile::tempdir().unwrap();
    let junk = folder.path().join("junk.ply");
    fs::write(&junk, b"no surface at all").unwrap();
    let run = |arguments: &[&str]| {
        let done = homolog().arg("match").arg(&junk).arg(&junk).args(arguments).output().unwrap();
        (done.status.code(), done.stdout, String::from_utf8(done.stderr).unwrap())
    };
    let (code, stdout, stderr) = run(&["--json"]);
    assert_eq!((code, stdout.len()), (Some(2), 0));
    assert!(stderr.contains("source") && stderr.contains("junk.ply"), "{stderr}");
    let (code, _, stderr) = run(&["--set", "energy.alfa=1", "--set", "sed=1"]);
    assert_eq!(code, Some(2));
    assert!(stderr.contains("energy.alfa: ") && stderr.contains("sed: unknown key; did you mean seed?"), "{stderr}");
    let missing = homolog().args(["inspect", "/no/such/file"]).output().unwrap();
    assert_eq!(missing.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&missing.stderr).contains("/no/such/file"));
    let parameters = folder.path().join("p.json");
    fs::write(&parameters, "[1]").unwrap();
    assert_eq!(run(&["--params", parameters.to_str().unwrap()]).0, Some(2));
}

#[test]
fn a_closed_output_is_not_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let mut command = homolog();
    command.args(["phantom", "--edge", "2", "--kind", "surface", "--out"]).arg(folder.path());
    let mut child = child_with_closed_output(&mut command);
    assert_eq!(child.wait().unwrap().code(), Some(0));
}

fn child_with_closed_output(command: &mut Command) -> std::process::Child {
    let mut child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    child
}

#[test]
fn match_prints_the_result_document_and_nothing_else() {
    let folder = tempfile::tempdir().unwrap();
    let (source, target) = small_pair(folder.path());
    let out = folder.path().join("out");
    let done = homolog()
        .arg("match")
        .args([&source, &target])
        .args(["--json", "--seed", "7", "--out"])
        .arg(&out)
        .arg("--html")
        .arg(folder.path().join("page.html"))
        .output()
        .unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let printed: Value = serde_json::from_slice(&done.stdout).unwrap();
    assert_eq!(printed["provenance"]["seed"], 7);
    let version = String::from_utf8(homolog().arg("--version").output().unwrap().stdout).unwrap();
    let commit = printed["provenance"]["commit"].as_str().unwrap();
    assert!(version.contains(&format!("({commit})")), "{version} {commit}");
    let n = printed["correspondences"]["source"].as_array().unwrap().len();
    assert!(n > 0);
    assert_eq!(read_json(&out.join("result.json")), printed);
    assert_eq!(fs::read_to_string(out.join("correspondences.csv")).unwrap().lines().count(), n + 1);
    for name in ["source.ply", "target.ply", "aligned.ply", "warped.ply"] {
        assert!(fs::read(out.join(name)).unwrap().starts_with(b"ply"), "{name}");
    }
    assert!(fs::read_to_string(out.join("warped.csv")).unwrap().starts_with("vertex,image_x_mm,"));
    assert!(fs::read_to_string(out.join("warped.vtp")).unwrap().contains("displacement_normal_mm"));
    assert!(fs::read_to_string(out.join("warped.surf.gii")).unwrap().contains("area_ratio"));
    let page = fs::read_to_string(folder.path().join("page.html")).unwrap();
    assert!(page.contains("RELIABLE") && page.contains("dashed: a new round"), "{}", &page[..2000]);
    assert!(!page.contains("source.ply") && page.len() < 1 << 20, "no file names; {} bytes", page.len());
    let trace = fs::read_to_string(out.join("trace.jsonl")).unwrap();
    let seqs: Vec<u64> =
        trace.lines().map(|l| serde_json::from_str::<Value>(l).unwrap()["seq"].as_u64().unwrap()).collect();
    assert!(!seqs.is_empty() && seqs.windows(2).all(|w| w[0] < w[1]));
}

#[test]
fn match_says_first_whether_the_answer_can_be_relied_on() {
    let folder = tempfile::tempdir().unwrap();
    let (source, target) = small_pair(folder.path());
    let shown = |target: &Path| {
        let done = homolog().arg("match").args([&source, target]).output().unwrap();
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        String::from_utf8(done.stdout).unwrap()
    };
    let text = shown(&target);
    assert!(text.starts_with("RELIABLE: no reason was found"), "{text}");
    assert!(text.contains("\nNext: Look at both surfaces in corresponding colors (--html PAGE.html)"), "{text}");
    // A file against itself alarms nobody.
    let text = shown(&source);
    assert!(text.starts_with("RELIABLE") && text.contains("0.00 mm apart on average"), "{text}");
    assert!(!text.contains("limit") && !text.contains("-0.00"), "{text}");

    let mirrored = folder.path().join("mirrored.ply");
    let FileContent::Mesh(file) = read(&fs::read(&target).unwrap(), None, &ReadLimits::default()).unwrap().content
    else {
        panic!("a mesh is expected")
    };
    let points = file.mesh.vertices().iter().map(|p| Point3::new(-p.x, p.y, p.z)).collect();
    fs::write(&mirrored, write_ply(&file.mesh.with_vertices(points).unwrap())).unwrap();
    let text = shown(&mirrored);
    assert!(text.starts_with("NOT RELIABLE: do not use"), "{text}");
    assert!(text.contains("- A mirror image of the source fits the target better.\n"), "{text}");
    assert!(text.contains("\nNext: Is one of them left") && text.contains("--mirror source"), "{text}");
}

#[test]
fn inspect_names_the_option_that_makes_a_surface_suitable() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("open.off");
    fs::write(&file, "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n").unwrap();
    let inspected = |json: &[&str]| {
        let done =
            homolog().arg("inspect").arg(&file).args(["--set", "input.allow_boundary=false"]).args(json).output();
        let done = done.unwrap();
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
        String::from_utf8(done.stdout).unwrap()
    };
    let text = inspected(&[]);
    assert!(text.contains("3 edges have only one face") && text.contains("--set input.allow_boundary=true"), "{text}");
    let report: Value = serde_json::from_str(&inspected(&["--json"])).unwrap();
    let detail = report["refusal"]["detail"].as_str().unwrap();
    assert!(detail.contains(r#"{"input": {"allow_boundary": true}}"#), "{detail}");
}

#[test]
fn inspect_reports_a_closed_surface_of_genus_zero() {
    let folder = tempfile::tempdir().unwrap();
    let (source, _) = small_pair(folder.path());
    let done = homolog().arg("inspect").arg(&source).arg("--json").output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let report: Value = serde_json::from_slice(&done.stdout).unwrap();
    assert_eq!(report["topology"]["genus"], 0);
}

#[test]
fn the_demo_compares_its_answer_with_the_truth() {
    let folder = tempfile::tempdir().unwrap();
    let done = homolog().args(["demo", "--out"]).arg(folder.path()).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let shown = String::from_utf8(done.stdout).unwrap();
    assert!(shown.starts_with("RELIABLE"), "{shown}");
    let after = |text: &str| shown.split_once(text).unwrap().1.split_whitespace().next().unwrap().to_owned();
    let [degrees, median_mm] = ["\n  rotation", "\n  corresponding points"].map(after);
    assert!(degrees.trim_end_matches('°').parse::<f64>().unwrap() < 10.0, "{shown}");
    // Half a voxel.
    assert!(median_mm.parse::<f64>().unwrap() < 0.5, "{shown}");
    let (energies, fits) = (after("energy of the field over"), after("iterations of"));
    assert!(energies.parse::<u32>().unwrap() > 10 && fits.parse::<u32>().unwrap() >= 1, "{shown}");
    assert_eq!(shown.lines().filter(|line| line.contains('┤')).count(), 10, "{shown}");
    for name in ["warped.vtp", "warped.surf.gii", "correspondences.csv", "transform.tfm", "transform.lta"] {
        assert!(fs::metadata(folder.path().join(name)).unwrap().len() > 0, "{name}");
    }
}

#[test]
fn the_demo_runs_from_submission_to_aligned_surface() {
    let folder = tempfile::tempdir().unwrap();
    let (source, target) = small_pair(&folder.path().join("pair"));
    let out = folder.path().join("demo");
    let done = homolog().arg("demo").args([&source, &target]).arg("--out").arg(&out).output().unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let shown = String::from_utf8(done.stdout).unwrap();
    assert!(shown.contains("target_from_source") && shown.contains("energy"), "{shown}");
    assert!(fs::read(out.join("aligned.ply")).unwrap().starts_with(b"ply"));
    assert!(read_json(&out.join("result.json"))["transform"]["matrix"].is_array());
    let left: Vec<_> = fs::read_dir(&out).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert!(!left.iter().any(|name| name.to_string_lossy().starts_with("service-data")), "{left:?}");
}

/// The command that `make demo KEEP=1` runs.
#[test]
fn a_demo_that_is_kept_ends_with_the_address_of_its_match_and_runs_until_it_is_interrupted() {
    let folder = tempfile::tempdir().unwrap();
    let mut demo =
        homolog().args(["demo", "--keep", "--out"]).arg(folder.path()).stdout(Stdio::piped()).spawn().unwrap();
    let mut lines = BufReader::new(demo.stdout.take().unwrap()).lines().map(Result::unwrap);
    let address = lines.find_map(|line| line.strip_prefix("the match in 3D: ").map(str::to_owned)).unwrap();
    let (base, job) = address.split_once("#/jobs/").unwrap();
    homolog::tls::prepare();
    let page = reqwest::blocking::get(base).unwrap();
    assert_eq!(page.status(), 200);
    assert!(page.text().unwrap().contains("<script"), "{base} is the dashboard");
    let job: Value =
        serde_json::from_slice(&reqwest::blocking::get(format!("{base}v1/jobs/{job}")).unwrap().bytes().unwrap())
            .unwrap();
    assert_eq!((&job["state"], &job["reliable"]), (&"succeeded".into(), &true.into()));
    assert!(Command::new("kill").args(["-INT", &demo.id().to_string()]).status().unwrap().success());
    assert!(demo.wait().unwrap().success());
    assert!(lines.next().is_none(), "nothing after the address");
    assert!(reqwest::blocking::get(base).is_err(), "the service has ended");
}

/// Exit code, standard output and standard error of `homolog` with these variables and no other settings.
fn with_environment(arguments: &[&str], environment: &[(&str, &str)]) -> (Option<i32>, String, String) {
    let mut command = homolog();
    std::env::vars().filter(|(name, _)| name.starts_with("HOMOLOG_")).for_each(|(name, _)| {
        command.env_remove(name);
    });
    let done = command.args(arguments).envs(environment.iter().copied()).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (done.status.code(), text(done.stdout), text(done.stderr))
}

#[test]
fn settings_come_from_the_file_the_environment_and_the_command_line_in_this_order() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("homolog.toml");
    fs::write(
        &file,
        "max_queue = 11\nmax_batch = 12\nmax_checks = 13\ninsecure = true\nauth = \"keys\"\ntenant_weights = [\"a=2\", \"b=3\"]\n\
         retain_results_days = 7.5\ndatabase_url = \"postgres://homolog:geheim@db/homolog\"\nmax_jobs = 5\n",
    )
    .unwrap();
    let path = file.to_str().unwrap();
    let environment = [("HOMOLOG_MAX_BATCH", "22"), ("HOMOLOG_MAX_CHECKS", "23"), ("HOMOLOG_CONFIG", path)];
    let (code, printed, stderr) = with_environment(&["config", "--max-checks", "33"], &environment);
    assert_eq!(code, Some(0), "{stderr}");
    let line = |name: &str| {
        let found = printed.lines().find(|line| line.trim_start_matches("# ").starts_with(&format!("{name} =")));
        let (value, source) = found.unwrap_or_else(|| panic!("no {name}:\n{printed}")).rsplit_once('#').unwrap();
        (value.trim().to_owned(), source.trim().to_owned())
    };
    let expect = |name: &str, value: &str, source: &str| {
        assert_eq!(line(name), (format!("{name} = {value}"), source.to_owned()));
    };
    expect("max_queue", "11", "file");
    expect("max_batch", "22", "environment");
    expect("max_checks", "33", "command line");
    expect("insecure", "true", "file");
    expect("auth", "\"keys\"", "file");
    expect("tenant_weights", "[\"a=2\", \"b=3\"]", "file");
    expect("retain_results_days", "7.5", "file");
    expect("max_jobs", "5", "file");
    expect("listen", "\"127.0.0.1:8080\"", "default");
    let cores = std::thread::available_parallelism().unwrap();
    assert_eq!(line("cores").1, format!("not set; here {cores}"));
    assert_eq!(line("max_stored_bytes").1, "not set");
    assert_eq!(line("database_url"), ("# database_url = \"***\"".to_owned(), "file".to_owned()));
    assert!(!printed.contains("geheim"));

    // The printed text is a configuration file that gives the same settings.
    let again = folder.path().join("again.toml");
    fs::write(&again, &printed).unwrap();
    let (code, reprinted, stderr) = with_environment(&["config", "--config", again.to_str().unwrap()], &[]);
    assert_eq!(code, Some(0), "{stderr}");
    let settings = |text: &str| -> Vec<String> {
        text.lines()
            .filter(|line| !line.contains("database_url"))
            .map(|line| line.rsplit_once('#').unwrap().0.to_owned())
            .collect()
    };
    assert_eq!(settings(&reprinted), settings(&printed));
}

#[test]
fn every_setting_is_in_the_printed_configuration() {
    let (_, printed, _) = with_environment(&["config"], &[]);
    for command in ["serve", "worker", "purge"] {
        let (_, help, _) = with_environment(&[command, "--help"], &[]);
        let words: Vec<&str> = help.split_whitespace().collect();
        for name in words
            .join(" ")
            .split("[env: HOMOLOG_")
            .skip(1)
            .map(|rest| rest.split(['=', ']']).next().unwrap().to_owned())
        {
            let key = name.to_lowercase();
            let is_there = printed.lines().any(|line| line.trim_start_matches("# ").starts_with(&format!("{key} =")));
            assert!(is_there || name == "CONFIG", "{command}: {name} is not in\n{printed}");
        }
    }
}

#[test]
fn wrong_configuration_files_are_refused_with_the_place() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("homolog.toml");
    let data = folder.path().join("data");
    for (text, said) in [
        ("max_queues = 5", "max_queues is no setting; did you mean max_queue?"),
        ("config = \"other.toml\"", "config is no setting"),
        ("max_queue = \"many\"", "invalid value 'many' for '--max-queue <N>'"),
        ("lease_ms = 1", "--lease-ms"),
        ("max_queue = {n = 1}", "max_queue must be a text"),
        ("max_queue 5", "is no TOML"),
    ] {
        fs::write(&file, text).unwrap();
        let arguments = ["config", "--data-dir", data.to_str().unwrap(), "--config", file.to_str().unwrap()];
        let (code, stdout, stderr) = with_environment(&arguments, &[]);
        assert_eq!((code, stdout.as_str()), (Some(2), ""), "{text}: {stderr}");
        assert!(stderr.contains(said) && stderr.contains("homolog.toml"), "{text}: {stderr}");
        assert!(!data.exists());
    }
    let (code, _, stderr) = with_environment(&["config", "--config", "/nonexistent.toml"], &[]);
    assert!(code == Some(2) && stderr.contains("/nonexistent.toml"), "{stderr}");
    let (code, _, stderr) = with_environment(&["config"], &[("HOMOLOG_MAX_QUEUES", "5")]);
    assert!(code == Some(2) && stderr.contains("did you mean HOMOLOG_MAX_QUEUE?"), "{stderr}");
}
