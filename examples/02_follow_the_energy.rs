//! Follows a match: phases, and the energy trace, whose series are described in docs/api.md. An observer could cancel too.
//!
//! Usage: `02_follow_the_energy SOURCE TARGET`.
#![allow(clippy::print_stdout, reason = "an example")]

use homolog_matching::{Method, Observer, Phase, TracePoint, preset};
use homolog_run::{InputFile, intake::IntakeLimits, run_match};

struct Follower;

impl Observer for Follower {
    fn phase(&self, phase: Phase) {
        println!("phase {}", phase.name());
    }

    fn trace(&self, point: &TracePoint) {
        if let (Some(quantity), Some(energy)) = (point.quantity, point.energy) {
            let start = point.start.map_or(String::new(), |start| format!(", start {start}"));
            let mark = if point.chosen { ", the energy of the result" } else { "" };
            println!("  {quantity:?}, round {}{start}, iteration {}: {energy:.4}{mark}", point.round, point.iteration);
        }
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let paths: Vec<String> = std::env::args().skip(1).collect();
    let [source, target] = paths.as_slice() else { return Err("usage: 02_follow_the_energy SOURCE TARGET".into()) };
    let (source, target) = (std::fs::read(source)?, std::fs::read(target)?);
    let [source, target] = [&source, &target].map(|bytes| InputFile { bytes, name: None });
    let found = run_match(source, target, &preset(Method::Balanced), &IntakeLimits::default(), &Follower)?.document;
    let energy = found.energy.ok_or("the method minimizes no energy of labels")?;
    println!("energy of the result: {:.4}", energy.r#final);
    Ok(())
}
