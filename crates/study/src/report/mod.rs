//! One page per study: quality control first, maps and modes to rotate with the mouse, effects, the model, and the
//! methods.
//!
//! The page is one HTML file that loads nothing, like the page of a match (`homolog_run::write_report`). Its policy
//! allows only its own script and style, named by their hashes.

mod demographics;
mod methods;
pub(crate) mod plots;

use crate::error::StudyError;
use crate::findings::{Findings, shape_on_mean};
use crate::folder::Folder;
use crate::measures::measured;
use crate::plan::{Matched, Round, Study};
use crate::quality::most_urgent_first;
use crate::rivals::GroupDecision;
use crate::settings::Measure;
use crate::subjects::SubjectOutcome;
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD as BASE64;
use homolog_contract::result::UnreliableReason;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Observer, checkpoint};
use homolog_run::page::{Page, escaped};
use nalgebra::{Matrix3, Point3, Vector3};
use serde_json::{Value, json};
use std::fmt::Write;

/// Standard deviations from the mean at which a mode is shown.
pub(crate) const MODE_DEVIATIONS: f64 = 2.0;

/// Share of the surface with a p below 0.05.
pub(crate) fn significant_share(p: &[f64], weights: &[f64]) -> f64 {
    // An empty sum is a negative zero.
    p.iter().zip(weights).filter(|(p, _)| **p < 0.05).map(|(_, weight)| weight).sum::<f64>() + 0.0
}

/// Triangles of a surface for the page: indices of corners, 32 bits each, little-endian.
pub(crate) fn triangles(mesh: &SurfaceMesh) -> Vec<u8> {
    mesh.triangles().into_iter().flatten().flat_map(u32::to_le_bytes).collect()
}

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");
/// Caption of the plot of effects.
const FOREST_HINT: &str = "<p class=\"hint\">Hedges' g, the effect over the standard deviation of the residuals, with its 95 % \
     interval.</p>\n";
/// Largest number of pictures of quality control, and of vertices of all of them together.
const MAX_PICTURES: usize = 12;
const MAX_PICTURE_VERTICES: usize = 120_000;
/// Modes on the page.
const SHOWN_MODES: usize = 5;
/// Most maps and modes that are printed, each with a picture.
const PRINTED_FIGURES: usize = 24;
/// Rows of the table of quality control on a screen; print has all.
const SHOWN_SUBJECTS: usize = 200;

/// The page as HTML.
///
/// # Errors
/// Errors of reading records; [`StudyError::Interrupted`].
pub(crate) fn page(
    study: &Study,
    found: &Findings,
    folder: &Folder,
    commit: &str,
    observer: &dyn Observer,
) -> Result<String, StudyError> {
    let view = View::new(study, found, folder, observer)?;
    let body = [
        summary(found),
        quality(study, found, &view.pictures),
        demographics::section(study, found),
        view.section,
        effects(study, found),
        model(found),
        template(found)?,
        consistency(found),
        labels(found),
        methods::text(study, found, commit),
        methods::references(study, found),
    ]
    .concat();
    let all: Vec<usize> = (0..found.subjects.len()).collect();
    let counted = demographics::counted(study, &all);
    let page = Page {
        title: &format!("homolog: a study of {counted}"),
        heading: &format!("Study of {counted}"),
        style: STYLE,
        script: SCRIPT,
        body: &body,
        data: &view.data,
    };
    Ok(page.html())
}

fn summary(found: &Findings) -> String {
    let count = |place: SubjectOutcome| found.subjects.iter().filter(|subject| subject.place == place).count();
    let mut parts = vec![format!("{} in the shape model", count(SubjectOutcome::Model))];
    for (place, words) in [
        (SubjectOutcome::Scored, "compared with it"),
        (SubjectOutcome::Unreliable, "left out because their match is not reliable"),
        (SubjectOutcome::Dropped, "left out by decision"),
        (SubjectOutcome::Failed, "without a match"),
    ] {
        if count(place) > 0 {
            parts.push(format!("{} {words}", count(place)));
        }
    }
    let flagged = found.subjects.iter().filter(|subject| !subject.flags.is_empty()).count();
    format!("<p class=\"summary\">{}. {flagged} to look at.</p>\n", parts.join(", "))
}

/// A table with a header; numeric cells are formatted as numbers.
fn table(header: &[&str], rows: &[Vec<String>], class: &str) -> String {
    let head: String = header.iter().map(|name| format!("<th scope=\"col\">{name}</th>")).collect();
    let cell = |text: &String| {
        let is_number = text.trim_start_matches('−').starts_with(|c: char| c.is_ascii_digit());
        format!("<td{}>{text}</td>", if is_number { " class=\"number\"" } else { "" })
    };
    let rows: String =
        rows.iter().map(|row| format!("<tr>{}</tr>", row.iter().map(cell).collect::<String>())).collect();
    format!("<div class=\"scroll {class}\"><table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table></div>\n")
}

/// A number with a true minus sign.
fn signed(value: f64, digits: usize) -> String {
    format!("{value:.digits$}").replace('-', "−")
}

fn p_value(p: f64) -> String {
    if p < 0.001 { "&lt; 0.001".to_owned() } else { format!("{p:.3}") }
}

/// A reason to doubt a match, with advice specific to studies where there is one.
fn reason_in_words(reason: &str) -> String {
    let words = escaped(&reason.replace('_', " "));
    // Of several structures, the one that is doubted stands before its reason.
    if reason.rsplit(": ").next() == Some(UnreliableReason::OtherHandedness.name()) {
        return format!("{words}: if it lies on the other side than the template, state its side (column side)");
    }
    words
}

/// What the group says about a pose.
fn pose_in_words(structure: Option<&str>, on: &GroupDecision) -> String {
    let GroupDecision { candidates, candidate, marginal, decided, reliable } = *on;
    let of = structure.map_or(String::new(), |name| format!("{}: ", escaped(name)));
    let map = if candidate == 0 { "that of its match".to_owned() } else { format!("rival {candidate}") };
    let verb = if decided { "decided" } else { "not decided" };
    format!(
        "{of}pose {verb} by {reliable} reliable subjects: {map} of {candidates} poses has probability {marginal:.3}"
    )
}

/// The table of quality control, the most urgent first.
fn quality(study: &Study, found: &Findings, pictures: &[(usize, usize)]) -> String {
    let mut rows = String::new();
    let order = most_urgent_first(&found.subjects);
    for (place, &k) in order.iter().enumerate() {
        let subject = &found.subjects[k];
        let class = match (subject.place, subject.flags.is_empty()) {
            (SubjectOutcome::Failed | SubjectOutcome::Unreliable, _) => "bad",
            (_, false) => "open",
            _ => "good",
        };
        let more = if place < SHOWN_SUBJECTS { "" } else { " more" };
        let picture = pictures.iter().find(|(of, _)| *of == k).map_or(String::new(), |(_, shape)| {
            format!("<canvas data-shape=\"{shape}\" role=\"img\" aria-label=\"the shape of this subject\"></canvas>")
        });
        let mut why: Vec<String> = subject.flags.iter().map(|flag| flag.title().to_owned()).collect();
        why.extend(subject.facts.reasons.iter().map(|reason| reason_in_words(reason)));
        why.extend(subject.facts.error.iter().map(|error| escaped(error)));
        why.extend(subject.group_decisions().map(|(structure, on)| pose_in_words(structure, on)));
        if let Some(decision) = &subject.decision {
            why.push(format!("decided: {}", escaped(&decision.reason)));
        }
        let number =
            |value: Option<f64>, digits: usize| value.map_or(String::new(), |value| format!("{value:.digits$}"));
        let is_matched = subject.place != SubjectOutcome::Failed;
        let _ = write!(
            rows,
            "<tr class=\"{class}{more}\"><td>{}</td><td>{picture}</td><td>{}</td><td>{}</td><td class=\"number\">{}</td>\
             <td class=\"number\">{}</td><td class=\"number\">{}</td></tr>",
            escaped(&study.cohort.subjects[k].id),
            subject.place.name(),
            why.join("<br>"),
            number(is_matched.then_some(subject.facts.residual_mm), 3),
            number(is_matched.then_some(100.0 * subject.facts.folded), 2),
            number(subject.unusual_p, 3),
        );
    }
    let more = order.len().saturating_sub(SHOWN_SUBJECTS);
    let more = if more > 0 {
        format!("<p class=\"hint screen\">{more} more in print and in quality.csv.</p>")
    } else {
        String::new()
    };
    format!(
        "<h2>Quality control</h2>\n<p class=\"hint\">The most urgent first. Residual: mean distance from the subject's surface to the \
         template deformed onto it. Flipped: share of triangles that the map turns over. Unusual: share of subjects \
         whose shape is at least as unusual to a model of the others. Pictures: displacement from the mean along its normal, red \
         outwards, each in a scale of its own.</p>\n\
         <p class=\"hint screen\">To leave a subject out, or to keep one whose match is not reliable, write its id, dropped or kept, and \
         why into decisions.csv, and run the study again.</p>\n\
         <div class=\"scroll\"><table><thead><tr><th scope=\"col\">subject</th><th scope=\"col\">shape</th>\
         <th scope=\"col\">role</th><th scope=\"col\">flags</th><th scope=\"col\">residual, mm</th>\
         <th scope=\"col\">flipped triangles, %</th><th scope=\"col\">unusual, p</th></tr></thead><tbody>{rows}</tbody></table></div>\n{more}"
    )
}

/// The view of maps, modes and subjects.
struct View {
    section: String,
    data: Value,
    /// Subjects with a picture, and their places among the shapes.
    pictures: Vec<(usize, usize)>,
}

fn base64(numbers: impl Iterator<Item = f64>) -> String {
    BASE64.encode(numbers.flat_map(|x| (x as f32).to_le_bytes()).collect::<Vec<u8>>())
}

/// Values from −127 to 127, and the value represented by 127: the 99th percentile of their magnitudes.
fn scaled(values: &[f64]) -> (String, f64) {
    let mut sizes: Vec<f64> = values.iter().map(|x| x.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    let largest = sizes.get(sizes.len() * 99 / 100).copied().unwrap_or(0.0).max(f64::MIN_POSITIVE);
    let bytes = values.iter().map(|x| ((x / largest).clamp(-1.0, 1.0) * 127.0).round() as i8 as u8);
    (BASE64.encode(bytes.collect::<Vec<u8>>()), largest)
}

impl View {
    fn new(study: &Study, found: &Findings, folder: &Folder, observer: &dyn Observer) -> Result<View, StudyError> {
        let mean = &found.mean;
        let (center, radius, turn) = frame(mean.vertices());
        let flat = |points: &[Point3<f64>]| base64(points.iter().flat_map(|p| <[f64; 3]>::from(p - center)));
        let mut maps: Vec<Value> = Vec::new();
        let mut map_options = String::new();
        for map in found.statistics.iter().flat_map(|statistics| &statistics.maps) {
            checkpoint(observer)?;
            let contrast = found.statistics.as_ref().map(|s| &s.design.contrasts[map.contrast]);
            let (values, largest) = scaled(map.effect());
            let significant: Vec<u8> = map.p_local().iter().map(|&p| u8::from(p < 0.05)).collect();
            let title = format!("{}: {}", contrast.map_or("", |c| &c.name), map.measure.title());
            let _ = write!(map_options, "<option value=\"{}\">{}</option>", maps.len(), escaped(&title));
            maps.push(json!({
                "legend": title, "largest": largest, "values": values, "significant": BASE64.encode(significant),
            }));
        }
        if maps.is_empty() {
            // Without an effect: the variation of the group along the normal.
            let normals = mean.vertex_normals();
            let spread: Vec<f64> = (0..mean.n_vertices())
                .map(|v| {
                    let along = found.model.modes.iter().zip(&found.model.variances);
                    along.map(|(mode, variance)| variance * mode[v].dot(&normals[v]).powi(2)).sum::<f64>().sqrt()
                })
                .collect();
            let (values, largest) = scaled(&spread);
            let title = "standard deviation along the normal, mm";
            let _ = write!(map_options, "<option value=\"0\">{title}</option>");
            let all = BASE64.encode(vec![1u8; mean.n_vertices()]);
            maps.push(json!({"legend": title, "largest": largest, "values": values, "significant": all}));
        }
        let (mut shapes, mut shape_options) = (Vec::new(), String::new());
        for mode in 0..found.model.modes.len().min(SHOWN_MODES) {
            let length = MODE_DEVIATIONS * found.model.variances[mode].sqrt();
            let normals = mean.vertex_normals();
            let vectors = &found.model.modes[mode];
            let along: Vec<f64> = vectors.iter().zip(&normals).map(|(d, n)| length * d.dot(n)).collect();
            let share = 100.0 * found.model.variances[mode] / found.model.variances.iter().sum::<f64>();
            let title = format!("mode {}, {share:.1} % of the variance", mode + 1);
            let _ = write!(shape_options, "<option value=\"{}\">{title}</option>", shapes.len());
            let moves = base64(vectors.iter().flat_map(|d| <[f64; 3]>::from(*d * length)));
            let (values, largest) = scaled(&along);
            let legend =
                format!("{title}, at +{MODE_DEVIATIONS} standard deviations: displacement along the normal, mm");
            shapes.push(json!({"title": title, "legend": legend, "largest": largest, "values": values, "move": moves}));
        }
        let mut pictures = Vec::new();
        let most = (MAX_PICTURE_VERTICES / mean.n_vertices().max(1)).clamp(1, MAX_PICTURES);
        for k in most_urgent_first(&found.subjects) {
            if pictures.len() == most {
                break;
            }
            if found.subjects[k].place == SubjectOutcome::Failed {
                continue;
            }
            let own = shape_on_mean(study, &found.matched, folder, &found.alignment, k)?;
            let surface = mean.with_vertices(own.clone())?;
            let along = measured(Measure::NormalDisplacement, mean, &surface, observer)?.unwrap_or_default();
            let title = format!("subject {}", study.cohort.subjects[k].id);
            let _ = write!(shape_options, "<option value=\"{}\">{}</option>", shapes.len(), escaped(&title));
            pictures.push((k, shapes.len()));
            let (values, largest) = scaled(&along);
            let legend = format!("{title}: displacement from the mean along the normal, mm");
            let points = flat(&own);
            shapes.push(
                json!({"title": title, "legend": legend, "largest": largest, "values": values, "points": points}),
            );
        }
        let n_figures = maps.len() + found.model.modes.len().min(SHOWN_MODES);
        let more = n_figures.saturating_sub(PRINTED_FIGURES);
        let more = if more > 0 { format!(" {more} more are in the folder, maps and modes.") } else { String::new() };
        let data = json!({
            "radius": radius, "turn": turn, "points": flat(mean.vertices()), "triangles": BASE64.encode(triangles(mean)),
            "maps": maps, "shapes": shapes, "printed": PRINTED_FIGURES,
        });
        let section = format!(
            "<h2>Maps and modes</h2>\n<div class=\"stage\"><canvas id=\"view\" tabindex=\"0\" role=\"img\" aria-label=\"The mean \
             surface with a map, and a mode or a subject\"></canvas><span class=\"name left\">mean</span>\
             <span class=\"name right\" id=\"right\"></span></div>\n<div class=\"controls\"><div>\
             <select id=\"map\" aria-label=\"Map\">{map_options}</select>\
             <label><input type=\"checkbox\" id=\"only\"> only significant vertices</label></div><div>\
             <select id=\"shape\" aria-label=\"Mode or subject\">{shape_options}</select>\
             <label>−2 sd <input type=\"range\" id=\"along\" min=\"-50\" max=\"50\" value=\"50\"> +2 sd</label></div></div>\n\
             <p class=\"colors screen\"><span id=\"low\"></span><span class=\"bar\" id=\"bar\"></span><span id=\"high\"></span> \
             <span id=\"legend\"></span></p>\n\
             <p class=\"colors screen\"><span id=\"right-low\"></span><span class=\"bar\" id=\"right-bar\"></span>\
             <span id=\"right-high\"></span> <span id=\"right-legend\"></span></p>\n\
             <p class=\"save\" id=\"save\"></p>\n\
             <p class=\"hint printed\">Each map and mode on the mean surface, from both sides; the bar ends at the 99th percentile.{more}</p>\n\
             <div class=\"printed figures\" id=\"figures\"></div>\n\
             <p class=\"hint screen\">Drag or use the arrow keys to turn, scroll to zoom. Red is outwards, blue inwards, of modes and \
             subjects along the normal of the mean. Pictures are saved as they are shown; the surfaces with all maps are in the folder, \
             maps/*.vtk and maps/*.shape.gii over mean.surf.gii.</p>\n"
        );
        Ok(View { section, data, pictures })
    }
}

/// Center, radius and first rotation of the view: the longest axis from left to right, the shortest towards the viewer.
fn frame(points: &[Point3<f64>]) -> (Point3<f64>, f64, Vec<f64>) {
    let n = points.len().max(1) as f64;
    let center = Point3::from(points.iter().map(|p| p.coords).sum::<Vector3<f64>>() / n);
    let scatter: Matrix3<f64> = points.iter().map(|p| (p - center) * (p - center).transpose()).sum();
    let axes = scatter.symmetric_eigen();
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| axes.eigenvalues[b].total_cmp(&axes.eigenvalues[a]));
    let [x, y] = [order[0], order[1]].map(|k| axes.eigenvectors.column(k).into_owned());
    let rows = [x, y, x.cross(&y)];
    let reach = points.iter().map(|p| (p - center).norm()).fold(0.0, f64::max);
    (center, reach.max(f64::MIN_POSITIVE), rows.iter().flat_map(|row| row.iter().copied()).collect())
}

fn effects(study: &Study, found: &Findings) -> String {
    let Some(statistics) = &found.statistics else {
        return "<h2>Effects</h2>\n<p>No effect was asked for (<code>--effect</code>).</p>\n".to_owned();
    };
    let mut html = format!("<h2>Effects at vertices</h2>\n{}", demographics::degrees(study, found));
    let named: Vec<Vec<String>> = statistics
        .design
        .contrasts
        .iter()
        .map(|contrast| vec![escaped(&contrast.name), escaped(&contrast.meaning)])
        .collect();
    html.push_str(&table(&["contrast", "what it compares"], &named, "free"));
    let weights = &found.alignment.weights;
    let rows: Vec<Vec<String>> = statistics
        .maps
        .iter()
        .map(|map| {
            let p = map.p_corrected();
            let best = (0..p.len()).fold(0, |best, v| {
                let key = |v: usize| (p[v], -map.effect()[v].abs());
                if key(v) < key(best) { v } else { best }
            });
            let mut row = vec![
                escaped(&statistics.design.contrasts[map.contrast].name),
                map.measure.title().to_owned(),
                p.get(best).map_or(String::new(), |p| p_value(*p)),
                format!("{:.1} %", 100.0 * significant_share(&map.p_local(), weights)),
                map.effect().get(best).map_or(String::new(), |effect| signed(*effect, 3)),
            ];
            // Of visits the corrected value is q itself, and g is not defined.
            if let Some((linear, _)) = &map.linear {
                row.push(signed(linear.g[best], 2));
                row.extend([p, map.q.as_slice()].map(|p| format!("{:.1} %", 100.0 * significant_share(p, weights))));
            }
            row
        })
        .collect();
    let corrected = if statistics.longitudinal { "smallest q (FDR)" } else { "smallest p (TFCE, FWE)" };
    let mut header = vec!["contrast", "measure", corrected, "of the surface significant", "effect there"];
    if !statistics.longitudinal {
        header.extend(["g there", "p below 0.05", "q (FDR) below 0.05"]);
    }
    html.push_str(&table(&header, &rows, "free"));
    let (there, both) = match statistics.longitudinal {
        true => ("Effect there", "q is"),
        false => ("Effect and g there", "both the corrected p and q are"),
    };
    let _ = writeln!(
        html,
        "<p class=\"hint\">Of the surface significant: share of the area where {both} below 0.05. {there}: where that value is \
         smallest, and of equal ones where the effect is largest.</p>"
    );
    for measure in &statistics.left_out {
        let _ = write!(html, "<p class=\"hint\">{} is not meaningful here: a surface is open.</p>", measure.name());
    }
    if !statistics.design.incomplete.is_empty() {
        let n = statistics.design.incomplete.len();
        let _ =
            write!(html, "<p class=\"hint\">{n} subjects with a missing covariate are not part of the statistics.</p>");
    }
    if !statistics.whole.is_empty() {
        html.push_str("<h2>Effects in whole subjects</h2>\n");
        html.push_str(&plots::forest(&statistics.whole));
        html.push_str(FOREST_HINT);
        let rows: Vec<Vec<String>> = statistics
            .whole
            .iter()
            .map(|whole| {
                let effect = &whole.effect;
                let range =
                    |ends: [f64; 2], digits| format!("{} to {}", signed(ends[0], digits), signed(ends[1], digits));
                vec![
                    escaped(&whole.variable),
                    escaped(&whole.contrast),
                    signed(effect.value, 2),
                    range(effect.interval, 2),
                    p_value(effect.p),
                    signed(effect.g, 2),
                    range(effect.g_interval, 2),
                ]
            })
            .collect();
        html.push_str(&table(
            &["variable", "contrast", "effect", "95 % interval", "p", "g", "95 % interval"],
            &rows,
            "free",
        ));
    }
    if !statistics.planning.is_empty() {
        let rows: Vec<Vec<String>> = statistics
            .planning
            .iter()
            .map(|plan| {
                let n = plan.subjects.map_or("more than 100,000".to_owned(), |n| n.to_string());
                vec![escaped(&plan.contrast), format!("{:.1}", plan.d), n]
            })
            .collect();
        html.push_str("<h2>Planning</h2>\n<p class=\"hint\">Subjects, in the proportions of this study, with which one test at 0.05 \
             finds a true difference of d standard deviations in 80 % of studies.</p>\n");
        html.push_str(&table(&["contrast", "d", "subjects"], &rows, "free"));
    }
    html
}

fn model(found: &Findings) -> String {
    let quality = &found.model.quality;
    let rows: Vec<Vec<String>> = (0..found.model.modes.len().min(12))
        .map(|k| {
            vec![
                (k + 1).to_string(),
                format!("{:.1} %", 100.0 * quality.compactness[k]),
                format!("{:.3}", quality.generalization_mm[k]),
                format!("{:.3}", quality.specificity_mm[k]),
            ]
        })
        .collect();
    format!(
        "<h2>Shape model</h2>\n<p class=\"hint\">Compactness: variance that the first modes explain. Generalization: distance of a \
         subject from the nearest shape of a model of the others. Specificity: distance of a random shape of the model from the \
         nearest subject. Distances are root mean squares over the surface.</p>\n{}{}",
        plots::model(quality),
        table(&["modes", "compactness", "generalization, mm", "specificity, mm"], &rows, "free")
    )
}

fn template(found: &Findings) -> Result<String, StudyError> {
    let Matched { making, .. } = &found.matched;
    let whole = &making.template.mesh;
    let structures = found.complex.iter().flat_map(|complex| &complex.structures);
    let mut html = "<h2>Template</h2>\n".to_owned();
    if found.complex.is_none() {
        html.push_str(&template_of("", whole, &making.rounds));
    }
    for structure in structures {
        let name = format!("{}: ", escaped(&structure.name));
        html.push_str(&template_of(&name, &structure.of(whole)?, &structure.rounds));
    }
    Ok(html)
}

/// A template and its rounds; `name` begins the text.
fn template_of(name: &str, mesh: &SurfaceMesh, rounds: &[Round]) -> String {
    let mut html = format!(
        "<p>{name}{} vertices, mean edge {:.2} mm, {}.</p>\n",
        mesh.n_vertices(),
        mesh.mean_edge_length(),
        if rounds.is_empty() { "given" } else { "made from the group" }
    );
    if !rounds.is_empty() {
        let rows: Vec<Vec<String>> = rounds
            .iter()
            .enumerate()
            .map(|(k, round)| {
                vec![
                    (k + 1).to_string(),
                    round.subjects.to_string(),
                    format!("{:.3}", round.moved_mm),
                    format!("{:.3}", round.moved_share),
                    format!("{:.3}", round.slid_mm),
                    format!("{:.0} %", 100.0 * round.put_back),
                    format!("{:.2}", round.triangle_quality[0]),
                    format!("{:.2}", round.triangle_quality[1]),
                    format!("{:.0}", round.volume_mm3),
                ]
            })
            .collect();
        let header = [
            "round",
            "subjects",
            "surface moved, mm",
            "in mean edges",
            "vertices slid, mm",
            "drift reverted",
            "triangle quality",
            "5th percentile",
            "volume, mm³",
        ];
        html.push_str(&table(&header, &rows, "free"));
        html.push_str(
            "<p class=\"hint\">Moved: distance of the mean from the template before, as surfaces, root mean square over both. Vertices \
             also drift along the surface; this drift is reverted where that does not change the shape. Triangle quality: 1 for equilateral \
             triangles.</p>\n",
        );
    }
    html
}

fn consistency(found: &Findings) -> String {
    let Some(found) = &found.consistency else { return String::new() };
    let row = |name: &str, d: &crate::consistency::Distances| {
        vec![name.to_owned(), format!("{:.2}", d.mean_mm), format!("{:.2}", d.median_mm), format!("{:.2}", d.p95_mm)]
    };
    let n = found.ring.len();
    let rows = [
        row("subject → template → subject, two independent matches", &found.template_and_back),
        row("subject → subject → back, two independent matches", &found.pair_and_back),
        row(&format!("around a ring of {n} subjects, pair maps alone"), &found.ring_by_pairs),
        row(&format!("around the ring of {n}, through the template"), &found.ring_through_template),
        row("from pair maps to maps through the template", &found.pair_to_template),
    ];
    let header = ["cycle error", "mean, mm", "median, mm", "95th percentile, mm"];
    let mut html = format!("<h2>Consistency over the group</h2>\n{}", table(&header, &rows, "free"));
    if !found.decided.is_empty() {
        let (n, s) = (found.decided.len(), if found.decided.len() == 1 { "" } else { "s" });
        html.push_str(&format!(
            "<p class=\"hint\">Without {n} subject{s} whose pose the group decided, in the first and the last row: matches leave it \
             open.</p>\n"
        ));
    }
    html
}

fn labels(found: &Findings) -> String {
    let Some(labels) = &found.labels else { return String::new() };
    let rows: Vec<Vec<String>> = labels
        .labels
        .iter()
        .enumerate()
        .map(|(at, label)| {
            let mut dice: Vec<f64> = labels.dice.iter().filter_map(|(_, dice)| dice[at]).collect();
            dice.sort_by(f64::total_cmp);
            let mean = dice.iter().sum::<f64>() / dice.len().max(1) as f64;
            let least = dice.first().map_or(String::new(), |d| format!("{d:.3}"));
            vec![label.to_string(), dice.len().to_string(), format!("{mean:.3}"), least]
        })
        .collect();
    let whose = if labels.of_template {
        "The labels are those of the given template."
    } else {
        "The label of each vertex is that of most subjects. Dice: subjects of one half get labels that those of the other half \
         voted for."
    };
    format!(
        "<h2>Labels</h2>\n<p class=\"hint\">{whose}</p>\n{}",
        table(&["label", "subjects with labels", "mean Dice", "least Dice"], &rows, "free")
    )
}
