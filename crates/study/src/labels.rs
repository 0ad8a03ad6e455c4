//! Transfer of labels: from the label volumes of subjects to the vertices of the template, and from there to every
//! subject.

use homolog_mesh::volume::LabelVolume;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use nalgebra::{Point3, Vector4};
use std::collections::BTreeMap;

/// Range in which a vertex's label is searched, voxels along each axis. A smooth surface lies within one voxel of the
/// voxels it was made from.
const REACH: i64 = 3;
/// Voxels or vertices between two calls of the observer: a few milliseconds.
const AT_ONCE: usize = 4096;

/// The label of the voxel nearest to a point, among voxels with one of `labels`; `None` if none is near.
///
/// Ties go to the first voxel in the order of the volume.
pub fn label_at(volume: &LabelVolume, labels: &[u32], point: &Point3<f64>) -> Option<u32> {
    let inverse = volume.affine().try_inverse()?;
    let at = inverse.transform_point(point);
    let dims = volume.dims().map(|d| d as i64);
    let center = [0, 1, 2].map(|k| at[k].round() as i64);
    let mut best: Option<(f64, u32)> = None;
    for z in (center[2] - REACH).max(0)..=(center[2] + REACH).min(dims[2] - 1) {
        for y in (center[1] - REACH).max(0)..=(center[1] + REACH).min(dims[1] - 1) {
            for x in (center[0] - REACH).max(0)..=(center[0] + REACH).min(dims[0] - 1) {
                let label = volume.labels()[((z * dims[1] + y) * dims[0] + x) as usize];
                if labels.binary_search(&label).is_err() {
                    continue;
                }
                let place = volume.affine() * Vector4::new(x as f64, y as f64, z as f64, 1.0);
                let distance = (place.xyz() - point.coords).norm_squared();
                if best.is_none_or(|(least, _)| distance < least) {
                    best = Some((distance, label));
                }
            }
        }
    }
    best.map(|(_, label)| label)
}

/// [`label_at`] of every point.
///
/// # Errors
/// [`Cancelled`].
pub fn labels_at(
    volume: &LabelVolume,
    labels: &[u32],
    points: &[Point3<f64>],
    observer: &dyn Observer,
) -> Result<Vec<Option<u32>>, Cancelled> {
    let mut each = Vec::with_capacity(points.len());
    for some in points.chunks(AT_ONCE) {
        checkpoint(observer)?;
        each.extend(some.iter().map(|p| label_at(volume, labels, p)));
    }
    Ok(each)
}

/// The most frequent label of each vertex; ties go to the lowest. `None` if no subject has a label there.
pub fn voted<'a>(votes: impl Iterator<Item = &'a [Option<u32>]>, n_vertices: usize) -> Vec<Option<u32>> {
    let mut counts: Vec<BTreeMap<u32, u32>> = vec![BTreeMap::new(); n_vertices];
    for vote in votes {
        for (counts, label) in counts.iter_mut().zip(vote) {
            if let Some(label) = label {
                *counts.entry(*label).or_default() += 1;
            }
        }
    }
    let most = |counts: BTreeMap<u32, u32>| {
        counts.into_iter().max_by(|a, b| a.1.cmp(&b.1).then(b.0.cmp(&a.0))).map(|(label, _)| label)
    };
    counts.into_iter().map(most).collect()
}

/// The volume with the labels of a surface: every voxel with one of `labels` gets the label of the nearest point of the
/// surface; other voxels get 0. `bent` is the template deformed onto the subject, `of_vertex` its labels.
///
/// # Errors
/// [`Cancelled`].
///
/// # Cost
/// `O(voxels of the structure · log n)`.
pub fn carried(
    volume: &LabelVolume,
    labels: &[u32],
    bent: &SurfaceMesh,
    of_vertex: &[Option<u32>],
    observer: &dyn Observer,
) -> Result<Vec<u32>, Cancelled> {
    let index = ClosestPointIndex::new(bent);
    let [nx, ny, _] = volume.dims();
    let each = volume.labels().iter().enumerate().map(|(k, label)| {
        if k.is_multiple_of(AT_ONCE) {
            checkpoint(observer)?;
        }
        if labels.binary_search(label).is_err() {
            return Ok(0);
        }
        let (x, y, z) = (k % nx, k / nx % ny, k / (nx * ny));
        let place = volume.affine() * Vector4::new(x as f64, y as f64, z as f64, 1.0);
        let nearest = index.closest(&Point3::from(place.xyz()));
        // The label with the largest share of the triangle at that point.
        let mut weights: BTreeMap<u32, f64> = BTreeMap::new();
        for (&corner, &weight) in nearest.triangle.iter().zip(&nearest.barycentric) {
            if let Some(label) = of_vertex[corner as usize] {
                *weights.entry(label).or_default() += weight;
            }
        }
        let mut best = (0, -1.0);
        for (label, weight) in weights {
            if weight > best.1 {
                best = (label, weight);
            }
        }
        Ok(best.0)
    });
    each.collect()
}

/// Dice overlap of each of `labels` in two volumes of equal size: `2 |A ∩ B| / (|A| + |B|)`; `None` if neither volume
/// has the label.
pub fn dice(a: &[u32], b: &[u32], labels: &[u32]) -> Vec<Option<f64>> {
    let of = |label: u32| {
        let (mut both, mut sum) = (0u64, 0u64);
        for (x, y) in a.iter().zip(b) {
            let (x, y) = (*x == label, *y == label);
            both += u64::from(x && y);
            sum += u64::from(x) + u64::from(y);
        }
        (sum > 0).then(|| 2.0 * both as f64 / sum as f64)
    };
    labels.iter().map(|&label| of(label)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use homolog_primitives::observe::Silent;
    use nalgebra::{Matrix4, Vector3};

    /// A ball of two halves, voxels of 1 mm about the origin.
    fn halves() -> LabelVolume {
        let n = 21;
        let label = |k: usize| {
            let [x, y, z] = [k % n, k / n % n, k / (n * n)].map(|c| c as f64 - 10.0);
            match (x * x + y * y + z * z < 64.0, x < 0.0) {
                (false, _) => 0,
                (true, true) => 1,
                (true, false) => 2,
            }
        };
        let affine = Matrix4::new_translation(&Vector3::repeat(-10.0));
        LabelVolume::new([n; 3], (0..n * n * n).map(label).collect(), affine).unwrap()
    }

    #[test]
    fn labels_come_from_the_nearest_voxel_and_go_back() {
        let volume = halves();
        let at = |x: f64| label_at(&volume, &[1, 2], &Point3::new(x, 0.0, 0.0));
        assert_eq!((at(-7.9), at(8.2), at(-0.6), at(15.0)), (Some(1), Some(2), Some(1), None));
        assert_eq!(label_at(&volume, &[2], &Point3::new(-1.2, 0.0, 0.0)), Some(2), "of the labels asked for");
        let sphere = ellipsoid(Vector3::repeat(8.0), 4);
        let votes: Vec<_> = sphere.vertices().iter().map(|p| label_at(&volume, &[1, 2], p)).collect();
        let labels = voted([votes.as_slice(), votes.as_slice()].into_iter(), votes.len());
        assert_eq!(labels, votes);
        let back = carried(&volume, &[1, 2], &sphere, &labels, &Silent).unwrap();
        let found = dice(&back, volume.labels(), &[1, 2, 3]);
        assert!(found[0].unwrap() > 0.97 && found[1].unwrap() > 0.97 && found[2].is_none(), "{found:?}");
        assert_eq!(back.iter().filter(|&&label| label > 0).count(), volume.labels().iter().filter(|&&l| l > 0).count());
    }

    #[test]
    fn the_majority_decides_and_the_lowest_of_equals() {
        let votes = [vec![Some(1), Some(2), None], vec![Some(1), Some(1), None], vec![Some(2), None, None]];
        assert_eq!(voted(votes.iter().map(Vec::as_slice), 3), [Some(1), Some(1), None]);
    }

    #[test]
    fn dice_is_the_overlap() {
        assert_eq!(dice(&[1, 1, 0, 2], &[1, 0, 0, 2], &[1, 2, 3]), [Some(2.0 / 3.0), Some(1.0), None]);
    }
}
