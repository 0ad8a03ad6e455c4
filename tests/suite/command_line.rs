//! Messages of the command line for people: suggestions for misspelled words, the required form of values, the options
//! of a command, the outcomes of many pairs. Every message uses terms of the command line.

use super::cli::homolog;
use serde_json::Value;
use std::fs;
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Exit code, standard output and standard error, without settings of the environment.
fn run(arguments: &[&str]) -> (Option<i32>, String, String) {
    let mut command = homolog();
    std::env::vars().filter(|(name, _)| name.starts_with("HOMOLOG_")).for_each(|(name, _)| {
        command.env_remove(name);
    });
    let done = command.args(arguments).output().unwrap();
    (done.status.code(), String::from_utf8(done.stdout).unwrap(), String::from_utf8(done.stderr).unwrap())
}

/// The message for wrong arguments.
fn refused(arguments: &[&str]) -> String {
    let (code, _, said) = run(arguments);
    assert_eq!(code, Some(2), "{arguments:?}: {said}");
    said
}

/// Small phantom surfaces: a source and a target.
fn pair(folder: &Path) -> [String; 2] {
    let done = homolog()
        .args(["phantom", "--kind", "surface", "--edge", "3", "--rotate-seed", "4", "--out"])
        .arg(folder)
        .output();
    assert!(done.unwrap().status.success());
    ["source.ply", "target.ply"].map(|name| folder.join(name).to_str().unwrap().to_owned())
}

#[test]
fn misspelled_commands_methods_and_keys_are_answered_with_what_was_meant() {
    for (arguments, meant) in [
        (&["mach", "a", "b"][..], "'match'"),
        (&["completion", "bash"], "'completions'"),
        (&["match", "a", "b", "--sead", "1"], "'--seed'"),
        (&["match", "a", "b", "--method", "thesys"], "'thesis'"),
        (&["match", "a", "b", "--repair", "wield"], "'weld'"),
        (&["match", "a", "b", "--set", "method=thesys"], "method: unknown method; did you mean thesis?"),
        (&["match", "a", "b", "--set", "energy.alfa=1"], "energy.alfa: unknown key; did you mean alpha?"),
        (&["match", "a", "b", "--set", "alpha=1"], "alpha: unknown key; did you mean energy.alpha?"),
        (&["match", "a", "b", "--set", "input.surface=smoth"], "input.surface: unknown word; did you mean smooth?"),
        (&["inspect", "a", "--set", "input.lables=1"], "input.lables: unknown key; did you mean labels?"),
    ] {
        let said = refused(arguments);
        assert!(said.contains(meant), "{arguments:?}: {said}");
    }
}

#[test]
fn wrong_values_are_answered_with_what_is_needed() {
    for (arguments, needed) in [
        (&["match", "a", "b", "--seed", "one"][..], "a whole number of at least 0 is needed here"),
        (&["match", "a", "b", "--seed", "-1"], "a whole number of at least 0 is needed here"),
        (&["match", "a", "b", "--set", "seed=one"], "seed: must be a whole number of at least 0"),
        (&["match", "a", "b", "--set", "energy.alpha=two"], "energy.alpha: must be a number from 0 to "),
        (&["match", "a", "b", "--set", "energy.alpha=-1"], "energy.alpha: must be from 0 to "),
        (&["match", "a", "b", "--set", "both_directions=1"], "both_directions: must be true or false"),
        (&["match", "a", "b", "--set", "features.0.weight=x"], "features.0.weight: must be a number"),
        (&["match", "a", "b", "--set", "alpha"], "write a.b=value"),
        (&["match", "a", "b", "--study-uid", "Doe", "--out", "x"], "must be a DICOM UID"),
        (&["match", "a", "b", "--study-uid", "1.2.3"], "--out"),
        (&["phantom", "--spacing", "wide"], "a number is needed here"),
        (&["serve", "--max-queue", "many"], "a whole number of at least 0 is needed here"),
        (
            &["serve", "--listen", "8080"],
            "an address with a port is needed here, such as 127.0.0.1:8080, localhost:8080",
        ),
        (&["serve", "--listen", "no-such-host.invalid:8080"], "no address is found for no-such-host.invalid"),
        (&["serve", "--insecure=perhaps"], "--insecure"),
    ] {
        let said = refused(arguments);
        assert!(said.contains(needed), "{arguments:?}: {said}");
        for jargon in ["u64", "u32", "f64", "invalid digit", "float literal", "/energy", "invalid type", "sequence"] {
            assert!(!said.contains(jargon), "{arguments:?}: {said}");
        }
    }
}

#[test]
fn options_say_the_same_as_settings() {
    let folder = tempfile::tempdir().unwrap();
    let [source, target] = pair(folder.path());
    let parameters = |arguments: &[&str]| -> Value {
        let (code, printed, said) = run(&[&["match", &source, &target, "--json"][..], arguments].concat());
        assert_eq!(code, Some(0), "{said}");
        serde_json::from_str::<Value>(&printed).unwrap()["provenance"]["parameters"].take()
    };
    let options = [
        "--method",
        "thesis",
        "--repair",
        "weld,orient",
        "--repair",
        "fill",
        "--label",
        "17",
        "--label",
        "Left",
        "--seed",
        "3",
    ];
    let settings = [
        "--set",
        "method=thesis",
        "--set",
        r#"input.repair=["weld","orient","fill"]"#,
        "--set",
        r#"input.labels=[17,"Left"]"#,
        "--set",
        "seed=3",
    ];
    assert_eq!(parameters(&options), parameters(&settings));
    let sides = parameters(&["--source-label", "17", "--target-label", "53", "--repair", "none"]);
    assert_eq!(sides["input"]["source"]["labels"], serde_json::json!([17]));
    assert_eq!(sides["input"]["target"]["labels"], serde_json::json!([53]));
    assert_eq!(sides["input"]["repair"], serde_json::json!([]));
}

#[test]
fn the_help_of_a_command_lists_what_it_uses_and_nothing_else() {
    let help = |arguments: &[&str]| {
        let (code, printed, _) = run(&[arguments, &["--help"]].concat());
        assert_eq!(code, Some(0));
        printed
    };
    for arguments in
        [&["migrate"][..], &["keys", "create"], &["keys", "list"], &["audit", "export"], &["backup"], &["restore"]]
    {
        let text = help(arguments);
        assert!(text.contains("--data-dir") && text.contains("--config"), "{arguments:?}: {text}");
        for other in ["--listen", "--max-queue", "--lease-ms", "--retain-results-days", "--max-vertices", "--workers"] {
            assert!(!text.contains(other), "{arguments:?} does not use {other}");
        }
    }
    let purge = help(&["purge"]);
    assert!(purge.contains("--retain-results-days") && purge.contains("--artifacts-url"));
    assert!(!purge.contains("--lease-ms"));
    assert!(!help(&["worker"]).contains("--listen ") && help(&["serve"]).contains("--listen "));
    let inspect = help(&["inspect"]);
    assert!(inspect.contains("--label") && inspect.contains("--repair"));
    assert!(!inspect.contains("--seed") && !inspect.contains("--method"));
    // Settings that are not listed are also accepted, because the file and the environment are shared with the service.
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().to_str().unwrap();
    let (code, _, said) = run(&["migrate", "--data-dir", data, "--lease-ms", "9000"]);
    assert_eq!(code, Some(0), "{said}");
}

#[test]
fn scripts_for_shells_complete_commands_and_options() {
    for (shell, known) in
        [("bash", "complete -F _homolog"), ("zsh", "#compdef homolog"), ("fish", "complete -c homolog")]
    {
        let (code, script, said) = run(&["completions", shell]);
        assert_eq!(code, Some(0), "{said}");
        for word in [known, "match", "repair", "largest_component"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
    assert!(refused(&["completions", "csh"]).contains("possible values: bash, elvish, fish"));
    // Bash loads the script and completes a command.
    if let Ok(bash) = Command::new("bash").arg("--version").stdout(Stdio::null()).status() {
        assert!(bash.success());
        let file = tempfile::NamedTempFile::new().unwrap();
        fs::write(file.path(), run(&["completions", "bash"]).1).unwrap();
        let ask = "source \"$0\"; COMP_WORDS=(homolog ins); COMP_CWORD=1; _homolog homolog ins homolog; echo \"${COMPREPLY[@]}\"";
        let done = Command::new("bash").args(["-c", ask]).arg(file.path()).output().unwrap();
        assert_eq!(
            String::from_utf8_lossy(&done.stdout).trim(),
            "inspect",
            "{}",
            String::from_utf8_lossy(&done.stderr)
        );
    }
}

/// A running `homolog serve`; it is killed when dropped.
struct Serving(std::process::Child);

impl Drop for Serving {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

#[test]
fn a_name_can_be_listened_on_and_a_taken_port_or_folder_is_said_at_once() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("data");
    let serve = |listen: &str, data: &Path| {
        let mut command = homolog();
        command.args(["serve", "--workers", "0", "--listen", listen, "--data-dir"]).arg(data);
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    };
    let line = |child: &mut std::process::Child, of: &str| {
        use std::io::{BufRead as _, BufReader};
        let mut line = String::new();
        let read = match of {
            "stdout" => BufReader::new(child.stdout.take().unwrap()).read_line(&mut line),
            _ => BufReader::new(child.stderr.take().unwrap()).read_line(&mut line),
        };
        assert!(read.unwrap() > 0, "nothing on {of}");
        line
    };
    let mut first = Serving(serve("localhost:0", &data).spawn().unwrap());
    let said = line(&mut first.0, "stdout");
    assert!(said.starts_with("homolog listens on http://127.0.0.1:"), "{said}");

    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = format!("localhost:{}", taken.local_addr().unwrap().port());
    let done = serve(&address, &folder.path().join("other")).output().unwrap();
    let said = String::from_utf8_lossy(&done.stderr).into_owned();
    assert_eq!(done.status.code(), Some(1));
    assert!(said.contains("another program listens there") && said.contains("--listen"), "{said}");

    // A folder in use is reported at once; the command then waits for the other process to end.
    let mut second = Serving(serve("127.0.0.1:0", &data).spawn().unwrap());
    let said = line(&mut second.0, "stderr");
    assert!(said.contains("uses the data directory; waiting 10 s"), "{said}");
    assert!(second.0.try_wait().unwrap().is_none(), "it waits");

    // Unwritable folders and pages are reported before the match.
    let [source, target] = pair(&folder.path().join("pair"));
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    let said = refused(&["match", &source, &target, "--out", file.to_str().unwrap()]);
    assert!(said.contains("is a file; choose a folder with --out"), "{said}");
    let (code, verdict, said) = run(&["match", &source, &target, "--html", "/no/such/folder/page.html"]);
    assert!(code == Some(1) && said.contains("cannot write /no/such/folder"), "{said}");
    assert!(verdict.is_empty(), "before the match: {verdict}");
}

#[test]
fn a_source_is_matched_to_many_targets_with_a_table_of_verdicts() {
    let folder = tempfile::tempdir().unwrap();
    let [source, target] = pair(folder.path());
    let other = folder.path().join("other.ply");
    fs::copy(&source, &other).unwrap();
    let broken = folder.path().join("broken.ply");
    fs::write(&broken, "ply\nno more").unwrap();
    let (other, broken) = (other.to_str().unwrap(), broken.to_str().unwrap());
    let out: PathBuf = folder.path().join("out");
    let (code, table, said) = run(&["match", &source, &target, other, "--out", out.to_str().unwrap()]);
    assert_eq!(code, Some(0), "{said}");
    let lines: Vec<Vec<&str>> = table.lines().map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(lines[0][..2], ["target", "verdict"]);
    assert_eq!((lines[1][0], lines[2][0]), ("target", "other"));
    assert_eq!(lines[2][1..3], ["reliable", "0.00"]);
    assert!(table.lines().last().unwrap().ends_with("of 2 reliable"), "{table}");
    for name in ["target", "other"] {
        for file in ["result.json", "correspondences.csv", "warped.ply", "transform.tfm", "report.html", "trace.jsonl"]
        {
            assert!(fs::metadata(out.join(name).join(file)).unwrap().len() > 0, "{name}/{file}");
        }
        // The rows of all answers are the vertices of the source.
        let rows = fs::read_to_string(out.join(name).join("warped.csv")).unwrap();
        let first = fs::read_to_string(out.join("target/warped.csv")).unwrap();
        assert_eq!(rows.lines().count(), first.lines().count());
    }
    let summary = fs::read_to_string(out.join("summary.csv")).unwrap();
    assert!(summary.starts_with("target,folder,reliable,reasons,mean_mm"), "{summary}");
    assert_eq!(summary.lines().count(), 3);

    // The answer of a pair does not depend on the other pairs.
    let (_, alone, _) = run(&["match", &source, &target, "--json"]);
    let alone: Value = serde_json::from_str(&alone).unwrap();
    let (code, printed, said) = run(&["match", &source, &target, broken, other, "--json"]);
    assert_eq!(code, Some(1), "one has failed: {said}");
    assert!(said.contains("1 of 3 pairs could not be matched"), "{said}");
    let lines: Vec<Value> = printed.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines[0]["result"]["correspondences"], alone["correspondences"]);
    assert!(lines[1]["error"].as_str().unwrap().contains("broken.ply") && lines[2]["result"].is_object());
    let (_, table, _) = run(&["match", &source, &target, broken, other]);
    assert!(table.lines().nth(2).unwrap().starts_with("broken") && table.contains("FAILED"), "{table}");

    assert!(refused(&["match", &source, &target, other, "--html", "page.html"]).contains("--html is for one pair"));
    assert!(refused(&["match", &source, &target, "/no/such/file"]).contains("cannot read /no/such/file"));
}

#[cfg(target_os = "linux")]
#[test]
fn the_memory_of_one_match_is_that_of_a_process() {
    let folder = tempfile::tempdir().unwrap();
    let [source, target] = pair(folder.path());
    let (code, printed, said) = run(&["peak-memory", &source, &target, "--method", "rigid"]);
    assert_eq!(code, Some(0), "{said}");
    let bytes: u64 = printed.trim().parse().unwrap();
    assert!((4 << 20..1 << 30).contains(&bytes), "{bytes} bytes");
    let (code, printed, _) = run(&["match", &source, &target, "--method", "rigid"]);
    assert_eq!(code, Some(0));
    assert!(printed.contains("deformation       0 triangles folded"), "{printed}");
}

#[test]
fn the_first_long_build_is_announced() {
    let makefile = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("Makefile")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("Makefile"), makefile).unwrap();
    fs::create_dir(folder.path().join("scripts")).unwrap();
    let make = |target: &str| {
        let mut command = Command::new("make");
        command.arg("-C").arg(folder.path()).args([target, "CARGO=true"]);
        let done = command.output().ok()?;
        Some(String::from_utf8(done.stderr).unwrap())
    };
    let setup = folder.path().join("scripts/setup");
    fs::write(&setup, "#!/bin/sh\n").unwrap();
    #[cfg(unix)]
    fs::set_permissions(&setup, std::os::unix::fs::PermissionsExt::from_mode(0o755)).unwrap();
    let Some(said) = make("build") else { return eprintln!("skipped: there is no make") };
    assert!(said.contains("the first build compiles several hundred libraries, which takes minutes"), "{said}");
    fs::create_dir_all(folder.path().join("target/release")).unwrap();
    fs::write(folder.path().join("target/release/homolog"), "").unwrap();
    assert!(!make("build").unwrap().contains("the first build"));
}
