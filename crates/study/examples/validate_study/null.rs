//! Splits of the subjects as they are into two random groups: how often anything is found.

use crate::group::{Bench, Quiet};
use crate::splits::{of_members, shares};
use homolog_study::findings::find;
use homolog_study::settings::{Correspondence, Measure};
use homolog_study::statistics::tfce::Enhancer;
use std::error::Error;

/// A line of the report.
pub(crate) fn row(
    bench: &Bench,
    how: Correspondence,
    splits: u64,
    permutations: usize,
) -> Result<String, Box<dyn Error>> {
    let (study, matched, folder) = bench.matched(&bench.original(&bench.chosen(usize::MAX, 0)), how)?;
    let found = find(&study, &matched, &folder, &[], &Quiet)?;
    let subjects = of_members(&found, &folder, Measure::NormalDisplacement)?;
    let (graph, areas) = (found.mean.edge_graph(), homolog_study::align::vertex_areas(&found.mean));
    let [tfce, largest, local] = shares(&subjects, &Enhancer::new(&graph, &areas), splits, permutations)?;
    let error = (0.05 * 0.95 / splits as f64).sqrt();
    Ok(format!("| {} | {tfce:.3} | {largest:.3} | {local:.3} | {error:.3} |\n", how.name()))
}
