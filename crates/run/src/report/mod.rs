//! One page per match: the verdict first, both surfaces to rotate with the mouse, and the numbers.
//!
//! The page is one HTML file that loads nothing. Its policy allows only its own script and style, named by their
//! hashes. It contains no file names. The viewer of two meshes is 130 lines of WebGL without a library; the smallest
//! library with such a viewer is larger than the data.

mod plot;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use homolog_contract::result::{Correspondences, InputProvenance, OutlierReason, ResultDocument};
use homolog_contract::result::{WarpDirection, WarpSpace};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Phase, TracePoint};
use nalgebra::{Matrix3, Point3, Vector3};
use plot::energy_plot;
use serde_json::{Value, json};
use std::fmt::Write;

use crate::colors::{Colors, ramp_svg};
use crate::next::next_step;
use crate::page::{Page, escaped};
use crate::warped::{WarpError, warp};

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// Content of a page.
#[derive(Debug, Clone, Copy)]
pub struct ReportInputs<'a> {
    /// The result; its own correspondences are not used.
    pub document: &'a ResultDocument,
    /// The correspondences.
    pub correspondences: &'a Correspondences,
    /// The source surface, to whose vertices the correspondences refer.
    pub source: &'a SurfaceMesh,
    /// The target surface.
    pub target: &'a SurfaceMesh,
    /// The energy trace.
    pub trace: &'a [TracePoint],
}

/// The page as HTML.
///
/// # Errors
/// [`WarpError`] if the correspondences do not belong to these surfaces.
///
/// # Cost
/// Linear in the size of both surfaces; about 100 bytes per vertex.
pub fn write_report(inputs: &ReportInputs<'_>) -> Result<String, WarpError> {
    let view = View::new(inputs)?;
    let body = [verdict(inputs), view.section, numbers(inputs), energy(inputs), provenance(inputs.document)].concat();
    let page = Page {
        title: "homolog: a match of two surfaces",
        heading: "Match of two surfaces",
        style: STYLE,
        script: SCRIPT,
        body: &body,
        data: &view.data,
    };
    Ok(page.html())
}

/// The verdict, its reasons, and points to check.
fn verdict(inputs: &ReportInputs<'_>) -> String {
    let verdict = inputs.document.verdict();
    let class = match verdict.reliable {
        Some(true) => "good",
        Some(false) => "bad",
        None => "open",
    };
    let mut html = format!("<section class=\"verdict {class}\"><strong>{}</strong>", escaped(verdict.headline()));
    if !verdict.reasons.is_empty() {
        html.push_str("<ul>");
        for reason in &verdict.reasons {
            let _ = write!(html, "<li>{}</li>", escaped(reason.meaning()));
        }
        html.push_str("</ul>");
    }
    if !verdict.warnings.is_empty() {
        html.push_str("<p>Warnings:</p><ul>");
        for warning in &verdict.warnings {
            let _ = write!(html, "<li>{}</li>", escaped(warning));
        }
        html.push_str("</ul>");
    }
    let _ = write!(html, "<p><strong>Next:</strong> {}</p>", escaped(&next_step(inputs.document)));
    let _ = write!(html, "<p>{}</p>", escaped(&verdict.distance()));
    let missing = inputs.correspondences.outlier.iter().filter(|&&o| o == OutlierReason::NoCounterpart).count();
    if missing > 0 {
        let n = inputs.correspondences.source.len();
        let _ = write!(html, "<p>{missing} of {n} source vertices have no counterpart on the target.</p>");
    }
    html.push_str("</section>\n");
    html
}

/// The view of both surfaces.
struct View {
    section: String,
    /// Data drawn by the script.
    data: Value,
}

impl View {
    fn new(inputs: &ReportInputs<'_>) -> Result<View, WarpError> {
        let &ReportInputs { document, correspondences, source, target, .. } = inputs;
        let matrix = &document.transform.matrix;
        let bent = warp([source, target], correspondences, matrix, WarpDirection::Forward, WarpSpace::Target)?.mesh;
        let rigid = source.moved(matrix)?;
        let colors = Colors::new(correspondences, &rigid, &bent, target);
        let (center, radius, turn) = frame(target.vertices(), rigid.vertices());
        let data = json!({
            "radius": radius,
            "turn": turn,
            "surfaces": [
                {
                    "points": points(&rigid, &center),
                    "bent": points(&bent, &center),
                    "triangles": triangles(&rigid),
                    "colors": colors.source.map(|bytes| BASE64.encode(bytes)),
                },
                {
                    "points": points(target, &center),
                    "triangles": triangles(target),
                    "colors": colors.target.map(|bytes| BASE64.encode(bytes)),
                },
            ],
        });
        let section = format!(
            "<h2>Surfaces</h2>\n<div class=\"stage\"><canvas id=\"view\" tabindex=\"0\" role=\"img\" aria-label=\"Source and \
             target surface in corresponding colors\"></canvas><span class=\"name left\">source, moved rigidly onto the \
             target</span><span class=\"name right\">target</span></div>\n<div class=\"controls\"><fieldset>\
             <legend>Color:</legend>\
             <label><input type=\"radio\" name=\"color\" checked> correspondence</label>\
             <label><input type=\"radio\" name=\"color\"> confidence</label>\
             <label><input type=\"radio\" name=\"color\"> residual</label></fieldset>\
             <label>Bend the source onto the target <input type=\"range\" id=\"bending\" min=\"0\" max=\"100\" value=\"0\">\
             </label></div>\n<p class=\"legend\" id=\"legend\"><span>Corresponding points have the same color.</span>\
             <span hidden>Confidence: probability of being within one edge of the true point. 0 {ramp} 1</span>\
             <span hidden>Residual: distance to the corresponding point after rigid registration. 0 {ramp} {:.2} mm or \
             more</span> Gray: no counterpart.</p>\n\
             <p class=\"hint\">Drag or use the arrow keys to turn, scroll to zoom.</p>\n",
            colors.largest_residual_mm,
            ramp = ramp_svg(),
        );
        Ok(View { section, data })
    }
}

/// Center, radius and first rotation of the view: the longest axis of the target from left to right, the shortest towards
/// the viewer.
fn frame(target: &[Point3<f64>], source: &[Point3<f64>]) -> (Point3<f64>, f64, Vec<f64>) {
    let n = target.len().max(1) as f64;
    let center = Point3::from(target.iter().map(|p| p.coords).sum::<Vector3<f64>>() / n);
    let scatter: Matrix3<f64> = target.iter().map(|p| (p - center) * (p - center).transpose()).sum();
    let axes = scatter.symmetric_eigen();
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| axes.eigenvalues[b].total_cmp(&axes.eigenvalues[a]));
    let [x, y] = [order[0], order[1]].map(|k| axes.eigenvectors.column(k).into_owned());
    let rows = [x, y, x.cross(&y)];
    let reach = target.iter().chain(source).map(|p| (p - center).norm()).fold(0.0, f64::max);
    (center, reach.max(f64::MIN_POSITIVE), rows.iter().flat_map(|row| row.iter().copied()).collect())
}

/// Positions about `center`, three little-endian numbers of four bytes each, in base64.
fn points(mesh: &SurfaceMesh, center: &Point3<f64>) -> String {
    let numbers = mesh.vertices().iter().flat_map(|p| [p.x - center.x, p.y - center.y, p.z - center.z]);
    BASE64.encode(numbers.flat_map(|x| (x as f32).to_le_bytes()).collect::<Vec<u8>>())
}

/// Corners of all triangles, little-endian, in base64; quads are split.
fn triangles(mesh: &SurfaceMesh) -> String {
    BASE64.encode(mesh.triangles().into_iter().flatten().flat_map(u32::to_le_bytes).collect::<Vec<u8>>())
}

/// A table with a heading for each row.
fn table(rows: &[(&str, String)]) -> String {
    let rows: String =
        rows.iter().map(|(name, value)| format!("<tr><th scope=\"row\">{name}</th><td>{value}</td></tr>")).collect();
    format!("<div class=\"scroll\"><table>{rows}</table></div>\n")
}

/// The transform and the measures of the answer.
fn numbers(inputs: &ReportInputs<'_>) -> String {
    let document = inputs.document;
    let (t, s, d) = (&document.transform, &document.support, &document.surface_distance);
    let [x, y, z] = t.translation_mm;
    let median = inputs.correspondences.median_confidence().unwrap_or(0.0);
    let mut rows = vec![
        ("rotation", format!("{:.2}°", t.rotation_angle_deg)),
        ("translation", format!("{x:.2}, {y:.2}, {z:.2} mm")),
        (
            "surface distance",
            format!("mean {:.3} mm, 95th percentile {:.3} mm, maximum {:.3} mm", d.mean_mm, d.p95_mm, d.max_mm),
        ),
        (
            "inliers of the transform",
            format!("{} ({:.1} %) within {:.2} mm, RMS {:.3} mm", s.inliers, 100.0 * s.ratio, s.tolerance_mm, s.rms_mm),
        ),
        ("median confidence", format!("{median:.2}")),
    ];
    if t.mirrored {
        rows.insert(0, ("mirrored", "yes: a reflection, then this rotation and translation".to_owned()));
    }
    if let Some(similarity) = &t.similarity {
        rows.push(("similarity", similarity.sentence()));
    }
    if let Some(found) = &document.reliability {
        let other = |misfit: Option<f64>| misfit.map_or_else(|| "none".to_owned(), |m| format!("{m:.3}"));
        rows.push((
            "misfit after bending",
            format!(
                "{:.3}; of the best other pose {}, of the best mirror image {} (lower is better)",
                found.misfit,
                other(found.runner_up_misfit),
                other(found.other_handedness_misfit)
            ),
        ));
        rows.push((
            "agreement",
            format!("of curvatures {:.2}, of normals {:.2}", found.curvature_agreement, found.normal_agreement),
        ));
        if let Some(distortion) = found.distortion {
            // The distortion is logarithmic; the stretching of a circle is easier to picture.
            let longer = 100.0 * distortion.exp_m1();
            rows.push(("distortion", format!("small circles become {longer:.0} % longer than wide, on average")));
        }
        rows.push(("residual after bending", format!("{:.3} mm along the normal", found.residual_mm)));
        if let Some(other) = &found.second_opinion {
            let text =
                format!("pose {:.1}° away, corresponding points agree by {:.2} of 1", other.angle_deg, other.agreement);
            rows.push(("the default method", text));
        }
    }
    rows.push((
        "map",
        format!(
            "{:.1} % of neighboring vertices stay neighbors; {:.1} % of target vertices are the nearest one to a \
             corresponding point",
            100.0 * document.topology.consistency,
            100.0 * document.topology.coverage
        ),
    ));
    if let Some(deformation) = &document.deformation {
        rows.push(("deformation", deformation.sentence()));
    }
    let matrix: Vec<String> =
        t.matrix.iter().map(|r| format!("{:>10.5} {:>10.5} {:>10.5} {:>11.4}", r[0], r[1], r[2], r[3])).collect();
    format!(
        "<h2>Numbers</h2>\n{}<p>Rigid transform <code>target_from_source</code>, mm:</p>\n<pre>{}</pre>\n",
        table(&rows),
        matrix.join("\n")
    )
}

/// The energy over the iterations.
fn energy(inputs: &ReportInputs<'_>) -> String {
    let Some(energy) = &inputs.document.energy else {
        return match energy_plot(None, Phase::Displacement, inputs.trace) {
            None => "<h2>Energy</h2>\n<p>This method minimizes no energy.</p>\n".to_owned(),
            Some(plot) => format!(
                "<h2>Energy</h2>\n<p>Of the displacement field: misfit of the surfaces plus the cost of the deformation, for each \
                 independent observation; no unit, lower is better. Each round is one fit: with a wide kernel, with a narrower one as well, \
                 or from the target back to the source. The scale at which the surfaces are compared falls from iteration to \
                 iteration, so the energy can rise.</p>\n{plot}"
            ),
        };
    };
    let minimized = energy.minimized(&inputs.document.rounds);
    format!(
        "<h2>Energy</h2>\n<p>{:.2} where every vertex takes the target vertex that suits it alone, {minimized:.2} after its \
         minimization, {:.2} for the answer, {:.2} for each of its {} variables (the curve has the iterations; conditional modes after the last one lower the energy further); {} target vertices to choose from, no unit, lower is better. The number of iterations is \
         part of the method.</p>\n{}",
        energy.initial,
        energy.r#final,
        energy.per_variable,
        energy.n_variables,
        energy.n_target_vertices,
        energy_plot(Some(energy.initial), Phase::Inference, inputs.trace).unwrap_or_default()
    )
}

/// Inputs, program and parameters: the information needed to compute the answer again.
fn provenance(document: &ResultDocument) -> String {
    let p = &document.provenance;
    let total = document.timings_ms.get("total").copied().unwrap_or(0.0);
    let rows = [
        ("program", format!("homolog {}, commit {}", escaped(&p.version), escaped(&p.commit))),
        ("method", format!("{}, seed {}", p.parameters.method.name(), p.seed)),
        ("time", format!("{:.2} s", total / 1000.0)),
        ("source", input(&p.source)),
        ("target", input(&p.target)),
    ];
    let parameters = serde_json::to_string_pretty(&p.parameters).unwrap_or_default();
    format!(
        "<h2>Provenance</h2>\n{}<details><summary>All parameters</summary><pre>{}</pre></details>\n",
        table(&rows),
        escaped(&parameters)
    )
}

/// One input: its hash, its size, and its changes.
fn input(input: &InputProvenance) -> String {
    let report = &input.report;
    let mut html = format!(
        "{}, {} vertices, {} faces<br><code>{}</code>",
        escaped(report.format.title()),
        input.n_vertices,
        input.n_faces,
        escaped(&input.hash)
    );
    for repair in &report.repairs {
        let _ = write!(html, "<br>{}", escaped(&repair.detail));
    }
    for note in &report.notes {
        let _ = write!(html, "<br>{}", escaped(note));
    }
    html
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::intake::IntakeLimits;
    use crate::page::hash;
    use crate::{InputFile, run_match};
    use homolog_contract::input::{InputWarning, RepairNote};
    use homolog_contract::parameters::{LabelChoice, Repair, resolve};
    use homolog_formats::ply::write_ply;
    use homolog_mesh::shapes::ellipsoid;
    use homolog_primitives::observe::Silent;

    #[test]
    fn the_page_begins_with_the_verdict_and_loads_nothing() {
        let file = write_ply(&ellipsoid(Vector3::new(9.0, 5.0, 3.0), 3));
        let input = InputFile { bytes: &file, name: Some("Doe^Jane.ply") };
        let parameters = resolve(&json!({})).unwrap();
        let output = run_match(input, input, &parameters, &IntakeLimits::default(), &Silent).unwrap();
        let correspondences = output.document.correspondences.as_ref().unwrap();
        let inputs = ReportInputs {
            document: &output.document,
            correspondences,
            source: &output.source,
            target: &output.target,
            trace: &[],
        };
        let page = write_report(&inputs).unwrap();
        let body = page.split_once("</h1>").unwrap().1;
        assert!(body.trim_start().starts_with("<section class=\"verdict"), "{}", &body[..200]);
        assert!(body.contains(&format!("<strong>Next:</strong> {}", escaped(&next_step(&output.document)))));
        assert!(page.contains(output.document.verdict().headline()) && !page.contains("Doe^Jane"));
        for reference in ["http://", "https://", "src=", "href=", "style=", "url(", "@import", "onclick="] {
            assert!(!page.contains(reference), "{reference}");
        }
        // The scripts that run are the ones the policy names.
        let inside = |open: &str, close: &str| {
            let (_, rest) = page.split_once(open).unwrap();
            rest.split_once(close).unwrap().0.to_owned()
        };
        let policy = inside("content=\"default-src 'none';", "\"");
        for (element, directive) in [("script", "script-src"), ("style", "style-src")] {
            let text = inside(&format!("<{element}>"), &format!("</{element}>"));
            assert!(policy.contains(&format!("{directive} '{}'", hash(&text))), "{policy}");
            assert_eq!(page.matches(&format!("<{element}>")).count(), 1);
        }
        let data: serde_json::Value =
            serde_json::from_str(&inside("<script type=\"application/json\" id=\"data\">", "</script>")).unwrap();
        let n = output.source.n_vertices();
        for surface in data["surfaces"].as_array().unwrap() {
            let length = |text: &serde_json::Value| BASE64.decode(text.as_str().unwrap()).unwrap().len();
            assert_eq!(length(&surface["points"]), 12 * n);
            assert_eq!(length(&surface["triangles"]), 12 * output.source.n_faces());
            assert!(surface["colors"].as_array().unwrap().iter().all(|colors| length(colors) == 3 * n));
        }
        // Texts from people and files stay texts: names of labels, messages of readers, warnings, and the program's
        // own.
        let markup = "</script><img src=x onerror=alert(1)>";
        let mut document = output.document.clone();
        let label = LabelChoice::Name(markup.to_owned());
        document.provenance.parameters.input.labels = Some(vec![label]);
        let warning = InputWarning { reason: None, detail: markup.to_owned() };
        document.warn(vec![warning.clone()]);
        document.provenance.version = markup.to_owned();
        document.provenance.commit = markup.to_owned();
        for input in [&mut document.provenance.source, &mut document.provenance.target] {
            input.hash = markup.to_owned();
            input.report.notes.push(markup.to_owned());
            input.report.warnings.push(warning.clone());
            input.report.repairs.push(RepairNote { repair: Repair::Weld, detail: markup.to_owned() });
        }
        let marked = write_report(&ReportInputs { document: &document, ..inputs }).unwrap();
        assert_eq!((marked.matches("</script").count(), marked.matches("<img").count()), (2, 0));
        assert!(marked.matches("&lt;img src=x").count() >= 10, "every text is there");
        let other = Correspondences { triangle: vec![[u32::MAX; 3]; n], ..correspondences.clone() };
        assert_eq!(write_report(&ReportInputs { correspondences: &other, ..inputs }), Err(WarpError::OtherSurfaces));
    }
}
