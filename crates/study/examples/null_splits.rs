//! How often a study finds a difference where there is none: random splits of the subjects of a finished study into two groups of
//! equal size. Prints the share of splits with any corrected p up to 0.05, for each measure. `make study` runs it.
//!
//! Usage: `null_splits FOLDER SPLITS PERMUTATIONS`, with the folder of a study all of whose matches are there.
#![allow(clippy::print_stdout)]

#[path = "validate_study/splits.rs"]
mod splits;

use homolog_study::cohort::Role;
use homolog_study::findings::find;
use homolog_study::folder::Folder;
use homolog_study::matching::StudyObserver;
use homolog_study::output::read_document;
use homolog_study::plan::Study;
use homolog_study::settings::{Analysis, Measure};
use homolog_study::statistics::tfce::Enhancer;
use splits::{of_members, shares};
use std::path::Path;

struct Quiet;
impl StudyObserver for Quiet {}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, folder, splits, permutations] = arguments.as_slice() else {
        return Err("usage: null_splits FOLDER SPLITS PERMUTATIONS".into());
    };
    let (splits, permutations): (u64, usize) = (splits.parse()?, permutations.parse()?);
    let document = read_document(&std::fs::read(Path::new(folder).join("study.json"))?)?;
    let folder = Folder::create(Path::new(folder))?;
    let mut settings = document.settings;
    settings.analysis = Analysis::default();
    let mut study = Study::open(document.cohort, settings, &document.hashes, &folder, &Quiet)?;
    let matched = study.match_all(&folder, 1, &Quiet)?;
    let found = find(&study, &matched, &folder, &document.decisions, &Quiet)?;
    let n = found.members.len();
    let (graph, areas) = (found.mean.edge_graph(), homolog_study::align::vertex_areas(&found.mean));
    let enhancer = Enhancer::new(&graph, &areas);
    println!("{n} subjects, {} vertices, {splits} splits, {permutations} permutations", found.mean.n_vertices());
    debug_assert!(found.members.iter().all(|&k| study.cohort.subjects[k].role == Role::Model));
    for measure in Measure::ALL {
        let subjects = of_members(&found, &folder, measure)?;
        if subjects.len() < n {
            continue;
        }
        let [tfce, largest, local] = shares(&subjects, &enhancer, splits, permutations)?;
        println!("{}: {tfce:.3} by TFCE, {largest:.3} by the largest |t|, {local:.3} significant", measure.name());
    }
    Ok(())
}
