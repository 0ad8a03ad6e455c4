//! Matches two files and prints the verdict. Formats, repairs and label volumes are those of the service.
//!
//! Usage: `01_match_two_files SOURCE TARGET`.
#![allow(clippy::print_stdout, reason = "an example")]

use homolog_matching::{Method, Silent, preset};
use homolog_run::{InputFile, intake::IntakeLimits, run_match};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let paths: Vec<String> = std::env::args().skip(1).collect();
    let [source, target] = paths.as_slice() else { return Err("usage: 01_match_two_files SOURCE TARGET".into()) };
    let (source, target) = (std::fs::read(source)?, std::fs::read(target)?);
    let [source, target] = [&source, &target].map(|bytes| InputFile { bytes, name: None });
    let found = run_match(source, target, &preset(Method::Balanced), &IntakeLimits::default(), &Silent)?.document;
    let verdict = found.verdict();
    println!("reliable: {:?}, reasons: {:?}", verdict.reliable, verdict.reasons);
    println!("distance of the surfaces: {:.2} mm", found.surface_distance.mean_mm);
    println!("target from source: {:.3?}", found.transform.matrix);
    Ok(())
}
