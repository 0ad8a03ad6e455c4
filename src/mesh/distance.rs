//! How far points lie from a surface, for a great many points.
//!
//! [`super::ClosestPointIndex`] also says where the closest point is, and grows a tree for that. Where only the distance
//! counts, as between two surfaces laid on each other, three things make it several times as fast:
//!
//! - the tree is that of the numbering: faces in canonical order follow a curve through space, so eight of them in a row
//!   lie together, and so do eight such rows; nothing is sorted;
//! - every triangle lies in a disc. Far from a fine surface the boxes of many triangles are closer than the surface is,
//!   but few of the discs, so that few triangles are looked at themselves;
//! - queries are answered in a row, and the triangle of the answer before bounds each before its search begins.
//!
//! Boxes and discs only pass triangles over that are farther by more than rounding; the distance itself is computed by the
//! same routine as in [`super::ClosestPointIndex`], so that both give the same bits.

use super::SurfaceMesh;
use nalgebra::{Point3, Vector3};
use parry3d_f64::math::Vector;
use parry3d_f64::query::PointQuery;
use parry3d_f64::shape::Triangle;
use rayon::prelude::*;

/// Children of a node, and triangles of a leaf: a whole number of vector registers of any instruction set.
const FAN: usize = 8;
/// Queries answered in a row. Fixed, so that the work does not depend on the threads.
const ROW: usize = 256;
/// What a bound may be wrong by, in the size of the numbers it is computed from; rounding is a millionth of that.
const BOUND_RTOL: f64 = 1e-9;
/// Twice the area of a triangle over the square of its longest side, below which its normal is left out of its bound.
const THIN: f64 = 1e-4;
/// A place beyond all queries, for what a node has not: the square of its distance is no number any more, but infinite.
const NOWHERE: f64 = 1e300;

type Lanes = [f64; FAN];

/// The distances of points from one surface. Fast where faces that are close in space are close in the list, as in
/// canonical numbering; right in any case.
pub struct SurfaceDistances<'a> {
    vertices: &'a [Point3<f64>],
    triangles: Vec<[u32; 3]>,
    /// The discs of eight triangles after the other.
    discs: Vec<Discs>,
    /// From the boxes of the discs upwards; the last level has one node.
    levels: Vec<Vec<Boxes>>,
    /// Largest coordinate, mm.
    extent: f64,
}

/// Boxes of the children of a node, axis by axis.
#[derive(Clone)]
struct Boxes {
    low: [Lanes; 3],
    high: [Lanes; 3],
}

/// A disc around each triangle of a leaf, or a ball where `normal` is zero.
struct Discs {
    center: [Lanes; 3],
    normal: [Lanes; 3],
    radius: Lanes,
}

impl Boxes {
    fn nowhere() -> Self {
        Boxes { low: [[NOWHERE; FAN]; 3], high: [[NOWHERE; FAN]; 3] }
    }

    /// The box around all.
    fn around(&self, n: usize) -> [[f64; 2]; 3] {
        std::array::from_fn(|axis| {
            let low = self.low[axis][..n].iter().copied().fold(f64::INFINITY, f64::min);
            [low, self.high[axis][..n].iter().copied().fold(f64::NEG_INFINITY, f64::max)]
        })
    }

    fn squared_bounds(&self, p: &Point3<f64>) -> Lanes {
        let mut squared = [0.0; FAN];
        for axis in 0..3 {
            for (k, sum) in squared.iter_mut().enumerate() {
                let gap = (self.low[axis][k] - p[axis]).max(p[axis] - self.high[axis][k]).max(0.0);
                *sum += gap * gap;
            }
        }
        squared
    }
}

impl Discs {
    fn new(vertices: &[Point3<f64>], triangles: &[[u32; 3]]) -> Self {
        let mut discs = Discs { center: [[NOWHERE; FAN]; 3], normal: [[0.0; FAN]; 3], radius: [0.0; FAN] };
        for (k, triangle) in triangles.iter().enumerate() {
            let [a, b, c] = triangle.map(|v| vertices[v as usize].coords);
            let center = (a + b + c) / 3.0;
            let twice_area = (b - a).cross(&(c - a));
            let longest = (b - a).norm_squared().max((c - b).norm_squared()).max((a - c).norm_squared());
            let flat = twice_area.norm() > THIN * longest;
            let normal = if flat { twice_area.normalize() } else { Vector3::zeros() };
            for axis in 0..3 {
                discs.center[axis][k] = center[axis];
                discs.normal[axis][k] = normal[axis];
            }
            discs.radius[k] = [a, b, c].iter().map(|corner| (corner - center).norm()).fold(0.0, f64::max);
        }
        discs
    }

    fn squared_bounds(&self, p: &Point3<f64>) -> Lanes {
        std::array::from_fn(|k| {
            let offset: [f64; 3] = std::array::from_fn(|axis| p[axis] - self.center[axis][k]);
            let height = (0..3).map(|axis| offset[axis] * self.normal[axis][k]).sum::<f64>();
            // Not by the difference of squares, which would lose half of the digits.
            let across = (0..3).map(|axis| (offset[axis] - height * self.normal[axis][k]).powi(2)).sum::<f64>().sqrt();
            let beyond = (across - self.radius[k]).max(0.0);
            height * height + beyond * beyond
        })
    }
}

/// One search: the least distance so far, and the triangle it is to.
struct Search {
    at: Point3<f64>,
    best: f64,
    triangle: usize,
    /// Squared distance from which a bound tells that something is farther.
    limit_squared: f64,
    extent: f64,
}

impl Search {
    fn try_triangle(&mut self, surface: &SurfaceDistances<'_>, triangle: usize) {
        let distance = surface.distance_from_triangle(&self.at, triangle);
        if distance < self.best {
            (self.best, self.triangle) = (distance, triangle);
            let limit = distance + BOUND_RTOL * (distance + self.extent);
            self.limit_squared = limit * limit;
        }
    }
}

impl<'a> SurfaceDistances<'a> {
    /// Prepares `mesh`, of which quads are cut along a diagonal. `O(n)`, on all threads.
    pub fn new(mesh: &'a SurfaceMesh) -> Self {
        let (vertices, triangles) = (mesh.vertices(), mesh.triangles());
        let discs = triangles.par_chunks(FAN).map(|of_leaf| Discs::new(vertices, of_leaf)).collect();
        let corners = |triangle: &[u32; 3]| triangle.map(|v| vertices[v as usize]);
        let of_leaf = |leaf: &[[u32; 3]]| -> [[f64; 2]; 3] {
            let (first, points) = (vertices[leaf[0][0] as usize], leaf.iter().flat_map(corners));
            let (low, high) = points.fold((first, first), |(low, high), p| (low.inf(&p), high.sup(&p)));
            std::array::from_fn(|axis| [low[axis], high[axis]])
        };
        let mut boxes: Vec<[[f64; 2]; 3]> = triangles.par_chunks(FAN).map(of_leaf).collect();
        let mut levels = Vec::new();
        loop {
            let level: Vec<Boxes> = boxes.chunks(FAN).map(node).collect();
            boxes = level.iter().zip(boxes.chunks(FAN)).map(|(node, of)| node.around(of.len())).collect();
            levels.push(level);
            if boxes.len() == 1 {
                break;
            }
        }
        let extent = vertices.iter().map(|p| p.coords.amax()).fold(0.0, f64::max);
        SurfaceDistances { vertices, triangles, discs, levels, extent }
    }

    /// The distance of each of `points` from the surface, mm. `O(n log n')`, on all threads; fast where points that are
    /// close in space are close in the list. Coordinates have to be finite.
    pub fn of(&self, points: &[Point3<f64>]) -> Vec<f64> {
        let row = |points: &'_ [Point3<f64>]| -> Vec<f64> {
            let mut last = 0;
            let each = |p: &Point3<f64>| {
                let (distance, triangle) = self.search(p, last);
                last = triangle;
                distance
            };
            points.iter().map(each).collect()
        };
        points.par_chunks(ROW).flat_map_iter(row).collect()
    }

    /// The distance of `at`, and a triangle that is as close; `first` is tried first.
    fn search(&self, at: &Point3<f64>, first: usize) -> (f64, usize) {
        let mut search = Search {
            at: *at,
            best: f64::INFINITY,
            triangle: first,
            limit_squared: f64::INFINITY,
            extent: self.extent + at.coords.amax(),
        };
        search.try_triangle(self, first);
        self.visit(self.levels.len(), 0, &mut search);
        (search.best, search.triangle)
    }

    /// Looks at node `node` of `level`, counted from the leaves, 0, whose children are triangles.
    fn visit(&self, level: usize, node: usize, search: &mut Search) {
        let mut bounds = match level {
            0 => self.discs[node].squared_bounds(&search.at),
            _ => self.levels[level - 1][node].squared_bounds(&search.at),
        };
        // The nearest first: what it finds may rule the others out.
        loop {
            let mut nearest = 0;
            for k in 1..FAN {
                if bounds[k] < bounds[nearest] {
                    nearest = k;
                }
            }
            if bounds[nearest] > search.limit_squared || bounds[nearest] == f64::INFINITY {
                return;
            }
            bounds[nearest] = f64::INFINITY;
            let child = node * FAN + nearest;
            match level {
                0 => search.try_triangle(self, child),
                _ => self.visit(level - 1, child, search),
            }
        }
    }

    fn distance_from_triangle(&self, p: &Point3<f64>, triangle: usize) -> f64 {
        let vector = |p: &Point3<f64>| Vector::new(p.x, p.y, p.z);
        let [a, b, c] = self.triangles[triangle].map(|v| vector(&self.vertices[v as usize]));
        let found = Triangle::new(a, b, c).project_local_point(vector(p), false).point;
        (Point3::new(found.x, found.y, found.z) - p).norm()
    }
}

/// A node over these boxes.
fn node(boxes: &[[[f64; 2]; 3]]) -> Boxes {
    let mut node = Boxes::nowhere();
    for (k, of_child) in boxes.iter().enumerate() {
        for axis in 0..3 {
            [node.low[axis][k], node.high[axis][k]] = of_child[axis];
        }
    }
    node
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::shapes::{ellipsoid, torus};
    use crate::mesh::{ClosestPointIndex, FaceArity, canonicalize};
    use proptest::prelude::*;
    use rand_core::{Rng, SeedableRng};
    use rand_xoshiro::Xoshiro256PlusPlus;

    /// Triangle by triangle.
    fn plain(surface: &SurfaceDistances<'_>, p: &Point3<f64>) -> f64 {
        (0..surface.triangles.len()).map(|t| surface.distance_from_triangle(p, t)).fold(f64::INFINITY, f64::min)
    }

    fn shapes() -> Vec<SurfaceMesh> {
        let torus = |arity| torus(10.0, 4.0, 24, 11, arity);
        let round = ellipsoid(Vector3::new(9.0, 6.0, 5.0), 3);
        // Faces that lie flat in their boxes, as those of voxels do, and some without area.
        let snapped = round.vertices().iter().map(|p| p.map(f64::round)).collect();
        // Needles: all but flattened along an axis that no face is parallel to.
        let axis = Vector3::new(1.0, 2.0, 3.0).normalize();
        let flat = round.vertices().iter().map(|p| p - axis * (axis.dot(&p.coords) * (1.0 - 1e-7))).collect();
        let mut shapes = vec![round.with_vertices(snapped).unwrap(), round.with_vertices(flat).unwrap(), round];
        shapes.extend([FaceArity::Triangle, FaceArity::Quad].map(torus));
        shapes.push(ellipsoid(Vector3::new(2.0, 1.0, 1.5), 0));
        shapes
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
                    // Vertices themselves, points nearby, and points anywhere.
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
