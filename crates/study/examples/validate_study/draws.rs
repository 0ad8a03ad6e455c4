//! The same deformations in other ones of the subjects: how much of a figure is the chance of one draw.

use crate::figures::Figures;
use crate::group::{Bench, Maps};
use crate::planted::Plant;
use homolog_study::settings::Correspondence;
use std::error::Error;
use std::fmt::Write as _;
use std::path::Path;

const MAPS: [Maps; 2] = [Maps::Oracle, Maps::Matched(Correspondence::Joint)];

const HEADER: &str = "\
Shares of one draw are means over all deformations. The standard error is that of their mean over the draws, which have the subjects in \
common. Found, false: as in the report of all maps.

| maps | draw | beyond 2 SE | found | false | found by TFCE | false by TFCE |
|---|---|---|---|---|---|---|
";

/// Mean and its standard error.
fn mean_and_error(values: &[f64]) -> [f64; 2] {
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    [mean, (squares / (n - 1.0).max(1.0) / n).sqrt()]
}

/// Writes what studies of `n` subjects find in this number of draws.
///
/// # Errors
/// Errors of the studies, and of writing.
pub(crate) fn report(bench: &Bench, plants: &[Plant], n: usize, draws: u64, file: &Path) -> Result<(), Box<dyn Error>> {
    let mut text =
        format!("{draws} draws of the deformed among {n} subjects, {} deformations.\n\n{HEADER}", plants.len());
    let mut all = MAPS.map(|_| Vec::new());
    for draw in 0..draws {
        let mut sums = MAPS.map(|_| [0.0; 5]);
        for plant in plants {
            for (maps, sums) in MAPS.into_iter().zip(&mut sums) {
                let Figures { beyond, significant, by_tfce, .. } =
                    Figures::of(plant, &bench.found(plant, (n, draw), maps)?)?;
                let of_plant = [beyond, significant.found, significant.falsely, by_tfce.found, by_tfce.falsely];
                sums.iter_mut().zip(of_plant).for_each(|(sum, share)| *sum += share / plants.len() as f64);
                println!(
                    "{draw}, {}, {:?}: {}",
                    maps.name(),
                    plant,
                    of_plant.map(|share| format!("{share:.3}")).join(" ")
                );
            }
        }
        for ((maps, sums), all) in MAPS.iter().zip(sums).zip(&mut all) {
            let shares = sums.map(|share| format!("{share:.3}")).join(" | ");
            writeln!(text, "| {} | {draw} | {shares} |", maps.name())?;
            all.push(sums);
        }
        // Written as far as it is, because a draw takes minutes.
        std::fs::write(file, &text)?;
    }
    for (maps, of_draws) in MAPS.iter().zip(&all) {
        let share = |k: usize| {
            let [mean, error] = mean_and_error(&of_draws.iter().map(|sums: &[f64; 5]| sums[k]).collect::<Vec<_>>());
            format!("{mean:.3} ± {error:.3}")
        };
        let shares = [0, 1, 2, 3, 4].map(share).join(" | ");
        writeln!(text, "| {} | mean ± standard error | {shares} |", maps.name())?;
    }
    std::fs::write(file, text)?;
    Ok(())
}
