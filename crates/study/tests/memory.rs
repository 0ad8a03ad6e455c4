//! What a step of a study is predicted to take, beside what an allocator counts, at the ends of every size.
#![allow(clippy::unwrap_used, clippy::panic)]
#![allow(unsafe_code, reason = "an allocator that counts can only be written so")]

#[path = "../../../tests/counting/mod.rs"]
mod counting;
mod making;

use counting::{HELD, MOST};
use homolog_study::memory::step_bytes;
use making::{Extra, Made, made, made_with};
use std::sync::atomic::Ordering;

const THREADS: usize = 2;

/// What the step of a study takes at most, by the estimate and by the allocator, bytes.
fn step<T: Send>(study: &Made, work: impl FnOnce(&Made) -> T + Send) -> (u64, u64) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(THREADS).build().unwrap();
    let records: usize = study.files.values().map(Vec::len).sum();
    let before = HELD.load(Ordering::Relaxed) - records;
    MOST.store(HELD.load(Ordering::Relaxed), Ordering::Relaxed);
    let made = pool.install(|| work(study));
    let most = MOST.load(Ordering::Relaxed) - before;
    drop(made);
    (step_bytes(&study.size, THREADS), most as u64)
}

#[test]
fn no_step_of_a_study_takes_more_than_it_is_predicted_to() {
    let mut lines = Vec::new();
    let mut is_fine = true;
    for (subjects, levels, contrasts, covariates, permutations) in [
        (4, 1, 1, 0, 1),
        (5, 6, 1, 0, 2),
        (12, 5, 1, 0, 70),
        (6, 4, 20, 0, 2),
        (6, 1, 40, 0, 10),
        (5, 1, 1, 0, 200_000),
        (150, 4, 1, 0, 2),
        (400, 1, 1, 60, 20),
        (1_000, 1, 1, 0, 2),
        (1_500, 2, 1, 0, 2),
        (60, 3, 8, 10, 64),
    ] {
        let (predicted, counted) = step(&made(subjects, levels, contrasts, covariates, permutations), Made::step);
        let share = predicted as f64 / counted as f64;
        is_fine &= share >= 1.0;
        // Where arrays take most, and not names and facts of each subject, the estimate is not far too high either. Of a large
        // group so many may be left out that all components of the others are computed.
        is_fine &= share <= 2.0 || predicted < 32 << 20 || subjects > 1_000;
        lines.push(format!(
            "{subjects} subjects, level {levels}, {contrasts} contrasts, {covariates} covariates: predicted {predicted}, \
             counted {counted}, {share:.2}"
        ));
    }
    for (extra, subjects, levels) in [
        (Extra::Joint, 12, 4),
        (Extra::Joint, 60, 3),
        (Extra::Rivals, 12, 4),
        (Extra::Rivals, 60, 3),
        (Extra::Rivals, 300, 2),
        (Extra::OwnTemplates, 12, 4),
        (Extra::OwnTemplates, 60, 3),
    ] {
        let mut study = made_with(extra, subjects, levels, 1, 0, 2);
        let mut counts = vec![("last step", step(&study, Made::step))];
        if extra == Extra::Rivals {
            study.rivals.iter().for_each(|name| drop(study.files.remove(name)));
            counts.push(("step to rival poses", step(&study, Made::plan)));
        }
        for (what, (predicted, counted)) in counts {
            let share = predicted as f64 / counted as f64;
            // A step to matches takes less than the last one, which is predicted.
            is_fine &= share >= 1.0 && (share <= 2.0 || predicted < 32 << 20 || what != "last step");
            lines.push(format!(
                "{subjects} subjects, level {levels}, {extra:?}, {what}: predicted {predicted}, counted {counted}, {share:.2}"
            ));
        }
    }
    println!("{}", lines.join("\n"));
    assert!(is_fine, "\n{}", lines.join("\n"));
}
