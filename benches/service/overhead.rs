//! Overhead of the service over the match itself: the same pair on the command line and over HTTP.

use crate::http::Client;
use crate::node::Node;
use crate::pairs::{self, parameters};
use crate::place::Place;
use crate::schedule::{timed_match, write_pair};
use crate::{Latencies, Scale};
use serde_json::{Value, json};
use std::time::Instant;

pub(crate) async fn overhead(scale: Scale) {
    println!("\n## Overhead of the service over the command line\n");
    println!(
        "`homolog match --out` versus `POST /v1/jobs` of the same two files with `Prefer: wait=30`, an empty queue, and the"
    );
    println!("result stored on disk with fsync. Alternating runs, nothing cached, both on all cores.");
    pairs::say_parameters();
    println!("| vertices | runs | command line p50 ms | service p50 ms | overhead ms | overhead % | target |");
    println!("|---|---|---|---|---|---|---|");
    for (n_vertices, n_runs) in [(160, 15), (600, 11), (2_500, 5)] {
        let n_runs = scale.pick(2, n_runs);
        let [source, target] = pairs::pair(n_vertices);
        let folder = tempfile::tempdir().unwrap();
        let files = write_pair(folder.path(), [source.clone(), target.clone()]);
        let place = Place::sqlite();
        let node = Node::program(&place.environment());
        let mut client = Client::connect(&node.address).await;
        let (mut by_command, mut by_service) = (Vec::new(), Vec::new());
        for _ in 0..n_runs {
            by_command.push(timed_match(&files, &folder.path().join("out"), "0"));
            let began = Instant::now();
            let job = client.submit_and_wait(&source, &target, &parameters()).await;
            by_service.push(began.elapsed().as_secs_f64());
            assert_eq!((&job["state"], &job["cached"]), (&json!("succeeded"), &Value::Bool(false)), "{job}");
        }
        let [command, service] = [by_command, by_service].map(|taken| Latencies::new(taken).ms(0.5));
        let (more, share) = (service - command, (service / command - 1.0) * 100.0);
        let verdict = match n_vertices {
            160 if more <= 30.0 => "30 ms: met",
            160 => "30 ms: missed",
            2_500 if share <= 5.0 => "5 %: met",
            2_500 => "5 %: missed",
            _ => "",
        };
        println!("| {n_vertices} | {n_runs} | {command:.0} | {service:.0} | {more:.0} | {share:.1} | {verdict} |");
    }
}
