//! Distances against slow searches and against closed forms on planes, cubes, spheres and tori.

use super::*;
use homolog_mesh::FaceArity;
use homolog_mesh::shapes::{ellipsoid, torus};
use homolog_mesh::volume::{LabelVolume, voxel_surface};
use nalgebra::{Isometry3, Matrix4, Point3, Vector3};
use proptest::prelude::*;
use rand_core::{Rng, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;
use std::f64::consts::{PI, TAU};

/// Every vertex moved by up to `size` mm along each axis.
fn bumped(mesh: &SurfaceMesh, size: f64, seed: u64) -> SurfaceMesh {
    let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
    let mut number = || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0;
    let moved = mesh.vertices().iter().map(|p| p + Vector3::new(number(), number(), number()) * size).collect();
    mesh.with_vertices(moved).unwrap()
}

/// The surface of a box of voxels of 1 mm.
fn voxel_box(dims: [usize; 3]) -> SurfaceMesh {
    let volume = LabelVolume::new(dims, vec![1; dims.iter().product()], Matrix4::identity()).unwrap();
    voxel_surface(&volume.mask(None).unwrap()).unwrap()
}

/// Shortest paths over a complete table of lengths. Each round settles the closest point that is left.
fn all_shortest(table: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let from = |source: usize| {
        let mut distances = vec![f64::INFINITY; table.len()];
        distances[source] = 0.0;
        let mut left: Vec<usize> = (0..table.len()).collect();
        while let Some(at) = (0..left.len()).min_by(|&a, &b| distances[left[a]].total_cmp(&distances[left[b]])) {
            let settled = left.swap_remove(at);
            for &other in &left {
                distances[other] = distances[other].min(distances[settled] + table[settled][other]);
            }
        }
        distances
    };
    (0..table.len()).map(from).collect()
}

fn edge_table(mesh: &SurfaceMesh) -> Vec<Vec<f64>> {
    let n = mesh.n_vertices();
    let mut table = vec![vec![f64::INFINITY; n]; n];
    for [a, b] in mesh.edges().into_iter().map(|e| e.map(|v| v as usize)) {
        let length = (mesh.vertices()[a] - mesh.vertices()[b]).norm();
        table[a][b] = length;
        table[b][a] = length;
    }
    (0..n).for_each(|i| table[i][i] = 0.0);
    table
}

/// Geodesic distances from above: shortest paths over points `per_edge` on every edge, joined straight within faces.
/// Every sweep follows all joints once, until none makes a path shorter.
struct PointsOnEdges {
    points: Vec<Point3<f64>>,
    joined: Vec<Vec<usize>>,
}

impl PointsOnEdges {
    fn new(mesh: &SurfaceMesh, per_edge: usize) -> Self {
        let edges = mesh.edges();
        let v = mesh.vertices();
        let mut points = v.to_vec();
        for [a, b] in edges.iter().map(|e| e.map(|v| v as usize)) {
            points.extend((1..=per_edge).map(|k| v[a] + (v[b] - v[a]) * (k as f64 / (per_edge + 1) as f64)));
        }
        let mut joined = vec![Vec::new(); points.len()];
        for face in mesh.triangles() {
            let mut rim: Vec<usize> = face.iter().map(|&c| c as usize).collect();
            for k in 0..3 {
                let (a, b) = (face[k].min(face[(k + 1) % 3]), face[k].max(face[(k + 1) % 3]));
                let edge = edges.binary_search(&[a, b]).unwrap();
                rim.extend((0..per_edge).map(|p| v.len() + edge * per_edge + p));
            }
            rim.iter().for_each(|&a| joined[a].extend_from_slice(&rim));
        }
        PointsOnEdges { points, joined }
    }

    fn distances_from(&self, source: usize) -> Vec<f64> {
        let mut distances = vec![f64::INFINITY; self.points.len()];
        distances[source] = 0.0;
        let mut shorter = true;
        while shorter {
            shorter = false;
            for (a, joined) in self.joined.iter().enumerate() {
                for &b in joined {
                    let by_way_of_a = distances[a] + (self.points[a] - self.points[b]).norm();
                    // Sums in another order differ by rounding, which does not count as a shorter path.
                    if by_way_of_a < distances[b] - 1e-12 {
                        distances[b] = by_way_of_a;
                        shorter = true;
                    }
                }
            }
        }
        distances
    }
}

/// Mean and maximum of `|d / truth − 1|` over all pairs of different labels.
fn relative_errors(labels: &LabelNeighborhoods, mut truth: impl FnMut(usize, usize, f64) -> f64) -> (f64, f64) {
    let (mut sum, mut largest, mut n) = (0.0, 0.0f64, 0);
    for x in 0..labels.n_labels() {
        for (&y, &d) in labels.members(x).iter().zip(labels.distances(x)) {
            if y as usize != x {
                let error = (f64::from(d) / truth(x, y as usize, d.into()) - 1.0).abs();
                sum += error;
                largest = largest.max(error);
                n += 1;
            }
        }
    }
    (sum / f64::from(n), largest)
}

fn great_circle(mesh: &SurfaceMesh, x: usize, y: usize) -> f64 {
    let (a, b) = (mesh.vertices()[x].coords, mesh.vertices()[y].coords);
    a.norm() * a.cross(&b).norm().atan2(a.dot(&b))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn graph_distances_are_the_shortest_paths_along_edges(seed in any::<u64>(), rings in 0usize..5) {
        for mesh in [ellipsoid(Vector3::new(6.0, 4.0, 3.0), 2), torus(6.0, 2.0, 14, 8, FaceArity::Quad)] {
            let mesh = bumped(&mesh, 0.4, seed);
            let truth = all_shortest(&edge_table(&mesh));
            let labels = label_neighborhoods(&mesh, rings, LabelDistance::Graph);
            for (x, from_x) in truth.iter().enumerate() {
                for (&y, &d) in labels.members(x).iter().zip(labels.distances(x)) {
                    prop_assert!((f64::from(d) - from_x[y as usize]).abs() < 1e-5);
                }
            }
        }
    }

    #[test]
    fn geodesic_distances_are_the_shortest_paths_over_faces(seed in any::<u64>(), rings in 1usize..6) {
        // Strong bumps make saddles, where shortest paths bend.
        let mesh = bumped(&ellipsoid(Vector3::new(5.0, 4.0, 3.0), 1), 0.9, seed);
        let above = PointsOnEdges::new(&mesh, 24);
        let labels = label_neighborhoods(&mesh, rings, LabelDistance::Geodesic);
        for x in (0..labels.n_labels()).step_by(3) {
            let from_x = above.distances_from(x);
            for (&y, &d) in labels.members(x).iter().zip(labels.distances(x)) {
                // Where paths bend past a vertex, points on edges come close to it slowly: 2 % is what 24 leave.
                let (d, above) = (f64::from(d), from_x[y as usize]);
                prop_assert!(d <= above * (1.0 + 1e-6) && d >= above * 0.98, "{x} {y}: {d} {above}");
            }
        }
    }

    #[test]
    fn the_three_distances_are_ordered_symmetric_and_agree_on_edges(seed in any::<u64>(), rings in 1usize..5) {
        let shapes = [
            bumped(&ellipsoid(Vector3::new(6.0, 4.0, 3.0), 2), 0.4, seed),
            bumped(&torus(6.0, 2.0, 14, 8, FaceArity::Quad), 0.4, seed),
        ];
        for mesh in shapes {
            let [straight, along, over] = [LabelDistance::Euclidean, LabelDistance::Graph, LabelDistance::Geodesic]
                .map(|d| label_neighborhoods(&mesh, rings, d));
            let graph = mesh.edge_graph();
            let lengths = edge_lengths(&mesh, &graph);
            for x in 0..mesh.n_vertices() {
                prop_assert_eq!(straight.members(x), over.members(x));
                for (k, &y) in over.members(x).iter().enumerate() {
                    let [s, a, o] = [&straight, &along, &over].map(|l| l.distances(x)[k]);
                    prop_assert!(s <= o * (1.0 + 1e-6) && o <= a * (1.0 + 1e-6), "{} {} {}", s, o, a);
                    prop_assert_eq!(Some(o), over.distance_within(y as usize, x));
                    prop_assert_eq!(Some(a), along.distance_within(y as usize, x));
                    prop_assert!(y as usize != x || (o == 0.0 && a == 0.0 && s == 0.0));
                }
                for e in graph.row(x) {
                    for labels in [&straight, &along, &over] {
                        let d = labels.distance_within(x, graph.head(e)).unwrap();
                        prop_assert!((d - lengths[e]).abs() <= 1e-6 * lengths[e]);
                    }
                }
            }
        }
    }

    #[test]
    fn distances_do_not_depend_on_the_pose(angle in -3.0f64..3.0, shift in -100.0f64..100.0, seed in any::<u64>()) {
        let mesh = bumped(&torus(6.0, 2.0, 14, 8, FaceArity::Quad), 0.3, seed);
        let moved = mesh.transformed(&Isometry3::new(Vector3::repeat(shift), Vector3::new(angle, 1.0, 0.3)));
        let [here, there] = [&mesh, &moved].map(|m| label_neighborhoods(m, 3, LabelDistance::Geodesic));
        for x in 0..mesh.n_vertices() {
            for (a, b) in here.distances(x).iter().zip(there.distances(x)) {
                prop_assert!((a - b).abs() < 1e-5);
            }
        }
    }
}

#[test]
fn on_a_flat_side_the_geodesic_is_straight() {
    let mesh = voxel_box([8, 8, 8]);
    let p = mesh.vertices();
    let labels = label_neighborhoods(&mesh, 4, LabelDistance::Geodesic);
    let mut n_pairs = 0;
    for x in 0..mesh.n_vertices() {
        for (&y, &d) in labels.members(x).iter().zip(labels.distances(x)) {
            if (0..3).any(|k| p[x][k] == p[y as usize][k] && (p[x][k] == -0.5 || p[x][k] == 7.5)) {
                assert!((f64::from(d) - (p[x] - p[y as usize]).norm()).abs() < 1e-6);
                n_pairs += 1;
            }
        }
    }
    assert!(n_pairs > 5000);
}

#[test]
fn around_the_edge_of_a_box_the_geodesic_is_the_line_on_the_unfolded_sides() {
    let mesh = voxel_box([10, 10, 10]);
    let p = mesh.vertices();
    let labels = label_neighborhoods(&mesh, 5, LabelDistance::Geodesic);
    let mut n_pairs = 0;
    for x in (0..mesh.n_vertices()).filter(|&x| p[x].z == 9.5 && (3.0..7.0).contains(&p[x].y)) {
        for (&y, &d) in labels.members(x).iter().zip(labels.distances(x)) {
            let q = p[y as usize];
            if q.x == 9.5 && (3.0..7.0).contains(&q.y) {
                let unfolded = ((9.5 - p[x].x) + (9.5 - q.z)).hypot(q.y - p[x].y);
                assert!((f64::from(d) - unfolded).abs() < 1e-6, "{d} {unfolded}");
                n_pairs += 1;
            }
        }
    }
    assert!(n_pairs > 100);
}

#[test]
fn on_a_sphere_the_geodesic_converges_to_great_circles() {
    let errors: Vec<(f64, f64)> = [2, 3, 4]
        .map(|levels| {
            let mesh = ellipsoid(Vector3::repeat(8.0), levels);
            let labels = label_neighborhoods(&mesh, 4, LabelDistance::Geodesic);
            relative_errors(&labels, |x, y, _| great_circle(&mesh, x, y))
        })
        .into();
    assert!(errors[2].0 < 5e-4 && errors[2].1 < 1e-3, "{errors:?}");
    assert!(errors.windows(2).all(|e| e[1].0 < e[0].0 / 3.0), "{errors:?}");
}

/// Length of the geodesic of a torus between two points given by their angles, from a first guess of its direction and
/// length: the geodesic equations by Runge and Kutta, the end met by Newton's method.
fn torus_geodesic(radius: f64, tube: f64, from: [f64; 2], to: [f64; 2], guess: f64) -> f64 {
    let end = |direction: f64, length: f64| {
        let rate = |s: [f64; 4]| {
            let ring = radius + tube * s[1].cos();
            [s[2], s[3], 2.0 * tube * s[1].sin() / ring * s[2] * s[3], -ring * s[1].sin() / tube * s[2] * s[2]]
        };
        let ring = radius + tube * from[1].cos();
        let mut s = [from[0], from[1], direction.cos() / ring, direction.sin() / tube];
        let step = length / 60.0;
        for _ in 0..60 {
            let add = |s: [f64; 4], r: [f64; 4], h: f64| std::array::from_fn(|k| s[k] + h * r[k]);
            let a = rate(s);
            let b = rate(add(s, a, step / 2.0));
            let c = rate(add(s, b, step / 2.0));
            let d = rate(add(s, c, step));
            s = std::array::from_fn(|k| s[k] + step / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]));
        }
        [s[0], s[1]]
    };
    let wrap = |angle: f64| (angle + PI).rem_euclid(TAU) - PI;
    let middle = from[1] + wrap(to[1] - from[1]) / 2.0;
    let mut direction = (wrap(to[1] - from[1]) * tube).atan2(wrap(to[0] - from[0]) * (radius + tube * middle.cos()));
    let mut length = guess;
    for _ in 0..12 {
        let miss = |p: [f64; 2]| [wrap(p[0] - to[0]), wrap(p[1] - to[1])];
        let (here, h) = (miss(end(direction, length)), 1e-6);
        let (turned, longer) = (miss(end(direction + h, length)), miss(end(direction, length + h)));
        let [[a, b], [c, d]] = [0, 1].map(|k| [(turned[k] - here[k]) / h, (longer[k] - here[k]) / h]);
        let determinant = a * d - b * c;
        direction -= (d * here[0] - b * here[1]) / determinant;
        length -= (a * here[1] - c * here[0]) / determinant;
    }
    length
}

#[test]
fn on_a_torus_the_geodesic_follows_the_geodesic_equations() {
    let (radius, tube, around, across) = (10.0, 4.0, 60, 30);
    for arity in [FaceArity::Triangle, FaceArity::Quad] {
        let mesh = torus(radius, tube, around, across, arity);
        let labels = label_neighborhoods(&mesh, 4, LabelDistance::Geodesic);
        let angles = |v: usize| {
            let (i, j) = (v as u32 / across, v as u32 % across);
            [TAU * f64::from(i) / f64::from(around), TAU * f64::from(j) / f64::from(across)]
        };
        // All of the torus looks like what one column of vertices sees.
        let (mean, largest) = relative_errors(&labels, |x, y, d| {
            if x < across as usize { torus_geodesic(radius, tube, angles(x), angles(y), d) } else { d }
        });
        let mean = mean * f64::from(around);
        assert!(mean < 1.5e-3 && largest < 5e-3, "{arity:?} {mean} {largest}");
    }
}

#[test]
fn a_shortest_path_that_bends_at_a_saddle_is_found() {
    // An L of voxels. Around its inner corner lie 450 degrees, 217 of them on the upper side between these two ends
    // and 233 by way of the walls: no straight line joins them.
    let mut labels = vec![1; 5 * 5];
    for (k, label) in labels.iter_mut().enumerate() {
        *label = u32::from(k % 5 < 2 || k / 5 < 2);
    }
    let volume = LabelVolume::new([5, 5, 1], labels, Matrix4::identity()).unwrap();
    let mesh = voxel_surface(&volume.mask(None).unwrap()).unwrap();
    let find = |x, y, z| mesh.vertices().iter().position(|p| *p == Point3::new(x, y, z)).unwrap();
    let (a, b) = (find(0.5, 3.5, 0.5), find(3.5, 0.5, 0.5));
    let d = label_neighborhoods(&mesh, 6, LabelDistance::Geodesic).distance_within(a, b).unwrap();
    assert!((f64::from(d) - 2.0 * 5.0f64.sqrt()).abs() < 1e-6, "{d}");
}

#[test]
fn faces_without_area_leave_finite_distances() {
    let ball = ellipsoid(Vector3::repeat(3.0), 2);
    let mut vertices = ball.vertices().to_vec();
    // One edge shrinks to a point, and one triangle to a line.
    let [a, b] = ball.edges()[0].map(|v| v as usize);
    vertices[b] = vertices[a];
    let f: Vec<usize> = ball.faces().last().unwrap().iter().map(|&v| v as usize).collect();
    vertices[f[0]] = nalgebra::center(&vertices[f[1]], &vertices[f[2]]);
    let pinched = ball.with_vertices(vertices).unwrap();
    let [straight, along, over] = [LabelDistance::Euclidean, LabelDistance::Graph, LabelDistance::Geodesic]
        .map(|d| label_neighborhoods(&pinched, 3, d));
    for x in 0..pinched.n_vertices() {
        for (k, &o) in over.distances(x).iter().enumerate() {
            let (s, a) = (straight.distances(x)[k], along.distances(x)[k]);
            assert!(s <= o * (1.0 + 1e-5) + 1e-6 && o <= a * (1.0 + 1e-5) + 1e-6, "{s} {o} {a}");
        }
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let mesh = bumped(&ellipsoid(Vector3::new(6.0, 4.0, 3.0), 3), 0.1, 4);
    let with = |n_threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(n_threads).build().unwrap();
        pool.install(|| label_neighborhoods(&mesh, 3, LabelDistance::Geodesic))
    };
    assert_eq!(with(1), with(3));
}
