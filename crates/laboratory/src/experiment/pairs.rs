//! Pairs of surfaces with their ground truth, where it is known.

use super::draws::Draws;
use super::hippocampi::{Subject, surface};
use super::solids::{Form, Individual, bumped};
use crate::phantom::{Deformation, PairRecipe, Part, PhantomPair, random_permutation, random_pose};
use homolog_formats::nifti::write_nifti;
use homolog_mesh::volume::LabelVolume;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::Silent;
use homolog_registration::{
    ClosestSurfacePoint, IcpMetric, IcpOptions, RigidTransform, absolute_orientation, refine_icp,
};
use nalgebra::{Isometry3, Matrix3, Matrix4, Point3, Vector3};
use rayon::prelude::*;
use serde::Serialize;

/// A source, a target, and the ground truth where it is known.
#[derive(Debug, Clone)]
pub(super) struct Pair {
    pub(super) source: SurfaceMesh,
    pub(super) target: SurfaceMesh,
    /// The true corresponding point on the target of every source vertex, mm.
    pub(super) truth: Option<Vec<Point3<f64>>>,
    /// The transform that a registration should find.
    pub(super) pose: Option<RigidTransform>,
    /// Part of every source vertex and of every target vertex.
    pub(super) parts: Option<(Vec<u32>, Vec<u32>)>,
}

/// Parameters of a pair of phantoms; equal recipes give equal pairs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(super) struct PhantomRecipe {
    /// Number of the pair, from which all seeds come.
    pub(super) number: u64,
    /// Mean edge of the source, mm; the target is a tenth coarser, so that no vertex has an exact counterpart.
    pub(super) edge_mm: f64,
    /// RMS of the smooth deformation, as a share of the diagonal.
    pub(super) deform_share: f64,
    /// Standard deviation per axis of the noise on all vertices, as a share of the diagonal.
    pub(super) noise_share: f64,
}

const COARSER: f64 = 1.1;

/// A phantom and its deformed, rotated, resampled and permuted copy.
pub(super) fn phantom_pair(recipe: &PhantomRecipe) -> Result<Pair, String> {
    let k = recipe.number;
    let pair = PhantomPair::new(PairRecipe {
        subject: k,
        target_subject: k,
        deform_share: recipe.deform_share,
        deform_seed: 100 + k,
        pose_seed: Some(200 + k),
        permute_seed: Some(300 + k),
    })
    .map_err(|e| e.to_string())?;
    let source = pair.source_surface(recipe.edge_mm).map_err(|e| e.to_string())?;
    let (target, _) = pair.target_surface(COARSER * recipe.edge_mm).map_err(|e| e.to_string())?;
    let truth: Vec<_> = source.mesh.vertices().iter().map(|p| pair.place(p)).collect();
    let pose = absolute_orientation(source.mesh.vertices(), &truth, None, false).map_err(|e| e.to_string())?;
    let (low, high) = source.mesh.bounding_box();
    let sigma_mm = recipe.noise_share * (high - low).norm();
    let noisy = |mesh: SurfaceMesh, seed| {
        let moved = Draws::new(seed).jitter(mesh.vertices(), sigma_mm);
        mesh.with_vertices(moved).map_err(|e| e.to_string())
    };
    let parts = |parts: &[Part]| parts.iter().map(|p| u32::from(p.label())).collect();
    Ok(Pair {
        parts: Some((parts(&source.parts), parts(&target.parts))),
        source: noisy(source.mesh, 400 + k)?,
        target: noisy(target.mesh, 500 + k)?,
        truth: Some(truth),
        pose: Some(pose),
    })
}

/// Parameters of a pair of solids.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(super) struct SolidRecipe {
    pub(super) form: Form,
    /// Number of the pair, from which all seeds come.
    pub(super) number: u64,
    /// How often the icosahedron is subdivided.
    pub(super) levels: u32,
}

/// A bumped solid and its rotated copy, which is triangulated differently and has additional small bumps. The ground
/// truth is computed without these bumps.
pub(super) fn solid_pair(recipe: &SolidRecipe) -> Result<Pair, String> {
    let k = recipe.number;
    let (still, frame, motion) = (Isometry3::identity(), random_pose(900 + k), random_pose(1000 + k));
    let frame = Isometry3::from_parts(still.translation, frame.rotation);
    let of = |own_seed| Individual { seed: k, own_seed };
    let source = bumped(recipe.form, recipe.levels, of(None), &still, &still)?;
    let target = bumped(recipe.form, recipe.levels, of(Some(1100 + k)), &frame, &motion)?;
    Ok(Pair {
        truth: Some(source.vertices().iter().map(|p| motion * p).collect()),
        pose: Some(rigid(&motion)),
        parts: None,
        source,
        target,
    })
}

/// A surface and its rotated and permuted copy.
pub(super) fn copy_pair(subject: &Subject, seed: u64) -> Result<Pair, String> {
    let motion = random_pose(seed);
    let (target, order) = moved_and_permuted(&subject.mesh, &motion, seed)?;
    Ok(Pair {
        truth: Some(subject.mesh.vertices().iter().map(|p| motion * p).collect()),
        pose: Some(rigid(&motion)),
        parts: Some((subject.parts.clone(), permuted(&subject.parts, &order))),
        source: subject.mesh.clone(),
        target,
    })
}

/// Two subjects, the second one rotated and permuted. The reference pose is that of trimmed ICP started in scanner
/// space.
pub(super) fn cross_pair(source: &Subject, target: &Subject, seed: u64) -> Result<Pair, String> {
    let start =
        RigidTransform { rotation: Matrix3::identity(), translation: target.mesh.centroid() - source.mesh.centroid() };
    let options = IcpOptions { metric: IcpMetric::PointToPoint, keep: 0.9, max_iterations: 100, tolerance: 1e-6 };
    let closest = Surface(ClosestPointIndex::new(&target.mesh));
    let reference = refine_icp(source.mesh.vertices(), &closest, &start, &options, &Silent)
        .map_err(|e| e.to_string())?
        .target_from_source;
    let motion = random_pose(seed);
    let (moved, order) = moved_and_permuted(&target.mesh, &motion, seed)?;
    Ok(Pair {
        source: source.mesh.clone(),
        target: moved,
        truth: None,
        pose: Some(rigid(&motion).after(&reference)),
        parts: Some((source.parts.clone(), permuted(&target.parts, &order))),
    })
}

/// Voxels between a deformed structure and the border of its volume.
const MARGIN: f64 = 4.0;

/// A subject, and the surface made from its labels after a smooth deformation and a rotation, on voxels of the same
/// size. The truth is known everywhere, and the surfaces share neither vertices nor voxel steps.
pub(super) fn warped_pair(
    subject: &Subject,
    volume: &LabelVolume,
    deform_share: f64,
    seed: u64,
) -> Result<Pair, String> {
    let points = subject.mesh.vertices();
    let deformation = Deformation::new(points, deform_share, seed).map_err(|e| e.to_string())?;
    let motion = random_pose(seed);
    let truth: Vec<_> = points.iter().map(|p| motion * deformation.apply(p)).collect();
    let voxel_mm = volume.spacing_mm().into_iter().fold(f64::INFINITY, f64::min);
    let infinity = Point3::from([f64::INFINITY; 3]);
    let (low, high) = truth.iter().fold((infinity, -infinity), |(l, h), p| (l.inf(p), h.sup(p)));
    let low = low - Vector3::repeat(MARGIN * voxel_mm);
    let dims: [usize; 3] = std::array::from_fn(|k| ((high[k] - low[k]) / voxel_mm + MARGIN).ceil() as usize);
    let index_from_mm = volume.affine().try_inverse().ok_or("the volume has no inverse transform")?;
    let label = |k: usize| {
        let at = Vector3::new(k % dims[0], k / dims[0] % dims[1], k / (dims[0] * dims[1])).map(|c| c as f64);
        let of_subject = deformation.invert(&(motion.inverse() * (low + voxel_mm * at)))?;
        let index = index_from_mm.transform_point(&of_subject).map(f64::round);
        let inside = (0..3).all(|axis| index[axis] >= 0.0 && (index[axis] as usize) < volume.dims()[axis]);
        let [nx, ny, _] = volume.dims();
        inside.then(|| volume.labels()[(index.z as usize * ny + index.y as usize) * nx + index.x as usize])
    };
    let labels = (0..dims.iter().product()).into_par_iter().map(|k| label(k).unwrap_or(0)).collect();
    let mut affine = Matrix4::new_scaling(voxel_mm);
    affine.fixed_view_mut::<3, 1>(0, 3).copy_from(&low.coords);
    let moved = LabelVolume::new(dims, labels, affine).map_err(|e| e.to_string())?;
    let pose = absolute_orientation(points, &truth, None, false).map_err(|e| e.to_string())?;
    Ok(Pair {
        source: subject.mesh.clone(),
        target: surface(&write_nifti(&moved))?,
        truth: Some(truth),
        pose: Some(pose),
        parts: None,
    })
}

fn rigid(motion: &Isometry3<f64>) -> RigidTransform {
    RigidTransform { rotation: *motion.rotation.to_rotation_matrix().matrix(), translation: motion.translation.vector }
}

/// The transformed surface, with vertex `k` renumbered to `order[k]`.
fn moved_and_permuted(
    mesh: &SurfaceMesh,
    motion: &Isometry3<f64>,
    seed: u64,
) -> Result<(SurfaceMesh, Vec<u32>), String> {
    let order = random_permutation(mesh.n_vertices(), seed);
    let mut vertices = vec![Point3::origin(); mesh.n_vertices()];
    for (p, &new) in mesh.vertices().iter().zip(&order) {
        vertices[new as usize] = motion * p;
    }
    let indices = mesh.indices().iter().map(|&k| order[k as usize]).collect();
    let mesh = SurfaceMesh::new(vertices, mesh.arity(), indices).map_err(|e| e.to_string())?;
    Ok((mesh, order))
}

fn permuted(parts: &[u32], order: &[u32]) -> Vec<u32> {
    let mut moved = vec![0; parts.len()];
    for (&part, &new) in parts.iter().zip(order) {
        moved[new as usize] = part;
    }
    moved
}

/// Closest points for point-to-point ICP, which uses no normals.
struct Surface(ClosestPointIndex);

impl ClosestSurfacePoint for Surface {
    fn closest(&self, query: &Point3<f64>) -> (Point3<f64>, Vector3<f64>) {
        (self.0.closest(query).point, Vector3::z())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::phantom::Phantom;

    #[test]
    fn a_warped_copy_has_other_vertices_and_its_truth_lies_on_it() {
        let volume = Phantom::new(3).volume(1.0).unwrap().into_label_volume().unwrap();
        let mesh = surface(&write_nifti(&volume)).unwrap();
        let subject = Subject { parts: vec![1; mesh.n_vertices()], mesh };
        let pair = warped_pair(&subject, &volume, 0.04, 7).unwrap();
        let (source, target) = (&pair.source, &pair.target);
        let (index, edge_mm) = (ClosestPointIndex::new(target), target.mean_edge_length());
        let truth = pair.truth.unwrap();
        let off: Vec<f64> = truth.iter().map(|p| (index.closest(p).point - p).norm() / edge_mm).collect();
        // The voxels of another grid round the same structure differently; the bounds were fixed before the
        // measurement.
        let mean = off.iter().sum::<f64>() / off.len() as f64;
        assert!(mean < 0.25 && off.iter().all(|&d| d < 1.0), "{mean}");
        let at_vertex = |p: &Point3<f64>| target.vertices().iter().any(|q| (q - p).norm() < 1e-3 * edge_mm);
        assert!(!truth.iter().any(at_vertex), "a true corresponding point is a vertex");
        // Apart from the pose, the deformation has the requested strength.
        let (low, high) = source.bounding_box();
        let pose = pair.pose.unwrap();
        let squares: f64 = source.vertices().iter().zip(&truth).map(|(p, q)| (pose.apply(p) - q).norm_squared()).sum();
        let share = (squares / truth.len() as f64).sqrt() / (high - low).norm();
        assert!(share > 0.01 && share <= 0.0401, "{share}");
    }
}
