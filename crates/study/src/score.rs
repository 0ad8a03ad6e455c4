//! Scores one new subject against the group of a study: how far it deviates at every vertex, where it deviates more than a
//! member of the group would anywhere, and how unusual its shape is.
//!
//! The subject joins the study with the role `score`, so it costs one match and changes neither the template nor the maps
//! and the model of the others. Its group is the model of the study, or the members with one level of a covariate.

use crate::adjustment::{Adjusted, Adjustment, AdjustmentFacts};
use crate::align::{Alignment, Shapes, WatchedShapes, align, points};
use crate::cohort::{Cohort, Role, Subject, Values};
use crate::error::StudyError;
use crate::findings::{onto_mean, placed, shape_on_mean};
use crate::folder::{Decision, Folder, json};
use crate::matching::{Interruption, StudyObserver};
use crate::measures::measured;
use crate::model::ShapeModel;
use crate::normative::{Bound, Calibration, Norm, largest};
use crate::plan::{Matched, Records, Study};
use crate::rivals::decide;
use crate::settings::{Measure, Settings};
use crate::subjects::SubjectOutcome;
use homolog_contract::input::BodySide;
use homolog_contract::parameters::LabelChoice;
use homolog_formats::gifti::write_gifti;
use homolog_formats::vtk::write_vtk_with;
use homolog_formats::{VertexArray, VertexValues};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::Observer;
use nalgebra::Point3;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::path::PathBuf;

/// Largest group; of a larger one, a choice that is random with respect to shape.
const MOST_MEMBERS: usize = 1000;
/// Smallest group.
const FEWEST_MEMBERS: usize = 4;
/// Family-wise level of the screening for lesions.
const LEVEL: f64 = 0.05;

/// A subject that is not part of the study.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NewSubject {
    /// Its surface or label volume.
    pub file: PathBuf,
    /// Side of the body, if the study has sides.
    pub side: Option<BodySide>,
    /// Labels of its volume that belong to the structure; `None` for those of the settings.
    pub labels: Option<Vec<LabelChoice>>,
}

/// Members with one level of a covariate.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Subgroup {
    /// The covariate, a factor.
    pub covariate: String,
    /// Its level.
    pub level: String,
}

impl Subgroup {
    /// Reads `COVARIATE=LEVEL`.
    pub fn read(text: &str) -> Option<Self> {
        let (covariate, level) = text.split_once('=')?;
        let is_complete = !covariate.is_empty() && !level.is_empty();
        is_complete.then(|| Subgroup { covariate: covariate.to_owned(), level: level.to_owned() })
    }
}

/// What a new subject is compared with.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Reference {
    /// The group; `None` for all members of the model.
    pub within: Option<Subgroup>,
    /// Covariates that are adjusted for.
    pub adjustment: Adjustment,
}

/// A connected region of vertices beyond the bound, all in one direction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Region {
    /// Its vertices.
    pub vertices: usize,
    /// Its area on the mean of the group, mm².
    pub area_mm2: f64,
    /// The vertex of the largest absolute score.
    pub peak: usize,
    /// Position of the peak in the subject's coordinates, mm.
    pub peak_mm: [f64; 3],
    /// Score at the peak; positive outwards.
    pub score: f64,
    /// Deviation at the peak along the outward normal from the mean, or from the prediction at the subject's covariates, mm.
    pub deviation_mm: f64,
}

/// Findings on a new subject, apart from its maps.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ScoreSummary {
    /// The group, if it is a part of the study.
    pub within: Option<Subgroup>,
    /// The adjustment for covariates, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub adjusted: Option<AdjustmentFacts>,
    /// Members of the group.
    pub members: usize,
    /// Whether no reason was found to doubt the match; `None` for methods that do not judge.
    pub reliable: Option<bool>,
    /// The reasons to doubt it.
    pub reasons: Vec<String>,
    /// Mean distance of the subject's surface from the map, mm.
    pub residual_mm: f64,
    /// Squared Mahalanobis distance from the model of the group.
    pub mahalanobis_squared: f64,
    /// The p-value of a shape as unusual.
    pub unusual_p: f64,
    /// The largest absolute score.
    pub largest_score: f64,
    /// The p-value of a largest score as large.
    pub largest_score_p: f64,
    /// The bound of the screening.
    pub bound: Bound,
    /// How far the scores of left-out members are standard.
    pub calibration: Calibration,
    /// Regions beyond the bound, the largest score first.
    pub regions: Vec<Region>,
}

/// Findings on a new subject.
#[derive(Debug, Clone)]
pub struct SubjectScore {
    /// In figures.
    pub summary: ScoreSummary,
    /// Score at each vertex of the template; positive outwards.
    pub scores: Vec<f64>,
    /// Deviation along the outward normal from the mean of the group, or from the prediction at the subject's covariates, at
    /// each vertex, mm.
    pub deviation_mm: Vec<f64>,
    /// The template deformed onto the subject, in the subject's coordinates.
    pub surface: SurfaceMesh,
    /// The mean of the group.
    pub mean: SurfaceMesh,
}

/// Adds a subject with the role `score`; returns its index. The side of the template stays that of the study.
///
/// # Errors
/// [`StudyError::Settings`] if the subject has a side and the study has none, or the other way round.
pub fn add(cohort: &mut Cohort, settings: &mut Settings, new: NewSubject) -> Result<usize, StudyError> {
    let fault = |text: &str| Err(StudyError::Settings(text.to_owned()));
    if !cohort.structures().is_empty() {
        return fault(
            "a new subject is compared in a study of one structure; make one of each, with a table of its rows",
        );
    }
    settings.template_side = crate::sides::template_side(cohort, settings)?;
    match (settings.template_side, new.side) {
        (Some(_), None) => return fault("the study has sides: state that of the subject, left or right"),
        (None, Some(_)) => return fault("the study has no sides: leave that of the subject out"),
        _ => {}
    }
    let ids: BTreeSet<&str> = cohort.subjects.iter().flat_map(|of| [of.id.as_str(), of.subject.as_str()]).collect();
    let id = (0..).map(|k: usize| format!("scored-{k}")).find(|id| !ids.contains(id.as_str())).unwrap_or_default();
    for covariate in &mut cohort.covariates {
        match &mut covariate.values {
            Values::Numbers(of) => of.push(None),
            Values::Factor { of, .. } => of.push(None),
        }
    }
    let NewSubject { file, side, labels } = new;
    cohort.subjects.push(Subject { subject: id.clone(), id, file, role: Role::Score, side, labels, structure: None });
    Ok(cohort.subjects.len() - 1)
}

/// Scores subject `k` of a study, which has the role `score`, against the members, or a part of them, with or without
/// adjustment for covariates.
///
/// # Errors
/// [`StudyError::Settings`] for an unknown group or covariate, a value of the subject that is missing or unknown, and
/// fewer than four degrees of freedom of a regression; [`StudyError::TooFewMatches`] if the subject has no match or the group
/// fewer than four members; errors of the model.
///
/// # Cost
/// For `n` members and `V` vertices that of the shape model, and `O(n V)` quantiles of Student's t. Joint maps of the group
/// are made again if those of the subject are missing.
pub fn score(
    study: &Study,
    matched: &Matched,
    folder: &Folder,
    decisions: &[Decision],
    (k, reference): (usize, &Reference),
    watcher: &dyn StudyObserver,
) -> Result<SubjectScore, StudyError> {
    let observer = &Interruption(watcher);
    let mut matched = matched.clone();
    let poses = decide(study, &mut matched, folder, decisions, observer)?;
    let (subjects, members, _) = placed(study, (&mut matched, &poses), folder, decisions, watcher)?;
    if subjects[k].place == SubjectOutcome::Failed {
        let reason = subjects[k].facts.error.clone().unwrap_or_default();
        return Err(StudyError::TooFewMatches { matched: 0, all: 1, purpose: "to score the subject", reason });
    }
    let (group, adjusted) = group(study, &matched, &members, k, reference)?;
    watcher.progress("shape model", 0, 1);
    let template = &matched.making.template.mesh;
    let key = |k: &usize| (matched.keys[*k].clone(), study.cohort.subjects[*k].id.clone());
    let shapes = folder.shapes(group.iter().map(key).collect(), template.n_vertices());
    let alignment = align(&WatchedShapes { shapes: &shapes, observer }, template, study.settings.size)?;
    let mut frame = alignment.clone();
    frame.onto_mean.push(onto_mean(study, &matched, folder, &alignment, k)?.1);
    let all = folder.shapes(group.iter().chain([&k]).map(key).collect(), template.n_vertices());
    let seed = study.settings.analysis.seed;
    let watched = WatchedShapes { shapes: &all, observer };
    let unusual = Unusual::new(&watched, &frame, adjusted.as_ref(), seed, observer)?;
    let mean = template.with_vertices(alignment.mean.clone())?;
    let values = |k: usize| -> Result<Vec<f64>, StudyError> {
        let own = mean.with_vertices(shape_on_mean(study, &matched, folder, &alignment, k)?)?;
        Ok(measured(Measure::NormalDisplacement, &mean, &own, observer)?.unwrap_or_default())
    };
    watcher.progress("statistics", 0, 1);
    let of_members: Vec<Vec<f64>> = group.par_iter().map(|&k| values(k)).collect::<Result<_, _>>()?;
    let own = values(k)?;
    let few = || too_few(&group, "a normative score needs subjects that differ");
    let weights = alignment.weights.clone();
    let norm = match &adjusted {
        None => Norm::new(of_members, weights),
        Some(adjusted) => Norm::adjusted(&of_members, weights, &adjusted.model, &adjusted.own),
    };
    let norm = norm.ok_or_else(few)?;
    let left_out = norm.leave_one_out(observer)?;
    let scores = norm.scores(&own);
    let deviation_mm: Vec<f64> = own.iter().zip(norm.expected()).map(|(y, expected)| y - expected).collect();
    let points = folder.get(&matched.keys[k])?.map(|record| record.points).unwrap_or_default();
    let surface = crate::mirror::deformed_template(template, crate::align::points(&points), study.is_mirrored(k))?;
    let (facts, largest_score, bound) = (&subjects[k].facts, largest(&scores), left_out.bound(LEVEL));
    let summary = ScoreSummary {
        within: reference.within.clone(),
        adjusted: adjusted.map(|adjusted| adjusted.facts),
        members: group.len(),
        reliable: facts.reliable,
        reasons: facts.reasons.clone(),
        residual_mm: facts.residual_mm,
        mahalanobis_squared: unusual.distance,
        unusual_p: unusual.p,
        largest_score,
        largest_score_p: left_out.p_of_largest(largest_score),
        regions: regions(&mean, surface.vertices(), &scores, &deviation_mm, bound.score),
        bound,
        calibration: left_out.calibration.clone(),
    };
    Ok(SubjectScore { summary, scores, deviation_mm, surface, mean })
}

/// How unusual a shape is.
struct Unusual {
    /// Squared Mahalanobis distance from the model of the group.
    distance: f64,
    p: f64,
}

impl Unusual {
    /// The last of the shapes against the others, `frame` having the transforms of all onto the mean of the others.
    fn new(
        shapes: &dyn Shapes,
        frame: &Alignment,
        adjusted: Option<&Adjusted>,
        seed: u64,
        observer: &dyn Observer,
    ) -> Result<Self, StudyError> {
        let n = shapes.len() - 1;
        let of = |shapes: &dyn Shapes, frame: &Alignment| -> Result<Self, StudyError> {
            let model = ShapeModel::with_others(shapes, frame, n, seed, observer)?;
            let own = points(&shapes.read(n, 0..shapes.n_vertices())?);
            let moved: Vec<Point3<f64>> = own.iter().map(|p| frame.onto_mean[n].apply(p)).collect();
            let (_, distance) = model.score(frame, &moved);
            Ok(Unusual { distance, p: model.others_p.first().copied().unwrap_or(1.0) })
        };
        match adjusted {
            None => of(shapes, frame),
            Some(adjusted) => {
                let (shapes, frame) = adjusted.shapes(shapes, frame)?;
                of(&shapes, &frame)
            }
        }
    }
}

fn too_few(group: &[usize], reason: &str) -> StudyError {
    let n = group.len();
    StudyError::TooFewMatches { matched: n, all: n, purpose: "for a normative score", reason: reason.to_owned() }
}

/// The members of the group: one row of each person, without a copy of the subject's own file; and their regression.
fn group(
    study: &Study,
    matched: &Matched,
    members: &[usize],
    k: usize,
    reference: &Reference,
) -> Result<(Vec<usize>, Option<Adjusted>), StudyError> {
    let is_within = level_of(&study.cohort, reference.within.as_ref())?;
    let adjustment = (!reference.adjustment.is_empty()).then_some(&reference.adjustment);
    let mut known = BTreeSet::new();
    let is_own = |m: usize| study.hashes[m] == study.hashes[k] && matched.keys[m] == matched.keys[k];
    let mut group: Vec<usize> = members.iter().copied().filter(|&m| is_within(m) && !is_own(m)).collect();
    let all = group.iter().map(|&m| &study.cohort.subjects[m].subject).collect::<BTreeSet<_>>().len();
    if let Some(adjustment) = adjustment {
        group = adjustment.complete(&study.cohort, &group)?;
    }
    group.retain(|&m| known.insert(&study.cohort.subjects[m].subject));
    let incomplete = all - group.len();
    if group.len() > MOST_MEMBERS {
        // Keys are hashes.
        group.sort_by(|&a, &b| matched.keys[a].cmp(&matched.keys[b]));
        group.truncate(MOST_MEMBERS);
        group.sort_unstable();
    }
    if group.len() < FEWEST_MEMBERS {
        return Err(too_few(&group, "a normative score needs at least four"));
    }
    let adjusted = adjustment.map(|of| of.fit(&study.cohort, &group, incomplete)).transpose()?;
    Ok((group, adjusted))
}

/// Checks that a group exists.
///
/// # Errors
/// [`StudyError::Settings`].
pub fn check_group(cohort: &Cohort, within: Option<&Subgroup>) -> Result<(), StudyError> {
    level_of(cohort, within).map(|_| ())
}

type Membership<'a> = Box<dyn Fn(usize) -> bool + 'a>;

fn level_of<'a>(cohort: &'a Cohort, within: Option<&Subgroup>) -> Result<Membership<'a>, StudyError> {
    let Some(Subgroup { covariate, level }) = within else { return Ok(Box::new(|_| true)) };
    let fault = |why: String| StudyError::Settings(why);
    let found = cohort.covariate(covariate);
    match found.map(|found| &found.values) {
        None => Err(fault(format!("the study has no covariate {covariate}"))),
        Some(Values::Numbers(_)) => Err(fault(format!("{covariate} is a number and has no levels"))),
        Some(Values::Factor { levels, of }) => match levels.iter().position(|of| of == level) {
            None => Err(fault(format!("{covariate} has no level {level}; it has {}", levels.join(", ")))),
            Some(level) => Ok(Box::new(move |k| of[k] == Some(level))),
        },
    }
}

/// The connected regions of vertices whose scores are beyond the bound in one direction.
fn regions(mean: &SurfaceMesh, own: &[Point3<f64>], scores: &[f64], deviation_mm: &[f64], bound: f64) -> Vec<Region> {
    let (graph, areas) = (mean.edge_graph(), crate::align::vertex_areas(mean));
    let sign = |v: usize| if scores[v].abs() > bound { scores[v].signum() } else { 0.0 };
    let (mut seen, mut regions) = (vec![false; scores.len()], Vec::new());
    for first in 0..scores.len() {
        if seen[first] || sign(first) == 0.0 {
            continue;
        }
        seen[first] = true;
        let (mut region, mut at) = (vec![first], 0);
        while at < region.len() {
            for &next in graph.neighbors(region[at]) {
                let next = next as usize;
                if !seen[next] && sign(next) == sign(first) {
                    seen[next] = true;
                    region.push(next);
                }
            }
            at += 1;
        }
        let most = |best: usize, v: usize| if scores[v].abs() > scores[best].abs() { v } else { best };
        let peak = region.iter().copied().fold(first, most);
        regions.push(Region {
            vertices: region.len(),
            area_mm2: region.iter().map(|&v| areas[v]).sum(),
            peak,
            peak_mm: own[peak].coords.into(),
            score: scores[peak],
            deviation_mm: deviation_mm[peak],
        });
    }
    regions.sort_by(|a, b| b.score.abs().total_cmp(&a.score.abs()));
    regions
}

/// `score.json`: a score, with the build that made it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ScoreDocument {
    /// Version of homolog.
    pub version: String,
    /// Commit of the build.
    pub commit: String,
    /// The figures.
    #[serde(flatten)]
    pub summary: ScoreSummary,
    /// Score at each vertex of the template.
    pub scores: Vec<f32>,
    /// Deviation along the outward normal from the mean of the group, or from the prediction at the subject's covariates, at
    /// each vertex, mm.
    pub deviation_mm: Vec<f32>,
}

impl SubjectScore {
    /// Its document.
    pub fn document(&self, commit: &str) -> ScoreDocument {
        let short = |values: &[f64]| values.iter().map(|x| *x as f32).collect();
        ScoreDocument {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            commit: commit.to_owned(),
            summary: self.summary.clone(),
            scores: short(&self.scores),
            deviation_mm: short(&self.deviation_mm),
        }
    }

    /// Its files, by name: `score.json`; the template deformed onto the subject with scores, deviations and the vertices
    /// beyond the bound, as VTK and GIFTI; and the same arrays for the mean of the group, as VTK.
    pub fn files(&self, commit: &str) -> Vec<(&'static str, Vec<u8>)> {
        let real = |name, values: &[f64]| VertexArray { name, values: VertexValues::Real(values.to_vec()) };
        let bound = self.summary.bound.score;
        let beyond = self.scores.iter().map(|z| if z.abs() > bound { z.signum() as i32 } else { 0 }).collect();
        let arrays = [
            real("score", &self.scores),
            real("deviation_mm", &self.deviation_mm),
            VertexArray { name: "beyond_bound", values: VertexValues::Int(beyond) },
        ];
        vec![
            ("score.json", json(&self.document(commit))),
            ("subject.vtk", write_vtk_with(&self.surface, &arrays)),
            ("subject.surf.gii", write_gifti(&self.surface, &arrays)),
            ("mean.vtk", write_vtk_with(&self.mean, &arrays)),
        ]
    }
}
