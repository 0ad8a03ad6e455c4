//! Maps of visits: the map of the group's template to the template of a person, followed by that one's map to the visit.
//!
//! They follow from the matches, so they can be lost, and are named by both of them.

use crate::align::{area_weights, fit_onto, points};
use crate::error::StudyError;
use crate::folder::{Folder, record_name};
use crate::plan::{Matched, OwnMaps, Records, Study};
use crate::record::{Facts, Record, distances, folded, hash_of_texts};
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::{Observer, checkpoint};
use nalgebra::{Matrix3, Point3};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Version of the composition in the names of records.
const VERSION: &str = "visits 1";
/// Subfolder of the records.
const PART: &str = "matches/visits";

/// Carries points that lie on or near a surface to images of this surface.
struct Carrier {
    mesh: SurfaceMesh,
    index: ClosestPointIndex,
}

/// Directions along and across a triangle; `None` if it has no area.
fn frame(corners: [Point3<f64>; 3]) -> Option<Matrix3<f64>> {
    let [a, b, c] = corners;
    let along = (b - a).try_normalize(1e-300)?;
    let normal = along.cross(&(c - a)).try_normalize(1e-300)?;
    Some(Matrix3::from_columns(&[along, normal.cross(&along), normal]))
}

impl Carrier {
    fn new(mesh: SurfaceMesh) -> Self {
        Carrier { index: ClosestPointIndex::new(&mesh), mesh }
    }

    /// Where points go, mm, if the vertices of the surface go to `images`: the nearest point keeps its place in its
    /// triangle, and the offset from it its direction relative to the triangle and its length. Exact for rigid motions.
    fn carried(&self, points: &[Point3<f64>], images: &[Point3<f64>]) -> Vec<Point3<f64>> {
        let carry = |p: &Point3<f64>| {
            let near = self.index.closest(p);
            let at = Point3::from(near.blend(|k| images[k].coords));
            let corners = |of: &[Point3<f64>]| near.triangle.map(|k| of[k as usize]);
            match (frame(corners(self.mesh.vertices())), frame(corners(images))) {
                (Some(from), Some(to)) => at + to * (from.transpose() * (p - near.point)),
                // An image without an area has no direction of the offset.
                _ => at,
            }
        };
        points.par_iter().map(carry).collect()
    }
}

/// The facts on a map that was made from two matches: `onto` the template of the person, and from there to the `visit`.
fn joined(onto: &Facts, visit: &Facts) -> Facts {
    let mut reasons = onto.reasons.clone();
    reasons.extend(visit.reasons.iter().filter(|reason| !onto.reasons.contains(reason)).cloned());
    let reliable = match (onto.reliable, visit.reliable) {
        (Some(a), Some(b)) => Some(a && b),
        (one, other) => one.or(other),
    };
    Facts {
        reliable,
        reasons,
        rigid_distance_mm: onto.rigid_distance_mm,
        confidence: onto.confidence.min(visit.confidence),
        ..visit.clone()
    }
}

/// The facts on a match with those that follow from the map itself: distances of the surface from it, and flipped triangles.
fn map_facts(
    of_match: Facts,
    template: &SurfaceMesh,
    surface: Option<&SurfaceMesh>,
    map: &[Point3<f64>],
) -> Result<Facts, StudyError> {
    let (mut facts, mapped) = (of_match, template.with_vertices(map.to_vec())?);
    if let Some(surface) = surface {
        let distances = distances(surface, &mapped);
        let n = distances.len().max(1);
        facts.residual_mm = distances.iter().sum::<f64>() / n as f64;
        facts.residual_p95_mm = distances.get(n * 19 / 20).copied().unwrap_or(0.0);
    }
    if let Ok(pose) = fit_onto(template.vertices(), map, &area_weights(template), false) {
        facts.folded = folded(template, &mapped, &pose.rotation);
    }
    Ok(facts)
}

/// Names the composition of two matches, or of a revised map and a match.
fn composed_key(onto: &str, visit: &str) -> String {
    hash_of_texts([VERSION, env!("CARGO_PKG_VERSION"), onto, visit])
}

/// Keeps the map of each visit of a person under `key`, of which there is one for each visit; `onto`: the map from the
/// group's template to the person's, `own`. Visits without a match get none.
pub(crate) fn kept(
    (study, folder, template): (&Study, &Folder, &SurfaceMesh),
    maps: &OwnMaps,
    own: SurfaceMesh,
    onto: &Record,
    key: &dyn Fn(usize) -> String,
    observer: &dyn Observer,
) -> Result<(), StudyError> {
    let (n, from) = (own.n_vertices(), points(&onto.points));
    let carrier = Carrier::new(own);
    for (place, of_visit) in maps.visits.iter().enumerate() {
        checkpoint(observer)?;
        let Some(visit) = folder.get(of_visit)?.filter(|record| record.is_map_of(n)) else { continue };
        let map = carrier.carried(&from, &points(&visit.points));
        let stored: Vec<[f32; 3]> = map.iter().map(|p| [p.x as f32, p.y as f32, p.z as f32]).collect();
        let surface = study.surface_of(study.persons[maps.person].visits[place], folder)?;
        let facts = map_facts(joined(&onto.facts, &visit.facts), template, surface.as_ref(), &points(&stored))?;
        folder.keep(&key(place), &Record { facts, points: stored })?;
    }
    Ok(())
}

impl Study {
    /// Makes the maps of the visits of persons with a template of their own, which become those of `matched`. A visit
    /// without one of the two matches has the record that says why.
    ///
    /// # Errors
    /// [`StudyError`].
    pub(crate) fn compose(
        &self,
        matched: &mut Matched,
        folder: &Folder,
        observer: &dyn Observer,
    ) -> Result<(), StudyError> {
        if matched.own.is_empty() {
            return Ok(());
        }
        let (template, mut names) = (&matched.making.template.mesh, BTreeSet::new());
        let found: Vec<Vec<(usize, String)>> = matched
            .own
            .par_iter()
            .map(|maps| {
                checkpoint(observer)?;
                let visits = &self.persons[maps.person].visits;
                let onto = folder.get(&maps.onto)?.filter(|record| record.is_map_of(template.n_vertices()));
                let Some(onto) = onto else {
                    return Ok(visits.iter().map(|&k| (k, maps.onto.clone())).collect());
                };
                let key = |place: usize| format!("visits/{}", composed_key(&maps.onto, &maps.visits[place]));
                let own = self.own_template(maps, folder, observer)?.mesh;
                let mut keys = Vec::new();
                let mut is_missing = false;
                for (place, &k) in visits.iter().enumerate() {
                    let record = folder.get(&maps.visits[place])?;
                    if record.is_some_and(|record| record.is_map_of(own.n_vertices())) {
                        is_missing |= !folder.has(&key(place));
                        keys.push((k, key(place)));
                    } else {
                        keys.push((k, maps.visits[place].clone()));
                    }
                }
                if is_missing {
                    kept((self, folder, template), maps, own, &onto, &key, observer)?;
                }
                Ok(keys)
            })
            .collect::<Result<_, StudyError>>()?;
        for (k, key) in found.into_iter().flatten() {
            names.insert(record_name(&key));
            matched.keys[k] = key;
        }
        let prefix = format!("{PART}/");
        let names = names.iter().filter_map(|name| name.strip_prefix(&prefix).map(str::to_owned)).collect();
        folder.keep_only(PART, &names);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::{Isometry3, Vector3};

    #[test]
    fn points_beside_a_surface_follow_its_motion() {
        let mesh = ellipsoid(Vector3::new(9.0, 5.0, 3.0), 3);
        let motion = Isometry3::new(Vector3::new(3.0, -8.0, 1.0), Vector3::new(2.0, 0.5, -1.0));
        let images: Vec<_> = mesh.vertices().iter().map(|p| motion * p).collect();
        let beside: Vec<_> = mesh.vertices().iter().map(|p| Point3::from(1.07 * p.coords)).collect();
        let carrier = Carrier::new(mesh.clone());
        for (p, q) in beside.iter().zip(carrier.carried(&beside, &images)) {
            assert!((motion * p - q).norm() < 1e-9);
        }
        // Triangles without an area keep their points.
        let nowhere = vec![Point3::origin(); mesh.n_vertices()];
        assert!(carrier.carried(&beside, &nowhere).iter().all(|q| q.coords.norm() < 1e-9));
    }

    #[test]
    fn a_map_is_as_reliable_as_both_matches() {
        let facts = |reliable: Option<bool>, reason: &str| Facts {
            reliable,
            reasons: vec![reason.to_owned()],
            ..Facts::default()
        };
        let of = |a, b| joined(&facts(a, "far"), &facts(b, "far")).reliable;
        assert_eq!(of(Some(true), Some(false)), Some(false));
        assert_eq!(of(Some(false), Some(true)), Some(false));
        assert_eq!((of(Some(true), None), of(None, None)), (Some(true), None));
        assert_eq!(joined(&facts(None, "far"), &facts(None, "thin")).reasons, ["far", "thin"]);
    }
}
