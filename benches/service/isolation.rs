//! The price of isolation: the same work in processes of their own and in threads of the service, in turns.

use crate::http::Client;
use crate::node::Node;
use crate::pairs::{self, makespan_s, parameters, run_batch, upload_file};
use crate::place::Place;
use crate::{Latencies, Scale};
use serde_json::json;
use std::time::Instant;

/// The two settings that are compared.
const WAYS: [&str; 2] = ["process", "none"];

pub(crate) async fn price(scale: Scale) {
    let (n_subjects, n_vertices) = scale.pick((4, 160), (100, 2_500));
    let n_rounds = scale.pick(1, 3);
    println!("\n## The price of isolation\n");
    println!(
        "A template against {n_subjects} phantom subjects of about {n_vertices} vertices each, uploaded before, in one batch, from the"
    );
    println!(
        "first acceptance to the last end; a new service and an empty cache each time, the two settings in turns."
    );
    pairs::say_parameters();
    let (template, subjects) = pairs::template_and_subjects(n_subjects, n_vertices);
    println!(
        "| round | processes, s | threads, s | ratio | processes, processor s | threads, processor s | ratio | service with processes, max MiB | with threads, max MiB |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let mut all: [Vec<f64>; 2] = [Vec::new(), Vec::new()];
    let mut processor: [Vec<f64>; 2] = [Vec::new(), Vec::new()];
    for round in 1..=n_rounds {
        let mut mib = [0.0; 2];
        for (way, isolation) in WAYS.into_iter().enumerate() {
            let place = Place::sqlite();
            let mut environment = place.environment();
            environment.push(("HOMOLOG_ISOLATION", isolation.to_owned()));
            let node = Node::program(&environment);
            let mut client = Client::connect(&node.address).await;
            let template_id = upload_file(&mut client, &template.name, &template.bytes).await;
            let mut ids = Vec::with_capacity(subjects.len());
            for subject in &subjects {
                let id = upload_file(&mut client, &subject.name, &subject.bytes).await;
                ids.push(json!({"input": {"mesh_id": id}}));
            }
            let batch = json!({"template": {"mesh_id": template_id}, "subjects": ids, "parameters": parameters()});
            let before = node.processor_s();
            all[way].push(makespan_s(&run_batch(&mut client, &batch).await));
            processor[way].push(node.processor_s() - before);
            mib[way] = node.status_mib("VmHWM");
        }
        let last = |of: &[Vec<f64>; 2]| [0, 1].map(|way| of[way].last().copied().unwrap_or(f64::NAN));
        let ([a, b], [c, d]) = (last(&all), last(&processor));
        println!(
            "| {round} | {a:.1} | {b:.1} | {:.3} | {c:.1} | {d:.1} | {:.3} | {:.0} | {:.0} |",
            a / b,
            c / d,
            mib[0],
            mib[1]
        );
    }
    let ratio = |of: [Vec<f64>; 2]| {
        let [processes, threads] = of.map(|taken| Latencies::new(taken).ms(0.5));
        processes / threads
    };
    println!("\nRatio of the medians: {:.3}; of the medians of processor time: {:.3}.\n", ratio(all), ratio(processor));
    single(scale).await;
}

/// One small job at a time: what a job pays for its process.
async fn single(scale: Scale) {
    let n_runs = scale.pick(2, 60);
    let [source, target] = pairs::pair(160);
    let mut taken: [Vec<f64>; 2] = [Vec::new(), Vec::new()];
    let places = WAYS.map(|_| Place::sqlite());
    let mut nodes = Vec::new();
    for (place, isolation) in places.iter().zip(WAYS) {
        let mut environment = place.environment();
        environment.push(("HOMOLOG_ISOLATION", isolation.to_owned()));
        let node = Node::program(&environment);
        let client = Client::connect(&node.address).await;
        nodes.push((node, client));
    }
    for run in 0..n_runs {
        for (way, (_, client)) in nodes.iter_mut().enumerate() {
            // Another seed each time, so that nothing is answered from an earlier job.
            let mut parameters = parameters();
            parameters["seed"] = json!(run);
            let began = Instant::now();
            let job = client.submit_and_wait(&source, &target, &parameters).await;
            taken[way].push(began.elapsed().as_secs_f64());
            assert_eq!(job["state"], "succeeded", "{job}");
        }
    }
    println!(
        "A pair of 160 vertices, submitted with both files and awaited, {n_runs} times in turns. Each checks two files, in children of"
    );
    println!("their own, and is then computed in a third.\n");
    println!("| | p50 ms | p90 ms |\n|---|---|---|");
    let all = taken.map(Latencies::new);
    for (isolation, of) in WAYS.into_iter().zip(&all) {
        println!("| `--isolation {isolation}` | {:.1} | {:.1} |", of.ms(0.5), of.ms(0.9));
    }
    println!("\nDifference of the medians: {:.1} ms a submission.", all[0].ms(0.5) - all[1].ms(0.5));
}
