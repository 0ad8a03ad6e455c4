//! The outline of a study: a page of its subjects and the decisions about them, without their covariates.
//!
//! A definition may have a thousand subjects of hundreds of covariates, which take ten times their stored size when they are
//! read. Here they are passed over while the text is read.

use super::documents::{BodySide, LabelChoice};
use super::error::JobError;
use super::ids::StudyId;
use super::job::Tenant;
use super::service::JobService;
use super::study::{SubjectDecision, SubjectRole};
use super::study_progress::definition_bytes;
use serde::Deserialize;
use serde::de::{DeserializeSeed, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde_json::Value;
use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;

/// A page of a study's subjects.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StudyOutline {
    /// The subjects, in the order in which they were added.
    pub subjects: Vec<OutlinedSubject>,
    /// Subjects of the study.
    pub n_subjects: usize,
    /// Effective parameters of every match.
    pub parameters: Value,
}

/// A subject in the outline of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct OutlinedSubject {
    /// Its name in all outputs.
    pub id: String,
    /// Its role in the study.
    pub role: SubjectRole,
    /// On which side of the body it lies.
    pub side: Option<BodySide>,
    /// Labels of its volume that belong to the structure, if it states any.
    pub labels: Option<Vec<LabelChoice>>,
    /// Which structure it is, in a study of several.
    pub structure: Option<String>,
    /// Hash of its surface or label volume.
    pub hash: String,
    /// The decision about it.
    pub decision: Option<SubjectDecision>,
}

impl StudyOutline {
    /// The subjects at these places of the definition in `bytes`. `O(bytes)`; holds no more than the page and one decision for
    /// each of its subjects.
    ///
    /// # Errors
    /// That of `serde_json`, if `bytes` are no definition.
    pub fn read(bytes: &[u8], places: Range<usize>) -> serde_json::Result<Self> {
        let mut reader = serde_json::Deserializer::from_slice(bytes);
        let outline = Definition { places }.deserialize(&mut reader)?;
        reader.end()?;
        Ok(outline)
    }
}

#[derive(Deserialize)]
struct Subject {
    id: String,
    role: SubjectRole,
    #[serde(default)]
    side: Option<BodySide>,
    #[serde(default)]
    labels: Option<Vec<LabelChoice>>,
    #[serde(default)]
    structure: Option<String>,
    input: Input,
}

#[derive(Deserialize)]
struct Input {
    hash: String,
}

/// Reads a definition.
struct Definition {
    places: Range<usize>,
}

impl<'de> DeserializeSeed<'de> for Definition {
    type Value = StudyOutline;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<StudyOutline, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for Definition {
    type Value = StudyOutline;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the definition of a study")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<StudyOutline, A::Error> {
        let mut outline = StudyOutline::default();
        let mut decisions: Vec<SubjectDecision> = Vec::new();
        while let Some(name) = map.next_key::<String>()? {
            match name.as_str() {
                "subjects" => {
                    let (subjects, n_subjects) = map.next_value_seed(Subjects { places: self.places.clone() })?;
                    (outline.subjects, outline.n_subjects) = (subjects, n_subjects);
                }
                "parameters" => outline.parameters = map.next_value()?,
                "decisions" => decisions = map.next_value()?,
                _ => drop(map.next_value::<IgnoredAny>()?),
            }
        }
        let mut decided: BTreeMap<String, SubjectDecision> =
            decisions.into_iter().map(|decision| (decision.id.clone(), decision)).collect();
        for subject in &mut outline.subjects {
            subject.decision = decided.remove(&subject.id);
        }
        Ok(outline)
    }
}

/// Reads the subjects at some places, and counts all.
struct Subjects {
    places: Range<usize>,
}

impl<'de> DeserializeSeed<'de> for Subjects {
    type Value = (Vec<OutlinedSubject>, usize);

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for Subjects {
    type Value = (Vec<OutlinedSubject>, usize);

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of subjects")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self::Value, A::Error> {
        let (mut page, mut n_subjects) = (Vec::new(), 0);
        loop {
            if self.places.contains(&n_subjects) {
                let Some(Subject { id, role, side, labels, structure, input }) = list.next_element()? else { break };
                page.push(OutlinedSubject { id, role, side, labels, structure, hash: input.hash, decision: None });
            } else if list.next_element::<IgnoredAny>()?.is_none() {
                break;
            }
            n_subjects += 1;
        }
        Ok((page, n_subjects))
    }
}

impl JobService {
    /// The subjects of a study at these places, in the order in which they were added; `None` if its definition has outlived
    /// its retention.
    ///
    /// # Errors
    /// [`JobError::StudyNotFound`], and those of the stores.
    pub async fn study_outline(
        &self,
        tenant: &Tenant,
        id: StudyId,
        places: Range<usize>,
    ) -> Result<Option<StudyOutline>, JobError> {
        let found = definition_bytes(self.stores.studies.as_ref(), self.stores.artifacts.as_ref(), tenant, id).await;
        let bytes = match found {
            Err(JobError::Gone) => return Ok(None),
            bytes => bytes?,
        };
        // Megabytes take a while, for which this thread has others to serve.
        let read = tokio::task::spawn_blocking(move || StudyOutline::read(&bytes, places)).await;
        let read = read.map_err(|join| JobError::Unavailable(Box::new(join)))?;
        read.map(Some).map_err(|error| JobError::corrupt("the definition of a study", error))
    }
}

#[cfg(test)]
mod tests {
    use super::super::job::JobInput;
    use super::super::study::{DecisionVerdict, StudyDefinition, StudyQuestions, StudySubject};
    use super::*;
    use proptest::prelude::*;
    use serde_json::json;

    fn definition(n: usize, decided: &[usize]) -> StudyDefinition {
        let subject = |k: usize| StudySubject {
            id: format!("s{k}"),
            subject: k.is_multiple_of(3).then(|| format!("\"person\" {k}")),
            role: if k % 4 == 1 { SubjectRole::Score } else { SubjectRole::Model },
            side: [None, Some(BodySide::Left), Some(BodySide::Right)][k % 3],
            labels: (k % 2 == 1).then(|| vec![LabelChoice::Number(17), LabelChoice::Name("CA\"1".to_owned())]),
            structure: (k % 5 == 2).then(|| "amygdala".to_owned()),
            covariates: (0..k % 5).map(|c| (format!("id{c}"), "\u{e9}\\\"}]".to_owned())).collect(),
            input: JobInput {
                hash: format!("hash{k}"),
                n_bytes: 1,
                name_hint: None,
                n_vertices: 3,
                n_faces: 1,
                report: json!({"hash": "no", "id": [1, {"role": "model"}]}),
            },
        };
        let decision =
            |k: &usize| SubjectDecision { id: format!("s{k}"), decision: DecisionVerdict::Dropped, reason: "r".into() };
        StudyDefinition {
            subjects: (0..n).map(subject).collect(),
            template: None,
            questions: StudyQuestions::default(),
            parameters: json!({"method": "smooth_field", "subjects": []}),
            decisions: decided.iter().map(decision).collect(),
        }
    }

    proptest! {
        /// The pages are those of the definition that is read whole, for any definition and any places.
        #[test]
        fn a_page_is_that_of_the_whole_definition(
            n in 0..40usize, decided in prop::collection::btree_set(0..40usize, 0..8), first in 0..50usize, size in 0..50usize,
        ) {
            let decided: Vec<usize> = decided.into_iter().rev().collect();
            let whole = definition(n, &decided);
            let bytes = serde_json::to_vec(&whole).unwrap();
            let read = StudyOutline::read(&bytes, first..first + size).unwrap();
            let expected: Vec<OutlinedSubject> = whole.subjects.iter().skip(first).take(size).map(|subject| OutlinedSubject {
                id: subject.id.clone(),
                role: subject.role,
                side: subject.side,
                labels: subject.labels.clone(),
                structure: subject.structure.clone(),
                hash: subject.input.hash.clone(),
                decision: whole.decisions.iter().find(|decision| decision.id == subject.id).cloned(),
            }).collect();
            prop_assert_eq!(read, StudyOutline { subjects: expected, n_subjects: n, parameters: whole.parameters });
            prop_assert!(StudyOutline::read(&bytes[..bytes.len() - 1], 0..1).is_err());
        }
    }
}
