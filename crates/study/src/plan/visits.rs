//! The matches that the templates of persons need, as a pure function of the finished ones.

use crate::error::StudyError;
use crate::plan::{Purpose, Records, Step, Study, Task, Template, mean_on};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Observer, checkpoint};
use rayon::prelude::*;
use std::sync::Arc;

/// Persons whose templates are in memory at a time.
const AT_A_TIME: usize = 256;
/// Fewest visits of which a mean is made.
const FEWEST: usize = 2;

/// The visits of a person on one side, and the surface from which its own template is made.
#[derive(Debug, Clone)]
pub struct Person {
    /// Its rows, at least two, as indices into the cohort; their order does not depend on the order of the table.
    pub visits: Vec<usize>,
    /// The visit of median volume.
    pub start: usize,
    /// The surface of that visit, on the side of the template, with all vertices of its file.
    pub surface: Arc<SurfaceMesh>,
}

/// The maps of a person that has a template of its own.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OwnMaps {
    /// The person, as an index into [`Study::persons`].
    pub person: usize,
    /// Key of the match of the template of the group to the person's.
    pub onto: String,
    /// Keys of the matches of the person's first template to each of its visits, in the order of [`Person::visits`].
    pub visits: Vec<String>,
}

/// Missing matches of persons, or their maps.
pub(crate) enum PersonsState {
    /// All matches exist.
    Ready(Vec<OwnMaps>),
    /// A step that comes first.
    Missing(Step),
}

/// The templates of a person: the first one, with the keys of its matches to the visits, and the mean of its images,
/// `None` before these matches exist, or if too few of them are usable.
struct Templates {
    first: Template,
    visits: Vec<String>,
    last: Option<Template>,
}

/// The mean of shapes on a mesh, which lies where the mesh does; `None` for fewer than two shapes.
fn mean_of(
    mesh: &SurfaceMesh,
    shapes: &Vec<Vec<[f32; 3]>>,
    observer: &dyn Observer,
) -> Result<Option<Template>, StudyError> {
    if shapes.len() < FEWEST {
        return Ok(None);
    }
    let mean = mean_on(mesh, shapes, "of a mean of visits", observer)?;
    Ok(Some(Template::new(&mesh.with_vertices(mean)?)))
}

/// The points of a record, unless it says that its match is unusable.
fn usable(records: &dyn Records, key: &str, n_vertices: usize) -> Result<Option<Vec<[f32; 3]>>, StudyError> {
    let found = records.get(key)?.filter(|record| record.is_reliable_map_of(n_vertices));
    Ok(found.map(|record| record.points))
}

impl Study {
    /// The matches of the visit of median volume to the others, in the order of the visits.
    fn within(&self, person: &Person) -> Vec<Task> {
        let others = person.visits.iter().filter(|&&k| k != person.start);
        // No template takes part.
        others.map(|&k| self.task("", Some(person.start), Some(k))).collect()
    }

    /// The first template of a person, if enough matches of its visits are usable.
    fn first_of(
        &self,
        person: &Person,
        records: &dyn Records,
        observer: &dyn Observer,
    ) -> Result<Option<Template>, StudyError> {
        checkpoint(observer)?;
        let mesh = &person.surface;
        let mut shapes: Vec<Vec<[f32; 3]>> =
            vec![mesh.vertices().iter().map(|p| [p.x, p.y, p.z].map(|x| x as f32)).collect()];
        for task in self.within(person) {
            shapes.extend(usable(records, &task.key, mesh.n_vertices())?);
        }
        mean_of(mesh, &shapes, observer)
    }

    /// The templates of a person as far as they follow from the records; `None` without a first one.
    fn templates_of(
        &self,
        person: &Person,
        records: &dyn Records,
        observer: &dyn Observer,
    ) -> Result<Option<Templates>, StudyError> {
        let Some(first) = self.first_of(person, records, observer)? else { return Ok(None) };
        let visits: Vec<String> = person.visits.iter().map(|&k| self.task(&first.hash, None, Some(k)).key).collect();
        let mut shapes = Vec::new();
        if visits.iter().all(|key| records.has(key)) {
            for key in &visits {
                shapes.extend(usable(records, key, first.mesh.n_vertices())?);
            }
        }
        let last = mean_of(&first.mesh, &shapes, observer)?;
        Ok(Some(Templates { first, visits, last }))
    }

    /// The template of a person that has one, from the records of its matches.
    ///
    /// # Errors
    /// [`StudyError::Internal`] if a record is not there any more; errors of reading.
    pub(crate) fn own_template(
        &self,
        maps: &OwnMaps,
        records: &dyn Records,
        observer: &dyn Observer,
    ) -> Result<Template, StudyError> {
        let found = self.templates_of(&self.persons[maps.person], records, observer)?.and_then(|found| found.last);
        found.ok_or_else(|| StudyError::Internal("a record of a person's template was removed meanwhile".to_owned()))
    }

    /// The next matches for the templates of persons, or the maps of those that have one. `template`: that of the group.
    ///
    /// # Errors
    /// Errors of reading records; [`StudyError::Interrupted`].
    ///
    /// # Cost
    /// An alignment of the visits of each person for each of its two means.
    pub(crate) fn own_maps(
        &self,
        template: &Template,
        records: &dyn Records,
        observer: &dyn Observer,
    ) -> Result<PersonsState, StudyError> {
        let step = |round: usize, tasks: Vec<Task>, own: Vec<Template>| {
            Step::missing(Purpose::Visits(round), template, tasks, own, records)
        };
        let pairs = self.persons.iter().flat_map(|person| self.within(person)).collect();
        if let Some(step) = step(1, pairs, Vec::new()) {
            return Ok(PersonsState::Missing(step));
        }
        let mut ready = Vec::new();
        for (chunk, persons) in self.persons.chunks(AT_A_TIME).enumerate() {
            let found: Vec<Option<Templates>> = persons
                .par_iter()
                .map(|person| self.templates_of(person, records, observer))
                .collect::<Result<_, StudyError>>()?;
            let (mut tasks, mut own) = (Vec::new(), Vec::new());
            for (person, found) in persons.iter().zip(&found) {
                let Some(found) = found else { continue };
                let of_visits = found.visits.iter().cloned().zip(&person.visits);
                let task = |(key, &k)| Task { key, source: None, target: Some(k), own: Some(own.len()), rival: None };
                tasks.extend(of_visits.map(task));
                own.push(found.first.clone());
            }
            if let Some(step) = step(2, tasks, own) {
                return Ok(PersonsState::Missing(step));
            }
            let (mut tasks, mut own) = (Vec::new(), Vec::new());
            for (k, found) in found.into_iter().enumerate() {
                let Some(Templates { visits, last: Some(last), .. }) = found else { continue };
                let key = self.key([&template.hash, &last.hash], &Task::between_templates(own.len()));
                tasks.push(Task { key: key.clone(), ..Task::between_templates(own.len()) });
                ready.push(OwnMaps { person: AT_A_TIME * chunk + k, onto: key, visits });
                own.push(last);
            }
            if let Some(step) = step(3, tasks, own) {
                return Ok(PersonsState::Missing(step));
            }
        }
        Ok(PersonsState::Ready(ready))
    }
}
