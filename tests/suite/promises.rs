//! The contract of the service, promise by promise, over HTTP and on both stores (SQLite with a folder, PostgreSQL with
//! S3).
//!
//! [`PROMISES`] lists them in the order of the API's design, each in a few words with the tests that check it: the
//! tests of this file, and others with more detail. A test checks that all of them exist.

mod following;
mod formats;
mod resources;
mod submitting;

use super::faults::client::Client;
use super::faults::site::{Backend, Site};
use reqwest::{Method, Response};
use serde_json::{Value, json};
use std::path::Path;
use std::time::Duration;

/// Longest wait for something that takes a poll or two, on a loaded machine.
const SOON: Duration = crate::patience::PATIENCE;

/// Each promise, and the tests that check it, as module path and function.
const PROMISES: &[(&str, &[&str])] = &[
    // Conventions
    (
        "paths begin with /v1; names are in snake case; ids are UUIDs of version 7; times are RFC 3339 in UTC",
        &["promises::resources::documents_follow_the_conventions"],
    ),
    (
        "every list is paged by page_size and page_token, and says next_page_token",
        &["promises::resources::every_list_is_paged"],
    ),
    (
        "GETs of jobs, meshes and results have an ETag and answer 304 to If-None-Match",
        &["promises::resources::documents_follow_the_conventions", "api::unchanged_answers_are_304"],
    ),
    (
        "traceparent is accepted and passed on; X-Request-Id is echoed",
        &[
            "promises::resources::documents_follow_the_conventions",
            "promises::resources::webhooks_are_signed_repeated_and_disabled_and_changes_are_in_order",
            "spans::one_trace_leads_from_the_request_to_the_phases_of_the_job_and_names_no_patient",
        ],
    ),
    (
        "every error is a problem document; 422 lists pointer, code and detail",
        &[
            "promises::resources::documents_follow_the_conventions",
            "contract::every_error_of_every_operation_is_a_problem",
            "api::every_invalid_request_is_answered_with_a_problem",
        ],
    ),
    (
        "no number that is not finite is sent",
        &[
            "src/worker/observer.rs::points_are_numbered_consecutively_across_several_takes",
            "promises::formats::a_match_is_answered_in_every_format",
        ],
    ),
    // Submission
    (
        "one multipart request is a whole submission: 202, Location, Retry-After",
        &["promises::submitting::a_submission_comes_in_three_forms"],
    ),
    (
        "a submission may name uploaded meshes, or contain them",
        &["promises::submitting::a_submission_comes_in_three_forms"],
    ),
    (
        "a request with an Idempotency-Key creates one job",
        &["promises::submitting::a_submission_is_made_once_tried_or_waited_for"],
    ),
    (
        "validate_only creates nothing; Prefer: wait answers 200 with the finished job",
        &["promises::submitting::a_submission_is_made_once_tried_or_waited_for"],
    ),
    // Jobs
    (
        "jobs are filtered by state, method, label, batch, reference and time, in either order",
        &["promises::resources::jobs_are_filtered_and_ordered"],
    ),
    ("?wait= answers when the job changes", &["promises::following::a_job_is_followed_by_polls_trace_and_events"]),
    ("cancel is prompt; retry makes a new job", &["promises::following::cancel_is_prompt_and_a_retry_is_a_new_job"]),
    (
        "DELETE removes everything of a job, and is refused while it is active",
        &[
            "promises::following::cancel_is_prompt_and_a_retry_is_a_new_job",
            "hostile::traces::nothing_of_a_deleted_job_is_left_in_the_files",
        ],
    ),
    (
        "the trace is in order, and live while the job runs",
        &["promises::following::a_job_is_followed_by_polls_trace_and_events"],
    ),
    (
        "events are state, progress, trace and done, with ids; Last-Event-ID resumes without a gap or a repeat",
        &["promises::following::a_job_is_followed_by_polls_trace_and_events"],
    ),
    (
        "an idle stream of events sends comments, and ends when the service does",
        &["promises::following::an_idle_stream_is_kept_alive_and_ends_with_the_service"],
    ),
    (
        "a result has transform, metrics, energies, provenance and links",
        &["promises::formats::a_match_is_answered_in_every_format"],
    ),
    (
        "a result that is not there is 409 before the end and 410 after its retention",
        &["promises::following::results_are_not_ready_then_there_then_expired"],
    ),
    (
        "correspondences, transform and aligned surface come in the listed formats, by Accept or ?format=",
        &[
            "promises::formats::a_match_is_answered_in_every_format",
            "representations::every_part_comes_in_every_format_it_has",
        ],
    ),
    // Other resources
    (
        "an upload is named by its hash, stored once a tenant, reported on, and kept while it is used",
        &["promises::resources::an_upload_is_held_once_and_kept_while_it_is_used"],
    ),
    (
        "methods describe their parameters by a JSON Schema with defaults, ranges and texts",
        &["promises::formats::methods_describe_their_parameters"],
    ),
    (
        "a batch is created as a whole, counted by state, and cancelled as a whole",
        &["promises::resources::a_batch_is_created_and_cancelled_as_a_whole"],
    ),
    (
        "webhooks are managed, tested, signed and repeated; 410 disables; private addresses are refused",
        &[
            "promises::resources::webhooks_are_signed_repeated_and_disabled_and_changes_are_in_order",
            "webhooks::private_addresses_are_refused_unless_allowed",
        ],
    ),
    (
        "the feed of changes is in order and resumes after any change",
        &["promises::resources::webhooks_are_signed_repeated_and_disabled_and_changes_are_in_order"],
    ),
    (
        "liveness asks nothing, readiness names each dependency, documentation needs no internet",
        &["promises::formats::methods_describe_their_parameters", "api::readiness_names_the_failing_dependency"],
    ),
    // A job
    ("a job has the listed members", &["promises::resources::documents_follow_the_conventions"]),
    (
        "a finished state never changes; dead is the limit of crashes",
        &[
            "store::cancellation_leads_to_exactly_one_final_state_from_every_state",
            "faults::crashes::a04_a_job_that_kills_its_workers_becomes_dead_and_others_run",
        ],
    ),
    (
        "progress never decreases within an attempt",
        &[
            "promises::following::a_job_is_followed_by_polls_trace_and_events",
            "store::progress_never_decreases_within_an_attempt",
        ],
    ),
    (
        "a point of the trace has seq, round, phase, iteration, elapsed_ms, and what has a meaning in its phase",
        &["promises::formats::a_match_is_answered_in_every_format"],
    ),
    // Guarantees
    (
        "a 202 survives the death of every process",
        &[
            "faults::crashes::a01_the_job_of_a_killed_worker_runs_again",
            "process::a_job_survives_the_death_of_its_process",
            "store::the_store_has_durable_settings",
        ],
    ),
    (
        "a result is accepted once: everything that a worker writes is fenced",
        &[
            "faults::fences::a02_a_worker_that_slept_past_its_lease_changes_nothing",
            "faults::fences::a08_no_job_is_claimed_twice_in_one_epoch",
        ],
    ),
    (
        "a crash is no failure, and a shutdown no attempt",
        &[
            "faults::crashes::a04_a_job_that_kills_its_workers_becomes_dead_and_others_run",
            "store::a_shutdown_does_not_count_as_an_attempt",
        ],
    ),
    (
        "equal requests give equal bytes, and are answered from the first result unless told not to",
        &["promises::submitting::equal_requests_share_a_result"],
    ),
    (
        "nobody learns of another tenant's resources",
        &["faults::tenants::a19_resources_of_another_tenant_are_not_found"],
    ),
    (
        "everything has a limit with a problem of its own",
        &[
            "promises::submitting::limits_have_problems_of_their_own",
            "api::each_limit_has_its_own_problem",
            "faults::disk::a15_sqlite",
        ],
    ),
    // Stores
    (
        "without settings the service listens on this machine alone, and elsewhere it demands keys",
        &[
            "hostile::hosts::without_authentication_no_web_page_is_answered_whatever_the_address",
            "promises::no_other_address_without_keys",
        ],
    ),
];

#[test]
fn every_test_that_holds_a_promise_exists() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut missing = Vec::new();
    for (promise, tests) in PROMISES {
        assert!(!tests.is_empty(), "{promise}");
        for test in *tests {
            let (module, function) = test.rsplit_once("::").unwrap();
            let stem = root.join("tests/suite").join(module.replace("::", "/"));
            let files = [stem.with_extension("rs"), stem.join("mod.rs"), root.join(module)];
            let is_there =
                |file: &Path| std::fs::read_to_string(file).is_ok_and(|text| text.contains(&format!("fn {function}(")));
            if !files.iter().any(|file| is_there(file)) {
                missing.push(format!("{promise}: {test}"));
            }
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

#[test]
fn no_other_address_without_keys() {
    let folder = tempfile::tempdir().unwrap();
    let serve = |more: &[&str]| {
        let mut command = super::cli::homolog();
        command.args(["serve", "--listen", "0.0.0.0:0", "--data-dir"]).arg(folder.path()).args(more).output().unwrap()
    };
    let refused = serve(&["--auth", "none"]);
    assert!(!refused.status.success());
    assert!(String::from_utf8_lossy(&refused.stderr).contains("--insecure"), "{refused:?}");
}

/// A service on a store, with the scripted engine.
struct Served {
    client: Client,
    node: super::faults::node::Node,
    site: Site,
}

impl Served {
    fn start(backend: Backend, more: &[&str]) -> Self {
        let site = Site::open(backend);
        let node = site.serve(more);
        Served { client: site.client(&node), node, site }
    }

    fn url(&self, path: &str) -> String {
        format!("{}{path}", self.client.base)
    }

    async fn send(&self, method: Method, path: &str, headers: &[(&str, &str)], body: Option<&Value>) -> Response {
        let mut request = self.client.http.request(method, self.url(path));
        for (name, value) in headers {
            request = request.header(*name, *value);
        }
        if let Some(body) = body {
            request = request.json(body);
        }
        request.send().await.unwrap()
    }

    async fn get(&self, path: &str) -> Response {
        self.send(Method::GET, path, &[], None).await
    }

    async fn post(&self, path: &str, body: &Value) -> Response {
        self.send(Method::POST, path, &[], Some(body)).await
    }

    /// The body of an answer that must have this status.
    async fn expect(&self, response: Response, status: u16) -> Value {
        let (got, url) = (response.status().as_u16(), response.url().clone());
        let text = response.text().await.unwrap();
        assert_eq!(got, status, "{url}: {text}");
        if text.is_empty() { Value::Null } else { serde_json::from_str(&text).unwrap() }
    }

    /// Uploads these bytes; returns the id.
    async fn upload(&self, content: &str) -> String {
        let sent = self.client.http.post(self.url("/v1/meshes")).body(content.to_owned()).send().await.unwrap();
        assert!(sent.status().is_success());
        sent.json::<Value>().await.unwrap()["id"].as_str().unwrap().to_owned()
    }
}

/// Parameters of a job with this number of trace points at this interval.
fn steps(points: u64, step_ms: u64) -> Value {
    json!({"points": points, "step_ms": step_ms})
}

fn text<'a>(value: &'a Value, member: &str) -> &'a str {
    value[member].as_str().unwrap_or_else(|| panic!("no {member} in {value}"))
}

fn array<'a>(value: &'a Value, member: &str) -> &'a Vec<Value> {
    value[member].as_array().unwrap_or_else(|| panic!("no {member} in {value}"))
}
