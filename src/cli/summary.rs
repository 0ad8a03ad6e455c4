//! A result document summarized in a few lines.

use homolog_contract::result::{ResultDocument, StopReason};
use std::fmt::Write;

/// Transform, support, distances, energies and counts.
pub(super) fn summary(result: &ResultDocument) -> String {
    let (t, s, d) = (&result.transform, &result.support, &result.surface_distance);
    let p = &result.provenance;
    let mut text = String::new();
    let _ = writeln!(text, "target_from_source (mm)");
    for row in &t.matrix {
        let _ = writeln!(text, "  {:>10.5} {:>10.5} {:>10.5} {:>11.4}", row[0], row[1], row[2], row[3]);
    }
    let [x, y, z] = t.translation_mm;
    let _ = writeln!(text, "rotation          {:.2}°", t.rotation_angle_deg);
    let _ = writeln!(text, "translation       {x:.2}  {y:.2}  {z:.2} mm");
    let _ = writeln!(
        text,
        "inliers           {} ({:.1} %) within {:.2} mm, RMS {:.3} mm, {} trials",
        s.inliers,
        100.0 * s.ratio,
        s.tolerance_mm,
        s.rms_mm,
        s.trials
    );
    let _ = writeln!(
        text,
        "surface distance  mean {:.3} mm, 95th percentile {:.3} mm, maximum {:.3} mm",
        d.mean_mm, d.p95_mm, d.max_mm
    );
    if let Some(e) = &result.energy {
        let bound = e.lower_bound.map_or_else(String::new, |bound| format!(", lower bound {bound:.2}"));
        let _ = writeln!(
            text,
            "energy            {:.2} (from {:.2}; unary {:.2}, pairwise {:.2}{bound}), {}",
            e.r#final,
            e.initial,
            e.unary,
            e.pairwise,
            match result.stop_reason {
                StopReason::Converged => "converged",
                StopReason::MaxIterations => "iteration limit reached",
                StopReason::TargetReached => "target energy reached",
                StopReason::RegistrationOnly => "not minimized",
            }
        );
    }
    let _ = writeln!(
        text,
        "map               {:.1} % of edges keep their neighborhood, {:.1} % of target vertices covered",
        100.0 * result.topology.consistency,
        100.0 * result.topology.coverage
    );
    let _ = writeln!(text, "variables         {} source vertices", p.source.n_vertices);
    let _ = writeln!(text, "labels            {} target vertices", p.target.n_vertices);
    if let Some(total) = result.timings_ms.get("total") {
        let _ = writeln!(text, "time              {:.2} s", total / 1000.0);
    }
    text.truncate(text.trim_end().len());
    text
}
