//! Distances of many points from a surface.
//!
//! [`super::ClosestPointIndex`] also finds the closest point, but needs a tree that has to be built. Where only the
//! distance is needed, as between two registered surfaces, three properties make this search faster:
//!
//! - The tree follows the numbering and nothing is sorted: faces in canonical order follow a curve through space, so
//!   eight consecutive faces are close together, and so are eight such groups.
//! - Every group has a bounding box and a bounding slab, a disc of some thickness along its mean normal. Far from a
//!   fine surface, the boxes of many groups are closer than the surface, but few of the slabs are.
//! - Queries are answered in sequence, and the triangle found for one query bounds the next before its search begins.
//!
//! Boxes and slabs only exclude groups that are farther by more than rounding. The distance itself is computed by the
//! routine of [`super::ClosestPointIndex`], so both give the same bits.

use super::SurfaceMesh;
use multiversion::multiversion;
use nalgebra::{Point3, Vector3};
use parry3d_f64::math::Vector;
use parry3d_f64::query::PointQuery;
use parry3d_f64::shape::Triangle;
use rayon::prelude::*;

/// Children of a node: a whole number of vector registers of any instruction set.
const FAN: usize = 8;
/// Consecutive queries per task. Fixed, so that the work does not depend on the number of threads.
const ROW: usize = 256;
/// Number of lowest levels with slabs. Slabs exclude flat groups: single triangles and groups of eight. On higher
/// levels they excluded almost nothing.
const SLAB_LEVELS: usize = 2;
/// Error of a bound, relative to the numbers it is computed from: about fifty times the rounding of 32 bits.
const BOUND_RTOL: f64 = 4e-6;
/// Coordinate of missing children of a node: its squared distance from any query is infinite in 32 bits.
const NOWHERE: f32 = f32::MAX;

/// Extents, mm, within which 32 bits hold squared lengths without scaling.
const SMALLEST: f64 = 1e-12;
const LARGEST: f64 = 1e12;

type Lanes = [f32; FAN];

/// The distances of points from one surface. Fast if faces that are close in space have close indices, as in canonical
/// numbering; correct for any order.
pub struct SurfaceDistances<'a> {
    vertices: &'a [Point3<f64>],
    triangles: Vec<[u32; 3]>,
    /// Bounds by level, from single triangles up; the last level has one node.
    levels: Vec<Vec<Node>>,
    /// Origin of the bounds; chosen so that 32 bits resolve positions on the surface.
    center: Point3<f64>,
    /// Largest coordinate relative to `center`, mm.
    extent: f64,
    /// Factor of lengths in the bounds, a power of two: 32 bits then hold squared lengths of any unit.
    scale: f64,
}

/// Bounds of the children of a node, each a group of consecutive triangles. Lengths in mm.
struct Node {
    low: [Lanes; 3],
    high: [Lanes; 3],
    /// Center of the slab.
    middle: [Lanes; 3],
    /// Unit normal of the slab; zero turns the slab into a ball.
    normal: [Lanes; 3],
    radius: Lanes,
    half_thickness: Lanes,
}

impl Node {
    fn nowhere() -> Self {
        let (place, none) = ([[NOWHERE; FAN]; 3], [[0.0; FAN]; 3]);
        Node { low: place, high: place, middle: place, normal: none, radius: [0.0; FAN], half_thickness: [0.0; FAN] }
    }

    /// Bounds child `k` by a box.
    fn set_box(&mut self, k: usize, [low, high]: [Vector3<f64>; 2]) {
        for axis in 0..3 {
            (self.low[axis][k], self.high[axis][k]) = (low[axis] as f32, high[axis] as f32);
        }
    }

    /// Bounds child `k`, triangles with these corners, by a box and a slab.
    fn set_patch(&mut self, k: usize, corners: &[[Vector3<f64>; 3]]) {
        let points = || corners.iter().flatten();
        self.set_box(k, box_around(points()));
        // Twice the vector area. The slab contains the corners for any normal; this normal makes it thin.
        let area: Vector3<f64> = corners.iter().map(|[a, b, c]| (b - a).cross(&(c - a))).sum();
        let normal = area.try_normalize(f64::MIN_POSITIVE).unwrap_or_default();
        let mean = points().sum::<Vector3<f64>>() / (3 * corners.len()) as f64;
        let (mut lowest, mut highest, mut across) = (f64::INFINITY, f64::NEG_INFINITY, 0.0f64);
        for p in points() {
            let height = (p - mean).dot(&normal);
            (lowest, highest) = (lowest.min(height), highest.max(height));
            across = across.max((p - mean - normal * height).norm_squared());
        }
        let middle = mean + normal * ((lowest + highest) / 2.0);
        for axis in 0..3 {
            (self.middle[axis][k], self.normal[axis][k]) = (middle[axis] as f32, normal[axis] as f32);
        }
        (self.radius[k], self.half_thickness[k]) = (across.sqrt() as f32, ((highest - lowest) / 2.0) as f32);
    }

    /// The box around the first `n` children of the node.
    fn around(&self, n: usize) -> [Vector3<f64>; 2] {
        let corner = |of: &[Lanes; 3], k: usize| Vector3::from_fn(|axis, _| f64::from(of[axis][k]));
        let [low, high] = [&self.low, &self.high].map(|of| box_around((0..n).map(|k| corner(of, k))));
        [low[0], high[1]]
    }

    /// For every child a lower bound of its squared distance from `p`, up to rounding.
    // Indexed loops over all columns, which the compiler vectorizes.
    #[allow(clippy::needless_range_loop)]
    #[inline(always)]
    fn squared_bounds(&self, p: &[f32; 3], with_slabs: bool) -> Lanes {
        let mut bounds = [0.0; FAN];
        for axis in 0..3 {
            for k in 0..FAN {
                let outside = larger(self.low[axis][k] - p[axis], p[axis] - self.high[axis][k]);
                let gap = larger(outside, 0.0);
                bounds[k] += gap * gap;
            }
        }
        if !with_slabs {
            return bounds;
        }
        let mut height = [0.0; FAN];
        for axis in 0..3 {
            for k in 0..FAN {
                height[k] += (p[axis] - self.middle[axis][k]) * self.normal[axis][k];
            }
        }
        let mut across = [0.0; FAN];
        for axis in 0..3 {
            for k in 0..FAN {
                // The difference of squares would lose half of the digits.
                let part = p[axis] - self.middle[axis][k] - height[k] * self.normal[axis][k];
                across[k] += part * part;
            }
        }
        for k in 0..FAN {
            let above = larger(height[k].abs() - self.half_thickness[k], 0.0);
            let beyond = larger(across[k].sqrt() - self.radius[k], 0.0);
            bounds[k] = larger(bounds[k], above * above + beyond * beyond);
        }
        bounds
    }
}

/// The larger of two numbers; one instruction on every set, unlike [`f32::max`].
#[inline(always)]
fn larger(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// Lowest and highest corner of the box around `points`.
fn box_around(points: impl Iterator<Item = impl std::borrow::Borrow<Vector3<f64>>>) -> [Vector3<f64>; 2] {
    let limits = [Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY)];
    points.fold(limits, |[low, high], p| [low.inf(p.borrow()), high.sup(p.borrow())])
}

/// State of one search: the least distance so far, and its triangle.
struct Search {
    at: Point3<f64>,
    best: f64,
    triangle: usize,
    /// Groups with a bound above this limit are farther than `best`.
    limit_squared: f32,
    /// Error of the bounds, mm.
    slack: f64,
    scale: f64,
}

impl Search {
    fn try_triangle(&mut self, surface: &SurfaceDistances<'_>, triangle: usize) {
        let distance = surface.distance_from_triangle(&self.at, triangle);
        if distance < self.best {
            (self.best, self.triangle) = (distance, triangle);
            self.limit_squared = ((distance + self.slack) * self.scale).powi(2) as f32;
        }
    }
}

/// The bound, level and index of a node to be searched.
type Open = (f32, usize, usize);

/// The distance of `at`, and a triangle at this distance; `first` is tried first. `open` is scratch memory.
#[inline(always)]
fn search(surface: &SurfaceDistances<'_>, at: &Point3<f64>, first: usize, open: &mut Vec<Open>) -> (f64, usize) {
    let place = at - surface.center;
    let slack = BOUND_RTOL * (place.amax() + surface.extent);
    let scale = surface.scale;
    let place = [(place.x * scale) as f32, (place.y * scale) as f32, (place.z * scale) as f32];
    let mut search =
        Search { at: *at, best: f64::INFINITY, triangle: first, limit_squared: f32::INFINITY, slack, scale };
    search.try_triangle(surface, first);
    open.push((0.0, surface.levels.len() - 1, 0));
    while let Some((bound, level, node)) = open.pop() {
        if bound > search.limit_squared {
            continue;
        }
        let bounds = surface.levels[level][node].squared_bounds(&place, level < SLAB_LEVELS);
        let mut near = 0u32;
        for (k, bound) in bounds.iter().enumerate() {
            near |= u32::from(*bound <= search.limit_squared) << k;
        }
        while near != 0 {
            let k = near.trailing_zeros() as usize;
            near &= near - 1;
            let child = node * FAN + k;
            // For a point so far away that all bounds are infinite, missing children would seem near.
            let n_children = if level > 0 { surface.levels[level - 1].len() } else { surface.triangles.len() };
            if child >= n_children {
                continue;
            }
            if level > 0 {
                open.push((bounds[k], level - 1, child));
            } else if bounds[k] <= search.limit_squared {
                search.try_triangle(surface, child);
            }
        }
    }
    (search.best, search.triangle)
}

/// The distances of consecutive points.
#[allow(unsafe_code)] // the dispatch that `multiversion` generates; the body is safe code
#[multiversion(targets("x86_64+avx2"))]
fn search_row(surface: &SurfaceDistances<'_>, points: &[Point3<f64>]) -> Vec<f64> {
    let (mut last, mut open) = (0, Vec::new());
    let mut distances = Vec::with_capacity(points.len());
    for p in points {
        let (distance, triangle) = search(surface, p, last, &mut open);
        last = triangle;
        distances.push(distance);
    }
    distances
}

impl<'a> SurfaceDistances<'a> {
    /// Prepares `mesh`, whose quads are split along a diagonal. `O(n)`, on all threads.
    pub fn new(mesh: &'a SurfaceMesh) -> Self {
        let (vertices, triangles) = (mesh.vertices(), mesh.triangles());
        let (low, high) = mesh.bounding_box();
        let center = nalgebra::center(&low, &high);
        let extent = (high - center).amax();
        let scale = if (SMALLEST..LARGEST).contains(&extent) { 1.0 } else { 2f64.powi(-extent.log2().floor() as i32) };
        let scale = if scale.is_normal() { scale } else { 1.0 };
        let mut levels: Vec<Vec<Node>> = Vec::new();
        for of_child in [1, FAN] {
            let node = |of_node: &[[u32; 3]]| {
                let mut node = Node::nowhere();
                let mut corners = [[Vector3::zeros(); 3]; FAN];
                for (k, run) in of_node.chunks(of_child).enumerate() {
                    for (corners, triangle) in corners.iter_mut().zip(run) {
                        *corners = triangle.map(|v| (vertices[v as usize] - center) * scale);
                    }
                    node.set_patch(k, &corners[..run.len()]);
                }
                node
            };
            levels.push(triangles.par_chunks(FAN * of_child).map(node).collect());
        }
        let mut n_below = triangles.len().div_ceil(FAN);
        while levels[levels.len() - 1].len() > 1 {
            let below = &levels[levels.len() - 1];
            let last = below.len() - 1;
            let of_last = n_below - FAN * last;
            let boxes = below.iter().enumerate().map(|(k, node)| node.around(if k < last { FAN } else { of_last }));
            n_below = below.len();
            let boxes: Vec<[Vector3<f64>; 2]> = boxes.collect();
            let node = |boxes: &[[Vector3<f64>; 2]]| {
                let mut node = Node::nowhere();
                boxes.iter().enumerate().for_each(|(k, of_child)| node.set_box(k, *of_child));
                node
            };
            levels.push(boxes.chunks(FAN).map(node).collect());
        }
        SurfaceDistances { vertices, triangles, levels, center, extent, scale }
    }

    /// The distance of each of `points` from the surface, mm. `O(n log n')`, on all threads; fast if points that are
    /// close in space have close indices. Coordinates must be finite.
    pub fn of(&self, points: &[Point3<f64>]) -> Vec<f64> {
        points.par_chunks(ROW).flat_map_iter(|row| search_row(self, row)).collect()
    }

    fn distance_from_triangle(&self, p: &Point3<f64>, triangle: usize) -> f64 {
        let vector = |p: &Point3<f64>| Vector::new(p.x, p.y, p.z);
        let [a, b, c] = self.triangles[triangle].map(|v| vector(&self.vertices[v as usize]));
        let found = Triangle::new(a, b, c).project_local_point(vector(p), false).point;
        (Point3::new(found.x, found.y, found.z) - p).norm()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::{ellipsoid, torus};
    use crate::{ClosestPointIndex, FaceArity, canonicalize};
    use proptest::prelude::*;
    use rand_core::{Rng, SeedableRng};
    use rand_xoshiro::Xoshiro256PlusPlus;

    /// By the distance from every triangle.
    fn plain(surface: &SurfaceDistances<'_>, p: &Point3<f64>) -> f64 {
        (0..surface.triangles.len()).map(|t| surface.distance_from_triangle(p, t)).fold(f64::INFINITY, f64::min)
    }

    fn shapes() -> Vec<SurfaceMesh> {
        let torus = |arity| torus(10.0, 4.0, 24, 11, arity);
        let round = ellipsoid(Vector3::new(9.0, 6.0, 5.0), 3);
        // Axis-aligned faces like those of voxels, and some without area.
        let snapped = round.vertices().iter().map(|p| p.map(f64::round)).collect();
        // Needles: nearly flattened along an axis that no face is parallel to.
        let axis = Vector3::new(1.0, 2.0, 3.0).normalize();
        let flat = round.vertices().iter().map(|p| p - axis * (axis.dot(&p.coords) * (1.0 - 1e-7))).collect();
        let mut shapes = vec![round.with_vertices(snapped).unwrap(), round.with_vertices(flat).unwrap(), round];
        shapes.extend([FaceArity::Triangle, FaceArity::Quad].map(torus));
        shapes.push(ellipsoid(Vector3::new(2.0, 1.0, 1.5), 0));
        shapes
    }

    #[test]
    fn surfaces_and_points_of_any_size_have_distances() {
        for exponent in [-200, -100, -45, 0, 45, 100, 200, 300] {
            let size = 2f64.powi(exponent);
            let round = ellipsoid(Vector3::new(9.0, 6.0, 5.0), 3);
            let mesh = round.with_vertices(round.vertices().iter().map(|p| p * size).collect()).unwrap();
            let surface = SurfaceDistances::new(&mesh);
            for far in [0.1, 1.0, 3.0, 1e30] {
                let points: Vec<_> = mesh.vertices().iter().step_by(40).map(|p| p * far).collect();
                for (p, distance) in points.iter().zip(surface.of(&points)) {
                    assert_eq!(distance, plain(&surface, p), "2^{exponent}, {far}");
                }
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(12))]

        #[test]
        fn distances_are_those_of_all_triangles_and_of_closest_points_to_the_bit(
            seed in any::<u64>(),
            spread in 0.0f64..3.0,
            far in 0.0f64..1e4,
        ) {
            let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
            let mut number = || (random.next_u64() >> 11) as f64 / (1u64 << 52) as f64 - 1.0;
            for mesh in shapes() {
                let offset = Vector3::new(number(), number(), number()) * far;
                let mesh = mesh.with_vertices(mesh.vertices().iter().map(|p| p + offset).collect()).unwrap();
                for mesh in [canonicalize(&mesh).mesh, mesh] {
                    let tree = ClosestPointIndex::new(&mesh);
                    // Vertices of the surface, points nearby, and points anywhere.
                    let mut points = mesh.vertices()[..mesh.n_vertices().min(150)].to_vec();
                    points.extend(points.clone().iter().map(|p| p + Vector3::from_fn(|_, _| number()) * spread));
                    points.extend((0..20).map(|_| Point3::from(offset) + Vector3::from_fn(|_, _| number()) * 40.0));
                    let surface = SurfaceDistances::new(&mesh);
                    let found = surface.of(&points);
                    for (p, &distance) in points.iter().zip(&found) {
                        prop_assert_eq!(distance, plain(&surface, p));
                        prop_assert_eq!(distance, (tree.closest(p).point - p).norm());
                    }
                }
            }
        }
    }

    #[test]
    fn distances_are_the_same_bits_on_any_number_of_threads() {
        let mesh = canonicalize(&ellipsoid(Vector3::new(9.0, 6.0, 5.0), 4)).mesh;
        let points: Vec<Point3<f64>> = mesh.vertices().iter().map(|p| p * 1.1).collect();
        let with_threads = |n| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap();
            pool.install(|| SurfaceDistances::new(&mesh).of(&points))
        };
        let one = with_threads(1);
        assert_eq!(one.len(), points.len());
        assert!([2, 5].into_iter().all(|n| with_threads(n) == one));
    }
}
