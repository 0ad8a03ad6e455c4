//! The views of an input: its surface, also of a refused input, and its label volume.

use super::{IntakeError, IntakeLimits, prepare_surface, read};
use homolog_contract::parameters::InputParameters;
use homolog_formats::FileContent;
use homolog_mesh::SurfaceMesh;
use homolog_mesh::volume::LabelVolume;

/// The surface that would be matched; for a refused mesh, the surface in the file, on which the places named by
/// [`IntakeError::place_mm`] can be shown.
///
/// # Errors
/// [`IntakeError`] if there is no surface: the file cannot be read, or is a label volume from which none can be made.
///
/// # Cost
/// The cost of [`super::prepare_surface`].
pub fn shown_surface(
    bytes: &[u8],
    file_name: Option<&str>,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Result<SurfaceMesh, IntakeError> {
    let refusal = match prepare_surface(bytes, file_name, parameters, limits) {
        Ok(prepared) => return Ok(prepared.uploaded().clone()),
        Err(refusal) => refusal,
    };
    match read(bytes, file_name, parameters, limits)?.content {
        FileContent::Mesh(file) => Ok(file.mesh),
        FileContent::Labels(_) => Err(refusal),
    }
}

/// The label volume of a file, with all its labels in RAS; `None` for a mesh.
///
/// # Errors
/// [`IntakeError`] if the file cannot be read.
///
/// # Cost
/// Linear in the file.
pub fn shown_volume(
    bytes: &[u8],
    file_name: Option<&str>,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Result<Option<LabelVolume>, IntakeError> {
    match read(bytes, file_name, parameters, limits)?.content {
        FileContent::Labels(volume) => Ok(Some(volume)),
        FileContent::Mesh(_) => Ok(None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_contract::parameters::{Method, preset};

    /// A tetrahedron, one of whose faces looks inwards.
    const TURNED: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

    #[test]
    fn a_refused_surface_is_shown_as_it_is_in_the_file_with_the_place_of_its_fault() {
        let parameters = InputParameters { repair: Some(Vec::new()), ..preset(Method::Balanced).input };
        let limits = IntakeLimits::default();
        let bytes = TURNED.as_bytes();
        let refusal = prepare_surface(bytes, Some("a.obj"), &parameters, &limits).unwrap_err();
        let place = refusal.place_mm().unwrap();
        let shown = shown_surface(bytes, Some("a.obj"), &parameters, &limits).unwrap();
        assert_eq!((shown.n_vertices(), shown.n_faces()), (4, 4));
        // The middle of an edge of the face that looks inwards.
        let middles = [[0.5, 0.0, 0.0], [0.5, 0.5, 0.0], [0.0, 0.5, 0.0]];
        assert!(middles.contains(&place), "{place:?}");
        assert!(shown_surface(b"nothing", None, &parameters, &limits).is_err());
    }
}
