//! Computes all findings of a study from matches and decisions.

use crate::align::{Alignment, WatchedShapes, align, centroid_size, fit_onto, points};
use crate::cohort::Role;
use crate::complex::{Complex, measured_by_structure};
use crate::consistency::{Consistency, consistency};
use crate::error::StudyError;
use crate::folder::{Decision, Folder, Verdict};
use crate::joint::JointFindings;
use crate::labels::{carried, dice, labels_at, voted};
use crate::matching::{Interruption, StudyObserver};
use crate::model::ShapeModel;
use crate::plan::{Matched, Records, Study};
use crate::pose::relative_poses;
use crate::quality::flags;
use crate::record::{Facts, Record};
use crate::rivals::{GroupDecision, decide};
use crate::settings::{Correspondence, Measure, Size, TemplateChoice};
use crate::statistics::VertexValues;
use crate::statistics::design::{Contrast, Design};
use crate::statistics::effect::{Effect, effect, subjects_needed};
use crate::statistics::linear::{ContrastMap, LinearModel};
use crate::statistics::mixed::{MixedMap, MixedModel};
use crate::statistics::multiple::false_discovery;
use crate::statistics::paired::Pairs;
use crate::statistics::permutation::{Exchange, PermutationMap, test_by};
use crate::statistics::tfce::Enhancer;
use crate::subjects::{LabelSize, SubjectFindings, SubjectOutcome};
use faer::Mat;
use homolog_contract::parameters::LabelChoice;
use homolog_formats::{FileContent, ReadLimits};
use homolog_mesh::SurfaceMesh;
use homolog_mesh::volume::LabelVolume;
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use homolog_registration::SimilarityTransform;
use homolog_run::intake::chosen_numbers;
use nalgebra::Point3;
use rayon::prelude::*;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

/// All findings of a study.
#[derive(Debug, Clone)]
pub struct Findings {
    /// The template, and the maps: matches, or joint maps.
    pub matched: Matched,
    /// How joint maps were made.
    pub joint: Option<JointFindings>,
    /// The structures, in a study of several, whose subjects are persons.
    pub complex: Option<Complex>,
    /// Findings for each subject, in the order of the cohort.
    pub subjects: Vec<SubjectFindings>,
    /// Subjects of the model, as indices into the cohort.
    pub members: Vec<usize>,
    /// The frame of the model.
    pub alignment: Alignment,
    /// The mean of the members, on the template's mesh.
    pub mean: SurfaceMesh,
    /// The shape model.
    pub model: ShapeModel,
    /// The statistics, if an effect or a contrast was requested.
    pub statistics: Option<Statistics>,
    /// Consistency of the maps.
    pub consistency: Option<Consistency>,
    /// Labels of the template, and their transfer.
    pub labels: Option<LabelFindings>,
}

impl Findings {
    /// How joint maps were made: of the subjects, or of each structure.
    pub fn joint_maps(&self) -> impl Iterator<Item = &JointFindings> {
        let structures = self.complex.iter().flat_map(|complex| &complex.structures);
        self.joint.iter().chain(structures.filter_map(|structure| structure.joint.as_ref()))
    }
}

/// Labels of the template.
#[derive(Debug, Clone, PartialEq)]
pub struct LabelFindings {
    /// The labels.
    pub labels: Vec<u32>,
    /// The label of each vertex of the template.
    pub of_vertex: Vec<Option<u32>>,
    /// Whether the labels are the given template's own; otherwise they are the majority of the subjects.
    pub of_template: bool,
    /// For each subject with labels of its own and each label, the Dice overlap with the labels transferred to it,
    /// which subjects of the other half voted (or which are the template's own).
    pub dice: Vec<(usize, Vec<Option<f64>>)>,
}

/// The statistics of a study.
#[derive(Debug, Clone)]
pub struct Statistics {
    /// The design.
    pub design: Design,
    /// Whether subjects have several visits, which calls for a mixed model without permutations.
    pub longitudinal: bool,
    /// The pairs, if differences within persons are tested.
    pub pairs: Option<Pairs>,
    /// Degrees of freedom of the residuals.
    pub degrees: f64,
    /// Maps, by measure and contrast.
    pub maps: Vec<StatisticMap>,
    /// Measures that are not meaningful for these surfaces.
    pub left_out: Vec<Measure>,
    /// Effects in variables of whole subjects, by variable and contrast.
    pub whole: Vec<WholeEffect>,
    /// Subjects needed to find standardized effects at 80 % power, by contrast.
    pub planning: Vec<Planning>,
}

/// A map of a contrast.
#[derive(Debug, Clone)]
pub struct StatisticMap {
    /// The measure.
    pub measure: Measure,
    /// Index of the contrast in the design.
    pub contrast: usize,
    /// The linear model, and its permutations; `None` for visits.
    pub linear: Option<(ContrastMap, PermutationMap)>,
    /// The mixed model of visits.
    pub mixed: Option<MixedMap>,
    /// Smallest false discovery rate at which each vertex is a discovery.
    pub q: Vec<f64>,
}

impl StatisticMap {
    /// The effect at each vertex.
    pub fn effect(&self) -> &[f64] {
        match (&self.linear, &self.mixed) {
            (Some((linear, _)), _) => &linear.effect,
            (None, Some(mixed)) => &mixed.effect,
            (None, None) => &[],
        }
    }

    /// The p-value that says whether there is an effect at all: corrected over all vertices by enhanced clusters, or for visits
    /// the false discovery rate.
    pub fn p_corrected(&self) -> &[f64] {
        self.linear.as_ref().map_or(&self.q, |(_, permuted)| &permuted.p_tfce)
    }

    /// The p-value that says where an effect is: at each vertex the larger one of [`Self::p_corrected`] and the false discovery
    /// rate.
    ///
    /// An enhanced cluster rejects the hypothesis that there is no effect anywhere. Beside a true effect its value is also small
    /// at vertices of little `|t|` that are connected with it, which `q` bounds. Both must reject (intersection-union test; Berger
    /// 1982): without any effect, a vertex up to 0.05 is as rare as by clusters, and of the vertices up to 0.05 at most about a
    /// twentieth is wrong.
    pub fn p_local(&self) -> Vec<f64> {
        self.p_corrected().iter().zip(&self.q).map(|(p, q)| p.max(*q)).collect()
    }
}

/// An effect in a variable of whole subjects.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WholeEffect {
    /// The variable.
    pub variable: String,
    /// The contrast.
    pub contrast: String,
    /// The effect.
    pub effect: Effect,
}

/// Number of subjects needed in a further study.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Planning {
    /// The contrast.
    pub contrast: String,
    /// The standardized effect.
    pub d: f64,
    /// Number of subjects, in the proportions of this study; `None` for more than 100,000.
    pub subjects: Option<usize>,
}

/// Computes all findings of a study from its matches.
///
/// # Errors
/// [`StudyError`].
pub fn find(
    study: &Study,
    matched: &Matched,
    folder: &Folder,
    decisions: &[Decision],
    watcher: &dyn StudyObserver,
) -> Result<Findings, StudyError> {
    find_with((study, matched, None), folder, decisions, watcher)
}

/// [`find`], also for persons with several structures: subjects of `study` are then persons, whose records in `matched` have
/// the vertices of all structures.
///
/// # Errors
/// [`StudyError`].
pub(crate) fn find_with(
    (study, matched, complex): (&Study, &Matched, Option<Complex>),
    folder: &Folder,
    decisions: &[Decision],
    watcher: &dyn StudyObserver,
) -> Result<Findings, StudyError> {
    let observer = &Interruption(watcher);
    let (cohort, template) = (&study.cohort, &matched.making.template.mesh);
    let mut pairs = matched.clone();
    let group = decide(study, &mut pairs, folder, decisions, observer)?;
    let mut matched = pairs.clone();
    let (mut subjects, members, joint) = placed(study, (&mut matched, &group), folder, decisions, watcher)?;
    let matched = &matched;
    for (subject, structures) in subjects.iter_mut().zip(complex.iter().flat_map(|complex| &complex.of_persons)) {
        subject.structures.clone_from(structures);
    }
    watcher.progress("shape model", 0, 1);
    let keys = |of: &[usize]| of.iter().map(|&k| (matched.keys[k].clone(), cohort.subjects[k].id.clone())).collect();
    let shapes = folder.shapes(keys(&members), template.n_vertices());
    let alignment = align(&WatchedShapes { shapes: &shapes, observer }, template, study.settings.size)?;
    let others: Vec<usize> = (0..subjects.len())
        .filter(|&k| !matches!(subjects[k].place, SubjectOutcome::Model | SubjectOutcome::Failed))
        .collect();
    let mut frame = alignment.clone();
    for &k in &others {
        checkpoint(observer)?;
        frame.onto_mean.push(onto_mean(study, matched, folder, &alignment, k)?.1);
    }
    let all: Vec<usize> = members.iter().chain(&others).copied().collect();
    let shapes = folder.shapes(keys(&all), template.n_vertices());
    let seed = study.settings.analysis.seed;
    let model = ShapeModel::with_others(&shapes, &frame, members.len(), seed, observer)?;
    drop(frame);
    let mean = template.with_vertices(alignment.mean.clone())?;
    for (row, &k) in members.iter().enumerate() {
        subjects[k].scores.clone_from(&model.scores[row][..model.modes.len()].to_vec());
        subjects[k].distance = Some(model.left_out[row]);
        subjects[k].unusual_p = Some(model.unusual_of(row));
    }
    for (&k, p) in others.iter().zip(&model.others_p) {
        checkpoint(observer)?;
        let moved = shape_on_mean(study, matched, folder, &alignment, k)?;
        let (scores, distance) = model.score(&alignment, &moved);
        (subjects[k].scores, subjects[k].distance) = (scores, Some(distance));
        subjects[k].unusual_p = Some(*p);
    }
    let mean_size = centroid_size(&alignment.mean, &alignment.weights);
    let sizes: Vec<_> = (0..subjects.len())
        .into_par_iter()
        .filter(|&k| subjects[k].place != SubjectOutcome::Failed)
        .map(|k| {
            checkpoint(observer)?;
            let record = folder.get(&matched.keys[k])?;
            let shape = record.map(|record| points(&record.points)).unwrap_or_default();
            let size = centroid_size(&shape, &alignment.weights);
            let scale = if study.settings.size == Size::Removed { mean_size / size } else { 1.0 };
            let poses = complex
                .iter()
                .flat_map(|complex| relative_poses(complex, (&shape, scale), &alignment.mean, &alignment.weights));
            Ok((k, size, poses.collect::<Vec<_>>()))
        })
        .collect::<Result<_, StudyError>>()?;
    for (k, size, poses) in sizes {
        subjects[k].size_mm = size;
        subjects[k].structures.iter_mut().zip(poses).for_each(|(structure, pose)| structure.pose = pose);
    }
    watcher.progress("labels", 0, 1);
    let labels = match &complex {
        None => labels(study, matched, folder, &mut subjects, observer)?,
        // The numbers of labels of two structures may be the same.
        Some(_) => None,
    };
    flags(&mut subjects);
    watcher.progress("statistics", 0, 1);
    let complex_of = complex.as_ref();
    let statistics = statistics(study, matched, complex_of, folder, &alignment, &mean, &subjects, &members, watcher)?;
    let consistency = consistency(study, (&pairs, matched), &group, folder, observer)?;
    let matched = matched.clone();
    Ok(Findings { matched, joint, complex, subjects, members, alignment, mean, model, statistics, consistency, labels })
}

/// The subjects with their outcomes, the members of the model, and how joint maps were made.
pub(crate) type Placed = (Vec<SubjectFindings>, Vec<usize>, Option<JointFindings>);

/// The subjects with their outcomes, the members of the model, and joint maps if the study has them: these replace the
/// maps of `matched`. `group`: what the group says about the poses of its subjects, whose maps `matched` has already.
///
/// # Errors
/// [`StudyError::TooFewMatches`] for fewer than three members; errors of reading and of joint maps.
pub(crate) fn placed(
    study: &Study,
    (matched, group): (&mut Matched, &[Option<GroupDecision>]),
    folder: &Folder,
    decisions: &[Decision],
    watcher: &dyn StudyObserver,
) -> Result<Placed, StudyError> {
    let observer = &Interruption(watcher);
    let (cohort, n_vertices) = (&study.cohort, matched.making.template.mesh.n_vertices());
    let mut subjects = Vec::new();
    for (k, subject) in cohort.subjects.iter().enumerate() {
        checkpoint(observer)?;
        let Record { mut facts, points: shape } = folder.get(&matched.keys[k])?.unwrap_or(Record {
            facts: Facts { error: Some("the match is missing".to_owned()), ..Facts::default() },
            points: Vec::new(),
        });
        if facts.error.is_none() && shape.len() != n_vertices {
            facts.error = Some("the match has other vertices than the template".to_owned());
        }
        let decision = decisions.iter().find(|decision| decision.id == subject.id).cloned();
        let verdict = decision.as_ref().map(|decision| decision.decision);
        let place = match (&facts.error, verdict, facts.reliable, subject.role) {
            (Some(_), ..) => SubjectOutcome::Failed,
            (None, Some(Verdict::Dropped), ..) => SubjectOutcome::Dropped,
            (None, None, Some(false), _) => SubjectOutcome::Unreliable,
            (None, _, _, Role::Model) => SubjectOutcome::Model,
            (None, _, _, Role::Score) => SubjectOutcome::Scored,
        };
        subjects.push(SubjectFindings {
            place,
            facts,
            decision,
            group: group.get(k).copied().flatten(),
            size_mm: 0.0,
            scores: Vec::new(),
            distance: None,
            unusual_p: None,
            flags: Vec::new(),
            urgency: 0.0,
            labels: BTreeMap::new(),
            structures: Vec::new(),
        });
    }
    let members: Vec<usize> = (0..subjects.len()).filter(|&k| subjects[k].place == SubjectOutcome::Model).collect();
    if members.len() < 3 {
        let count = |place: SubjectOutcome| subjects.iter().filter(|subject| subject.place == place).count();
        let left_out = || {
            format!(
                "none; {} are left out by a decision, {} because their match is not reliable, and {} are only compared with the model",
                count(SubjectOutcome::Dropped),
                count(SubjectOutcome::Unreliable),
                count(SubjectOutcome::Scored)
            )
        };
        let reason = subjects.iter().find_map(|subject| subject.facts.error.clone()).unwrap_or_else(left_out);
        let (found, all) = (members.len(), subjects.len());
        return Err(StudyError::TooFewMatches { matched: found, all, purpose: "for a shape model", reason });
    }
    let joint = match study.settings.correspondence {
        Correspondence::Pairs => None,
        Correspondence::Joint => {
            watcher.progress("joint maps", 0, 1);
            Some(crate::joint::revised(study, matched, folder, &mut subjects, observer)?)
        }
    };
    Ok((subjects, members, joint))
}

/// A subject's shape, moved onto the mean.
pub(crate) fn shape_on_mean(
    study: &Study,
    matched: &Matched,
    folder: &Folder,
    alignment: &Alignment,
    k: usize,
) -> Result<Vec<Point3<f64>>, StudyError> {
    let (own, transform) = onto_mean(study, matched, folder, alignment, k)?;
    Ok(own.iter().map(|p| transform.apply(p)).collect())
}

/// A subject's shape as stored, and its transform onto the mean.
pub(crate) fn onto_mean(
    study: &Study,
    matched: &Matched,
    folder: &Folder,
    alignment: &Alignment,
    k: usize,
) -> Result<(Vec<Point3<f64>>, SimilarityTransform), StudyError> {
    let record = folder.get(&matched.keys[k])?;
    let own = record.map(|record| points(&record.points)).unwrap_or_default();
    let sized = study.settings.size == Size::Removed;
    let id = || study.cohort.subjects[k].id.clone();
    let transform = fit_onto(&own, &alignment.mean, &alignment.weights, sized)
        .map_err(|error| StudyError::Alignment { id: id(), error })?;
    Ok((own, transform))
}

/// A subject's label volume and its labels that belong to the structure, ascending; `None` for a surface.
pub(crate) fn volume_of(
    study: &Study,
    folder: &Folder,
    k: usize,
) -> Result<Option<(LabelVolume, Vec<u32>)>, StudyError> {
    let file = &study.cohort.subjects[k].file;
    let bytes = folder.input(file)?;
    Ok(volume(&bytes, file.file_name().and_then(|name| name.to_str()), &study.input_of(k).labels))
}

fn volume(bytes: &[u8], name: Option<&str>, chosen: &Option<Vec<LabelChoice>>) -> Option<(LabelVolume, Vec<u32>)> {
    let read = homolog_formats::read(bytes, name, &ReadLimits::default()).ok()?;
    let FileContent::Labels(volume) = read.content else { return None };
    let numbers = match chosen {
        Some(chosen) => Some(chosen_numbers(chosen, &read.label_names, &volume).ok()?),
        None => None,
    };
    let is_chosen = |label: u32| numbers.as_ref().is_none_or(|numbers| numbers.contains(&label));
    let labels = volume.label_counts().into_keys().filter(|&label| is_chosen(label)).collect();
    Some((volume, labels))
}

/// Labels of the template and their transfer to all subjects.
fn labels(
    study: &Study,
    matched: &Matched,
    folder: &Folder,
    subjects: &mut [SubjectFindings],
    observer: &dyn Observer,
) -> Result<Option<LabelFindings>, StudyError> {
    let mesh = &matched.making.template.mesh;
    let usable: Vec<usize> = (0..subjects.len()).filter(|&k| subjects[k].place != SubjectOutcome::Failed).collect();
    let shape = |k: usize| -> Result<Vec<Point3<f64>>, StudyError> {
        // The labels are in the subject's file.
        let own = folder.get(&matched.keys[k])?.map(|record| points(&record.points)).unwrap_or_default();
        Ok(crate::mirror::in_file(own, study.is_mirrored(k)))
    };
    type Voted = (usize, Vec<u32>, Vec<Option<u32>>);
    let votes: Vec<Option<Voted>> = usable
        .par_iter()
        .map(|&k| {
            checkpoint(observer)?;
            let Some((volume, labels)) = volume_of(study, folder, k)?.filter(|(_, labels)| labels.len() > 1) else {
                return Ok(None);
            };
            let vote = labels_at(&volume, &labels, &shape(k)?, observer)?;
            Ok(Some((k, labels, vote)))
        })
        .collect::<Result<_, StudyError>>()?;
    let votes: Vec<Voted> = votes.into_iter().flatten().collect();
    let own = match &study.settings.template {
        TemplateChoice::Given { file } => {
            let name = file.file_name().and_then(|name| name.to_str());
            let found = volume(&folder.input(file)?, name, &study.settings.parameters.input.of_source().labels);
            match found.filter(|(_, labels)| labels.len() > 1) {
                Some((volume, labels)) => {
                    let of = labels_at(&volume, &labels, mesh.vertices(), observer)?;
                    Some((labels, of))
                }
                None => None,
            }
        }
        TemplateChoice::Made(_) => None,
    };
    let of_template = own.is_some();
    let n = mesh.n_vertices();
    let (labels, of_vertex) = match own {
        Some(own) => own,
        None if votes.is_empty() => return Ok(None),
        None => {
            let labels: BTreeSet<u32> = votes.iter().flat_map(|(_, labels, _)| labels.iter().copied()).collect();
            let members = votes.iter().filter(|(k, ..)| subjects[*k].place == SubjectOutcome::Model);
            (labels.into_iter().collect(), voted(members.map(|(_, _, vote)| vote.as_slice()), n))
        }
    };
    // Each half of the subjects, taken alternately, votes for the other, so that no subject's labels are transferred
    // back to it.
    let half = |which: usize| {
        let some = votes.iter().enumerate().filter(|(row, _)| row % 2 == which);
        voted(some.map(|(_, (_, _, vote))| vote.as_slice()), n)
    };
    let halves = [half(0), half(1)];
    type Carried = (usize, BTreeMap<u32, LabelSize>, Option<Vec<Option<f64>>>);
    let rows: BTreeMap<usize, usize> = votes.iter().enumerate().map(|(row, (k, ..))| (*k, row)).collect();
    let found: Vec<Carried> = usable
        .par_iter()
        .map(|&k| {
            checkpoint(observer)?;
            let bent = mesh.with_vertices(shape(k)?)?;
            let areas = crate::align::vertex_areas(&bent);
            let area = |label: u32| {
                areas.iter().zip(&of_vertex).filter(|(_, of)| **of == Some(label)).map(|(area, _)| area).sum::<f64>()
            };
            let size = |&label: &u32| (label, LabelSize { area_mm2: area(label), volume_mm3: None });
            let mut each: BTreeMap<u32, LabelSize> = labels.iter().map(size).collect();
            let mut overlap = None;
            if let Some((volume, structure)) = volume_of(study, folder, k)? {
                let voxel = volume.affine().fixed_view::<3, 3>(0, 0).determinant().abs();
                for label in carried(&volume, &structure, &bent, &of_vertex, observer)? {
                    if let Some(size) = each.get_mut(&label) {
                        size.volume_mm3 = Some(size.volume_mm3.unwrap_or(0.0) + voxel);
                    }
                }
                if let Some(row) = rows.get(&k).filter(|_| of_template || votes.len() > 1) {
                    let by = if of_template { &of_vertex } else { &halves[(row + 1) % 2] };
                    let back = carried(&volume, &structure, &bent, by, observer)?;
                    overlap = Some(dice(&back, volume.labels(), &labels));
                }
            }
            Ok((k, each, overlap))
        })
        .collect::<Result<_, StudyError>>()?;
    let mut overlaps = Vec::new();
    for (k, each, overlap) in found {
        subjects[k].labels = each;
        overlaps.extend(overlap.map(|dice| (k, dice)));
    }
    Ok(Some(LabelFindings { labels, of_vertex, of_template, dice: overlaps }))
}

#[allow(clippy::too_many_arguments)]
fn statistics(
    study: &Study,
    matched: &Matched,
    complex: Option<&Complex>,
    folder: &Folder,
    alignment: &Alignment,
    mean: &SurfaceMesh,
    subjects: &[SubjectFindings],
    members: &[usize],
    watcher: &dyn StudyObserver,
) -> Result<Option<Statistics>, StudyError> {
    let (analysis, observer) = (&study.settings.analysis, &Interruption(watcher));
    if analysis.effect.is_none() && analysis.contrasts.is_empty() {
        return Ok(None);
    }
    let design = Design::new(&study.cohort, members, analysis).map_err(StudyError::Settings)?;
    let people: Vec<&String> = design.rows.iter().map(|&k| &study.cohort.subjects[k].subject).collect();
    let known: BTreeSet<&String> = people.iter().copied().collect();
    let longitudinal = known.len() < people.len();
    let person: Vec<usize> =
        people.iter().map(|id| known.iter().position(|other| other == id).unwrap_or_default()).collect();
    let pairs = if longitudinal { Pairs::of(&study.cohort, &design, analysis) } else { None };
    let longitudinal = longitudinal && pairs.is_none();
    let ones = |n: usize| Mat::from_fn(n, 1, |_, _| 1.0);
    let linear = LinearModel::new(&pairs.as_ref().map_or_else(|| design.matrix.clone(), |of| ones(of.pairs.len())));
    // Of the differences there is only their mean.
    let exchange = if pairs.is_some() { Exchange::SignFlips } else { Exchange::Permutations };
    let weights = |contrast: &Contrast| if pairs.is_some() { vec![1.0] } else { contrast.weights.clone() };
    let compared = |of: Vec<Vec<f64>>| match &pairs {
        Some(pairs) => pairs.differences(&of),
        None => of,
    };
    let mixed = MixedModel::new(&design.matrix, &person);
    let (graph, areas) = (mean.edge_graph(), crate::align::vertex_areas(mean));
    let enhancer = Enhancer::new(&graph, &areas);
    let (mut maps, mut left_out) = (Vec::new(), Vec::new());
    for (done, &measure) in analysis.measures.iter().enumerate() {
        let of_subjects: Vec<Option<Vec<f64>>> = design
            .rows
            .par_iter()
            .map(|&k| {
                let own = mean.with_vertices(shape_on_mean(study, matched, folder, alignment, k)?)?;
                measured_by_structure(complex, measure, [mean, &own], observer)
            })
            .collect::<Result<_, StudyError>>()?;
        let Some(of_subjects) = of_subjects.into_iter().collect::<Option<Vec<_>>>() else {
            left_out.push(measure);
            continue;
        };
        let values = VertexValues::from_subjects(&compared(of_subjects));
        for (place, contrast) in design.contrasts.iter().enumerate() {
            checkpoint(observer)?;
            watcher.progress(
                "statistics",
                done * design.contrasts.len() + place,
                analysis.measures.len() * design.contrasts.len(),
            );
            maps.push(if longitudinal {
                let mixed = mixed.contrast(&values, &contrast.weights, observer)?;
                let q = false_discovery(&mixed.p);
                StatisticMap { measure, contrast: place, linear: None, mixed: Some(mixed), q }
            } else {
                let (weights, how_many) = (weights(contrast), (analysis.permutations, analysis.seed));
                let map = linear.contrast(&values, &weights, observer)?;
                let permuted = test_by(exchange, &linear, &values, &weights, &enhancer, how_many, observer)?;
                let q = false_discovery(&map.robust_p);
                StatisticMap { measure, contrast: place, linear: Some((map, permuted)), mixed: None, q }
            });
        }
    }
    let rows: Vec<&SubjectFindings> = design.rows.iter().map(|&k| &subjects[k]).collect();
    let contrasts: Vec<(&Contrast, Vec<f64>)> = design.contrasts.iter().map(|of| (of, weights(of))).collect();
    let whole = if longitudinal { Vec::new() } else { whole_effects(&linear, &contrasts, &rows, &compared, observer)? };
    // The sizes of groups that a further study would need are of no pairs.
    let is_plain = !longitudinal && pairs.is_none();
    let planning = if is_plain { planning(&linear, &design, observer)? } else { Vec::new() };
    let degrees = linear.degrees();
    Ok(Some(Statistics { design, longitudinal, pairs, degrees, maps, left_out, whole, planning }))
}

/// Effects in variables of whole subjects.
fn whole_effects(
    linear: &LinearModel,
    contrasts: &[(&Contrast, Vec<f64>)],
    rows: &[&SubjectFindings],
    compared: &dyn Fn(Vec<Vec<f64>>) -> Vec<Vec<f64>>,
    observer: &dyn Observer,
) -> Result<Vec<WholeEffect>, Cancelled> {
    let mut effects = Vec::new();
    for (variable, values) in crate::whole::variables(rows) {
        let values = VertexValues::from_subjects(&compared(values.iter().map(|&value| vec![value]).collect()));
        for (Contrast { name, .. }, weights) in contrasts {
            let length = crate::statistics::linear::norm(&linear.observation_weights(weights));
            let effect = effect(&linear.contrast(&values, weights, observer)?, linear.degrees(), length);
            effects.push(WholeEffect { variable: variable.clone(), contrast: name.clone(), effect });
        }
    }
    Ok(effects)
}

fn planning(linear: &LinearModel, design: &Design, observer: &dyn Observer) -> Result<Vec<Planning>, Cancelled> {
    let mut planning = Vec::new();
    for contrast in design.contrasts.iter().filter(|contrast| contrast.of_levels) {
        let length = crate::statistics::linear::norm(&linear.observation_weights(&contrast.weights));
        for d in [0.2, 0.5, 0.8] {
            checkpoint(observer)?;
            let subjects = subjects_needed(d, design.rows.len(), design.columns.len(), length, 0.05, 0.8);
            planning.push(Planning { contrast: contrast.name.clone(), d, subjects });
        }
    }
    Ok(planning)
}
