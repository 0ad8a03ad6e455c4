//! Consistency of maps over the group: a point that goes around a cycle of subjects should return to its place.
//!
//! Four cycles are measured, over all vertices of the subject where they begin:
//!
//! - to the template and back, by two independent matches;
//! - to another subject and back, by two independent matches;
//! - around a ring of subjects, by pair maps alone;
//! - around the same ring through the template, where every map is the template's map to one subject after the inverse
//!   of its map to another. This cycle is consistent by construction, except where a bent template does not reach; it
//!   is reported to show the cost of that.
//!
//! The distance between pair maps and maps through the template is reported too.
//!
//! With joint maps ([`crate::joint`]) the match back to the template has to follow the revision: a point of a subject
//! first goes where the pair map has the vertices that the joint map has at the point. The cycle then measures the
//! agreement of both matches as before, in the revised positions.
//!
//! Where the group decided the pose of a subject ([`crate::rivals`]), its own matches leave the pose open, and need not have the one of
//! its map. Cycles in which its map meets such a match are left out: to the template and back, and the distance of its pair maps from
//! those through the template. The other cycles are of pair maps alone, or of maps through the template alone.

use crate::error::StudyError;
use crate::folder::Folder;
use crate::plan::{Matched, Records, Study};
use crate::record::Record;
use crate::rivals::GroupDecision;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use homolog_run::intake::{IntakeLimits, prepare_surface};
use nalgebra::Point3;
use rayon::prelude::*;
use serde::Serialize;

/// Distances over all vertices of the ring's subjects, mm.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Distances {
    /// Mean.
    pub mean_mm: f64,
    /// Median.
    pub median_mm: f64,
    /// 95th percentile.
    pub p95_mm: f64,
}

/// Consistency of the maps.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Consistency {
    /// Subjects of the ring.
    pub ring: Vec<String>,
    /// Those of them whose pose the group decided. Without them: `template_and_back`, and the pairs of `pair_to_template`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub decided: Vec<String>,
    /// To the template and back, by two independent matches.
    pub template_and_back: Distances,
    /// To the next subject and back, by two independent matches.
    pub pair_and_back: Distances,
    /// Around the whole ring, by pair maps alone.
    pub ring_by_pairs: Distances,
    /// Around the whole ring, through the template.
    pub ring_through_template: Distances,
    /// Distance between a pair map and the map through the template.
    pub pair_to_template: Distances,
}

/// A continuous map from one surface to another.
struct SurfaceMap {
    from: ClosestPointIndex,
    images: Vec<Point3<f64>>,
}

impl SurfaceMap {
    fn new(from: &SurfaceMesh, images: Vec<Point3<f64>>) -> Self {
        SurfaceMap { from: ClosestPointIndex::new(from), images }
    }

    fn apply(&self, points: &[Point3<f64>], observer: &dyn Observer) -> Result<Vec<Point3<f64>>, Cancelled> {
        let image = |p: &Point3<f64>| {
            checkpoint(observer)?;
            Ok(Point3::from(self.from.closest(p).blend(|k| self.images[k].coords)))
        };
        points.iter().map(image).collect()
    }
}

fn distances(mut all: Vec<f64>) -> Distances {
    all.sort_by(f64::total_cmp);
    let n = all.len().max(1);
    let at = |share: usize| all.get(n * share / 100).copied().unwrap_or(0.0);
    Distances { mean_mm: all.iter().sum::<f64>() / n as f64, median_mm: at(50), p95_mm: at(95) }
}

/// Measures the cycles of a study; `None` if none were requested, a match of the ring failed, or the group decided so many poses that
/// no cycle of a kind is left. `maps` has the keys of the maps that the study uses, `matched` those of the matches, and `poses`
/// what the group says about the pose of each subject.
///
/// # Errors
/// Errors of reading records and files; [`StudyError::Interrupted`].
pub fn consistency(
    study: &Study,
    (matched, maps): (&Matched, &Matched),
    poses: &[Option<GroupDecision>],
    folder: &Folder,
    observer: &dyn Observer,
) -> Result<Option<Consistency>, StudyError> {
    let cycles = &matched.cycles;
    if cycles.ring.len() < 3 {
        return Ok(None);
    }
    let n = cycles.ring.len();
    let decided: Vec<bool> =
        cycles.ring.iter().map(|&k| poses.get(k).copied().flatten().is_some_and(|pose| pose.decided)).collect();
    let follows_pairs = |k: usize| !decided[k] && !decided[(k + 1) % n];
    if !(0..n).any(follows_pairs) {
        return Ok(None);
    }
    let mesh = &matched.making.template.mesh;
    let mut surfaces = Vec::new();
    for &k in &cycles.ring {
        checkpoint(observer)?;
        let file = &study.cohort.subjects[k].file;
        let bytes = folder.input(file)?;
        let name = file.file_name().and_then(|name| name.to_str());
        match prepare_surface(&bytes, name, &study.input_of(k), &IntakeLimits::default()) {
            // The numbering of the upload, to which records refer; vertices without faces are in no cycle.
            Ok(prepared) if study.is_mirrored(k) => surfaces.push(crate::mirror::mirrored(prepared.uploaded())?),
            Ok(prepared) => surfaces.push(prepared.uploaded().clone()),
            Err(_) => return Ok(None),
        }
    }
    let record = |key: &String, vertices: usize| -> Result<Option<Vec<Point3<f64>>>, StudyError> {
        let found: Option<Record> = folder.get(key)?;
        Ok(found
            .filter(|r| r.facts.error.is_none() && r.points.len() == vertices)
            .map(|r| crate::align::points(&r.points)))
    };
    let (mut out, mut back, mut to, mut inverse) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut unrevised = Vec::new();
    for (k, surface) in surfaces.iter().enumerate() {
        let next = &surfaces[(k + 1) % n];
        let (own, used) = (&matched.keys[cycles.ring[k]], &maps.keys[cycles.ring[k]]);
        let onto = record(used, mesh.n_vertices())?;
        unrevised.push(match (record(own, mesh.n_vertices())?, &onto) {
            (Some(pair), Some(onto)) if own != used => Some(SurfaceMap::new(&mesh.with_vertices(onto.clone())?, pair)),
            _ => None,
        });
        let found = (
            record(&cycles.forward[k], surface.n_vertices())?,
            record(&cycles.backward[k], next.n_vertices())?,
            record(&cycles.to_template[k], surface.n_vertices())?,
            onto,
        );
        let (Some(forward), Some(backward), Some(to_template), Some(onto)) = found else { return Ok(None) };
        out.push(SurfaceMap::new(surface, forward));
        back.push(SurfaceMap::new(next, backward));
        to.push((SurfaceMap::new(surface, to_template), SurfaceMap::new(mesh, onto.clone())));
        // From a subject to the template: the inverse of the template's map to the subject.
        inverse.push(SurfaceMap::new(&mesh.with_vertices(onto)?, mesh.vertices().to_vec()));
    }
    let apart = |a: &[Point3<f64>], b: &[Point3<f64>]| a.iter().zip(b).map(|(p, q)| (p - q).norm()).collect::<Vec<_>>();
    let each: Vec<[Vec<f64>; 5]> = (0..n)
        .into_par_iter()
        .map(|k| {
            let begin: Vec<Point3<f64>> = used(&surfaces[k]);
            let next = (k + 1) % n;
            let matched = match &unrevised[k] {
                Some(revision) => revision.apply(&begin, observer)?,
                None => begin.clone(),
            };
            let template = to[k].1.apply(&to[k].0.apply(&matched, observer)?, observer)?;
            let pair_image = out[k].apply(&begin, observer)?;
            let pair = back[k].apply(&pair_image, observer)?;
            let (mut by_pairs, mut through) = (begin.clone(), begin.clone());
            for step in 0..n {
                let at = (k + step) % n;
                by_pairs = out[at].apply(&by_pairs, observer)?;
                through = to[(at + 1) % n].1.apply(&inverse[at].apply(&through, observer)?, observer)?;
            }
            let direct = to[next].1.apply(&inverse[k].apply(&begin, observer)?, observer)?;
            Ok([
                if decided[k] { Vec::new() } else { apart(&begin, &template) },
                apart(&begin, &pair),
                apart(&begin, &by_pairs),
                apart(&begin, &through),
                if follows_pairs(k) { apart(&pair_image, &direct) } else { Vec::new() },
            ])
        })
        .collect::<Result<_, Cancelled>>()?;
    let all = |which: usize| distances(each.iter().flat_map(|cycles| cycles[which].iter().copied()).collect());
    let ids: Vec<&String> = cycles.ring.iter().map(|&k| &study.cohort.subjects[k].id).collect();
    Ok(Some(Consistency {
        decided: ids.iter().zip(&decided).filter(|(_, is)| **is).map(|(id, _)| (*id).clone()).collect(),
        ring: ids.into_iter().cloned().collect(),
        template_and_back: all(0),
        pair_and_back: all(1),
        ring_by_pairs: all(2),
        ring_through_template: all(3),
        pair_to_template: all(4),
    }))
}

/// The vertices that faces use.
fn used(mesh: &SurfaceMesh) -> Vec<Point3<f64>> {
    let mut is_used = vec![false; mesh.n_vertices()];
    mesh.indices().iter().for_each(|&v| is_used[v as usize] = true);
    mesh.vertices().iter().zip(is_used).filter(|(_, used)| *used).map(|(p, _)| *p).collect()
}
