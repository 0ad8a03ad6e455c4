//! How often a study finds a difference where there is none: random splits of the subjects of a finished study into two groups of
//! equal size. Prints the share of splits with any corrected p up to 0.05, for each measure. `make study` runs it.
//!
//! Usage: `null_splits FOLDER SPLITS PERMUTATIONS`, with the folder of a study all of whose matches are there.
#![allow(clippy::print_stdout)]

use faer::Mat;
use homolog_primitives::observe::Silent;
use homolog_study::cohort::Role;
use homolog_study::findings::find;
use homolog_study::folder::Folder;
use homolog_study::matching::Watcher;
use homolog_study::measures::measured;
use homolog_study::output::read_document;
use homolog_study::plan::{Records, Study};
use homolog_study::settings::{Analysis, Measure};
use homolog_study::statistics::VertexValues;
use homolog_study::statistics::linear::LinearModel;
use homolog_study::statistics::permutation::test;
use homolog_study::statistics::tfce::Enhancer;
use nalgebra::Point3;
use rand_core::Rng;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use std::path::Path;

struct Quiet;
impl Watcher for Quiet {}

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
    for measure in Measure::ALL {
        let mut subjects = Vec::new();
        for (row, &k) in found.members.iter().enumerate() {
            debug_assert_eq!(study.cohort.subjects[k].role, Role::Model);
            let record = folder.get(&found.matched.keys[k])?.ok_or("a record is missing")?;
            let onto = &found.alignment.onto_mean[row];
            let own = record.points.iter().map(|p| onto.apply(&Point3::from(p.map(f64::from)))).collect();
            subjects.extend(measured(measure, &found.mean, &found.mean.with_vertices(own)?, &Silent)?);
        }
        if subjects.len() < n {
            continue;
        }
        let values = VertexValues::from_subjects(&subjects);
        let (mut clusters, mut single) = (0u32, 0u32);
        for split in 0..splits {
            let mut random = Xoshiro256PlusPlus::seed_from_u64(1000 + split);
            let mut order: Vec<usize> = (0..n).collect();
            (1..n).rev().for_each(|k| order.swap(k, (random.next_u64() % (k as u64 + 1)) as usize));
            let matrix = Mat::from_fn(n, 2, |i, k| f64::from(u8::from(k == 0 || order[i] < n / 2)));
            let model = LinearModel::new(&matrix);
            let found = test(&model, &values, &[0.0, 1.0], &enhancer, permutations, split, &Silent)?;
            let any = |p: &[f64]| u32::from(p.iter().any(|&p| p <= 0.05));
            clusters += any(&found.p_tfce);
            single += any(&found.p_fwe);
        }
        let share = |count: u32| f64::from(count) / splits as f64;
        println!("{}: {:.3} by TFCE, {:.3} by the largest |t|", measure.name(), share(clusters), share(single));
    }
    Ok(())
}
