//! The energy of the truth against the energies that minimizers find: `make energies` writes the cases and runs it.
//!
//! `cargo run --release -p homolog-laboratory --example energies -- FOLDER > energies.csv`
//!
//! For every case in the folder, `NAME_s.ply`, `NAME_t.ply` and `NAME.truth` (the image of each source vertex, three
//! little-endian 64-bit numbers each, mm), a line for each energy and minimizer: the number of variables, the energy of the labels nearest to the
//! truth, that of the labeling to which conditional modes lead from there, that of the minimizer, and the mean distance of its labels from the truth in
//! percent of the target's diagonal. An energy is of use where no minimizer ends below the relaxed truth with a larger error.

#![allow(clippy::print_stdout)] // a program; its answer goes to standard output

use homolog_formats::{FileContent, ReadLimits, read};
use homolog_matching::parameters::{FeatureKind, MatchParameters};
use homolog_matching::{Levels, Method, Silent, SurfaceMesh, coarse_energy_model, near_isometry_model, preset};
use homolog_mesh::canonicalize;
use homolog_mrf::inference::{
    AnnealingOptions, BeliefPropagation, BpOptions, Cooling, DualBound, DualOptions, LasVegas, LasVegasOptions,
    Product, Sampler, SearchRun, SimulatedAnnealing,
};
use homolog_mrf::metric::MetricModel;
use homolog_mrf::{Labeling, MrfModel};
use nalgebra::Point3;
use rand_core::{Rng, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;
use std::error::Error;
use std::path::Path;

type Outcome<T> = Result<T, Box<dyn Error>>;

const SWEEPS: u32 = 200;
const SEED: u64 = 1;

fn main() -> Outcome<()> {
    let folder = std::env::args().nth(1).ok_or("usage: energies FOLDER")?;
    let mut names: Vec<String> = std::fs::read_dir(&folder)?
        .filter_map(|entry| Some(entry.ok()?.file_name().to_str()?.strip_suffix(".truth")?.to_owned()))
        .collect();
    names.sort();
    println!("case,energy,variables,minimizer,truth,relaxed,found,error_pct");
    for name in names {
        let case = Case::open(Path::new(&folder), &name)?;
        case.near_isometry(&name)?;
        case.coarse(&name)?;
    }
    Ok(())
}

/// A pair with its truth, in canonical numbering, mm.
struct Case {
    source: SurfaceMesh,
    target: SurfaceMesh,
    /// The image of each source vertex.
    truth: Vec<Point3<f64>>,
}

impl Case {
    fn open(folder: &Path, name: &str) -> Outcome<Case> {
        let surface = |side: &str| -> Outcome<SurfaceMesh> {
            let file = format!("{name}_{side}.ply");
            match read(&std::fs::read(folder.join(&file))?, Some(&file), &ReadLimits::default())?.content {
                FileContent::Mesh(file) => Ok(file.mesh),
                FileContent::Labels(_) => Err(format!("{file} is no surface").into()),
            }
        };
        let bytes = std::fs::read(folder.join(format!("{name}.truth")))?;
        let numbers: Vec<f64> =
            bytes.chunks_exact(8).map(|b| f64::from_le_bytes(std::array::from_fn(|k| b[k]))).collect();
        let (source, target) = (canonicalize(&surface("s")?), canonicalize(&surface("t")?));
        let truth = |&i: &u32| Point3::from_slice(&numbers[3 * i as usize..][..3]);
        Ok(Case {
            truth: source.numbering.originals().iter().map(truth).collect(),
            source: source.mesh,
            target: target.mesh,
        })
    }

    /// Percent of the target's diagonal.
    fn error(&self, labels: &[Point3<f64>], labeling: &[u32], truth: &[Point3<f64>]) -> f64 {
        let (low, high) = self.target.bounding_box();
        let apart: f64 = labeling.iter().zip(truth).map(|(&x, q)| (labels[x as usize] - q).norm()).sum();
        100.0 * apart / truth.len() as f64 / (high - low).norm()
    }

    fn near_isometry(&self, name: &str) -> Outcome<()> {
        let found = near_isometry_model(&self.source, &self.target)?;
        let labels: Vec<Point3<f64>> = found.labels.iter().map(|&k| self.target.vertices()[k as usize]).collect();
        let truth: Vec<Point3<f64>> = found.variables.iter().map(|&k| self.truth[k as usize]).collect();
        let of_truth: Labeling = truth.iter().map(|q| nearest(&labels, q)).collect();
        let energy = |x: &[u32]| found.model.energy(x).total();
        let relaxed = found.model.descend(of_truth.clone(), 100);
        let say = |minimizer: &str, x: &[u32]| {
            let error = self.error(&labels, x, &truth);
            let (truth, relaxed) = (energy(&of_truth), energy(&relaxed));
            let variables = found.model.n_variables();
            println!(
                "{name},near isometry,{variables},{minimizer},{truth:.2},{relaxed:.2},{:.2},{error:.3}",
                energy(x)
            );
        };
        say("conditional modes from the truth", &relaxed);
        let from_nothing = found.minimized(&[]);
        let mut all = vec![from_nothing.clone()];
        let mut labelings: Vec<Labeling> = found.of_extremities.iter().map(|bias| found.minimized(bias)).collect();
        all.extend_from_slice(&labelings);
        labelings.sort_by(|a, b| energy(a).total_cmp(&energy(b)));
        if let Some(lowest) = labelings.first() {
            say("propagation (extremities)", lowest);
        }
        for (k, x) in labelings.iter().enumerate() {
            say(&format!("propagation from extremities {}", k + 1), x);
        }
        say("propagation from nothing", &from_nothing);
        if let Some(fused) = found.fused(&all) {
            say("fusion of what propagation found", &fused);
        }
        say("conditional modes from unary potentials", &found.model.descend(found.model.unary_minimum(), 100));
        let mut random = Xoshiro256PlusPlus::seed_from_u64(SEED);
        let any: Labeling =
            (0..found.model.n_variables()).map(|_| (uniform(&mut random) * labels.len() as f64) as u32).collect();
        say("conditional modes from random labels", &found.model.descend(any.clone(), 100));
        say("Gibbs", &annealed_metric(&found.model, any, &mut random));
        Ok(())
    }

    fn coarse(&self, name: &str) -> Outcome<()> {
        let of = |method| {
            let mut parameters: MatchParameters = preset(method);
            parameters.inference.coarse_vertices = preset(Method::Balanced).inference.coarse_vertices;
            parameters
        };
        let mut fpfh = of(Method::Balanced);
        fpfh.features.truncate(1);
        fpfh.features[0].kind = FeatureKind::Fpfh;
        for (energy, parameters) in [
            ("curvature, coarse level", of(Method::Balanced)),
            ("the same with features fpfh", fpfh),
            ("coarse level of thesis", of(Method::Thesis)),
        ] {
            let levels =
                [&self.source, &self.target].map(|mesh| Levels::new(mesh, parameters.inference.coarse_vertices));
            let model = coarse_energy_model(&levels[0], &levels[1], &parameters)?;
            let labels = levels[1].energy_mesh().vertices();
            // Sites of a coarse level are vertices of the surface.
            let own = |p: &Point3<f64>| self.truth[nearest(self.source.vertices(), p) as usize];
            let truth: Vec<Point3<f64>> = levels[0].energy_mesh().vertices().iter().map(own).collect();
            let of_truth: Labeling = truth.iter().map(|q| nearest(labels, q)).collect();
            let relaxed = relaxed(&model, &of_truth)?;
            let of = |x: &[u32]| model.energy(x).total();
            let say = |minimizer: &str, x: &[u32]| {
                let error = self.error(labels, x, &truth);
                println!(
                    "{name},{energy:?},{},{minimizer},{:.2},{:.2},{:.2},{error:.3}",
                    truth.len(),
                    of(&of_truth),
                    of(&relaxed),
                    of(x)
                );
            };
            let options = BpOptions { product: Product::Max, damping: 0.5, floor: 1e-5, tolerance: 1e-3 };
            say("conditional modes from the truth", &relaxed);
            say("propagation", &BeliefPropagation::new(&model, options).run(100, &Silent, |_| ())?.labeling);
            let dual = DualOptions { gap_tolerance: 1e-6, progress_tolerance: 1e-5 };
            say("tree-reweighted messages", &DualBound::new(&model, dual).run(40, &Silent, |_, _| ())?.labeling);
            for (minimizer, sampler) in [("Gibbs", Sampler::Gibbs), ("Metropolis", Sampler::Metropolis)] {
                say(minimizer, &annealed(&model, sampler)?);
            }
            let run = SearchRun { sweeps: SWEEPS, seed: SEED, start: None, target_energy: None };
            say(
                "Las Vegas",
                &LasVegas::new(&model, LasVegasOptions { patience: 20 }).run(&run, &Silent, |_| ())?.labeling,
            );
        }
        Ok(())
    }
}

/// Simulated annealing by Gibbs sampling from `labeling`, and conditional modes after it.
///
/// The temperature falls geometrically from 10, above which an edge hardly matters (its most is 3), to 0.01.
fn annealed_metric(model: &MetricModel, mut labeling: Labeling, random: &mut Xoshiro256PlusPlus) -> Labeling {
    const SWEEPS_OF_METRIC: u32 = 60;
    let (first, last) = (10.0f64, 0.01f64);
    for sweep in 0..SWEEPS_OF_METRIC {
        let temperature = first * (last / first).powf(f64::from(sweep) / f64::from(SWEEPS_OF_METRIC - 1));
        for i in 0..model.n_variables() {
            let cost = model.conditional(i, &labeling);
            let least = cost.iter().copied().fold(f32::INFINITY, f32::min);
            let weight = |c: &f32| (f64::from(least - c) / temperature).exp();
            let mut left = uniform(random) * cost.iter().map(weight).sum::<f64>();
            labeling[i] = cost
                .iter()
                .position(|c| {
                    left -= weight(c);
                    left <= 0.0
                })
                .unwrap_or(labeling[i] as usize) as u32;
        }
    }
    model.descend(labeling, 100)
}

/// Uniform in `[0, 1)`.
fn uniform(random: &mut Xoshiro256PlusPlus) -> f64 {
    (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64
}

fn annealed(model: &MrfModel, sampler: Sampler) -> Outcome<Labeling> {
    let options = AnnealingOptions {
        sampler,
        schedule: Cooling::Geometric,
        initial_temperature: None,
        final_temperature: None,
        patience: 20,
    };
    let run = SearchRun { sweeps: SWEEPS, seed: SEED, start: None, target_energy: None };
    Ok(SimulatedAnnealing::new(model, options).run(&run, &Silent, |_| ())?.labeling)
}

/// The labeling to which single changes that lower the energy lead.
fn relaxed(model: &MrfModel, start: &[u32]) -> Outcome<Labeling> {
    let run = SearchRun { sweeps: 30, seed: SEED, start: Some(start), target_energy: None };
    let options = AnnealingOptions {
        sampler: Sampler::Gibbs,
        schedule: Cooling::Geometric,
        // So cold that only changes that lower the energy are made.
        initial_temperature: Some(1e-6),
        final_temperature: Some(1e-6),
        patience: 1,
    };
    Ok(SimulatedAnnealing::new(model, options).run(&run, &Silent, |_| ())?.labeling)
}

fn nearest(points: &[Point3<f64>], to: &Point3<f64>) -> u32 {
    let squared = |k: &usize| (points[*k] - to).norm_squared();
    (0..points.len()).min_by(|a, b| squared(a).total_cmp(&squared(b))).unwrap_or(0) as u32
}
