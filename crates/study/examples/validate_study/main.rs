//! Known deformations put into real groups of hippocampi: how much of them a study finds, how much it finds beside them, and how
//! often it finds something where nothing was put. Writes `report.md`. `make validate-study` runs it.
//!
//! Every other subject is deformed in a patch and matched again. The *oracle* has the true correspondence of the deformation: the
//! maps of the subjects as they were, moved by the deformation of the surface. It differs from a study of the deformed surfaces only
//! in what their matches do with the deformation, and has the same error of the maps otherwise.
//!
//! Usage: `validate_study DATA OUT [short | splits | draws N]`, with label volumes in `DATA/hippocampus`. Matches are kept in OUT.
//! With `splits` only the splits without an effect are measured, into `splits.md`. With `draws` all subjects are studied N times,
//! other ones of them deformed each time, and only `draws.md` is written.
#![allow(clippy::print_stdout)]

mod draws;
mod figures;
mod group;
mod null;
mod planted;
mod splits;

use figures::Figures;
use group::{Bench, Maps};
use homolog_contract::parameters::Method;
use homolog_study::findings::Findings;
use homolog_study::settings::Correspondence;
use planted::Plant;
use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;

/// What is measured.
struct Plan {
    subjects: usize,
    sizes: Vec<usize>,
    plants: Vec<Plant>,
    permutations: usize,
    splits: u64,
}

impl Plan {
    fn short() -> Self {
        let plants = vec![Plant { radius_mm: 12.0, height_mm: -1.0, share: 0.5 }];
        Plan { subjects: 20, sizes: vec![20], plants, permutations: 200, splits: 40 }
    }

    fn long() -> Self {
        let mut plants = Vec::new();
        for height_mm in [-0.3, -1.0, -2.0, 1.0] {
            for radius_mm in [6.0, 12.0, 20.0] {
                plants.push(Plant { radius_mm, height_mm, share: 0.5 });
            }
        }
        Plan { subjects: 130, sizes: vec![20, 60, 130], plants, permutations: 500, splits: 600 }
    }
}

/// The maps that are compared.
const MAPS: [Maps; 5] = [
    Maps::Oracle,
    Maps::Matched(Correspondence::Pairs),
    Maps::Matched(Correspondence::Joint),
    Maps::Other(Method::SpharmPdm),
    Maps::Other(Method::Icp),
];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().collect();
    let usage = "usage: validate_study DATA OUT [short | splits | draws N]";
    let [_, data, out, words @ ..] = arguments.as_slice() else { return Err(usage.into()) };
    let (data, out) = (Path::new(data), Path::new(out));
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let plan = if words == ["short"] { Plan::short() } else { Plan::long() };
    let open = || Bench::open(data, out, plan.subjects, plan.permutations);
    match words.as_slice() {
        [] | ["short"] => write_all(&open()?, &plan, &out.join("report.md")),
        ["splits"] => write_splits(&open()?, &plan, String::new(), &out.join("splits.md")),
        ["draws", number] => {
            let number = number.parse()?;
            draws::report(&open()?, &plan.plants, plan.subjects, number, &out.join("draws.md"))
        }
        _ => Err(usage.into()),
    }
}

/// Writes what studies find of each deformation, and the splits without an effect, to `report`.
fn write_all(bench: &Bench, plan: &Plan, report: &Path) -> Result<(), Box<dyn Error>> {
    let mut text = format!(
        "{} hippocampi, every other one deformed; {} permutations; {} vertices.\n\n{HEADER}",
        plan.subjects,
        plan.permutations,
        bench.n_vertices()?
    );
    for plant in &plan.plants {
        for &n in &plan.sizes {
            for maps in MAPS {
                let line = row(plant, n, maps, &bench.found(plant, (n, 0), maps)?)?;
                println!("{line}");
                text.push_str(&line);
                text.push('\n');
                // Written as far as it is, because the long form takes hours.
                std::fs::write(report, &text)?;
            }
        }
    }
    write_splits(bench, plan, text, report)
}

/// Writes the splits without an effect to `report`, after `text`.
fn write_splits(bench: &Bench, plan: &Plan, mut text: String, report: &Path) -> Result<(), Box<dyn Error>> {
    writeln!(
        text,
        "\nSplits without an effect, {} of {} subjects each: share with any corrected p up to 0.05.\n",
        plan.splits, plan.subjects
    )?;
    text.push_str(
        "| maps | TFCE | largest \\|t\\| | significant (TFCE and FDR) | standard error |\n|---|---|---|---|---|\n",
    );
    for how in Correspondence::ALL {
        let line = null::row(bench, how, plan.splits, plan.permutations)?;
        println!("{line}");
        text.push_str(&line);
        std::fs::write(report, &text)?;
    }
    println!("written to {}", report.display());
    Ok(())
}

const HEADER: &str = "\
Maps: the oracle, those of homolog pair by pair and joint, and those of SPHARM-PDM and of closest points, with the same template. \
In the model: subjects whose match is not unreliable. Effect: mean over the part of the patch that moves by more than half of the height. \
SE: median standard error (HC3) there. Beyond 2 SE: \
share of the area of that part where the effect has the sign of the deformation and exceeds two standard errors. Found: share of it \
that is significant: corrected p (TFCE, family-wise) and q (FDR) up to 0.05. False: share of the significant area outside of the patch. \
By TFCE: both with the corrected p alone. \
Distance: from the largest |t| to the middle of the patch on the mean.

| radius, height, mm | n | in the model | maps | effect, mm | put there, mm | SE, mm | beyond 2 SE | found | false | found by TFCE | false by TFCE | distance, mm |
|---|---|---|---|---|---|---|---|---|---|---|---|---|
";

/// A line of the report.
fn row(plant: &Plant, n: usize, maps: Maps, found: &Findings) -> Result<String, Box<dyn Error>> {
    let of = Figures::of(plant, found)?;
    Ok(format!(
        "| {:.0}, {:+.1} | {n} | {} | {} | {:+.2} | {:+.2} | {:.2} | {:.2} | {:.2} | {:.3} | {:.2} | {:.3} | {:.1} |",
        plant.radius_mm,
        plant.height_mm,
        found.members.len(),
        maps.name(),
        of.effect_mm,
        of.expected_mm,
        of.se_mm,
        of.beyond,
        of.significant.found,
        of.significant.falsely,
        of.by_tfce.found,
        of.by_tfce.falsely,
        of.distance_mm,
    ))
}
