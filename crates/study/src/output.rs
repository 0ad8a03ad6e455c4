//! The folder of results: surfaces, maps, tables, the report, and `study.json`, from which the study can be computed
//! again.

use crate::cohort::{Cohort, Subject, Values};
use crate::error::StudyError;
use crate::findings::{Findings, shape_on_mean, volume_of};
use crate::folder::{Decision, Folder, decisions_table, json};
use crate::labels::carried;
use crate::matching::{Interruption, StudyObserver};
use crate::plan::{Round, Study};
use crate::quality::most_urgent_first;
use crate::report::{MODE_DEVIATIONS, page, plots, significant_share};
use crate::rivals::GroupDecision;
use crate::settings::{Measure, Settings, Visits};
use crate::subjects::{SubjectFindings, SubjectOutcome};
use homolog_contract::parameters::LabelChoice;
use homolog_formats::csv_cell::text_cell;
use homolog_formats::gifti::{write_gifti, write_gifti_shape};
use homolog_formats::nifti::write_nifti_gz;
use homolog_formats::parquet::{TableColumn, write_parquet_columns};
use homolog_formats::vtk::{write_vtk, write_vtk_with};
use homolog_formats::{VertexArray, VertexValues};
use homolog_mesh::volume::LabelVolume;
use homolog_primitives::observe::{Observer, checkpoint};
use homolog_run::plot::standalone;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::fmt::Write as _;

/// Number of modes written as surfaces.
const WRITTEN_MODES: usize = 5;
/// Number of scores in the tables.
const WRITTEN_SCORES: usize = 20;
/// `study.json`: the information needed to compute the study again, and its main figures.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StudyDocument {
    /// Version of this document.
    pub format: u32,
    /// Version of homolog.
    pub version: String,
    /// Commit of the build.
    pub commit: String,
    /// The subjects and their covariates.
    pub cohort: Cohort,
    /// Hash (BLAKE3) of each subject's file.
    pub hashes: Vec<String>,
    /// The settings.
    pub settings: Settings,
    /// The decisions.
    pub decisions: Vec<Decision>,
    /// Hash of the template.
    pub template: String,
    /// The rounds in which it was made.
    pub rounds: Vec<Round>,
    /// Main figures; written only.
    #[serde(default)]
    pub found: serde_json::Value,
}

/// The version of [`StudyDocument`] that this program reads and writes.
pub const FORMAT: u32 = 1;

/// The study document in a folder or a file.
///
/// # Errors
/// The fault and its remedy.
pub fn read_document(text: &[u8]) -> Result<StudyDocument, String> {
    let document: StudyDocument =
        serde_json::from_slice(text).map_err(|error| format!("it is no study.json of this program: {error}"))?;
    if document.format != FORMAT {
        return Err(format!("it has format {}; this program reads {FORMAT}", document.format));
    }
    Ok(document)
}

/// Writes all findings. Outdated files of earlier computations are removed.
///
/// # Errors
/// [`StudyError::File`], [`StudyError::Interrupted`], and errors of reading records.
pub fn write(
    study: &Study,
    found: &Findings,
    decisions: &[Decision],
    folder: &Folder,
    commit: &str,
    watcher: &dyn StudyObserver,
) -> Result<(), StudyError> {
    let observer = &Interruption(watcher);
    watcher.progress("writing", 0, 1);
    let mut written = Written { folder, names: BTreeSet::new() };
    let mesh = &found.matched.making.template.mesh;
    let of_vertex = found.labels.as_ref().map(|labels| {
        let values = labels.of_vertex.iter().map(|label| label.unwrap_or(0) as i32).collect();
        VertexArray { name: "label", values: VertexValues::Int(values) }
    });
    let label_arrays: Vec<VertexArray> = of_vertex.iter().cloned().collect();
    folder.write("template/template.surf.gii", &write_gifti(mesh, &label_arrays))?;
    folder.write("template/template.vtk", &write_vtk_with(mesh, &label_arrays))?;
    folder.write("mean.surf.gii", &write_gifti(&found.mean, &label_arrays))?;
    folder.write("mean.vtk", &write_vtk_with(&found.mean, &label_arrays))?;
    for mode in 0..found.model.modes.len().min(WRITTEN_MODES) {
        checkpoint(observer)?;
        for (word, sign) in [("minus", -1.0), ("plus", 1.0)] {
            let points = found.model.along(&found.alignment.mean, mode, sign * MODE_DEVIATIONS);
            let surface = found.mean.with_vertices(points)?;
            let name = format!("modes/mode-{}-{word}-2sd", mode + 1);
            written.file(&format!("{name}.surf.gii"), &write_gifti(&surface, &[]))?;
            written.file(&format!("{name}.vtk"), &write_vtk(&surface))?;
        }
    }
    written.finish("modes");
    surfaces(study, found, &mut written, of_vertex.as_ref(), observer)?;
    maps(found, &mut written, observer)?;
    folder.write("model.csv", model_table(found).as_bytes())?;
    folder.write("quality.csv", quality_table(study, found).as_bytes())?;
    let columns = subject_columns(study, found);
    folder.write("subjects.csv", csv_table(&columns).as_bytes())?;
    folder.write("subjects.parquet", &write_parquet_columns(&columns))?;
    folder.write("effects.csv", effect_table(found).as_bytes())?;
    written.file("figures/model.svg", standalone(&plots::model(&found.model.quality)).as_bytes())?;
    if let Some(statistics) = found.statistics.as_ref().filter(|statistics| !statistics.whole.is_empty()) {
        written.file("figures/effects.svg", standalone(&plots::forest(&statistics.whole)).as_bytes())?;
    }
    written.finish("figures");
    if folder.read("decisions.csv")?.is_none() {
        folder.write("decisions.csv", decisions_table(&[]).as_bytes())?;
    }
    folder.write("report.html", page(study, found, folder, commit, observer)?.as_bytes())?;
    // Of several structures the rows are stated, not the persons that are made of them.
    let (cohort, hashes, settings) = match &found.complex {
        None => (&study.cohort, &study.hashes, &study.settings),
        Some(complex) => (&complex.rows, &complex.hashes, &complex.settings),
    };
    let document = StudyDocument {
        format: FORMAT,
        version: env!("CARGO_PKG_VERSION").to_owned(),
        commit: commit.to_owned(),
        cohort: cohort.clone(),
        hashes: hashes.clone(),
        settings: settings.clone(),
        decisions: decisions.to_vec(),
        template: found.matched.making.template.hash.clone(),
        rounds: found.matched.making.rounds.clone(),
        found: figures(study, found),
    };
    // Written last: its presence means that all files are complete.
    folder.write("study.json", &json(&document))
}

/// Files of the output folders that were written in this run.
struct Written<'a> {
    folder: &'a Folder,
    names: BTreeSet<String>,
}

impl Written<'_> {
    fn file(&mut self, name: &str, bytes: &[u8]) -> Result<(), StudyError> {
        self.names.insert(name.to_owned());
        self.folder.write(name, bytes)
    }

    /// Removes the files of a folder that were not written in this run.
    fn finish(&self, part: &str) {
        let names = self.names.iter().filter_map(|name| name.strip_prefix(part)?.strip_prefix('/')).map(str::to_owned);
        self.folder.keep_only(part, &names.collect());
    }
}

fn real(name: &'static str, values: Vec<f64>) -> VertexArray {
    VertexArray { name, values: VertexValues::Real(values) }
}

/// The template deformed onto every subject, and label volumes.
fn surfaces(
    study: &Study,
    found: &Findings,
    written: &mut Written<'_>,
    label: Option<&VertexArray>,
    observer: &dyn Observer,
) -> Result<(), StudyError> {
    let folder = written.folder;
    let mesh = &found.matched.making.template.mesh;
    let usable: Vec<usize> =
        (0..found.subjects.len()).filter(|&k| found.subjects[k].place != SubjectOutcome::Failed).collect();
    let made: Vec<Vec<String>> = usable
        .par_iter()
        .map(|&k| {
            checkpoint(observer)?;
            let id = &study.cohort.subjects[k].id;
            let own = crate::plan::Records::get(folder, &found.matched.keys[k])?;
            let own = crate::align::points(&own.map(|record| record.points).unwrap_or_default());
            let aligned =
                found.mean.with_vertices(shape_on_mean(study, &found.matched, folder, &found.alignment, k)?)?;
            let mut arrays = Vec::new();
            for (measure, name) in
                [(Measure::NormalDisplacement, "normal_displacement"), (Measure::LogArea, "log_area")]
            {
                let values = crate::measures::measured(measure, &found.mean, &aligned, observer)?;
                arrays.extend(values.map(|values| real(name, values)));
            }
            arrays.extend(label.cloned());
            let bent = crate::mirror::deformed_template(mesh, own, study.is_mirrored(k))?;
            let mut names = vec![format!("subjects/{id}.surf.gii"), format!("subjects/{id}.vtk")];
            folder.write(&names[0], &write_gifti(&bent, &arrays))?;
            folder.write(&names[1], &write_vtk_with(&bent, &arrays))?;
            if let Some(labels) = &found.labels
                && let Some((volume, structure)) = volume_of(study, folder, k)?
            {
                let values = carried(&volume, &structure, &bent, &labels.of_vertex, observer)?;
                if let Ok(volume) = LabelVolume::new(volume.dims(), values, *volume.affine()) {
                    let name = format!("labels/{id}.nii.gz");
                    folder.write(&name, &write_nifti_gz(&volume))?;
                    names.push(name);
                }
            }
            Ok(names)
        })
        .collect::<Result<_, StudyError>>()?;
    written.names.extend(made.into_iter().flatten());
    written.finish("subjects");
    written.finish("labels");
    Ok(())
}

/// The maps of statistics.
fn maps(found: &Findings, written: &mut Written<'_>, observer: &dyn Observer) -> Result<(), StudyError> {
    for map in found.statistics.iter().flat_map(|statistics| &statistics.maps) {
        checkpoint(observer)?;
        let contrast =
            &found.statistics.as_ref().map_or(String::new(), |s| s.design.contrasts[map.contrast].name.clone());
        let mut arrays = Vec::new();
        if let Some((linear, permuted)) = &map.linear {
            arrays.extend([
                real("effect", linear.effect.clone()),
                real("robust_se", linear.robust_se.clone()),
                real("robust_t", linear.robust_t.clone()),
                real("robust_p", linear.robust_p.clone()),
                real("q_fdr", map.q.clone()),
                real("hedges_g", linear.g.clone()),
                real("t", permuted.t.clone()),
                real("p_permutation", permuted.p.clone()),
                real("p_fwe", permuted.p_fwe.clone()),
                real("tfce", permuted.tfce.clone()),
                real("p_tfce_fwe", permuted.p_tfce.clone()),
                real("p_local", map.p_local()),
            ]);
        }
        if let Some(mixed) = &map.mixed {
            arrays.extend([
                real("effect", mixed.effect.clone()),
                real("se", mixed.se.clone()),
                real("z", mixed.z.clone()),
                real("p", mixed.p.clone()),
                real("q_fdr", map.q.clone()),
                real("between_subjects", mixed.between.clone()),
            ]);
        }
        let name = format!("maps/{}.{contrast}", map.measure.name());
        written.file(&format!("{name}.shape.gii"), &write_gifti_shape(&arrays))?;
        written.file(&format!("{name}.vtk"), &write_vtk_with(&found.mean, &arrays))?;
    }
    written.finish("maps");
    Ok(())
}

/// A table with a row for each subject.
fn subject_columns(study: &Study, found: &Findings) -> Vec<(String, TableColumn)> {
    let Cohort { subjects, covariates } = &study.cohort;
    let of = &found.subjects;
    let text = |values: Vec<String>| TableColumn::Text(values);
    let number = |value: &dyn Fn(usize) -> Option<f64>| {
        TableColumn::Real((0..of.len()).map(|k| value(k).unwrap_or(f64::NAN)).collect())
    };
    let mut columns = vec![
        ("id".to_owned(), text(subjects.iter().map(|subject| subject.id.clone()).collect())),
        ("subject".to_owned(), text(subjects.iter().map(|subject| subject.subject.clone()).collect())),
        ("place".to_owned(), text(of.iter().map(|s| s.place.name().to_owned()).collect())),
    ];
    if subjects.iter().any(|subject| subject.labels.is_some()) {
        let labels = |subject: &Subject| {
            let text = |choice: &LabelChoice| match choice {
                LabelChoice::Number(number) => number.to_string(),
                LabelChoice::Name(name) => name.clone(),
            };
            subject.labels.iter().flatten().map(text).collect::<Vec<_>>().join(";")
        };
        columns.push(("label".to_owned(), text(subjects.iter().map(labels).collect())));
    }
    for covariate in covariates {
        let column = match &covariate.values {
            Values::Numbers(of) => number(&|k| of[k]),
            Values::Factor { levels, of } => {
                text(of.iter().map(|level| level.map_or(String::new(), |k| levels[k].clone())).collect())
            }
        };
        columns.push((covariate.name.clone(), column));
    }
    let matched = |k: usize| (of[k].place != SubjectOutcome::Failed).then_some(&of[k]);
    columns.push(("volume_mm3".to_owned(), number(&|k| matched(k)?.facts.volume_mm3)));
    columns.push(("area_mm2".to_owned(), number(&|k| Some(matched(k)?.facts.area_mm2))));
    columns.push(("centroid_size_mm".to_owned(), number(&|k| Some(matched(k)?.size_mm))));
    columns.push(("residual_mm".to_owned(), number(&|k| Some(matched(k)?.facts.residual_mm))));
    for (at, name) in found.complex.iter().flat_map(|complex| complex.structures.iter().map(|of| &of.name).enumerate())
    {
        let facts = |k: usize| Some(&of[k].structures.get(at)?.facts).filter(|facts| facts.error.is_none());
        columns.push((format!("volume_mm3.{name}"), number(&|k| facts(k)?.volume_mm3)));
        columns.push((format!("area_mm2.{name}"), number(&|k| Some(facts(k)?.area_mm2))));
        columns.push((format!("residual_mm.{name}"), number(&|k| Some(facts(k)?.residual_mm))));
        if at > 0 {
            let pose = |k: usize| of[k].structures.get(at)?.pose;
            for (axis, word) in ["x", "y", "z"].into_iter().enumerate() {
                columns.push((format!("shift_{word}_mm.{name}"), number(&|k| Some(pose(k)?.shift_mm[axis]))));
            }
            columns.push((format!("rotation_degrees.{name}"), number(&|k| Some(pose(k)?.rotation_degrees))));
        }
    }
    columns.extend(pose_columns(of));
    columns.push(("mahalanobis_squared".to_owned(), number(&|k| of[k].distance)));
    columns.push(("mahalanobis_p".to_owned(), number(&|k| of[k].unusual_p)));
    for label in found.labels.iter().flat_map(|labels| &labels.labels) {
        columns.push((format!("label_{label}_area_mm2"), number(&|k| of[k].labels.get(label).map(|l| l.area_mm2))));
        columns.push((
            format!("label_{label}_volume_mm3"),
            number(&|k| of[k].labels.get(label).and_then(|l| l.volume_mm3)),
        ));
    }
    if let Some(labels) = &found.labels {
        for (at, label) in labels.labels.iter().enumerate() {
            let of_subject = |k: usize| labels.dice.iter().find(|(of, _)| *of == k).and_then(|(_, dice)| dice[at]);
            columns.push((format!("label_{label}_dice"), number(&of_subject)));
        }
    }
    for mode in 0..found.model.modes.len().min(WRITTEN_SCORES) {
        columns.push((format!("score_{}_mm", mode + 1), number(&|k| of[k].scores.get(mode).copied())));
    }
    columns
}

/// What the group says about poses; no columns where no pose is ambiguous.
fn pose_columns(of: &[SubjectFindings]) -> Vec<(String, TableColumn)> {
    let names: BTreeSet<Option<&str>> =
        of.iter().flat_map(SubjectFindings::group_decisions).map(|(name, _)| name).collect();
    let mut columns = Vec::new();
    for name in names {
        let on = |subject: &SubjectFindings| subject.group_decisions().find(|(of, _)| *of == name).map(|(_, on)| *on);
        let found: Vec<Option<GroupDecision>> = of.iter().map(on).collect();
        let mut column = |word: &str, value: &dyn Fn(&GroupDecision) -> f64| {
            let title = name.map_or_else(|| word.to_owned(), |name| format!("{word}.{name}"));
            columns
                .push((title, TableColumn::Real(found.iter().map(|on| on.as_ref().map_or(f64::NAN, value)).collect())));
        };
        column("pose_candidates", &|on| on.candidates as f64);
        column("pose_candidate", &|on| on.candidate as f64);
        column("pose_marginal", &|on| on.marginal);
        column("pose_decided", &|on| f64::from(u8::from(on.decided)));
    }
    columns
}

fn csv_table(columns: &[(String, TableColumn)]) -> String {
    let header: Vec<String> = columns.iter().map(|(name, _)| text_cell(name)).collect();
    let mut text = header.join(",") + "\n";
    let n = columns.first().map_or(0, |(_, column)| match column {
        TableColumn::Real(values) => values.len(),
        TableColumn::Text(values) => values.len(),
    });
    for row in 0..n {
        let cells: Vec<String> = columns
            .iter()
            .map(|(_, column)| match column {
                TableColumn::Real(values) if values[row].is_nan() => String::new(),
                TableColumn::Real(values) => values[row].to_string(),
                TableColumn::Text(values) => text_cell(&values[row]),
            })
            .collect();
        text.push_str(&(cells.join(",") + "\n"));
    }
    text
}

fn model_table(found: &Findings) -> String {
    let mut text = "modes,variance_mm2,compactness,generalization_mm,specificity_mm\n".to_owned();
    let quality = &found.model.quality;
    for k in 0..found.model.modes.len() {
        let (a, b, c) = (quality.compactness[k], quality.generalization_mm[k], quality.specificity_mm[k]);
        let _ = writeln!(text, "{},{},{a},{b},{c}", k + 1, found.model.variances[k]);
    }
    text
}

fn quality_table(study: &Study, found: &Findings) -> String {
    let mut text =
        "id,place,flags,reasons,residual_mm,residual_p95_mm,folded,confidence,mahalanobis_p,decision,reason,error\n"
            .to_owned();
    for k in most_urgent_first(&found.subjects) {
        let subject = &found.subjects[k];
        let flags: Vec<&str> = subject.flags.iter().map(|flag| flag.title()).collect();
        let facts = &subject.facts;
        let matched =
            |value: f64| if subject.place == SubjectOutcome::Failed { String::new() } else { value.to_string() };
        let decided = subject.decision.as_ref();
        let word = |decision: &Decision| match decision.decision {
            crate::folder::Verdict::Kept => "kept",
            crate::folder::Verdict::Dropped => "dropped",
        };
        let _ = writeln!(
            text,
            "{},{},{},{},{},{},{},{},{},{},{},{}",
            text_cell(&study.cohort.subjects[k].id),
            subject.place.name(),
            text_cell(&flags.join("; ")),
            text_cell(&facts.reasons.join("; ")),
            matched(facts.residual_mm),
            matched(facts.residual_p95_mm),
            matched(facts.folded),
            matched(facts.confidence),
            subject.unusual_p.map_or(String::new(), |p| p.to_string()),
            decided.map_or("", word),
            text_cell(decided.map_or("", |decision| &decision.reason)),
            text_cell(facts.error.as_deref().unwrap_or_default())
        );
    }
    text
}

fn effect_table(found: &Findings) -> String {
    let mut text = "variable,contrast,effect,robust_se,low,high,t,p,hedges_g,g_low,g_high\n".to_owned();
    for whole in found.statistics.iter().flat_map(|statistics| &statistics.whole) {
        let effect = &whole.effect;
        let [low, high] = effect.interval;
        let [g_low, g_high] = effect.g_interval;
        let _ = writeln!(
            text,
            "{},{},{},{},{low},{high},{},{},{},{g_low},{g_high}",
            text_cell(&whole.variable),
            text_cell(&whole.contrast),
            effect.value,
            effect.robust_se,
            effect.t,
            effect.p,
            effect.g
        );
    }
    text
}

/// The main figures of `study.json`.
fn figures(study: &Study, found: &Findings) -> serde_json::Value {
    let places = |place: SubjectOutcome| found.subjects.iter().filter(|subject| subject.place == place).count();
    let quality = &found.model.quality;
    let maps: Vec<_> = found
        .statistics
        .iter()
        .flat_map(|statistics| {
            statistics.maps.iter().map(|map| {
                serde_json::json!({
                    "measure": map.measure,
                    "contrast": statistics.design.contrasts[map.contrast].name,
                    "smallest_p": map.p_corrected().iter().copied().fold(1.0, f64::min),
                    "significant_share": significant_share(&map.p_local(), &found.alignment.weights),
                    "smallest_q": map.q.iter().copied().fold(1.0, f64::min),
                })
            })
        })
        .collect();
    let dice = found.labels.as_ref().map(|labels| {
        let each = labels.labels.iter().enumerate().map(|(at, label)| {
            let values: Vec<f64> = labels.dice.iter().filter_map(|(_, dice)| dice[at]).collect();
            let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
            serde_json::json!({"label": label, "subjects": values.len(), "mean_dice": mean})
        });
        each.collect::<Vec<_>>()
    });
    let whole: Vec<_> = found.statistics.iter().flat_map(|statistics| &statistics.whole).collect();
    let planning: Vec<_> = found.statistics.iter().flat_map(|statistics| &statistics.planning).collect();
    let mut figures = serde_json::json!({
        "subjects": {
            "model": places(SubjectOutcome::Model),
            "scored": places(SubjectOutcome::Scored),
            "dropped": places(SubjectOutcome::Dropped),
            "unreliable": places(SubjectOutcome::Unreliable),
            "failed": places(SubjectOutcome::Failed),
        },
        "model": {
            "modes": found.model.modes.len(),
            "variances_mm2": &found.model.variances[..found.model.modes.len()],
            "compactness": quality.compactness,
            "generalization_mm": quality.generalization_mm,
            "specificity_mm": quality.specificity_mm,
        },
        "joint": found.joint,
        "consistency": found.consistency,
        "dice": dice,
        "maps": maps,
        "effects": whole,
        "planning": planning,
    });
    if study.settings.visits == Visits::OwnTemplate {
        let (own, persons) = (found.matched.own.len(), study.persons.len());
        figures["own_templates"] = serde_json::json!({"persons": own, "matched_directly": persons - own});
    }
    let poses = found.subjects.iter().zip(&study.cohort.subjects).flat_map(|(subject, Subject { id, .. })| {
        let of = move |(structure, on): (Option<&str>, &GroupDecision)| {
            let mut entry = serde_json::json!(on);
            entry["id"] = serde_json::json!(id);
            if let Some(structure) = structure {
                entry["structure"] = serde_json::json!(structure);
            }
            entry
        };
        subject.group_decisions().map(of).collect::<Vec<_>>()
    });
    let poses: Vec<_> = poses.collect();
    if !poses.is_empty() {
        figures["ambiguous_poses"] = serde_json::json!(poses);
    }
    if let Some(complex) = &found.complex {
        figures["structures"] = serde_json::json!(complex.structures);
    }
    figures
}
