//! Third-party programs: clients that generators make from the OpenAPI document, the Python package from its wheel, and
//! the examples of the documentation, each against the real program. `scripts/setup campaigns` installs their dependencies.

use super::faults::site::{Backend, Program, Site};
use super::representations::small_volumes;
use homolog_formats::write_nifti_gz;
use homolog_laboratory::phantom::{PairRecipe, PhantomPair};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

pub(super) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A program of the Python environment with the generators.
fn python(name: &str) -> Command {
    Command::new(root().join("target/clients-env/bin").join(name))
}

pub(super) fn node() -> Command {
    Command::new("node")
}

/// Makes the packages of tests/clients available to scripts in a folder.
pub(super) fn modules(folder: &Path) {
    let link = folder.join("node_modules");
    if !link.exists() {
        std::os::unix::fs::symlink(root().join("target/clients-npm/node_modules"), link).unwrap();
    }
}

/// The output of a command, which must succeed. The command runs at the same time as the service that it calls.
pub(super) async fn said(mut command: Command) -> String {
    let done = tokio::task::spawn_blocking(move || command.output().unwrap_or_else(|e| panic!("{command:?}: {e}")))
        .await
        .unwrap();
    let (out, err) = (String::from_utf8_lossy(&done.stdout).into_owned(), String::from_utf8_lossy(&done.stderr));
    let last: Vec<&str> = err.lines().rev().take(40).collect();
    assert!(done.status.success(), "{out}\n{}", last.into_iter().rev().collect::<Vec<_>>().join("\n"));
    out
}

/// Writes two label volumes of one shape in different poses; returns their paths.
pub(super) fn pair(folder: &Path) -> [PathBuf; 2] {
    let paths = ["source.nii.gz", "target.nii.gz"].map(|name| folder.join(name));
    for (path, bytes) in paths.iter().zip(small_volumes()) {
        fs::write(path, bytes).unwrap();
    }
    paths
}

/// A running service, a folder for the output of a generator, and the OpenAPI document in it.
fn service() -> (Site, Program, tempfile::TempDir) {
    let site = Site::open(Backend::Sqlite);
    let program = site.program(&["--allow-private-webhooks", "--log", "error"]);
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("openapi.json"), homolog::http::openapi_json().unwrap()).unwrap();
    (site, program, folder)
}

/// Copies files of tests/clients.
fn copy(folder: &Path, names: &[&str]) {
    for name in names {
        fs::copy(root().join("tests/clients").join(name), folder.join(name)).unwrap();
    }
}

#[tokio::test]
#[ignore = "needs the generators that scripts/setup campaigns installs"]
async fn openapi_python_client_makes_a_client_that_does_everything() {
    let (_site, program, folder) = service();
    let mut generate = python("openapi-python-client");
    generate.current_dir(folder.path()).args(["generate", "--path", "openapi.json", "--meta", "none"]);
    generate.args(["--output-path", "client", "--config"]).arg(root().join("clients/python/generator.yaml"));
    let made = said(generate).await;
    assert!(!made.contains("WARNING") && !made.contains("ERROR"), "{made}");
    copy(folder.path(), &["roundtrip.py"]);
    let mut run = python("python");
    run.current_dir(folder.path()).args(["roundtrip.py", &program.base]).args(pair(folder.path()));
    assert!(said(run).await.contains("all of it"));
}

#[tokio::test]
#[ignore = "needs the generators that scripts/setup campaigns installs"]
async fn datamodel_code_generator_makes_models_with_the_bounds_of_the_service() {
    let (_site, program, folder) = service();
    let mut generate = python("datamodel-codegen");
    generate.current_dir(folder.path()).args(["--input", "openapi.json", "--input-file-type", "openapi"]);
    generate.args([
        "--output",
        "models_made.py",
        "--output-model-type",
        "pydantic_v2.BaseModel",
        "--formatters",
        "builtin",
    ]);
    said(generate).await;
    copy(folder.path(), &["models.py"]);
    let mut run = python("python");
    run.current_dir(folder.path()).args(["models.py", &program.base]).args(pair(folder.path()));
    assert!(said(run).await.contains("all of it"));
}

#[tokio::test]
#[ignore = "needs the generators that scripts/setup campaigns installs"]
async fn openapi_typescript_makes_types_that_compile_and_hold() {
    let (_site, program, folder) = service();
    modules(folder.path());
    copy(folder.path(), &["package.json", "tsconfig.json", "generate.mjs", "roundtrip.ts"]);
    let mut generate = node();
    said({
        generate.current_dir(folder.path()).args(["generate.mjs", "openapi.json", "schema.d.ts"]);
        generate
    })
    .await;
    let mut compile = node();
    compile.current_dir(folder.path()).arg("node_modules/typescript/bin/tsc");
    said(compile).await;
    let mut run = node();
    run.current_dir(folder.path()).args(["roundtrip.js", &program.base]).args(pair(folder.path()));
    assert!(said(run).await.contains("all of it"));
}

#[tokio::test]
#[ignore = "needs the generators that scripts/setup campaigns installs"]
async fn openapi_generator_makes_a_client_in_java() {
    let (_site, program, folder) = service();
    let mut find = python("python");
    find.args(["-c", "import openapi_generator_cli as g, pathlib; print(pathlib.Path(g.__file__).with_name('openapi-generator.jar'))"]);
    // The generator contains Jackson, which the client needs.
    let generator = said(find).await.trim().to_owned();
    copy(folder.path(), &["Roundtrip.java", "java.json"]);
    let java = |program: &str, arguments: &[&str]| {
        let mut run = Command::new(program);
        run.current_dir(folder.path()).args(arguments);
        run
    };
    let settings = "skipFormModel=false,apiTests=false,modelTests=false,apiDocs=false,modelDocs=false";
    let generate =
        ["-jar", &generator, "generate", "-g", "java", "-i", "openapi.json", "-o", "made", "-c", "java.json"];
    said(java("java", &[&generate[..], &["--global-property", settings]].concat())).await;
    let sources = root().join("target/tools/java/usr/share/java");
    let classes = format!("classes:{generator}:{}/*", sources.display());
    let mut files = vec!["Roundtrip.java".to_owned()];
    sources_under(&folder.path().join("made/src/main/java"), &mut files);
    fs::write(folder.path().join("files"), files.join("\n")).unwrap();
    said(java("javac", &["-nowarn", "-d", "classes", "-cp", &classes, "@files"])).await;
    let mut run = java("java", &["-cp", &classes, "Roundtrip", &program.base]);
    run.args(pair(folder.path()));
    assert!(said(run).await.contains("all of it"));
}

/// The paths of the Java files under a folder.
fn sources_under(folder: &Path, into: &mut Vec<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources_under(&path, into);
        } else if path.extension().is_some_and(|ending| ending == "java") {
            into.push(path.to_str().unwrap().to_owned());
        }
    }
}

/// Installs the wheel with this program in an environment below this folder, with only its declared dependencies.
async fn install_package(here: &Path) {
    let mut build = Command::new(root().join("scripts/wheel"));
    build.arg(env!("CARGO_BIN_EXE_homolog")).arg(here).env("PYTHON", root().join("target/clients-env/bin/python"));
    said(build).await;
    let wheel = fs::read_dir(here)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .find(|path| path.extension().is_some_and(|e| e == "whl"));
    let wheel = wheel.unwrap();
    let name = wheel.file_name().unwrap().to_string_lossy().into_owned();
    assert!(name.starts_with("homolog-") && name.contains("-py3-none-") && !name.contains("-any"), "{name}");
    let mut empty = python("python");
    empty.args(["-m", "venv"]).arg(here.join("env"));
    said(empty).await;
    // The dependencies of the wheel, from the wheels of the setup, at the versions of its list.
    let mut install = Command::new(here.join("env/bin/python"));
    install.args(["-m", "pip", "--quiet", "--disable-pip-version-check", "install", "--no-index"]);
    install.arg("--find-links").arg(root().join("target/clients-wheels")).arg(&wheel);
    said(install).await;
}

/// Python of that environment with this program. Nothing outside the environment is used: the service is the wheel's.
fn researcher(here: &Path, text: &str) -> Command {
    let mut run = Command::new(here.join("env/bin/python"));
    run.current_dir(here).arg("-c").arg(text).env_clear().env("HOME", here);
    run
}

/// The examples of the README of the package: a match, many subjects against a template, and a study.
fn package_examples() -> [String; 3] {
    let readme = fs::read_to_string(root().join("clients/python/README.md")).unwrap();
    let blocks: Vec<_> =
        readme.split("```python\n").skip(1).map(|rest| rest.split("```").next().unwrap().to_owned()).collect();
    blocks.try_into().expect("three examples")
}

/// The example in the package's README as written, and the study of twenty subjects.
#[tokio::test]
#[ignore = "needs the generators that scripts/setup campaigns installs"]
async fn the_python_package_is_all_that_a_researcher_installs() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    install_package(here).await;
    pair(here);
    fs::create_dir(here.join("subjects")).unwrap();
    fs::copy(here.join("target.nii.gz"), here.join("template.nii.gz")).unwrap();
    for k in 0..20 {
        let recipe = PairRecipe {
            subject: k,
            target_subject: k,
            deform_share: 0.0,
            deform_seed: 0,
            pose_seed: Some(k),
            permute_seed: None,
        };
        // Voxels of 2.5 mm would leave the rotation uncertain, and a study refuses such matches.
        let volume = PhantomPair::new(recipe).unwrap().source_volume(2.0).unwrap().into_label_volume().unwrap();
        fs::write(here.join(format!("subjects/{k:02}.nii.gz")), write_nifti_gz(&volume)).unwrap();
    }
    let rows = (0..20).map(|k| format!("{k:02},{}\n", ["a", "b"][k % 2])).collect::<String>();
    fs::write(here.join("people.csv"), format!("id,group\n{rows}")).unwrap();
    let [first, many, study] = package_examples();
    assert_eq!(first.lines().count(), 3);
    assert!(many.lines().count() <= 10 && study.lines().count() <= 10);
    let printed = said(researcher(here, &first)).await;
    assert!(printed.contains("barycentric_2") && printed.starts_with("True"), "{printed}");
    let printed = said(researcher(here, &many)).await;
    assert!(printed.contains("reliable"), "{printed}");
    let table = fs::read_to_string(here.join("matches.csv")).unwrap();
    assert_eq!(table.matches(",succeeded,").count(), 20, "{table}");
    let printed = said(researcher(here, &study)).await;
    assert!(printed.contains("20 subjects") && here.join("study/report.html").exists(), "{printed}");
    let more = fs::read_to_string(root().join("clients/python/tests/use.py")).unwrap();
    let lib = root().join("target/clients-env/lib");
    let packages = fs::read_dir(&lib).unwrap().map(|entry| entry.unwrap().path().join("site-packages")).next().unwrap();
    let mut with_other_packages = researcher(here, &more);
    with_other_packages.env("PYTHONPATH", packages);
    let printed = said(with_other_packages).await;
    assert!(printed.contains("all of it") && !printed.contains("without "), "{printed}");
}

/// As above, with patient files, which are not part of the repository.
mod real_data {
    use super::*;
    use crate::fixtures::real_files;

    #[tokio::test]
    #[ignore = "needs real data (hippocampus) and the generators that scripts/setup campaigns installs"]
    async fn twenty_real_subjects_against_a_template_take_ten_lines() {
        let folder = tempfile::tempdir().unwrap();
        let here = folder.path();
        install_package(here).await;
        let files = real_files("hippocampus");
        fs::copy(&files[0], here.join("template.nii.gz")).unwrap();
        fs::create_dir(here.join("subjects")).unwrap();
        for file in &files[1..=20] {
            fs::copy(file, here.join("subjects").join(file.file_name().unwrap())).unwrap();
        }
        let [_, many, _] = package_examples();
        assert!(many.lines().count() <= 10);
        let printed = said(researcher(here, &many)).await;
        let table = fs::read_to_string(here.join("matches.csv")).unwrap();
        assert_eq!(table.matches(",succeeded,").count(), 20, "{table}");
        // Row i of every subject is vertex i of the template: points x, y and z.
        assert!(printed.trim_end().ends_with(", 3)"), "{printed}");
        println!("{printed}\n{table}");
    }
}

/// The code blocks of one language in a document, from a heading to the next heading of the same level.
fn blocks(document: &str, heading: &str, language: &str) -> String {
    let text = fs::read_to_string(root().join(document)).unwrap();
    let from = text.split(&format!("\n{heading}\n")).nth(1).unwrap_or_else(|| panic!("no {heading} in {document}"));
    // Comments of the shell begin like headings of the first level.
    let own = format!("\n{} ", heading.split(' ').next().unwrap());
    let section = from.split(&own).next().unwrap().split("\n## ").next().unwrap();
    let found: Vec<&str> =
        section.split(&format!("```{language}\n")).skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
    assert!(!found.is_empty(), "no {language} under {heading} in {document}");
    found.concat()
}

#[tokio::test]
#[ignore = "needs the generators that scripts/setup campaigns installs"]
async fn examples_of_the_documentation_run_as_written() {
    let (_site, program, folder) = service();
    let here = folder.path();
    pair(here);
    // The documents name the default port; this service has another one.
    let at_service = |text: String| text.replace("http://127.0.0.1:8080", &program.base);
    let script = |name: &str, text: String| {
        fs::write(here.join(name), at_service(text)).unwrap();
        name.to_owned()
    };
    let mut run = Command::new("bash");
    run.current_dir(here)
        .args(["-eu", "-o", "pipefail"])
        .arg(script("a.sh", blocks("docs/clients.md", "## curl", "sh")));
    said(run).await;
    let table = fs::read_to_string(here.join("correspondences.csv")).unwrap();
    assert!(
        table.starts_with("source,target,") && here.join("warped.ply").exists() && here.join("report.html").exists()
    );
    fs::remove_file(here.join("correspondences.csv")).unwrap();

    let mut build = Command::new(root().join("scripts/wheel"));
    build.arg(env!("CARGO_BIN_EXE_homolog")).arg(here).env("PYTHON", root().join("target/clients-env/bin/python"));
    said(build).await;
    let wheel = fs::read_dir(here)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .find(|p| p.extension().is_some_and(|e| e == "whl"));
    let mut install = python("python");
    install.args(["-m", "pip", "--quiet", "--disable-pip-version-check", "install", "--no-deps", "--target"]);
    said({
        install.arg(here.join("packages")).arg(wheel.unwrap());
        install
    })
    .await;
    let mut run = python("python");
    run.current_dir(here)
        .arg(script("b.py", blocks("docs/clients.md", "## Python", "python")))
        .env("PYTHONPATH", here.join("packages"));
    assert!(said(run).await.starts_with("True []"));
    let of_python = fs::read_to_string(here.join("correspondences.csv")).unwrap();
    assert_eq!(of_python.lines().count(), table.lines().count());
    assert!(here.join("result/transform.tfm").exists());
    // The handwritten part of the package is typed and small.
    let mut check = python("python");
    check
        .current_dir(here.join("packages"))
        .args(["-m", "mypy", "--config-file"])
        .arg(root().join("clients/python/pyproject.toml"));
    said({
        check.args(["-p", "homolog"]);
        check
    })
    .await;
    let sources = fs::read_dir(root().join("clients/python/src/homolog")).unwrap().map(|entry| entry.unwrap().path());
    let text: String = sources
        .filter(|path| path.extension().is_some_and(|e| e == "py"))
        .map(|p| fs::read_to_string(p).unwrap())
        .collect();
    assert!(text.lines().filter(|line| !line.trim().is_empty()).count() <= 750);
    fs::remove_file(here.join("correspondences.csv")).unwrap();

    modules(here);
    copy(here, &["package.json", "tsconfig.json"]);
    script("roundtrip.ts", blocks("docs/clients.md", "## TypeScript", "ts"));
    let mut types = node();
    types.current_dir(here).args(["node_modules/openapi-typescript/bin/cli.js", "openapi.json", "-o", "schema.d.ts"]);
    said(types).await;
    let mut compile = node();
    compile.current_dir(here).arg("node_modules/typescript/bin/tsc");
    said(compile).await;
    let mut run = node();
    run.current_dir(here).arg("roundtrip.js");
    assert!(said(run).await.starts_with("true"));
    assert_eq!(fs::read_to_string(here.join("correspondences.csv")).unwrap(), table);
}

/// The README's commands for the command line and the service, one after the other.
#[tokio::test]
#[ignore = "needs the generators that scripts/setup campaigns installs"]
async fn examples_of_the_readme_run_as_written() {
    let folder = tempfile::tempdir().unwrap();
    let here = folder.path();
    fs::create_dir_all(here.join("target/release")).unwrap();
    std::os::unix::fs::symlink(env!("CARGO_BIN_EXE_homolog"), here.join("target/release/homolog")).unwrap();
    let port = std::net::TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
    let text =
        blocks("README.md", "### From the command line", "sh") + &blocks("README.md", "### From the service", "sh");
    let text = text.replace("127.0.0.1:8080", &format!("127.0.0.1:{port}"));
    fs::write(here.join("readme.sh"), format!("trap 'kill %1' EXIT\n{text}")).unwrap();
    // Requests are retried until the service has started, as a reader would wait.
    fs::write(here.join(".curlrc"), "retry-connrefused\nretry = 30\nretry-delay = 1\nfail\n").unwrap();
    let mut run = Command::new("bash");
    run.current_dir(here).args(["-eu", "-o", "pipefail", "readme.sh"]);
    run.env("CURL_HOME", here).env("HOMOLOG_LISTEN", format!("127.0.0.1:{port}"));
    let printed = said(run).await;
    assert!(printed.contains("\"reliable\": true") && printed.contains("\"matrix\""), "{printed}");
    assert!(here.join("result.html").exists() && here.join("aligned.ply").exists());
    assert!(fs::read_to_string(here.join("correspondences.csv")).unwrap().starts_with("source,target,"));
}
