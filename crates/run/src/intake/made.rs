//! The surface made from a file of either kind.

use super::candidate::{Candidate, from_mesh};
use super::label_surface::from_labels;
use super::{Advice, IntakeError, IntakeLimits};
use homolog_contract::parameters::{InputParameters, Repair};
use homolog_formats::{FileContent, ReadFile};
use homolog_mesh::repair;
use homolog_mesh::topology::SurfaceFault;

/// The surface of a file, repaired and simplified as far as the parameters allow.
///
/// # Errors
/// [`IntakeError`], if there is no surface, or too large a one; a remaining fault is in the candidate.
pub(super) fn from_file(
    file: &ReadFile,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Result<Candidate, IntakeError> {
    let mut candidate = match &file.content {
        FileContent::Labels(volume) => from_labels(volume, &file.label_names, parameters, limits)?,
        FileContent::Mesh(file) => {
            // Checked before repairs, which cost more than reading.
            let (found, limit) = (file.mesh.n_faces() as u64, limits.max_faces as u64);
            if found > limit {
                return Err(IntakeError::TooLarge { what: "faces", found, limit });
            }
            from_mesh(file, parameters)?
        }
    };
    if let Some(SurfaceFault::InsideOut { .. }) = candidate.fault {
        candidate.mesh = repair::reversed(&candidate.mesh);
        candidate.turned_outward = true;
        candidate.fault = None;
        candidate.repaired.volume_mm3 = candidate.repaired.volume_mm3.map(|v| -v);
    }
    candidate.triangulate(parameters);
    candidate.simplify(parameters);
    let (found, limit) = (candidate.mesh.n_vertices() as u64, limits.max_vertices as u64);
    if found > limit {
        return Err(IntakeError::TooLarge { what: "surface vertices", found, limit });
    }
    Ok(candidate)
}

/// The refusal, if this surface is unsuitable, with the smallest set of repairs that would make it suitable.
pub(super) fn refusal(
    candidate: &Candidate,
    file: &ReadFile,
    parameters: &InputParameters,
    limits: &IntakeLimits,
) -> Option<IntakeError> {
    let fault = candidate.fault.clone()?;
    let sets: &[&[Repair]] = match file.content {
        FileContent::Labels(_) => {
            &[&[Repair::Fill], &[Repair::LargestComponent], &[Repair::LargestComponent, Repair::Fill]]
        }
        FileContent::Mesh(_) => &[&[Repair::Weld], &[Repair::Orient], &[Repair::Weld, Repair::Orient]],
    };
    let helps = |set: &&&[Repair]| {
        let parameters = InputParameters { repair: Some(set.to_vec()), ..parameters.clone() };
        from_file(file, &parameters, limits).is_ok_and(|c| c.fault.is_none())
    };
    let opened = || {
        let parameters = InputParameters { allow_boundary: true, ..parameters.clone() };
        from_file(file, &parameters, limits).is_ok_and(|c| c.fault.is_none())
    };
    let advice = match sets.iter().find(helps) {
        Some(set) => Advice::Allow(set.to_vec()),
        None if !parameters.allow_boundary && opened() => Advice::Open,
        None => Advice::Edit,
    };
    let (others, topology) = (candidate.others.clone(), Box::new(candidate.repaired.clone()));
    Some(IntakeError::UnsuitableSurface { fault, others, advice, topology })
}
