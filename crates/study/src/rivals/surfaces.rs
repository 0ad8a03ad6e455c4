//! Surfaces of subjects turned back by the rotation of a rival pose, and points turned forth again.

use crate::error::StudyError;
use crate::folder::Folder;
use crate::plan::{Rival, Study, Task, Template, hash};
use crate::rotation::of_rows;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Observer, checkpoint};
use nalgebra::Point3;
use rayon::prelude::*;

/// A surface turned back about the origin.
///
/// # Errors
/// Errors of [`SurfaceMesh::with_vertices`].
fn turned_back(surface: &SurfaceMesh, rotation: &[[f64; 3]; 3]) -> Result<SurfaceMesh, StudyError> {
    let back = of_rows(rotation).transpose();
    Ok(surface.with_vertices(surface.vertices().iter().map(|p| back * p).collect())?)
}

/// Points of a surface that was turned back, where the surface is.
pub(super) fn turned(points: &[[f32; 3]], rotation: &[[f64; 3]; 3]) -> Vec<[f32; 3]> {
    let forth = of_rows(rotation);
    let turn = |p: &[f32; 3]| <[f64; 3]>::from((forth * Point3::from(p.map(f64::from))).coords).map(|x| x as f32);
    points.iter().map(turn).collect()
}

/// The surfaces of matches in rival poses, in their order.
///
/// # Errors
/// [`StudyError::Changed`] if a file is not the one that was matched; [`StudyError::File`]; [`StudyError::Interrupted`].
pub(crate) fn rival_surfaces(
    study: &Study,
    tasks: &[Task],
    folder: &Folder,
    observer: &dyn Observer,
) -> Result<Vec<Template>, StudyError> {
    let gone = || StudyError::Internal("the match of a subject was removed meanwhile".to_owned());
    tasks
        .par_iter()
        .map(|task| {
            checkpoint(observer)?;
            let Rival { subject, rotation } = task.rival.ok_or_else(gone)?;
            let path = &study.cohort.subjects[subject].file;
            if hash(&folder.input(path)?) != study.hashes[subject] {
                return Err(StudyError::Changed { path: path.clone() });
            }
            let surface = study.surface_of(subject, folder)?.ok_or_else(gone)?;
            Ok(Template::new(&turned_back(&surface, &rotation)?))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::{Rotation3, Vector3};

    #[test]
    fn points_come_back_to_the_surface() {
        let mesh = ellipsoid(Vector3::new(9.0, 5.0, 3.0), 2);
        let rotation = Rotation3::from_euler_angles(0.4, -2.0, 1.1);
        let rotation = crate::rotation::rows(rotation.matrix());
        let back = turned_back(&mesh, &rotation).unwrap();
        let stored: Vec<[f32; 3]> = back.vertices().iter().map(|p| [p.x, p.y, p.z].map(|x| x as f32)).collect();
        for (p, q) in turned(&stored, &rotation).iter().zip(mesh.vertices()) {
            assert!((Point3::from(p.map(f64::from)) - q).norm() < 1e-5);
        }
    }
}
