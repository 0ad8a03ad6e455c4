//! Splits of the subjects as they are into two random groups: how often anything is found.

use crate::group::{Bench, Quiet};
use faer::Mat;
use homolog_primitives::observe::Silent;
use homolog_study::findings::find;
use homolog_study::measures::measured;
use homolog_study::plan::Records;
use homolog_study::settings::{Correspondence, Measure};
use homolog_study::statistics::VertexValues;
use homolog_study::statistics::linear::LinearModel;
use homolog_study::statistics::permutation::test;
use homolog_study::statistics::tfce::Enhancer;
use nalgebra::Point3;
use rand_core::Rng;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use std::error::Error;

/// A line of the report.
pub(crate) fn row(
    bench: &Bench,
    how: Correspondence,
    splits: u64,
    permutations: usize,
) -> Result<String, Box<dyn Error>> {
    let (study, matched, folder) = bench.matched(&bench.original(&bench.chosen(usize::MAX)), how)?;
    let found = find(&study, &matched, &folder, &[], &Quiet)?;
    let mut subjects = Vec::new();
    for (row, &k) in found.members.iter().enumerate() {
        let record = folder.get(&found.matched.keys[k])?.ok_or("a record is missing")?;
        let onto = &found.alignment.onto_mean[row];
        let own = record.points.iter().map(|p| onto.apply(&Point3::from(p.map(f64::from)))).collect();
        let own = found.mean.with_vertices(own)?;
        subjects.extend(measured(Measure::NormalDisplacement, &found.mean, &own, &Silent)?);
    }
    let (values, n) = (VertexValues::from_subjects(&subjects), subjects.len());
    let (graph, areas) = (found.mean.edge_graph(), homolog_study::align::vertex_areas(&found.mean));
    let enhancer = Enhancer::new(&graph, &areas);
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
    let error = (0.05 * 0.95 / splits as f64).sqrt();
    Ok(format!("| {} | {:.3} | {:.3} | {error:.3} |\n", how.name(), share(clusters), share(single)))
}
