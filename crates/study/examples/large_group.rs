//! A study of a large made-up group: what planning it, its model, its statistics and its output take, and the most memory.
//! Every subject is an ellipsoid with 40 ways to differ and noise; its map is the truth, so that nothing is matched.
//!
//! Usage: `large_group SUBJECTS OUT`, with an empty folder that takes about 0.6 MB for each subject.
#![allow(clippy::print_stdout)]

use homolog_contract::parameters::resolve;
use homolog_formats::ply::write_ply;
use homolog_mesh::shapes::ellipsoid;
use homolog_study::cohort::Cohort;
use homolog_study::findings::find;
use homolog_study::folder::Folder;
use homolog_study::matching::StudyObserver;
use homolog_study::plan::{Step, Study};
use homolog_study::record::{Facts, Record};
use homolog_study::settings::{Analysis, Correspondence, Measure, Rivals, Settings, Size, TemplateChoice, Visits};
use nalgebra::{Point3, Vector3};
use rand_core::Rng;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use std::error::Error;
use std::fs;
use std::path::Path;
use std::time::Instant;

/// Ways in which subjects differ, the standard deviation of the first, mm, and that of the noise of each coordinate.
const WAYS: usize = 40;
const FIRST_MM: f64 = 0.5;
const NOISE_MM: f64 = 0.05;

struct Quiet;
impl StudyObserver for Quiet {}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, n, out] = arguments.as_slice() else { return Err("usage: large_group SUBJECTS OUT".into()) };
    let (n, out): (usize, &Path) = (n.parse()?, Path::new(out));
    fs::create_dir_all(out.join("files"))?;
    let out = std::path::absolute(out)?;
    let mesh = ellipsoid(Vector3::new(18.0, 7.0, 5.0), 4);
    let template = out.join("template.ply");
    fs::write(&template, write_ply(&mesh))?;
    // Nothing reads a subject but its hash.
    let mut table = "id,file,group\n".to_owned();
    for k in 0..n {
        let file = out.join("files").join(format!("{k}.ply"));
        fs::write(&file, format!("subject {k}"))?;
        table.push_str(&format!("s{k},{},{}\n", file.display(), ["patient", "control"][k % 2]));
    }
    let settings = Settings {
        template: TemplateChoice::Given { file: template },
        template_side: None,
        size: Size::Kept,
        correspondence: Correspondence::Pairs,
        visits: Visits::default(),
        rivals: Rivals::default(),
        analysis: Analysis {
            effect: Some("group".to_owned()),
            measures: vec![Measure::NormalDisplacement],
            permutations: 100,
            ..Analysis::default()
        },
        cycle_subjects: 0,
        cycle_ring: Vec::new(),
        parameters: resolve(&serde_json::json!({})).map_err(|faults| format!("{faults:?}"))?,
    };
    let folder = Folder::create(&out.join("study"))?;
    let mut began = Instant::now();
    let mut said = |what: &str| {
        println!("{what}: {:.1} s, {} MiB at most so far", began.elapsed().as_secs_f64(), most_memory_mib());
        began = Instant::now();
    };
    let mut study = Study::open(Cohort::from_csv(table.as_bytes(), Path::new(""))?, settings, &[], &folder, &Quiet)?;
    let Step::Match { tasks, .. } = study.advance(&folder, &Quiet)? else {
        return Err("the folder is not empty".into());
    };
    said(&format!("planned {n} subjects of {} vertices", mesh.n_vertices()));
    let ways: Vec<Vec<Vector3<f64>>> = (0..WAYS).map(|way| way_to_differ(way, mesh.vertices())).collect();
    for (k, task) in tasks.iter().enumerate() {
        folder.keep(&task.key, &record(k as u64, mesh.vertices(), &ways))?;
    }
    said("made up their maps");
    let Step::Matched(matched) = study.advance(&folder, &Quiet)? else { return Err("a map is missing".into()) };
    let found = find(&study, &matched, &folder, &[], &Quiet)?;
    said("aligned, model and statistics");
    println!(
        "compactness {:.4}, generalization {:.4} mm, specificity {:.4} mm with 10 modes",
        found.model.quality.compactness[9],
        found.model.quality.generalization_mm[9],
        found.model.quality.specificity_mm[9]
    );
    homolog_study::output::write(&study, &found, &[], &folder, "unknown", &Quiet)?;
    said("output");
    Ok(())
}

/// A smooth displacement of each vertex of length 1, mm, on average.
fn way_to_differ(way: usize, vertices: &[Point3<f64>]) -> Vec<Vector3<f64>> {
    let mut random = Xoshiro256PlusPlus::seed_from_u64(way as u64);
    let frequency = Vector3::from_fn(|_, _| 0.3 * normal(&mut random));
    let phase = 2.0 * std::f64::consts::PI * uniform(&mut random);
    let direction = Vector3::from_fn(|_, _| normal(&mut random)).normalize();
    vertices.iter().map(|p| direction * (2f64.sqrt() * (frequency.dot(&p.coords) + phase).cos())).collect()
}

fn record(subject: u64, vertices: &[Point3<f64>], ways: &[Vec<Vector3<f64>>]) -> Record {
    let mut random = Xoshiro256PlusPlus::seed_from_u64(1000 + subject);
    let scores: Vec<f64> = (0..ways.len()).map(|k| FIRST_MM * 0.9f64.powi(k as i32) * normal(&mut random)).collect();
    let points = vertices.iter().enumerate().map(|(v, p)| {
        let moved: Vector3<f64> = ways.iter().zip(&scores).map(|(way, score)| way[v] * *score).sum();
        let noise = Vector3::from_fn(|_, _| NOISE_MM * normal(&mut random));
        <[f64; 3]>::from(p.coords + moved + noise).map(|x| x as f32)
    });
    let points = points.collect();
    Record {
        facts: Facts { reliable: Some(true), volume_mm3: Some(2639.0), area_mm2: 1190.0, ..Facts::default() },
        points,
    }
}

fn uniform(random: &mut Xoshiro256PlusPlus) -> f64 {
    ((random.next_u64() >> 11) as f64 + 0.5) / (1u64 << 53) as f64
}

fn normal(random: &mut Xoshiro256PlusPlus) -> f64 {
    (-2.0 * uniform(random).ln()).sqrt() * (2.0 * std::f64::consts::PI * uniform(random)).cos()
}

/// The most memory of this process, MiB, where the system tells it.
fn most_memory_mib() -> u64 {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.split_whitespace().next()?.parse::<u64>().ok()).map_or(0, |kib| kib / 1024)
}
