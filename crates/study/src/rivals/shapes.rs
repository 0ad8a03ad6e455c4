//! Shapes of mapped templates in one frame, and their distance: how far one lies outside or inside the other.
//!
//! Maps are aligned with the mean of the reliable ones by rotation, translation and scale. What is compared is the displacement from
//! this mean along its normals, averaged over patches of the template, without the part that a small rotation, translation or
//! change of size explains (as in registration to tangent planes). Matches slide along a surface where it says nothing, even
//! around an axis, which has to do with no pose; the asymmetry that tells poses apart displaces the surface along its normal.
//!
//! Sources: Dryden, Mardia, *Statistical Shape Analysis*, 2nd edition, 2016, chapter 7 (generalized Procrustes analysis); Chen,
//! Medioni, *Object modeling by registration of multiple range images*, 1992 (tangent planes).

use crate::align::{area_weights, fit_onto, points};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::points::FarthestPoints;
use nalgebra::{Point3, Vector3};

/// Rounds of alignment with the mean, which changes little after the first.
const ROUNDS: usize = 3;

/// Share of the size below which a displacement is rounding.
const ROUNDING: f64 = 1e-6;

/// The mean of maps, and patches of the template.
pub(super) struct Frame {
    mean: Vec<Point3<f64>>,
    normals: Vec<Vector3<f64>>,
    /// The share of the area of each vertex.
    weights: Vec<f64>,
    /// The patch of each vertex, and the share of the area of each patch.
    of_vertex: Vec<usize>,
    areas: Vec<f64>,
    /// Displacements of the patches by rotations, translations and a change of size: orthonormal.
    motions: Vec<Vec<f64>>,
}

/// A shape in a frame: for each patch its displacement from the mean, mm in the size of the template, times the root of its weight.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shape(Vec<f64>);

/// The points of a map, aligned with others; `None` if they determine no alignment.
fn aligned(map: &[[f32; 3]], onto: &[Point3<f64>], weights: &[f64]) -> Option<Vec<Point3<f64>>> {
    let own = points(map);
    let fitted = fit_onto(&own, onto, weights, true).ok()?;
    let moved: Vec<Point3<f64>> = own.iter().map(|p| fitted.apply(p)).collect();
    moved.iter().all(|p| p.coords.iter().all(|x| x.is_finite())).then_some(moved)
}

impl Frame {
    /// The frame of maps of a template, with about `n` patches of equal size; the size is that of the template. `None` without a
    /// map.
    pub(super) fn new(template: &SurfaceMesh, maps: &[Vec<[f32; 3]>], n: usize) -> Option<Self> {
        let weights = area_weights(template);
        let mut mean = template.vertices().to_vec();
        for _ in 0..ROUNDS {
            let mut sums = vec![Vector3::zeros(); mean.len()];
            let mut used = 0usize;
            for moved in maps.iter().filter_map(|map| aligned(map, &mean, &weights)) {
                sums.iter_mut().zip(&moved).for_each(|(sum, p)| *sum += p.coords);
                used += 1;
            }
            if used == 0 {
                return None;
            }
            mean = sums.iter().map(|sum| Point3::from(sum / used as f64)).collect();
        }
        let surface = template.with_vertices(mean.clone()).ok()?;
        let mut sampling = FarthestPoints::new(&mean, Point3::from(surface.centroid()));
        sampling.extend_to(n);
        let of_vertex: Vec<usize> = sampling.nearest_samples().collect();
        let mut areas = vec![0.0; sampling.samples().len()];
        of_vertex.iter().zip(&weights).for_each(|(&patch, w)| areas[patch] += w);
        drop(sampling);
        let (normals, motions) = (surface.vertex_normals(), Vec::new());
        let mut frame = Frame { mean, normals, weights, of_vertex, areas, motions };
        let center = surface.centroid();
        for motion in 0..7 {
            let axis = Vector3::ith(motion % 3, 1.0);
            let along = |v: usize| {
                let from_center = frame.mean[v] - center;
                let moved = match motion {
                    0..3 => axis,
                    3..6 => axis.cross(&from_center),
                    _ => from_center,
                };
                moved.dot(&frame.normals[v])
            };
            let mut patches = frame.patches(along);
            remove(&frame.motions, &mut patches);
            let length = patches.iter().map(|x| x * x).sum::<f64>().sqrt();
            // A sphere has no rotations.
            if length > ROUNDING * frame.size() {
                patches.iter_mut().for_each(|x| *x /= length);
                frame.motions.push(patches);
            }
        }
        Some(frame)
    }

    /// Root mean square distance of the mean from the origin, mm.
    fn size(&self) -> f64 {
        self.mean.iter().zip(&self.weights).map(|(p, w)| w * p.coords.norm_squared()).sum::<f64>().sqrt()
    }

    /// The mean of a value at each vertex over each patch, times the root of the weight of the patch.
    fn patches(&self, value: impl Fn(usize) -> f64) -> Vec<f64> {
        let mut sums = vec![0.0; self.areas.len()];
        for (v, (&patch, w)) in self.of_vertex.iter().zip(&self.weights).enumerate() {
            sums[patch] += w * value(v);
        }
        let rooted = |(sum, &area): (&f64, &f64)| if area > 0.0 { sum / area.sqrt() } else { 0.0 };
        sums.iter().zip(&self.areas).map(rooted).collect()
    }

    /// The shape of a map; `None` if it is a point, or a number is not finite.
    pub(super) fn shape(&self, map: &[[f32; 3]]) -> Option<Shape> {
        let moved = aligned(map, &self.mean, &self.weights)?;
        let mut patches = self.patches(|v| (moved[v] - self.mean[v]).dot(&self.normals[v]));
        remove(&self.motions, &mut patches);
        Some(Shape(patches))
    }
}

/// Removes the parts along orthonormal vectors.
fn remove(vectors: &[Vec<f64>], from: &mut [f64]) {
    for vector in vectors {
        let part: f64 = vector.iter().zip(&*from).map(|(a, b)| a * b).sum();
        from.iter_mut().zip(vector).for_each(|(x, a)| *x -= part * a);
    }
}

impl Shape {
    /// Squared distance of two shapes: the mean square over the area, mm².
    pub(super) fn squared_distance(&self, other: &Shape) -> f64 {
        self.0.iter().zip(&other.0).map(|(a, b)| (a - b).powi(2)).sum()
    }

    /// Mean squared distance from other shapes; 0 for none.
    pub(super) fn mean_squared_distance<'a>(&self, others: impl Iterator<Item = &'a Shape>) -> f64 {
        let (sum, n) = others.fold((0.0, 0usize), |(sum, n), other| (sum + self.squared_distance(other), n + 1));
        sum / n.max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Isometry3;
    use proptest::prelude::*;

    fn stored(points: impl Iterator<Item = Point3<f64>>) -> Vec<[f32; 3]> {
        points.map(|p| [p.x, p.y, p.z].map(|x| x as f32)).collect()
    }

    proptest! {
        #[test]
        fn motion_and_size_do_not_count_and_a_bump_has_its_height(
            angles in prop::array::uniform3(-3.0..3.0f64), shift in prop::array::uniform3(-50.0..50.0f64), size in 0.5..2.0f64,
            bump in 0.01..0.5f64,
        ) {
            let mesh = ellipsoid(Vector3::new(9.0, 5.0, 3.0), 3);
            let normals = mesh.vertex_normals();
            let maps = vec![stored(mesh.vertices().iter().copied()); 3];
            let frame = Frame::new(&mesh, &maps, 642).unwrap();
            let motion = Isometry3::new(Vector3::from(shift), Vector3::from(angles));
            let heights: Vec<f64> =
                mesh.vertices().iter().map(|p| bump * (-(p - mesh.vertices()[40]).norm_squared() / 2.0).exp()).collect();
            let bumped: Vec<Point3<f64>> =
                mesh.vertices().iter().zip(&normals).zip(&heights).map(|((p, n), h)| p + n * *h).collect();
            let first = frame.shape(&maps[0]).unwrap();
            let own = frame.shape(&stored(bumped.iter().copied())).unwrap();
            let moved = frame.shape(&stored(bumped.iter().map(|p| motion * Point3::from(p.coords * size)))).unwrap();
            prop_assert!(own.squared_distance(&moved) < 1e-7);
            let weights = area_weights(&mesh);
            let whole: f64 = heights.iter().zip(&weights).map(|(h, w)| w * h * h).sum();
            let found = first.squared_distance(&own);
            // The alignment takes a small part of it.
            prop_assert!(found <= 1.01 * whole && found > 0.5 * whole, "{found} {whole}");
        }
    }

    #[test]
    fn points_that_slide_around_an_axis_hardly_count() {
        let axes = Vector3::new(9.0, 5.0, 4.0);
        let mesh = ellipsoid(axes, 3);
        let maps = vec![stored(mesh.vertices().iter().copied()); 3];
        let frame = Frame::new(&mesh, &maps, 256).unwrap();
        let turn = nalgebra::Rotation3::from_axis_angle(&Vector3::x_axis(), 0.1);
        let slid: Vec<Point3<f64>> = mesh
            .vertices()
            .iter()
            .map(|p| Point3::from((turn * p).coords.component_div(&axes).normalize().component_mul(&axes)))
            .collect();
        let moved = mesh.vertices().iter().zip(&slid).map(|(p, q)| (p - q).norm_squared()).sum::<f64>();
        let found = frame.shape(&stored(slid.into_iter())).unwrap().squared_distance(&frame.shape(&maps[0]).unwrap());
        assert!(found < 0.02 * moved / mesh.n_vertices() as f64, "{found} {moved}");
    }

    #[test]
    fn points_that_slide_along_the_surface_hardly_count() {
        let axes = Vector3::new(9.0, 5.0, 3.0);
        let mesh = ellipsoid(axes, 3);
        let maps = vec![stored(mesh.vertices().iter().copied()); 3];
        let frame = Frame::new(&mesh, &maps, 256).unwrap();
        let slid = mesh.vertices().iter().map(|p| {
            let q = p + 0.1 * Vector3::new((0.5 * p.y).sin(), (0.4 * p.z).cos(), (0.3 * p.x).sin());
            q / q.coords.component_div(&axes).norm()
        });
        let slid: Vec<Point3<f64>> = slid.collect();
        let moved = mesh.vertices().iter().zip(&slid).map(|(p, q)| (p - q).norm_squared()).sum::<f64>();
        let found = frame.shape(&stored(slid.into_iter())).unwrap().squared_distance(&frame.shape(&maps[0]).unwrap());
        assert!(found < 0.05 * moved / mesh.n_vertices() as f64, "{found} {moved}");
    }

    #[test]
    fn a_point_is_no_shape() {
        let mesh = ellipsoid(Vector3::new(9.0, 5.0, 3.0), 2);
        let maps = vec![stored(mesh.vertices().iter().copied()); 3];
        let frame = Frame::new(&mesh, &maps, 40).unwrap();
        assert!(frame.shape(&vec![[f32::NAN; 3]; mesh.n_vertices()]).is_none());
        assert!(Frame::new(&mesh, &[], 40).is_none());
    }
}
