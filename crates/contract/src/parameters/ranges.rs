//! The ranges of all parameters, and what excludes what.

use super::resolve::fault;
use super::{Algorithm, ClampingMode, InitialPose, MatchParameters, MessageSchedule, ParameterError, Update};

/// Every value outside its range.
pub(super) fn out_of_range(p: &MatchParameters) -> Vec<ParameterError> {
    let mut faults = Vec::new();
    let mut check = |ok: bool, pointer: &str, detail: &str| {
        if !ok {
            faults.push(fault(pointer, "out_of_range", detail.to_owned()));
        }
    };
    check(p.input.labels.as_ref().is_none_or(|l| !l.is_empty()), "/input/labels", "name at least one label, or null");
    check(
        p.input.labels.as_ref().is_none_or(|l| !l.contains(&0)),
        "/input/labels",
        "label 0 is the background; name labels from 1 on",
    );
    check((0.0..=10.0).contains(&p.input.smoothing_mm), "/input/smoothing_mm", "must be from 0 to 10 mm");
    check((1..=8).contains(&p.features.len()), "/features", "state from 1 to 8 features");
    for (k, f) in p.features.iter().enumerate() {
        let at = format!("/features/{k}");
        check((1..=8).contains(&f.scales_mm.len()), &format!("{at}/scales_mm"), "state from 1 to 8 scales");
        for (s, scale) in f.scales_mm.iter().enumerate() {
            check((0.0..=100.0).contains(scale), &format!("{at}/scales_mm/{s}"), "must be from 0 to 100 mm");
        }
        check(
            f.radius_mm.is_none_or(|r| r > 0.0 && r <= 100.0),
            &format!("{at}/radius_mm"),
            "must be more than 0, at most 100 mm, or null",
        );
        check(f.weight > 0.0 && f.weight <= 100.0, &format!("{at}/weight"), "must be more than 0, at most 100");
    }
    let e = &p.energy;
    check((0.0..=1000.0).contains(&e.alpha), "/energy/alpha", "must be from 0 to 1000");
    check((0.0..=1000.0).contains(&e.beta), "/energy/beta", "must be from 0 to 1000");
    check(
        e.truncation.is_none_or(|t| t > 0.0 && t <= 60.0),
        "/energy/truncation",
        "must be more than 0, at most 60, or null for the hard constraint",
    );
    check((1..=4).contains(&e.neighborhood_rings), "/energy/neighborhood_rings", "must be from 1 to 4");
    check((0.1..=10.0).contains(&e.minkowski_p), "/energy/minkowski_p", "must be from 0.1 to 10");
    check(e.feature_cap > 0.0 && e.feature_cap <= 100.0, "/energy/feature_cap", "must be more than 0, at most 100");
    let i = &p.inference;
    check(
        i.coarse_vertices.is_none_or(|n| (100..=20_000).contains(&n)),
        "/inference/coarse_vertices",
        "must be from 100 to 20000, or null",
    );
    check((1..=100_000).contains(&i.max_iterations), "/inference/max_iterations", "must be from 1 to 100000");
    check((0.0..1.0).contains(&i.damping), "/inference/damping", "must be from 0 to below 1");
    check((0.0..=1.0).contains(&i.tolerance), "/inference/tolerance", "must be from 0 to 1");
    let a = &i.annealing;
    for (name, value) in [("initial", a.initial_temperature), ("final", a.final_temperature)] {
        check(
            value.is_none_or(|t| t > 0.0 && t <= 1e6),
            &format!("/inference/annealing/{name}_temperature"),
            "must be more than 0, at most 1000000, or null",
        );
    }
    if let (Some(first), Some(last)) = (a.initial_temperature, a.final_temperature) {
        check(last <= first, "/inference/annealing/final_temperature", "must not be above the initial temperature");
    }
    check(i.target_energy.is_none_or(f64::is_finite), "/inference/target_energy", "must be a finite number or null");
    check((1..=10_000).contains(&i.restart_after), "/inference/restart_after", "must be from 1 to 10000");
    check(i.lower_bound_iterations <= 10_000, "/inference/lower_bound_iterations", "must be at most 10000");
    let alone = i.algorithm == Algorithm::None;
    check(
        !alone || p.registration.initial != InitialPose::Ransac,
        "/registration/initial",
        "must not be ransac where inference.algorithm is none: there is no correspondence to draw from",
    );
    check(
        alone || p.registration.initial == InitialPose::Ransac,
        "/registration/initial",
        "must be ransac unless inference.algorithm is none",
    );
    check(
        !alone || p.clamping.mode == ClampingMode::None,
        "/clamping/mode",
        "must be none where inference.algorithm is none: there is no energy to feed back to",
    );
    check(
        !alone || i.lower_bound_iterations == 0,
        "/inference/lower_bound_iterations",
        "must be 0 where inference.algorithm is none: there is no energy to bound",
    );
    check(
        i.update == Update::Sparse || i.schedule == MessageSchedule::Flooding,
        "/inference/schedule",
        "must be flooding unless inference.update is sparse",
    );
    check(matches!(i.message_bits, 16 | 32), "/inference/message_bits", "must be 16 or 32");
    let passes_messages = matches!(i.algorithm, Algorithm::MaxProduct | Algorithm::SumProduct);
    check(
        i.message_bits != 16
            || (passes_messages && i.update != Update::Active && i.schedule == MessageSchedule::Flooding),
        "/inference/message_bits",
        "must be 32 unless inference.algorithm is max_product or sum_product, inference.update sparse or full, and \
         inference.schedule flooding",
    );
    check(p.clamping.max_rounds <= 20, "/clamping/max_rounds", "must be at most 20");
    let r = &p.registration;
    check(
        r.tolerance_mm.is_none_or(|t| t > 0.0 && t <= 1000.0),
        "/registration/tolerance_mm",
        "must be more than 0, at most 1000 mm, or null",
    );
    check((0.0..1.0).contains(&r.confidence), "/registration/confidence", "must be from 0 to below 1");
    check((1..=10_000_000).contains(&r.max_trials), "/registration/max_trials", "must be from 1 to 10 million");
    check(p.landmarks.len() <= 1000, "/landmarks", "state at most 1000 landmarks");
    for (k, landmark) in p.landmarks.iter().enumerate() {
        let within = |point: &[f64; 3]| point.iter().all(|x| x.abs() <= 1e6);
        check(within(&landmark.source_mm), &format!("/landmarks/{k}/source_mm"), "must be within 1000000 mm of 0");
        check(within(&landmark.target_mm), &format!("/landmarks/{k}/target_mm"), "must be within 1000000 mm of 0");
        let sigma = (0.01..=100.0).contains(&landmark.sigma_mm);
        check(sigma, &format!("/landmarks/{k}/sigma_mm"), "must be from 0.01 to 100 mm");
    }
    faults
}
