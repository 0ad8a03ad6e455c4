//! docs/refusals.md: what was tried, and the message that refused it. Each entry is tried here, and the page has the messages of this
//! build. After a change: `HOMOLOG_WRITE_DOCS=1 cargo nextest run --workspace --locked -E 'test(refusals)'`.

use super::cli::homolog;
use super::faults::site::{Backend, Site};
use super::study_service::Service;
use homolog_mesh::volume::LabelVolume;
use nalgebra::{Matrix4, Vector3};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

/// Files in which something is wrong, and some good ones beside them.
fn files(folder: &Path) {
    let write = |name: &str, bytes: &[u8]| fs::write(folder.join(name), bytes).unwrap();
    let phantom = |arguments: &[&str], out: &str| {
        let done = homolog().arg("phantom").args(arguments).arg("--out").arg(folder.join(out)).output().unwrap();
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    };
    phantom(&["--spacing", "2"], "volume");
    phantom(&["--kind", "surface", "--edge", "3"], "surface");
    let take = |from: &str, to: &str| fs::copy(folder.join(from), folder.join(to)).unwrap();
    take("volume/source.nii.gz", "left.nii.gz");
    take("surface/source.ply", "left.ply");
    take("surface/target.ply", "right.ply");
    let good = fs::read(folder.join("left.nii.gz")).unwrap();
    write("cut.nii.gz", &good[..good.len() / 2]);
    write("empty.ply", b"");
    write("notes.docx", b"Dear colleague, the surfaces are attached.");
    write("scan.nhdr", b"NRRD0004\ntype: short\ndimension: 3\nsizes: 9 9 9\nencoding: raw\ndata file: scan.raw\n");
    // A scan: intensities of a head in noise.
    let side = 24usize;
    let intensity = |k: usize| {
        let [x, y, z] = [k % side, k / side % side, k / (side * side)].map(|c| c as f64 - 11.5);
        let noise = (k as u32).wrapping_mul(2_654_435_761) >> 26;
        if x * x + y * y + z * z < 100.0 { 200 + noise + x.abs() as u32 } else { 1 + noise / 4 }
    };
    let volume = |label: &dyn Fn(usize) -> u32| {
        let labels = (0..side.pow(3)).map(label).collect();
        LabelVolume::new([side; 3], labels, Matrix4::new_translation(&Vector3::repeat(-12.0))).unwrap()
    };
    write("t1.nii", &homolog_formats::write_nifti(&volume(&intensity)));
    write("blank.nii", &homolog_formats::write_nifti(&volume(&|_| 0)));
    // Structures with numbers of FreeSurfer.
    let brain = |k: usize| {
        let [x, y, z] = [k % side, k / side % side, k / (side * side)];
        let inside = (4..20).contains(&y) && (8..16).contains(&z);
        match x {
            2..=8 if inside => 17,
            15..=21 if inside => 53,
            12 if inside => 251,
            _ => 0,
        }
    };
    write("aseg.nii", &homolog_formats::write_nifti(&volume(&brain)));
    // A band with half a turn, a closed surface without a volume, a corner used twice.
    let ring: String = (0..12)
        .map(|k| {
            let (a, half) = (f64::from(k) * std::f64::consts::TAU / 12.0, f64::from(k) * std::f64::consts::PI / 12.0);
            let place = |w: f64| {
                let r = 10.0 + w * half.cos();
                format!("v {:.3} {:.3} {:.3}\n", r * a.cos(), r * a.sin(), w * half.sin())
            };
            place(-2.0) + &place(2.0)
        })
        .collect();
    let band: String = (0..12)
        .map(|k| {
            let (a, b) = (2 * k + 1, 2 * k + 2);
            let (c, d) = if k < 11 { (a + 2, b + 2) } else { (2, 1) };
            format!("f {a} {c} {b}\nf {b} {c} {d}\n")
        })
        .collect();
    write("moebius.obj", (ring + &band).as_bytes());
    write("flat.off", b"OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    write("twice.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\nf 1 1 2\n");
    for (name, table) in [
        ("no-file.csv", "id,scan\na,left.ply\n"),
        ("same-id.csv", "id,file\na,left.ply\na,right.ply\nb,left.ply\n"),
        ("two.csv", "id,file\na,left.ply\nb,right.ply\n"),
        ("sides.csv", "id,file,side\na,left.ply,left\nb,right.ply,rigth\nc,left.ply,left\n"),
        ("labels.csv", "id,file,label\na,aseg.nii,17\nb,aseg.nii,0\nc,aseg.nii,53\n"),
        ("groups.csv", "id,file,group\na,left.ply,p\nb,right.ply,c\nc,left.ply,c\n"),
        ("lost.csv", "id,file\na,left.ply\nb,lost.ply\nc,right.ply\n"),
    ] {
        write(name, table.as_bytes());
    }
}

/// What was tried on the command line, with a word on what is wrong, by section.
const COMMANDS: [(&str, &[(&str, &str)]); 4] = [
    (
        "Files",
        &[
            ("a document", "inspect notes.docx"),
            ("an empty file", "inspect empty.ply"),
            ("a transfer that was cut off", "inspect cut.nii.gz"),
            ("a header whose voxels are in another file", "inspect scan.nhdr"),
            ("a scan instead of its segmentation", "match t1.nii left.nii.gz"),
            ("a volume without a structure", "match blank.nii left.nii.gz"),
            ("a band with half a turn", "match moebius.obj left.ply"),
            ("a closed surface without a volume", "match flat.off left.ply"),
            ("a triangle that uses a vertex twice, without repair", "match twice.obj left.ply --repair none"),
            ("a larger surface than is allowed", "match left.ply right.ply --max-vertices 100"),
            ("a file that is not there", "match left.ply lost.ply"),
        ],
    ),
    (
        "Labels",
        &[
            ("a number that the volume has not", "match aseg.nii left.nii.gz --source-label 18"),
            ("a misspelled name", "match aseg.nii left.nii.gz --source-label left-hipocampus"),
            ("the background", "match aseg.nii left.nii.gz --source-label 0"),
            ("a label of a scan that it has not", "match t1.nii left.nii.gz --source-label 4000"),
        ],
    ),
    (
        "Parameters",
        &[
            ("a misspelled method", "match left.ply right.ply --method balansed"),
            ("a misspelled parameter", "match left.ply right.ply --set energy.alfa=1"),
            ("a value out of range", "match left.ply right.ply --set energy.alpha=-1"),
            ("a word instead of a number", "match left.ply right.ply --set seed=first"),
            ("a misspelled command", "mach left.ply right.ply"),
        ],
    ),
    (
        "Studies",
        &[
            ("a table without files", "study no-file.csv --out out"),
            ("two rows with one id", "study same-id.csv --out out"),
            ("two subjects", "study two.csv --out out"),
            ("a misspelled side", "study sides.csv --out out"),
            ("a label that is the background", "study labels.csv --out out"),
            ("a file that is not there", "study lost.csv --out out"),
            ("an effect that is no column", "study groups.csv --out out --effect grup"),
            ("a side of the template without sides of the subjects", "study groups.csv --out out --template-side left"),
        ],
    ),
];

/// What is printed on the standard error by a command that fails.
fn said(folder: &Path, command: &str) -> String {
    let done = homolog().current_dir(folder).args(command.split(' ')).output().unwrap();
    assert!(matches!(done.status.code(), Some(1 | 2)), "{command}: {:?}", done.status);
    let text = String::from_utf8(done.stderr).unwrap();
    // Only the refusal: notes, usage and progress are not part of it.
    let lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
    let lines =
        lines.filter(|line| !line.starts_with("note:") && !line.starts_with("Usage:") && !line.starts_with("For more"));
    let folder = folder.display().to_string();
    lines.collect::<Vec<_>>().join(" ").replace(&format!("{folder}/"), "")
}

/// What was tried over HTTP: a word on what is wrong, method and path, and the body.
fn requests(mesh: &str) -> Vec<(&'static str, &'static str, String, Value)> {
    let zeros = format!("blake3:{}", "0".repeat(64));
    let pair = |source: Value| json!({"source": source, "target": {"mesh_id": mesh}});
    let good = || json!({"mesh_id": mesh});
    let job = |name, body| (name, "POST", "/v1/jobs".to_owned(), body);
    let hook = |name, url: &str| (name, "POST", "/v1/webhooks".to_owned(), json!({"url": url}));
    let get = |name, path: &str| (name, "GET", path.to_owned(), Value::Null);
    let with = |name: &str, value: Value| {
        let mut body = pair(good());
        body[name] = value;
        body
    };
    let study = |subjects: Value| json!({"subjects": subjects});
    let subject = |id: &str| json!({"id": id, "input": good()});
    vec![
        job("a path instead of an upload", pair(json!("scans/s01.nii.gz"))),
        job("an upload that is not there", pair(json!({"mesh_id": zeros}))),
        job("an input in two forms", pair(json!({"mesh_id": mesh, "upload": "a.ply"}))),
        job("an input that is missing", json!({"source": good()})),
        job(
            "a file in base64 that is no surface",
            pair(json!({"content_base64": "bm90ZXM=", "file_name": "notes.ply"})),
        ),
        job("a misspelled parameter", with("parameters", json!({"energy": {"alfa": 1}}))),
        job("a misspelled method", with("parameters", json!({"method": "balansed"}))),
        job("a member that does not exist", with("label", json!(17))),
        job("tags that are no texts", with("tags", json!({"site": 7}))),
        job("a priority out of range", with("priority", json!(1000))),
        ("a study of two subjects", "POST", "/v1/studies".to_owned(), study(json!([subject("a"), subject("b")]))),
        (
            "a label for a subject that is the background",
            "POST",
            "/v1/studies".to_owned(),
            study(json!([subject("a"), subject("b"), {"id": "c", "input": good(), "labels": 0}])),
        ),
        ("an effect that no subject has", "POST", "/v1/studies".to_owned(), {
            let mut body = study(json!([subject("a"), subject("b"), subject("c")]));
            body["effect"] = json!("group");
            body
        }),
        get("an id that is none", "/v1/jobs/17"),
        get("a job that is not there", "/v1/jobs/01a1fd75-7d19-7645-82c0-bd629106a067"),
        get("a filter that does not exist", "/v1/jobs?satte=queued"),
        get("a longer wait than is allowed", "/v1/jobs/01a1fd75-7d19-7645-82c0-bd629106a067?wait=600"),
        hook("a webhook on the machine of the service", "http://127.0.0.1:8085/hook"),
        hook("a webhook on a private network", "http://10.0.0.7/hook"),
        hook("a webhook to the metadata of a cloud", "http://169.254.169.254/latest/meta-data"),
        hook("a webhook with another protocol", "ftp://receiver.example.org/hook"),
        hook("a webhook whose address is none", "receiver.example.org/hook"),
        hook("a webhook with a password in its address", "https://user:secret@receiver.example.org/hook"),
    ]
}

/// Status, title, and detail or faults of a problem.
fn answered(service: &Service, method: &str, path: &str, body: &Value) -> String {
    let response = if method == "GET" { service.fetch(path) } else { service.post(path, body) };
    let status = response.status().as_u16();
    let problem: Value = response.json().unwrap();
    assert!((400..500).contains(&status), "{method} {path}: {status} {problem}");
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let errors = problem["errors"].as_array().cloned().unwrap_or_default();
    let faults: Vec<String> =
        errors.iter().map(|error| format!("{}: {}", text(&error["pointer"]), text(&error["detail"]))).collect();
    let details = if faults.is_empty() { text(&problem["detail"]) } else { faults.join("; ") };
    let details = if details.is_empty() { details } else { format!(": {details}") };
    format!("{status} {}{details}", text(&problem["title"]))
}

/// A text as a cell of a table in Markdown.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('<', "&lt;").replace('>', "&gt;")
}

fn page() -> String {
    let folder = tempfile::tempdir().unwrap();
    files(folder.path());
    let mut page = "# What is refused\n\n\
         Wrong inputs of every kind that people have sent, and the messages that they get. A test tries each entry and compares\n\
         the message with this page (`tests/suite/refusals.rs`). The command line exits with 2 for a wrong input; the service answers\n\
         with a problem document, whose types are in [api/problems.md](../api/problems.md).\n"
        .to_owned();
    for (section, commands) in COMMANDS {
        let _ = write!(page, "\n## {section}\n\n| tried | `homolog …` | message |\n|---|---|---|\n");
        for (what, command) in commands {
            let _ = writeln!(page, "| {what} | `{command}` | {} |", cell(&said(folder.path(), command)));
        }
    }
    let site = Site::open(Backend::Sqlite);
    let service = Service::start(&site, &["--auth", "none", "--workers", "0"]);
    let mesh = service.upload(&folder.path().join("left.ply"));
    page.push_str(
        "\n## Over HTTP\n\n`…` stands for the id of an upload.\n\n| tried | request | answer |\n|---|---|---|\n",
    );
    for (what, method, path, body) in requests(&mesh) {
        let sent = if body.is_null() { String::new() } else { format!(" {}", body.to_string().replace(&mesh, "…")) };
        let sent = sent.replace(&"0".repeat(64), "000…");
        let answer = cell(&answered(&service, method, &path, &body));
        let _ = writeln!(page, "| {what} | `{method} {path}{sent}` | {answer} |");
    }
    page
}

#[test]
fn the_page_of_refusals_has_the_messages_of_this_build() {
    let committed = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/refusals.md");
    let page = page();
    if std::env::var_os("HOMOLOG_WRITE_DOCS").is_some() {
        fs::write(&committed, &page).unwrap();
    }
    let text = fs::read_to_string(&committed).unwrap_or_default();
    for (number, (now, before)) in page.lines().zip(text.lines()).enumerate() {
        assert_eq!(now, before, "line {} of docs/refusals.md", number + 1);
    }
    assert_eq!(page.lines().count(), text.lines().count());
}
