//! JSON documents of studies.

use super::input_wire::{SubmittedInputDocument, input, maybe_input};
use super::options::submission_document;
use super::problem::{ProblemDocument, failure_document};
use super::strict_json::objects;
use crate::jobs::documents::{BodySide, LabelChoice, MatchParameters};
use crate::jobs::mesh::content_id;
use crate::jobs::study::{DecisionVerdict, StudyQuestions, SubjectRole};
use crate::jobs::{OutlinedSubject, Study, StudyOutline, StudyState};
use jiff::Timestamp;
use serde::de::{Error, MapAccess, SeqAccess, Unexpected, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Number, Value};
use std::collections::BTreeMap;
use std::fmt;
use utoipa::ToSchema;

/// Most covariates of a subject.
const MAX_COVARIATES: usize = 256;
/// Most entries of a list of names, or of an object of strings.
const MAX_NAMES: usize = 1000;
/// Most labels of a subject.
const MAX_LABELS: usize = 256;

submission_document! {
    /// A study to be submitted.
    struct StudySubmissionDocument {
        /// At least three, each with a surface or a label volume.
        #[serde(deserialize_with = "objects")]
        pub(crate) subjects: Vec<StudySubjectDocument>,
        /// The template; without it one is made from the group.
        #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "maybe_input")]
        #[schema(value_type = Option<SubmittedInputDocument>)]
        pub(crate) template: Option<SubmittedInputDocument>,
        /// On which side of the body the template lies, where subjects have a `side`; needed with a `template`. If absent, that of the
        /// subject from which it is made, or of most subjects.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        pub(crate) template_side: Option<BodySide>,
        /// Id of the subject whose surface the template is made from; the one of median volume if absent.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        pub(crate) start: Option<String>,
        /// Most subjects that the template is made from, spread over the list; 0: all; 12 if absent.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schema(maximum = 100000)]
        pub(crate) template_subjects: Option<u32>,
        /// Most rounds of matching and averaging; 4 if absent.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schema(minimum = 1, maximum = 20)]
        pub(crate) template_rounds: Option<u32>,
        /// Take size out of shape: subjects are scaled to one size.
        #[serde(default)]
        pub(crate) without_size: bool,
        /// Origin of the maps: `pairs`, each subject's own match with the template, or `joint`, these matches revised together under a
        /// model of the group; `pairs` if absent.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        pub(crate) correspondence: Option<String>,
        /// What visits, subjects with one `subject` and side, are matched with: `group_template`, the template, each separately, or
        /// `own_template`, a template of the person that is made from its visits; `group_template` if absent.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        pub(crate) visits: Option<String>,
        /// What becomes of subjects whose only doubt is `ambiguous_pose`: `decide`, each is also matched in its other poses, and the group
        /// decides between them where it can, or `leave_out`; `decide` if absent.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        pub(crate) rivals: Option<String>,
        /// Subjects among which the consistency of maps is measured, at three matches each; not measured if absent.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schema(maximum = 1000)]
        pub(crate) cycles: Option<u32>,
        /// Covariate whose effect is tested: the difference between its levels, or its slope.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        pub(crate) effect: Option<String>,
        /// Covariates to adjust for.
        #[serde(default, skip_serializing_if = "Vec::is_empty", deserialize_with = "names")]
        pub(crate) adjust: Vec<String>,
        /// Level with which the others of a covariate are compared; the first in alphabetical order if absent.
        #[serde(default, skip_serializing_if = "BTreeMap::is_empty", deserialize_with = "pairs")]
        pub(crate) reference: BTreeMap<String, String>,
        /// Further contrasts: a name, and a sum of columns of the design such as `group:severe - group:mild`.
        #[serde(default, skip_serializing_if = "BTreeMap::is_empty", deserialize_with = "pairs")]
        pub(crate) contrasts: BTreeMap<String, String>,
        /// What is tested at every vertex: `normal_displacement`, `log_area`, `thickness`; all if absent.
        #[serde(default, skip_serializing_if = "Vec::is_empty", deserialize_with = "names")]
        pub(crate) measures: Vec<String>,
        /// Permutations of each test; 2000 if absent.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schema(minimum = 1, maximum = 1000000)]
        pub(crate) permutations: Option<u32>,
    } options {
        parameters: "Parameters of every match.",
        tags: "Tags of the study and of its matches.",
        external_ref: "The client's own id of the study.",
        priority: "Its jobs run before those with a lower priority.",
        max_run_s: "Longest run time of a match, s, up to the limit of the service."
    }
}

impl StudySubmissionDocument {
    /// The questions of a study: everything except subjects, inputs and parameters.
    pub(crate) fn questions(&self) -> StudyQuestions {
        StudyQuestions {
            template_side: self.template_side,
            start: self.start.clone(),
            template_subjects: self.template_subjects,
            template_rounds: self.template_rounds,
            without_size: self.without_size,
            correspondence: self.correspondence.clone(),
            visits: self.visits.clone(),
            rivals: self.rivals.clone(),
            cycles: self.cycles.unwrap_or(0),
            effect: self.effect.clone(),
            adjust: self.adjust.clone(),
            reference: self.reference.clone(),
            contrasts: self.contrasts.clone(),
            measures: self.measures.clone(),
            permutations: self.permutations,
        }
    }
}

/// Reads a list of at most [`MAX_NAMES`] strings.
fn names<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<String>, D::Error> {
    struct Reader;

    impl<'de> Visitor<'de> for Reader {
        type Value = Vec<String>;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(f, "a list of at most {MAX_NAMES} strings")
        }

        fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vec<String>, A::Error> {
            let mut names = Vec::new();
            while let Some(name) = list.next_element()? {
                names.push(name);
                if names.len() > MAX_NAMES {
                    return Err(A::Error::invalid_length(names.len(), &self));
                }
            }
            Ok(names)
        }
    }

    deserializer.deserialize_seq(Reader)
}

/// Reads at most [`MAX_LABELS`] labels; a single one may stand without brackets, and `null` is none.
pub(super) fn labels<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Vec<LabelChoice>>, D::Error> {
    struct Reader;

    impl<'de> Visitor<'de> for Reader {
        type Value = Option<Vec<LabelChoice>>;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(f, "a label, which is a whole number from 1 on or a name, or a list of at most {MAX_LABELS}")
        }

        fn visit_unit<E: Error>(self) -> Result<Self::Value, E> {
            Ok(None)
        }

        fn visit_u64<E: Error>(self, number: u64) -> Result<Self::Value, E> {
            match u32::try_from(number) {
                Ok(number) => Ok(Some(vec![LabelChoice::Number(number)])),
                Err(_) => Err(E::invalid_value(Unexpected::Unsigned(number), &self)),
            }
        }

        fn visit_str<E: Error>(self, name: &str) -> Result<Self::Value, E> {
            Ok(Some(vec![LabelChoice::Name(name.to_owned())]))
        }

        fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
            let mut labels = Vec::new();
            while let Some(label) = list.next_element()? {
                labels.push(label);
                if labels.len() > MAX_LABELS {
                    return Err(A::Error::invalid_length(labels.len(), &self));
                }
            }
            Ok(Some(labels))
        }
    }

    deserializer.deserialize_any(Reader)
}

/// Reads an object of at most [`MAX_NAMES`] strings, no member twice.
fn pairs<'de, D: Deserializer<'de>>(deserializer: D) -> Result<BTreeMap<String, String>, D::Error> {
    struct Reader;

    impl<'de> Visitor<'de> for Reader {
        type Value = BTreeMap<String, String>;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(f, "a JSON object of at most {MAX_NAMES} strings")
        }

        fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<BTreeMap<String, String>, A::Error> {
            let mut pairs = BTreeMap::new();
            while let Some((name, value)) = map.next_entry()? {
                if pairs.insert(name, value).is_some() {
                    return Err(A::Error::custom("this member is given twice"));
                }
                if pairs.len() > MAX_NAMES {
                    return Err(A::Error::invalid_length(pairs.len(), &self));
                }
            }
            Ok(pairs)
        }
    }

    deserializer.deserialize_map(Reader)
}

/// A subject of a study.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct StudySubjectDocument {
    /// Its name in all outputs: letters, digits, `_`, `-` and `.`; unique.
    #[schema(min_length = 1, max_length = 200)]
    pub(crate) id: String,
    /// Its surface or label volume.
    #[serde(deserialize_with = "input")]
    pub(crate) input: SubmittedInputDocument,
    /// Who it is, where one person has several visits; the id if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) subject: Option<String>,
    /// `model` (default): part of the model and the statistics; `score`: only compared with the model of the others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<SubjectRole>)]
    pub(crate) role: Option<SubjectRole>,
    /// On which side of the body it lies. One on the other side than the template is mirrored; `side` is a covariate too.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) side: Option<BodySide>,
    /// Labels of its volume that belong to the structure, by number or name, as in `input.labels` of the parameters, which hold
    /// if this is absent. Several subjects may use labels of one volume. A single one may stand without brackets.
    #[serde(default, deserialize_with = "labels", skip_serializing_if = "Option::is_none")]
    #[schema(min_items = 1)]
    pub(crate) labels: Option<Vec<LabelChoice>>,
    /// Which structure it is, where several of one person are analyzed together, their relative pose kept: those with the same `subject`,
    /// `side` and covariate `visit` belong together. Either all subjects state it, and `subject` too, or none does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(min_length = 1, max_length = 200)]
    pub(crate) structure: Option<String>,
    /// Covariates: a number if it is one for all subjects, else a factor; missing values are absent or `null`.
    #[serde(default)]
    #[schema(value_type = BTreeMap<String, CovariateValue>, required = false)]
    pub(crate) covariates: Covariates,
}

/// The value of a covariate.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, ToSchema)]
#[serde(untagged)]
pub(crate) enum CovariateValue {
    /// A number.
    #[schema(value_type = f64)]
    Number(Number),
    /// A level of a factor.
    Level(String),
}

/// The covariates of a subject as sent, as text.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub(crate) struct Covariates(pub(crate) BTreeMap<String, String>);

impl Covariates {
    /// Whether there are none.
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<'de> Deserialize<'de> for Covariates {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reader;

        impl<'de> Visitor<'de> for Reader {
            type Value = Covariates;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a JSON object of numbers, strings and null")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Covariates, A::Error> {
                let mut covariates = BTreeMap::new();
                while let Some((name, value)) = map.next_entry::<String, Option<CovariateValue>>()? {
                    let text = match value {
                        None => String::new(),
                        Some(CovariateValue::Number(number)) => number.to_string(),
                        Some(CovariateValue::Level(level)) => level,
                    };
                    if covariates.insert(name, text).is_some() {
                        return Err(A::Error::custom("a covariate is given twice"));
                    }
                    if covariates.len() > MAX_COVARIATES {
                        return Err(A::Error::custom(format!("at most {MAX_COVARIATES} covariates")));
                    }
                }
                Ok(Covariates(covariates))
            }
        }

        deserializer.deserialize_map(Reader)
    }
}

/// A study as a multipart form.
#[derive(Debug, Clone, ToSchema)]
#[allow(dead_code, reason = "describes a multipart form, which is read field by field")]
pub(crate) struct StudyForm {
    /// The study; its inputs refer to files by their names, as `{"upload": "subject-1.nii.gz"}`.
    document: StudySubmissionDocument,
    /// The files, under different names.
    #[schema(value_type = Vec<String>, format = Binary, required = false)]
    files: Vec<String>,
}

/// Subjects to be added to a study, as a multipart form.
#[derive(Debug, Clone, ToSchema)]
#[allow(dead_code, reason = "describes a multipart form, which is read field by field")]
pub(crate) struct AddedSubjectsForm {
    /// The subjects; their inputs refer to files by their names, as `{"upload": "subject-1.nii.gz"}`.
    document: AddedSubjectsDocument,
    /// The files, under different names.
    #[schema(value_type = Vec<String>, format = Binary, required = false)]
    files: Vec<String>,
}

/// Changes to a study.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct StudyChangeDocument {
    /// Its jobs run before those with a lower priority.
    #[schema(minimum = -100, maximum = 100)]
    pub(crate) priority: i32,
}

/// Subjects to be added to a study.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct AddedSubjectsDocument {
    /// At least one; each costs one match.
    #[serde(deserialize_with = "objects")]
    pub(crate) subjects: Vec<StudySubjectDocument>,
}

/// A decision about a subject.
#[derive(Debug, Clone, Deserialize, Serialize, ToSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct DecisionDocument {
    /// Whether it stays in the model and the statistics.
    pub(crate) decision: DecisionVerdict,
    /// Why.
    #[serde(default)]
    #[schema(max_length = 1000)]
    pub(crate) reason: String,
}

/// A study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct StudyDocument {
    /// UUIDv7.
    pub(crate) id: String,
    /// State of the study.
    pub(crate) state: StudyState,
    /// How far its matches are.
    pub(crate) progress: StudyProgressDocument,
    /// Number of subjects.
    pub(crate) n_subjects: u32,
    /// Name of the method of its matches.
    pub(crate) method: String,
    /// Version of the program that accepted it.
    pub(crate) method_version: String,
    /// Priority of its jobs.
    #[schema(minimum = -100, maximum = 100)]
    pub(crate) priority: i32,
    /// Tags of the client's choice.
    pub(crate) tags: BTreeMap<String, String>,
    /// The former name of `tags`, until 0.3.
    #[schema(deprecated)]
    pub(crate) labels: BTreeMap<String, String>,
    /// The client's own id.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) external_ref: Option<String>,
    /// When it was accepted.
    #[schema(value_type = String, format = DateTime)]
    pub(crate) created_at: Timestamp,
    /// When it finished, in whichever state.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub(crate) finished_at: Option<Timestamp>,
    /// When its result will be deleted.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<String>, format = DateTime)]
    pub(crate) expires_at: Option<Timestamp>,
    /// Why it has no result.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) error: Option<ProblemDocument>,
    /// All parameters of its matches, with defaults filled in; not in lists.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schema(value_type = Option<MatchParameters>)]
    pub(crate) parameters: Option<Value>,
    /// Its first 500 subjects, in the order in which they were added; not in lists. `links.subjects` has all, in pages.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) subjects: Option<Vec<StudySubjectStateDocument>>,
    /// Paths of related resources.
    pub(crate) links: StudyLinks,
}

/// How far the matches of a study are.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub(crate) struct StudyProgressDocument {
    /// The round of making a template to which the matches belong, from 1; 0 for the matches of all subjects.
    pub(crate) template_round: u32,
    /// Matches that are finished.
    pub(crate) matches_done: u32,
    /// All matches of this round.
    pub(crate) matches_total: u32,
}

/// A subject of a study, and what was decided about it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct StudySubjectStateDocument {
    /// Its name in all outputs.
    pub(crate) id: String,
    /// Id of its content, `blake3:` and 64 hexadecimal digits; of an upload, that of the upload.
    pub(crate) hash: String,
    /// What it is for.
    pub(crate) role: SubjectRole,
    /// On which side of the body it lies.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) side: Option<BodySide>,
    /// Labels of its volume that belong to the structure, if it states any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) labels: Option<Vec<LabelChoice>>,
    /// Which structure it is, in a study of several.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) structure: Option<String>,
    /// What was decided.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) decision: Option<DecisionVerdict>,
    /// Why.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) reason: Option<String>,
}

/// Paths of the resources of a study.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
pub(crate) struct StudyLinks {
    /// The study.
    #[serde(rename = "self")]
    pub(crate) study: String,
    /// Its matches.
    pub(crate) jobs: String,
    /// Its subjects.
    pub(crate) subjects: String,
    /// Its figures, if it is finished.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) result: Option<String>,
    /// A page about it, for browsers, if it is finished.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) report: Option<String>,
    /// Everything that was found, if it is finished.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) archive: Option<String>,
    /// Cancels it, until it is finished.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) cancel: Option<String>,
}

/// A page of the list of studies.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct StudyListDocument {
    /// The studies, newest first.
    pub(crate) studies: Vec<StudyDocument>,
    /// `page_token` of the next page; absent on the last one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) next_page_token: Option<String>,
}

/// A page of the list of a study's subjects.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct StudySubjectListDocument {
    /// The subjects, in the order in which they were added.
    pub(crate) subjects: Vec<StudySubjectStateDocument>,
    /// `page_token` of the next page; absent on the last one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) next_page_token: Option<String>,
}

/// The result of a study: the `study.json` that `homolog study` writes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, ToSchema)]
pub(crate) struct StudyResultDocument {
    /// Version of this document.
    pub(crate) format: u32,
    /// Version of homolog.
    pub(crate) version: String,
    /// Commit that it was built from.
    pub(crate) commit: String,
    /// Subjects and covariates.
    pub(crate) cohort: Value,
    /// Hash (BLAKE3) of each subject's file.
    pub(crate) hashes: Vec<String>,
    /// What was asked.
    pub(crate) settings: Value,
    /// What was decided.
    pub(crate) decisions: Value,
    /// Hash of the template.
    pub(crate) template: String,
    /// The rounds that made it.
    pub(crate) rounds: Value,
    /// Main figures: the shape model, effects, the smallest p of each map, consistency, labels.
    pub(crate) found: Value,
}

impl StudySubjectStateDocument {
    /// The displayed members of a subject.
    pub(crate) fn of(subject: &OutlinedSubject) -> Self {
        let decided = subject.decision.as_ref();
        StudySubjectStateDocument {
            id: subject.id.clone(),
            hash: content_id(&subject.hash),
            role: subject.role,
            side: subject.side,
            labels: subject.labels.clone(),
            structure: subject.structure.clone(),
            decision: decided.map(|decided| decided.decision),
            reason: decided.map(|decided| decided.reason.clone()),
        }
    }
}

impl StudyDocument {
    /// A study with its parameters and a page of its subjects, if they are known.
    pub(crate) fn of(study: &Study, outline: Option<&StudyOutline>) -> Self {
        let path = format!("/v1/studies/{}", study.id);
        let has_result = study.state == StudyState::Finished && study.purged_at.is_none();
        let part = |name: &str| has_result.then(|| format!("{path}/{name}"));
        let (matches_done, matches_total) = study.matches();
        let subjects = outline.map(|outline| outline.subjects.iter().map(StudySubjectStateDocument::of).collect());
        StudyDocument {
            id: study.id.to_string(),
            state: study.state,
            progress: StudyProgressDocument { template_round: study.progress.round, matches_done, matches_total },
            n_subjects: study.n_subjects,
            method: study.method.clone(),
            method_version: study.method_version.clone(),
            priority: study.priority,
            tags: study.tags.clone(),
            labels: study.tags.clone(),
            external_ref: study.external_ref.clone(),
            created_at: study.created_at,
            finished_at: study.finished_at,
            expires_at: study.expires_at,
            error: study.error.as_ref().map(failure_document),
            parameters: outline.map(|outline| outline.parameters.clone()),
            subjects,
            links: StudyLinks {
                jobs: format!("/v1/jobs?study={}", study.id),
                subjects: format!("{path}/subjects"),
                result: part("result"),
                report: part("report"),
                archive: part("archive"),
                cancel: (!study.state.is_final()).then(|| format!("{path}/cancel")),
                study: path,
            },
        }
    }
}
