//! A template of a person's own, between the template of the group and the visits of the person.
//!
//! Matched to each visit separately, the template of the group brings to every visit the error of a match of two different
//! subjects, which hides changes within the person. With [`crate::settings::Visits::OwnTemplate`] the visits meet in a
//! template of the person:
//!
//! 1. the visit of median volume is matched to the others. The mean of all of them, after Procrustes alignment, is the
//!    *first* template of the person, and that visit keeps no part in it but its triangles;
//! 2. the first template is matched to every visit. The mean of its images, in which all visits are treated alike, is the
//!    person's template. Its vertices are those of the first one, so its map to each visit is known and costs no match;
//! 3. the template of the group is matched to the person's template, once for all visits ([`crate::plan`]);
//! 4. the map to a visit is the composition of both ([`composed`]), so that the error of the match of two subjects is the
//!    same for all visits of a person and cancels from their changes.
//!
//! A person has its own template for each side and role, if at least two rows can be read, and at least two have a usable
//! match in both steps; otherwise its rows are matched as those of different persons.
//!
//! Source: Reuter, Schmansky, Rosas, Fischl, *Within-subject template estimation for unbiased longitudinal image analysis*,
//! NeuroImage 61, 2012.

mod composed;

pub(crate) use composed::kept;

use crate::cohort::Cohort;
use crate::error::StudyError;
use crate::folder::Folder;
use crate::matching::{Interruption, StudyObserver};
use crate::plan::{Person, Study};
use crate::settings::Visits;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::checkpoint;
use homolog_run::intake::{IntakeLimits, prepare_surface};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The rows that are visits of one person: two or more of one subject, side and role.
fn rows(cohort: &Cohort) -> Vec<Vec<usize>> {
    let mut of: BTreeMap<_, Vec<usize>> = BTreeMap::new();
    for (k, subject) in cohort.subjects.iter().enumerate() {
        let side = subject.side.map(homolog_contract::input::BodySide::name);
        of.entry((&subject.subject, side, subject.role as u8)).or_default().push(k);
    }
    of.into_values().filter(|rows| rows.len() > 1).collect()
}

impl Study {
    /// The persons with several visits, if these get templates of their own; reads the surfaces of all their visits.
    ///
    /// # Errors
    /// [`StudyError::File`]; [`StudyError::Interrupted`].
    pub(crate) fn find_persons(&mut self, folder: &Folder, watcher: &dyn StudyObserver) -> Result<(), StudyError> {
        if self.settings.visits == Visits::GroupTemplate {
            return Ok(());
        }
        let found: Vec<Option<Person>> = rows(&self.cohort)
            .into_par_iter()
            .map(|mut visits| {
                checkpoint(&Interruption(watcher))?;
                // By content, so that the order of the table does not matter.
                visits
                    .sort_by_cached_key(|&k| (self.hashes[k].clone(), format!("{:?}", self.cohort.subjects[k].labels)));
                let mut sized = Vec::new();
                for &k in &visits {
                    if let Some(surface) = self.surface_of(k, folder)? {
                        let closed = surface.boundary_vertices().is_none();
                        sized.push((if closed { surface.signed_volume() } else { surface.area() }, k, surface));
                    }
                }
                if sized.len() < 2 {
                    return Ok(None);
                }
                sized.sort_by(|a, b| a.0.total_cmp(&b.0));
                let (_, start, surface) = sized.swap_remove(sized.len() / 2);
                Ok(Some(Person { visits, start, surface: Arc::new(surface) }))
            })
            .collect::<Result<_, StudyError>>()?;
        self.persons = found.into_iter().flatten().collect();
        Ok(())
    }

    /// The surface of a subject as its records refer to it: all vertices of its file, mirrored if it lies on the other side
    /// than the template; `None` if it is refused.
    ///
    /// # Errors
    /// [`StudyError::File`]; [`StudyError::Mesh`].
    pub(crate) fn surface_of(&self, subject: usize, folder: &Folder) -> Result<Option<SurfaceMesh>, StudyError> {
        let file = &self.cohort.subjects[subject].file;
        let name = file.file_name().and_then(|name| name.to_str());
        let prepared = prepare_surface(&folder.input(file)?, name, &self.input_of(subject), &IntakeLimits::default());
        let Ok(prepared) = prepared else { return Ok(None) };
        let mesh = prepared.uploaded();
        Ok(Some(if self.is_mirrored(subject) { crate::mirror::mirrored(mesh)? } else { mesh.clone() }))
    }
}
