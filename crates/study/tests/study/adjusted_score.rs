//! A new subject against synthetic groups whose shapes change with age: adjusted for age, its p-values are uniform whatever
//! its age, a planted bump is found, and what cannot be adjusted for is refused.

use crate::population::{DEVIATION_MM, Population, WIDTH_MM, bump, template};
use crate::score::{compared, from_uniform};
use homolog_study::StudyError;
use homolog_study::adjustment::Adjustment;
use homolog_study::score::{Reference, SubjectScore};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Vertex at which the bump is planted, and the middle of the region that changes with age.
const PLACE: usize = 100;
const AGING: usize = 300;

/// Displacement for each standard deviation of age at each vertex, mm: inwards, most around a vertex.
fn slopes() -> Vec<f64> {
    bump(&template(), AGING).iter().map(|height| -3.0 * DEVIATION_MM * height).collect()
}

/// A group of `n`, its table, and a further shape of this age, in standard deviations from the group's mean.
fn group(n: usize, age: f64, seed: u64, further: &dyn Fn(usize) -> f64) -> (Vec<Vec<[f32; 3]>>, String) {
    let (mut population, slopes) = (Population::new(seed), slopes());
    let (mut shapes, mut table) = (Vec::new(), "id,file,age,sex\n".to_owned());
    for k in 0..n {
        let (own, sex) = (population.draw(), ["f", "m"][k % 2]);
        shapes.push(population.shape(&|v| own * slopes[v]));
        table.push_str(&format!("s{k},s{k}.ply,{},{sex}\n", 70.0 + 8.0 * own));
    }
    shapes.push(population.shape(&|v| age * slopes[v] + further(v)));
    (shapes, table)
}

fn of_age(age: f64) -> Reference {
    let values = BTreeMap::from([("age".to_owned(), (70.0 + 8.0 * age).to_string())]);
    Reference { within: None, adjustment: Adjustment { covariates: vec!["age".to_owned()], values } }
}

#[test]
fn old_subjects_are_unusual_without_adjustment_and_not_with_it() {
    const OLD: f64 = 3.5;
    for (n, tries) in [(20, 200), (60, 120)] {
        let score = |reference: &Reference| -> Vec<SubjectScore> {
            let one = |seed| {
                let (shapes, table) = group(n, OLD, seed, &|_| 0.0);
                compared(&shapes, &table, reference).unwrap()
            };
            (0..tries).into_par_iter().map(one).collect()
        };
        let (plain, adjusted) = (score(&Reference::default()), score(&of_age(OLD)));
        let share = |of: &[SubjectScore], is: &dyn Fn(&SubjectScore) -> bool| {
            of.iter().filter(|score| is(score)).count() as f64 / tries as f64
        };
        let (above, below) =
            (|s: &SubjectScore| !s.summary.regions.is_empty(), |s: &SubjectScore| s.summary.unusual_p < 0.2);
        let most = 1.0 / (n as f64 + 1.0) + 1.63 / (tries as f64).sqrt();
        let of = |p: fn(&SubjectScore) -> f64| from_uniform(adjusted.iter().map(p).collect());
        let (unusual, largest) = (of(|s| s.summary.unusual_p), of(|s| s.summary.largest_score_p));
        let rms = adjusted.iter().map(|s| s.summary.calibration.rms).sum::<f64>() / tries as f64;
        println!(
            "n = {n}: regions in {:.3} without and {:.3} with adjustment, unusual p below 0.2 in {:.3} and {:.3}; from \
             uniform: unusual {unusual:.3}, largest {largest:.3} (most {most:.3}); RMS {rms:.3}",
            share(&plain, &above),
            share(&adjusted, &above),
            share(&plain, &below),
            share(&adjusted, &below)
        );
        assert!(share(&plain, &above) > 0.2, "{n}: falsely beyond the bound in {}", share(&plain, &above));
        assert!(share(&adjusted, &above) < 0.05 + 3.0 * (0.05 * 0.95 / tries as f64).sqrt());
        assert!(largest < most, "{n}: {largest} {most}");
        // Far outside of the range of the group, residuals of the subject follow from those of the members.
        assert!(share(&adjusted, &below) < 0.2 + 3.0 * (0.16 / tries as f64).sqrt(), "{n}: {unusual}");
        assert!((rms - 1.0).abs() < 0.05, "{n}: {rms}");
    }
}

#[test]
fn p_values_of_subjects_of_all_ages_are_uniform() {
    let (n, tries) = (20, 200);
    let found: Vec<SubjectScore> = (0..tries)
        .into_par_iter()
        .map(|seed| {
            let age = Population::new(9000 + seed).draw();
            let (shapes, table) = group(n, age, seed, &|_| 0.0);
            compared(&shapes, &table, &of_age(age)).unwrap()
        })
        .collect();
    let most = 1.0 / (n as f64 + 1.0) + 1.63 / (tries as f64).sqrt();
    let of = |p: fn(&SubjectScore) -> f64| from_uniform(found.iter().map(p).collect());
    let (unusual, largest) = (of(|s| s.summary.unusual_p), of(|s| s.summary.largest_score_p));
    println!("from uniform: unusual {unusual:.3}, largest {largest:.3} (most {most:.3})");
    assert!(unusual < most && largest < most, "{unusual} {largest} {most}");
}

#[test]
fn a_bump_in_an_old_subject_is_found_at_its_place() {
    let mesh = template();
    let (height, place, tries) = (bump(&mesh, PLACE), mesh.vertices()[PLACE], 60);
    let near = |v: usize| (mesh.vertices()[v] - place).norm() < 3.0 * WIDTH_MM;
    let outcomes: Vec<[bool; 2]> = (0..tries)
        .into_par_iter()
        .map(|seed| {
            let (shapes, table) = group(20, 1.5, 7000 + seed, &|v| 6.0 * DEVIATION_MM * height[v]);
            let found = compared(&shapes, &table, &of_age(1.5)).unwrap();
            let bound = found.summary.bound.score;
            let is_found = found.summary.regions.first().is_some_and(|region| region.score > 0.0 && near(region.peak));
            [is_found, (0..mesh.n_vertices()).any(|v| !near(v) && found.scores[v].abs() > bound)]
        })
        .collect();
    let [found, elsewhere] = [0, 1].map(|k| outcomes.iter().filter(|of| of[k]).count());
    println!("found in {found} of {tries}, something elsewhere in {elsewhere}");
    assert!(100 * found >= 95 * tries as usize && 100 * elsewhere <= 12 * tries as usize, "{found} {elsewhere}");
}

#[test]
fn the_summary_states_what_was_adjusted_for() {
    let (shapes, table) = group(20, 0.0, 1, &|_| 0.0);
    let mut reference = of_age(0.0);
    reference.adjustment.covariates.push("sex".to_owned());
    reference.adjustment.values.insert("sex".to_owned(), " m".to_owned());
    let found = compared(&shapes, &table, &reference).unwrap().summary.adjusted.unwrap();
    assert_eq!((found.degrees, found.incomplete, found.covariates["sex"].as_str()), (17.0, 0, "m"));
    assert!(found.warnings.is_empty() && found.leverage > 0.05 && found.leverage < 0.3, "{found:?}");
    let old = compared(&shapes, &table, &of_age(9.0)).unwrap().summary.adjusted.unwrap();
    assert!(old.leverage > 1.0 && old.warnings[0].contains("age 142 lies outside of the range"), "{old:?}");
    // A member without an age is no member.
    let (first, rest) = table.split_once("f\n").unwrap();
    let without_age =
        format!("{},f\n{rest}", first.rsplit_once(',').unwrap().0.rsplit_once(',').unwrap().0.to_owned() + ",");
    let found = compared(&shapes, &without_age, &of_age(0.0)).unwrap().summary;
    assert_eq!((found.members, found.adjusted.unwrap().incomplete), (19, 1));
}

#[test]
fn what_cannot_be_adjusted_for_is_refused() {
    let (shapes, table) = group(20, 0.0, 1, &|_| 0.0);
    let said = |shapes: &[Vec<[f32; 3]>], table: &str, covariates: &[&str], values: &[(&str, &str)]| {
        let covariates = covariates.iter().map(|name| (*name).to_owned()).collect();
        let values = values.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
        let reference = Reference { within: None, adjustment: Adjustment { covariates, values } };
        match compared(shapes, table, &reference) {
            Err(StudyError::Settings(why)) => why,
            other => panic!("{:?}", other.map(|found| found.summary)),
        }
    };
    for (covariates, values, part) in [
        (&["age"][..], &[][..], "no value of age"),
        (&["age"], &[("age", "NA")], "no value of age"),
        (&["age"], &[("age", "old")], "not a number"),
        (&["age", "sex"], &[("age", "70"), ("sex", "x")], "no level x; it has f, m"),
        (&["height"], &[("height", "1")], "no covariate height; its covariates are: age, sex"),
        (&["age", "age"], &[("age", "70")], "twice"),
        (&[], &[("age", "70")], "not among"),
    ] {
        let why = said(&shapes, &table, covariates, values);
        assert!(why.contains(part), "{why}");
    }
    let few = |n: usize| [&shapes[..n], &shapes[20..]].concat();
    let rows = |n: usize| table.lines().take(n + 1).map(|line| format!("{line}\n")).collect::<String>();
    assert!(said(&few(5), &rows(5), &["age"], &[("age", "70")]).contains("at least 6 are needed"));
    // Six members leave four degrees of freedom.
    assert!(compared(&few(6), &rows(6), &of_age(0.0)).is_ok());
    let alone = table.replacen(",f\n", ",x\n", 1);
    assert!(said(&shapes, &alone, &["sex"], &[("sex", "m")]).contains("one member of the group alone"));
}
