//! The service against its OpenAPI document: schemathesis sends valid and invalid requests to every operation, and
//! reports every 5xx and every answer that the document does not describe.
//!
//! `make contract` sends more requests.

use super::faults::on_both;
use super::faults::site::{Backend, Site};
use std::path::Path;
use std::process::Command;

on_both!(needs "needs schemathesis": every_answer_is_one_of_the_document);

async fn every_answer_is_one_of_the_document(backend: Backend) {
    let tool = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/tools/schemathesis/bin/schemathesis");
    let examples = std::env::var("CONTRACT_EXAMPLES").unwrap_or_else(|_| "3".to_owned());
    let site = Site::open(backend);
    let mut program = site.program(&["--workers", "1", "--log", "error"]);
    let mut command = Command::new(tool);
    command.arg("--config-file").arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/suite/schemathesis.toml"));
    command.args(["run", &format!("{}/openapi.json", program.base), "--max-examples", &examples]);
    // The phase `coverage` is omitted: this version of schemathesis crashes in it on large documents.
    command.args(["--phases", "examples,fuzzing,stateful", "--suppress-health-check", "all"]);
    // A request that is valid by the document may still be refused, for example for a page token that was never issued,
    // or a file that is not a surface.
    command.args(["--exclude-checks", "positive_data_acceptance", "--seed", "1", "--workers", "1", "--no-color"]);
    let folder = site.folder.path().to_owned();
    let done = tokio::task::spawn_blocking(move || command.current_dir(folder).output()).await.unwrap().unwrap();
    let said = String::from_utf8_lossy(&done.stdout).into_owned();
    assert!(program.is_running(), "the service did not survive: {said}");
    assert!(done.status.success(), "{said}{}", String::from_utf8_lossy(&done.stderr));
    println!("{said}");
}
