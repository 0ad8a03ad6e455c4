//! A result document summarized in a few lines, the verdict first.

use super::words::on_command_line;
use homolog_contract::result::{Correspondences, EnergyDocument, OutlierReason, ResultDocument, StopReason};
use homolog_run::next_step;
use std::fmt::Write;

/// Verdict, transform, support, distances, energies and counts.
pub(super) fn summary(result: &ResultDocument) -> String {
    let (t, s) = (&result.transform, &result.support);
    let p = &result.provenance;
    let mut text = verdict(result);
    let _ = writeln!(text, "\ntarget_from_source (mm)");
    for row in &t.matrix {
        let [a, b, c, d] = row.map(without_sign_of_zero);
        let _ = writeln!(text, "  {a:>10.5} {b:>10.5} {c:>10.5} {d:>11.4}");
    }
    let [x, y, z] = t.translation_mm.map(without_sign_of_zero);
    if t.mirrored {
        let _ = writeln!(text, "mirrored          yes: a reflection, then this rotation and translation");
    }
    let _ = writeln!(text, "rotation          {:.2}°", t.rotation_angle_deg);
    let _ = writeln!(text, "translation       {x:.2}  {y:.2}  {z:.2} mm");
    if let Some(similarity) = &t.similarity {
        let _ = writeln!(text, "similarity        {}", similarity.sentence());
    }
    // Without assignments there are no trials.
    let trials = if s.trials > 0 { format!(", {} trials", s.trials) } else { String::new() };
    let _ = writeln!(
        text,
        "inliers           {} ({:.1} %) within {:.2} mm, RMS {:.3} mm{trials}",
        s.inliers,
        100.0 * s.ratio,
        s.tolerance_mm,
        s.rms_mm
    );
    if let Some(e) = &result.energy {
        let _ = writeln!(text, "energy            {}", energy(result, e));
    }
    let _ = writeln!(
        text,
        "map               {:.1} % of neighboring vertices stay neighbors; {:.1} % of target vertices are the nearest one \
         to a corresponding point",
        100.0 * result.topology.consistency,
        100.0 * result.topology.coverage
    );
    if let Some(precision) = result.correspondences.as_ref().and_then(precision) {
        let _ = writeln!(text, "confidence        {precision}");
    }
    if let Some(deformation) = &result.deformation {
        let _ = writeln!(text, "deformation       {}", deformation.sentence());
    }
    let _ = writeln!(
        text,
        "vertices          {} of the source, {} of the target",
        p.source.n_vertices, p.target.n_vertices
    );
    for (side, input) in [("source", &p.source), ("target", &p.target)] {
        for note in &input.report.notes {
            let _ = writeln!(text, "note on the {side}: {note}");
        }
    }
    if let Some(total) = result.timings_ms.get("total") {
        let _ = writeln!(text, "time              {:.2} s", total / 1000.0);
    }
    text.truncate(text.trim_end().len());
    text
}

/// Whether the answer is reliable, and why not, in words.
fn verdict(result: &ResultDocument) -> String {
    let verdict = result.verdict();
    let mut text = format!("{}\n", verdict.headline());
    for reason in &verdict.reasons {
        let _ = writeln!(text, "  - {}", reason.meaning());
    }
    if result.ambiguous_axes {
        let _ =
            writeln!(text, "  - Two axes of an ellipsoid are nearly equal: the rotation about the third is arbitrary.");
    }
    for warning in &verdict.warnings {
        let _ = writeln!(text, "  warning: {}", on_command_line(warning));
    }
    let _ = writeln!(text, "Next: {}", on_command_line(&next_step(result)));
    let _ = writeln!(text, "{}", verdict.distance());
    if let Some(pairs) = &result.correspondences {
        let missing = pairs.outlier.iter().filter(|&&reason| reason == OutlierReason::NoCounterpart).count();
        if missing > 0 {
            let _ = writeln!(
                text,
                "{missing} of {} source vertices have no counterpart on the target.",
                pairs.source.len()
            );
        }
    }
    text
}

/// Medians of confidence and spread over the source vertices.
fn precision(columns: &Correspondences) -> Option<String> {
    let (confidence, spread) = (columns.median_confidence()?, columns.median_spread_mm()?);
    Some(format!(
        "median {confidence:.2} that a point is within an edge of the truth; median expected error {spread:.2} mm"
    ))
}

/// The energy before and after its minimization, and the energy of the answer where a displacement field changed the
/// assignment.
fn energy(result: &ResultDocument, e: &EnergyDocument) -> String {
    let minimized = e.minimized(&result.rounds);
    let iterations: u32 = result.rounds.iter().map(|round| round.iterations).sum();
    let mut text = format!("{:.2} at the start, {minimized:.2} after minimization", e.initial);
    let _ = match result.rounds.len() {
        0 => Ok(()),
        1 => write!(text, " in {iterations} iterations"),
        n => write!(text, " in {iterations} iterations of {n} rounds"),
    };
    if result.stop_reason == StopReason::TargetReached {
        text.push_str(", the target");
    }
    // Above the minimum, because the map of the answer is also smooth and lies on the surface.
    let _ = write!(text, "; {:.2} for the answer, {:.2} per variable", e.r#final, e.per_variable);
    if let Some(bound) = e.lower_bound {
        let _ = write!(text, "; no assignment is below {bound:.2}");
    }
    text
}

/// Rounded to the shown digits, so that no number is shown as −0.
fn without_sign_of_zero(value: f64) -> f64 {
    if value.abs() < 5e-6 { 0.0 } else { value }
}
