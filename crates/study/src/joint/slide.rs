//! Slides of points along a surface: where a smooth residual wants them, and where the surface lets them.

use crate::error::StudyError;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::graph::EdgeGraph;
use nalgebra::{Point3, Vector3};

/// Least and largest area of a triangle, as a multiple of its area in the template when both surfaces have the same
/// area; a triangle beyond may only come nearer. No region collapses for a simpler population.
const AREAS: [f64; 2] = [0.2, 5.0];
/// Cosine of the angle by which the normal of a triangle may turn in a round that fits it to the surface: narrow
/// triangles are not turned on edge by it.
const FIT_COSINE: f64 = 0.8;
/// Share of the gradient at which the equations of a slide are solved.
const SOLVED: f64 = 1e-3;
/// Times that a step is halved around faulty triangles before it is given up there.
const HALVED: usize = 3;
/// Times that given up vertices make neighbors give up.
const GIVEN_UP: usize = 10;

/// The tangential displacement at each vertex after which the residual is smoothest.
///
/// `residual`: from the shape to its prediction, mm; `normals` of the shape, unit vectors. A displacement along the
/// surface changes only the tangential part of the residual `e`; it minimizes `½ Σ_v k_v |e_v|² − (β/2) Σ_v Σ_u~v
/// e_v · e_u` over the tangential parts, where `k_v` is the number of neighbors `u` of `v` and `0 ≤ β < 1` the
/// `stiffness`: the energy of a conditional autoregressive field (Besag 1974). With `β = 0` the tangential residual
/// vanishes, and each vertex moves alone; near 1 the residual is a smooth field that keeps the distances of vertices.
/// The energy is quadratic; at most `steps` of conjugate gradients from the present residual, each `O(V)`.
pub(super) fn smoothing_slide(
    residual: &[Vector3<f64>],
    normals: &[Vector3<f64>],
    graph: &EdgeGraph,
    stiffness: f64,
    steps: usize,
) -> Vec<Vector3<f64>> {
    let n = residual.len();
    let tangential = |v: usize, d: Vector3<f64>| d - normals[v] * normals[v].dot(&d);
    // Divided by k_v, which also conditions the equations; products then weigh each vertex by k_v.
    let gradient = |field: &[Vector3<f64>]| -> Vec<Vector3<f64>> {
        (0..n).map(|v| tangential(v, field[v] - stiffness * neighbors_mean(field, graph, v))).collect()
    };
    let product = |a: &[Vector3<f64>], b: &[Vector3<f64>]| -> f64 {
        (0..n).map(|v| graph.neighbors(v).len() as f64 * a[v].dot(&b[v])).sum()
    };
    let mut now = residual.to_vec();
    let mut down: Vec<Vector3<f64>> = gradient(&now).into_iter().map(|g| -g).collect();
    let mut direction = down.clone();
    let mut square = product(&down, &down);
    let rested = SOLVED * SOLVED * square;
    for _ in 0..steps {
        if square <= rested {
            break;
        }
        let change = gradient(&direction);
        let curvature = product(&direction, &change);
        if curvature <= 0.0 {
            break;
        }
        let length = square / curvature;
        for v in 0..n {
            now[v] += length * direction[v];
            down[v] -= length * change[v];
        }
        let next = product(&down, &down);
        (0..n).for_each(|v| direction[v] = down[v] + next / square * direction[v]);
        square = next;
    }
    (0..n).map(|v| tangential(v, residual[v] - now[v])).collect()
}

/// Mean of a field over the neighbors of a vertex; zero without neighbors.
fn neighbors_mean(field: &[Vector3<f64>], graph: &EdgeGraph, v: usize) -> Vector3<f64> {
    let near = graph.neighbors(v);
    near.iter().map(|&u| field[u as usize]).sum::<Vector3<f64>>() / near.len().max(1) as f64
}

/// Sums from which the stiffness of residuals is estimated: `Σ k_v e_v · ē_v` and `Σ k_v |ē_v|²`, with the mean `ē_v`
/// over the `k_v` neighbors. Their ratio maximizes the pseudo-likelihood of the field (Besag 1975).
pub(super) fn stiffness_sums(residual: &[Vector3<f64>], graph: &EdgeGraph) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for (v, own) in residual.iter().enumerate() {
        let (mean, k) = (neighbors_mean(residual, graph, v), graph.neighbors(v).len() as f64);
        sums[0] += k * own.dot(&mean);
        sums[1] += k * mean.norm_squared();
    }
    sums
}

/// A surface on which points slide.
pub struct Slidable {
    mesh: SurfaceMesh,
    index: ClosestPointIndex,
    normals: Vec<Vector3<f64>>,
}

impl Slidable {
    /// A surface of a subject, as read.
    pub fn new(mesh: SurfaceMesh) -> Self {
        Slidable { index: ClosestPointIndex::new(&mesh), normals: mesh.vertex_normals(), mesh }
    }

    /// Memory, bytes.
    pub fn heap_bytes(&self) -> usize {
        self.mesh.heap_bytes() + self.index.heap_bytes() + size_of_val(self.normals.as_slice())
    }

    /// The nearest point of the surface and the normal there.
    fn nearest(&self, p: &Point3<f64>) -> (Point3<f64>, Vector3<f64>) {
        let found = self.index.closest(p);
        (found.point, found.blend(|k| self.normals[k]))
    }

    /// The vertices of `template` at `from` after a step, back on the surface, as far as the guards allow it. A vertex
    /// does not move to a sheet of the surface that looks the other way.
    pub(super) fn slide(
        &self,
        template: &SurfaceMesh,
        from: &[Point3<f64>],
        step: &[Vector3<f64>],
    ) -> Vec<Point3<f64>> {
        let normals = template.vertex_normals_at(from);
        let place = |v: usize, share: f64| {
            let (point, normal) = self.nearest(&(from[v] + share * step[v]));
            let is_same_sheet = normal.dot(&normals[v]) > 0.0 || normal.dot(&self.nearest(&from[v]).1) > 0.0;
            if is_same_sheet { point } else { from[v] }
        };
        self.guarded(template, from, -1.0, &place)
    }

    /// Places vertices by `place(vertex, share of the step)`. No triangle turns over against the surface that was not
    /// turned before, none leaves [`AREAS`], and no normal turns by more than the angle of this cosine; around such
    /// triangles the step is halved, at last to nothing.
    fn guarded(
        &self,
        template: &SurfaceMesh,
        from: &[Point3<f64>],
        least_cosine: f64,
        place: &dyn Fn(usize, f64) -> Point3<f64>,
    ) -> Vec<Point3<f64>> {
        let areas = template.face_vector_areas();
        let faces = || template.faces().map(|face| [face[0] as usize, face[1] as usize, face[2] as usize]);
        let area = |p: &[Point3<f64>], [a, b, c]: [usize; 3]| (p[b] - p[a]).cross(&(p[c] - p[a])) / 2.0;
        let whole = faces().map(|face| area(from, face).norm()).sum::<f64>();
        let scale = whole / areas.iter().map(|area| area.norm()).sum::<f64>();
        let is_turned = |p: &[Point3<f64>], face: [usize; 3]| {
            let normal: Vector3<f64> = face.iter().map(|&v| self.nearest(&p[v]).1).sum();
            normal.dot(&area(p, face)) <= 0.0
        };
        let is_faulty = |next: &[Point3<f64>], (face, own): ([usize; 3], &Vector3<f64>)| {
            let (before, after) = (area(from, face), area(next, face));
            let (was, is, whole) = (before.norm(), after.norm(), scale * own.norm());
            let is_small = is < AREAS[0] * whole && is < was;
            let is_large = is > AREAS[1] * whole && is > was;
            let cosine = before.dot(&after) / (was * is).max(f64::MIN_POSITIVE);
            // Only triangles that turn far can turn over, and few do.
            let turns = || cosine < 0.5 && is_turned(next, face) && !is_turned(from, face);
            cosine < least_cosine || is_small || is_large || turns()
        };
        let mut shares = vec![1.0; from.len()];
        let mut next: Vec<Point3<f64>> = (0..from.len()).map(|v| place(v, 1.0)).collect();
        for round in 0..HALVED + GIVEN_UP {
            let faulty = faces().zip(&areas).filter(|&face| is_faulty(&next, face));
            let mut around: Vec<usize> = faulty.flat_map(|(face, _)| face).filter(|&v| shares[v] > 0.0).collect();
            around.sort_unstable();
            around.dedup();
            if around.is_empty() {
                break;
            }
            for v in around {
                shares[v] = if round < HALVED { shares[v] / 2.0 } else { 0.0 };
                next[v] = if shares[v] > 0.0 { place(v, shares[v]) } else { from[v] };
            }
        }
        next
    }

    /// Distance of each vertex of the surface that a face uses from the mapped template, mm, ascending.
    ///
    /// # Errors
    /// [`StudyError::Mesh`] if a position is not finite.
    pub(super) fn distances(&self, template: &SurfaceMesh, points: &[Point3<f64>]) -> Result<Vec<f64>, StudyError> {
        Ok(crate::record::distances(&self.mesh, &template.with_vertices(points.to_vec())?))
    }

    /// The mapped template moved along its normals towards the vertices of the surface, each of which pulls the
    /// triangle nearest to it. Corners of flat triangles on a curved surface then lie a little outside, so that the
    /// triangles lie neither inside nor outside on average.
    ///
    /// # Errors
    /// [`StudyError::Mesh`] if a position is not finite.
    pub(super) fn fitted(
        &self,
        template: &SurfaceMesh,
        mut points: Vec<Point3<f64>>,
        rounds: usize,
    ) -> Result<Vec<Point3<f64>>, StudyError> {
        for _ in 0..rounds {
            let mapped = template.with_vertices(points)?;
            let (index, normals) = (ClosestPointIndex::new(&mapped), mapped.vertex_normals());
            let mut pulls = vec![(0.0, 0.0); normals.len()];
            for p in self.mesh.vertices() {
                let found = index.closest(p);
                for (&corner, &share) in found.triangle.iter().zip(&found.barycentric) {
                    let pull = &mut pulls[corner as usize];
                    pull.0 += share * (p - found.point).dot(&normals[corner as usize]);
                    pull.1 += share;
                }
            }
            let from = mapped.vertices();
            let place = |v: usize, part: f64| {
                let (pull, share) = pulls[v];
                // Vertices that are hardly pulled stay nearly where they are.
                from[v] + normals[v] * (part * pull / share.max(1.0))
            };
            points = self.guarded(template, from, FIT_COSINE, &place);
        }
        Ok(points)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;

    fn field(mesh: &SurfaceMesh) -> Vec<Vector3<f64>> {
        let at = |p: &Point3<f64>| Vector3::new((0.7 * p.y).sin(), (0.5 * p.x + p.z).cos(), 0.2 * p.x * p.y);
        mesh.vertices().iter().map(at).collect()
    }

    /// The energy, from its definition.
    fn energy(e: &[Vector3<f64>], graph: &EdgeGraph, stiffness: f64) -> f64 {
        let mut sum = 0.0;
        for (v, own) in e.iter().enumerate() {
            for &u in graph.neighbors(v) {
                sum += 0.5 * own.norm_squared() - 0.5 * stiffness * own.dot(&e[u as usize]);
            }
        }
        sum
    }

    #[test]
    fn no_slide_has_less_energy() {
        let mesh = ellipsoid(Vector3::new(5.0, 3.0, 2.0), 2);
        let (graph, normals, residual) = (mesh.edge_graph(), mesh.vertex_normals(), field(&mesh));
        for stiffness in [0.0, 0.9, 0.99] {
            let slide = smoothing_slide(&residual, &normals, &graph, stiffness, 200);
            let after: Vec<_> = residual.iter().zip(&slide).map(|(r, d)| r - d).collect();
            assert!(slide.iter().zip(&normals).all(|(d, n)| d.dot(n).abs() < 1e-9), "along the surface");
            let least = energy(&after, &graph, stiffness);
            assert!(least < energy(&residual, &graph, stiffness));
            for v in [0, 7, 40] {
                for axis in 0..3 {
                    let along = Vector3::ith(axis, 1.0) - normals[v] * normals[v][axis];
                    for length in [-0.05, 0.05] {
                        let mut other = after.clone();
                        other[v] += length * along;
                        assert!(energy(&other, &graph, stiffness) > least, "{stiffness}, vertex {v}");
                    }
                }
            }
        }
    }

    #[test]
    fn without_stiffness_the_tangential_residual_vanishes_and_smooth_fields_are_stiff() {
        let mesh = ellipsoid(Vector3::new(5.0, 3.0, 2.0), 3);
        let (graph, normals) = (mesh.edge_graph(), mesh.vertex_normals());
        let residual = field(&mesh);
        let slide = smoothing_slide(&residual, &normals, &graph, 0.0, 50);
        for ((r, d), n) in residual.iter().zip(&slide).zip(&normals) {
            assert!((r - d - n * n.dot(r)).norm() < 1e-9);
        }
        let estimate = |field: &[Vector3<f64>]| {
            let [own, mean] = stiffness_sums(field, &graph);
            own / mean
        };
        assert!(estimate(&residual) > 0.95);
        let rough: Vec<_> = (0..residual.len()).map(|v| Vector3::new(((v * v) as f64 * 1.7).sin(), 0.0, 0.0)).collect();
        assert!(estimate(&rough) < 0.6, "{}", estimate(&rough));
    }

    #[test]
    fn points_stay_on_the_surface_and_no_triangle_turns_or_collapses() {
        let template = ellipsoid(Vector3::new(5.0, 3.0, 2.0), 2);
        let surface = Slidable::new(ellipsoid(Vector3::new(5.0, 3.0, 2.0), 4));
        // Everything is drawn to one point.
        let from = template.vertices();
        let step: Vec<_> = from.iter().map(|p| 0.9 * (Point3::new(0.0, 3.0, 0.0) - p)).collect();
        let next = surface.slide(&template, from, &step);
        assert!(next.iter().all(|p| (surface.nearest(p).0 - p).norm() < 1e-9));
        let mesh = template.with_vertices(next.clone()).unwrap();
        for (a, b) in template.face_vector_areas().iter().zip(mesh.face_vector_areas()) {
            assert!(a.dot(&b) > 0.0 && b.norm() > 0.15 * a.norm());
        }
        let moved = next.iter().zip(from).filter(|(p, q)| (*p - *q).norm() > 0.1).count();
        assert!(moved > 0, "what is allowed moves");
    }

    #[test]
    fn a_fitted_template_lies_nearer_to_the_surface() {
        let template = ellipsoid(Vector3::new(5.0, 3.0, 2.0), 2);
        let surface = Slidable::new(ellipsoid(Vector3::new(5.0, 3.0, 2.0), 4));
        let mean = |points: &[Point3<f64>]| {
            let all = surface.distances(&template, points).unwrap();
            all.iter().sum::<f64>() / all.len() as f64
        };
        let fitted = surface.fitted(&template, template.vertices().to_vec(), 2).unwrap();
        assert!(mean(&fitted) < 0.6 * mean(template.vertices()));
    }
}
