//! Several structures of each person as one shape: the vertices of all of them, one structure after the other.

use crate::cohort::Cohort;
use crate::error::StudyError;
use crate::joint::JointFindings;
use crate::measures::measured;
use crate::plan::Round;
use crate::settings::{Measure, Settings};
use crate::subjects::StructureFindings;
use homolog_mesh::{FaceArity, MeshError, SurfaceMesh};
use homolog_primitives::observe::Observer;
use serde::Serialize;
use std::ops::Range;

/// The structures of a study of several, and its rows, of which each is one structure of one person.
#[derive(Debug, Clone)]
pub struct Complex {
    /// In alphabetical order.
    pub structures: Vec<Structure>,
    /// The rows, by person and structure.
    pub rows: Cohort,
    /// Hash of the file of each row.
    pub hashes: Vec<String>,
    /// The settings of the study.
    pub settings: Settings,
    /// Findings for the structures of each person.
    pub(crate) of_persons: Vec<Vec<StructureFindings>>,
}

/// A structure of a complex.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Structure {
    /// Its name.
    pub name: String,
    /// Its vertices among those of the complex.
    pub vertices: Range<usize>,
    /// Hash of its template.
    pub template: String,
    /// The rounds in which the template was made; none if it was given.
    pub rounds: Vec<Round>,
    /// How its joint maps were made.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub joint: Option<JointFindings>,
}

impl Structure {
    /// The part of a surface of all structures that belongs to this one.
    ///
    /// # Errors
    /// [`MeshError`] if the surface does not have the vertices of the complex.
    pub fn of(&self, whole: &SurfaceMesh) -> Result<SurfaceMesh, MeshError> {
        let Range { start, end } = self.vertices;
        let is_own = |face: &&[u32]| face.iter().all(|&v| self.vertices.contains(&(v as usize)));
        let faces = whole.faces().filter(is_own).flat_map(|face| face.iter().map(|&v| v - start as u32));
        let vertices = whole.vertices().get(start..end).unwrap_or_default().to_vec();
        SurfaceMesh::new(vertices, whole.arity(), faces.collect())
    }
}

/// One surface of several, with the vertices of the first, then those of the second, and so on, in triangles.
///
/// # Errors
/// [`MeshError`] for no surface at all.
pub(crate) fn concatenated(surfaces: &[SurfaceMesh]) -> Result<SurfaceMesh, MeshError> {
    let (mut vertices, mut indices) = (Vec::new(), Vec::new());
    for surface in surfaces {
        let first = vertices.len() as u32;
        indices.extend(surface.triangles().into_iter().flatten().map(|v| v + first));
        vertices.extend_from_slice(surface.vertices());
    }
    SurfaceMesh::new(vertices, FaceArity::Triangle, indices)
}

/// [`measured`], of each structure by itself: another structure beside it does not bound its thickness.
///
/// # Errors
/// [`StudyError::Interrupted`]; [`StudyError::Mesh`].
pub(crate) fn measured_by_structure(
    complex: Option<&Complex>,
    measure: Measure,
    [mean, subject]: [&SurfaceMesh; 2],
    observer: &dyn Observer,
) -> Result<Option<Vec<f64>>, StudyError> {
    let Some(complex) = complex else { return Ok(measured(measure, mean, subject, observer)?) };
    let mut values = Vec::with_capacity(mean.n_vertices());
    for structure in &complex.structures {
        match measured(measure, &structure.of(mean)?, &structure.of(subject)?, observer)? {
            Some(of) => values.extend(of),
            None => return Ok(None),
        }
    }
    Ok(Some(values))
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::{Isometry3, Vector3};

    #[test]
    fn structures_are_found_in_the_whole_again() {
        let a = ellipsoid(Vector3::new(9.0, 5.0, 3.0), 2);
        let b = ellipsoid(Vector3::repeat(4.0), 1).transformed(&Isometry3::translation(0.0, 0.0, 9.0));
        let whole = concatenated(&[a.clone(), b.clone()]).unwrap();
        let n = a.n_vertices();
        let structure = |vertices: Range<usize>| Structure {
            name: String::new(),
            vertices,
            template: String::new(),
            rounds: Vec::new(),
            joint: None,
        };
        assert_eq!(structure(0..n).of(&whole).unwrap(), a);
        assert_eq!(structure(n..whole.n_vertices()).of(&whole).unwrap(), b);
        assert!((whole.signed_volume() - a.signed_volume() - b.signed_volume()).abs() < 1e-9);
        assert!(concatenated(&[]).is_err());
    }
}
