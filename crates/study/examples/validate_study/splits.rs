//! Random splits of subjects into two groups of equal size: how often a difference is found where there is none.

use faer::Mat;
use homolog_primitives::observe::Silent;
use homolog_study::findings::Findings;
use homolog_study::folder::Folder;
use homolog_study::measures::measured;
use homolog_study::plan::Records;
use homolog_study::settings::Measure;
use homolog_study::statistics::VertexValues;
use homolog_study::statistics::linear::LinearModel;
use homolog_study::statistics::multiple::false_discovery;
use homolog_study::statistics::permutation::test;
use homolog_study::statistics::tfce::Enhancer;
use nalgebra::Point3;
use rand_core::Rng;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use std::error::Error;

/// The measure at every vertex of each member for whom it is meaningful.
pub(crate) fn of_members(found: &Findings, folder: &Folder, measure: Measure) -> Result<Vec<Vec<f64>>, Box<dyn Error>> {
    let mut subjects = Vec::new();
    for (row, &k) in found.members.iter().enumerate() {
        let record = folder.get(&found.matched.keys[k])?.ok_or("a record is missing")?;
        let onto = &found.alignment.onto_mean[row];
        let own = record.points.iter().map(|p| onto.apply(&Point3::from(p.map(f64::from)))).collect();
        subjects.extend(measured(measure, &found.mean, &found.mean.with_vertices(own)?, &Silent)?);
    }
    Ok(subjects)
}

/// The shares of splits with any corrected p up to 0.05: by TFCE, by the largest |t|, and with any significant vertex, where both
/// the p by TFCE and q are up to 0.05.
pub(crate) fn shares(
    subjects: &[Vec<f64>],
    enhancer: &Enhancer<'_>,
    splits: u64,
    permutations: usize,
) -> Result<[f64; 3], Box<dyn Error>> {
    let (values, n) = (VertexValues::from_subjects(subjects), subjects.len());
    let mut counts = [0u32; 3];
    for split in 0..splits {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(1000 + split);
        let mut order: Vec<usize> = (0..n).collect();
        (1..n).rev().for_each(|k| order.swap(k, (random.next_u64() % (k as u64 + 1)) as usize));
        let matrix = Mat::from_fn(n, 2, |i, k| f64::from(u8::from(k == 0 || order[i] < n / 2)));
        let model = LinearModel::new(&matrix);
        let found = test(&model, &values, &[0.0, 1.0], enhancer, permutations, split, &Silent)?;
        let q = false_discovery(&model.contrast(&values, &[0.0, 1.0], &Silent)?.robust_p);
        let local: Vec<f64> = found.p_tfce.iter().zip(q).map(|(p, q)| p.max(q)).collect();
        for (count, p) in counts.iter_mut().zip([&found.p_tfce, &found.p_fwe, &local]) {
            *count += u32::from(p.iter().any(|&p| p <= 0.05));
        }
    }
    Ok(counts.map(|count| f64::from(count) / splits as f64))
}
