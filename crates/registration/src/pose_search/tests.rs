//! Invariances of the pose search and its robustness to noise, missing parts and warps, on beans given by a formula.

use super::*;
use crate::testing::{numbers, pose};
use std::f64::consts::{PI, TAU};

/// A surface given by points.
#[derive(Clone)]
struct Cloud {
    points: Vec<Point3<f64>>,
    normals: Vec<Vector3<f64>>,
    areas: Vec<f64>,
}

impl Cloud {
    fn oriented(&self) -> OrientedPoints<'_> {
        OrientedPoints { points: &self.points, normals: &self.normals, areas: &self.areas, features: &[] }
    }

    fn moved(&self, by: &RigidTransform) -> Cloud {
        let points = self.points.iter().map(|p| by.apply(p)).collect();
        Cloud { points, normals: self.normals.iter().map(|n| by.rotation * n).collect(), areas: self.areas.clone() }
    }

    fn only(&self, keep: impl Fn(&Point3<f64>) -> bool) -> Cloud {
        let kept: Vec<usize> = (0..self.points.len()).filter(|&i| keep(&self.points[i])).collect();
        Cloud {
            points: kept.iter().map(|&i| self.points[i]).collect(),
            normals: kept.iter().map(|&i| self.normals[i]).collect(),
            areas: kept.iter().map(|&i| self.areas[i]).collect(),
        }
    }
}

const LENGTH_MM: f64 = 45.0;

/// A bent, tapered tube with a flat side and three bumps that depend on `seed`, mapped by `warp`.
fn bean_with(seed: u64, n: usize, warp: impl Fn(Point3<f64>) -> Point3<f64>) -> Cloud {
    let mut number = numbers(seed);
    let bumps: Vec<[f64; 3]> = (0..3).map(|_| [0.2 + 0.6 * number(), TAU * number(), 0.15 + 0.2 * number()]).collect();
    let place = |s: f64, phi: f64| {
        let taper = (1.0 - (2.0 * s - 1.0).powi(4)).max(0.0).sqrt() * (1.3 - 0.7 * s);
        let raised: f64 = bumps
            .iter()
            .map(|[at, angle, height]| {
                let off = (phi - angle + PI).rem_euclid(TAU) - PI;
                height * (-0.5 * (((s - at) / 0.12).powi(2) + (off / 0.6).powi(2))).exp()
            })
            .sum();
        let radius = 5.5 * taper * (1.0 + raised);
        let along = LENGTH_MM * (s - 0.5);
        let (sin, cos) = phi.sin_cos();
        let bend = 9.0 * (2.0 * s - 1.0).powi(2);
        warp(Point3::new(along, 1.35 * radius * cos + bend, 0.8 * radius * sin + 3.0 * (3.0 * s).sin()))
    };
    let mut bean = Cloud { points: Vec::new(), normals: Vec::new(), areas: Vec::new() };
    for k in 0..n {
        // Equal steps along, the golden angle around.
        let (s, phi) = ((k as f64 + 0.5) / n as f64, 2.399_963_229_728_653 * k as f64);
        let (ds, dphi) = (1e-5, 1e-5);
        let across = (place(s, phi + dphi) - place(s, phi - dphi)) / (2.0 * dphi);
        let along = (place(s + ds, phi) - place(s - ds, phi)) / (2.0 * ds);
        let element = across.cross(&along);
        bean.points.push(place(s, phi));
        bean.normals.push(element.normalize());
        bean.areas.push(element.norm() * TAU / n as f64);
    }
    bean
}

fn bean(seed: u64, n: usize) -> Cloud {
    bean_with(seed, n, |p| p)
}

fn search(source: &Cloud, target: &Cloud) -> Vec<ScoredPose> {
    pose_search(&source.oriented(), &target.oriented(), &PoseSearchOptions::default())
}

fn degrees(found: &[ScoredPose], truth: &RigidTransform) -> f64 {
    found[0].target_from_source.angle_to(truth).to_degrees()
}

/// Sums of twelve uniform numbers: close to normal, mean 0, variance 1.
fn normal(number: &mut impl FnMut() -> f64) -> f64 {
    (0..12).map(|_| number()).sum::<f64>() - 6.0
}

#[test]
fn a_moved_copy_is_found_from_any_of_fifty_poses() {
    let source = bean(1, 700);
    for seed in 0..50 {
        let truth = pose(seed);
        let found = search(&source, &source.moved(&truth));
        assert!(degrees(&found, &truth) < 0.5, "seed {seed}: {} degrees", degrees(&found, &truth));
        let center = Point3::new(3.0, -2.0, 1.0);
        let off = (found[0].target_from_source.apply(&center) - truth.apply(&center)).norm();
        assert!(off < 0.2, "seed {seed}: {off} mm");
    }
}

#[test]
fn poses_are_sorted_by_misfit_and_at_least_30_degrees_apart() {
    let found = search(&bean(2, 900), &bean(3, 900).moved(&pose(7)));
    assert!(found.len() > 1 && found[0].excess == 0.0);
    assert!(found.is_sorted_by(|a, b| a.misfit <= b.misfit));
    for (k, a) in found.iter().enumerate() {
        assert!((a.misfit - found[0].misfit - a.excess).abs() < 1e-12);
        assert!(!a.target_from_source.is_reflection());
        for b in &found[..k] {
            assert!(a.target_from_source.angle_to(&b.target_from_source) > 0.99 * SAME_POSE_ANGLE);
        }
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let (source, target) = (bean(4, 800), bean(4, 900).moved(&pose(3)));
    let on = |n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap().install(|| search(&source, &target));
    assert_eq!(on(1), on(3));
}

#[test]
fn a_part_is_found_on_the_whole() {
    let (mut with, mut without) = (0, 0);
    for seed in 0..20 {
        let truth = pose(seed + 40);
        let end = |p: &Point3<f64>| if seed % 2 == 0 { p.x < -9.0 } else { p.x > 7.0 };
        let (part, whole) = (bean(seed, 2400).only(end), bean(seed, 1700));
        let area = |cloud: &Cloud| cloud.areas.iter().sum::<f64>();
        assert!(area(&part) < 0.45 * area(&whole));
        let found = |source_is_part: bool| {
            let options = PoseSearchOptions { source_is_part, ..PoseSearchOptions::default() };
            let found = pose_search(&part.oriented(), &whole.moved(&truth).oriented(), &options);
            u32::from(degrees(&found, &truth) < 15.0)
        };
        with += found(true);
        without += found(false);
    }
    assert!(with >= 18 && without < with, "{with} and {without} of 20");
}

#[test]
fn a_mirror_image_is_found_if_reflections_are_allowed() {
    let source = bean(5, 900);
    let mirror = RigidTransform {
        rotation: Matrix3::from_diagonal(&Vector3::new(-1.0, 1.0, 1.0)),
        translation: Vector3::new(4.0, 0.0, 0.0),
    };
    let truth = pose(11).after(&mirror);
    let target = source.moved(&truth);
    let allowed = PoseSearchOptions { allow_reflection: true, ..PoseSearchOptions::default() };
    let found = pose_search(&source.oriented(), &target.oriented(), &allowed);
    assert!((found[0].target_from_source.rotation - truth.rotation).norm() < 0.02);
    let proper = found.iter().find(|p| !p.target_from_source.is_reflection()).unwrap();
    assert!(proper.excess > 0.1, "{}", proper.excess);
    assert!(search(&source, &target).iter().all(|p| !p.target_from_source.is_reflection()));
    let copy = pose_search(&source.oriented(), &source.moved(&pose(12)).oriented(), &allowed);
    assert!(!copy[0].target_from_source.is_reflection());
}

fn diagonal_mm(points: &[Point3<f64>]) -> f64 {
    let low = points.iter().fold(points[0], |a, b| a.inf(b));
    (points.iter().fold(points[0], |a, b| a.sup(b)) - low).norm()
}

/// A sum of Gaussian bumps, 0.25 diagonals wide, whose root mean square over `points` is `share` of the diagonal.
fn bumps(points: &[Point3<f64>], share: f64, seed: u64) -> impl Fn(Point3<f64>) -> Point3<f64> + use<> {
    let mut number = numbers(seed);
    let diagonal = diagonal_mm(points);
    let bumps: Vec<(Point3<f64>, Vector3<f64>)> = (0..10)
        .map(|_| {
            let center = points[(number() * points.len() as f64) as usize];
            (center, Vector3::from_fn(|_, _| normal(&mut number)))
        })
        .collect();
    let displacement = move |p: &Point3<f64>| -> Vector3<f64> {
        bumps.iter().map(|(c, a)| a * (-0.5 * ((p - c).norm() / (0.25 * diagonal)).powi(2)).exp()).sum()
    };
    let squares: f64 = points.iter().map(|p| displacement(p).norm_squared()).sum();
    let scale = share * diagonal / (squares / points.len() as f64).sqrt();
    move |p| p + displacement(&p) * scale
}

#[test]
fn noise_a_missing_end_and_half_the_points_leave_the_pose_within_10_degrees() {
    for seed in 20..25 {
        let (source, truth) = (bean(seed, 2000), pose(seed));
        let near = |kind: &str, target: Cloud, limit: f64| {
            let off = degrees(&search(&source, &target), &truth);
            assert!(off < limit, "{kind}, seed {seed}: {off} degrees");
        };
        let mut number = numbers(seed ^ 99);
        let mut random = || Vector3::from_fn(|_, _| normal(&mut number));
        let mut noisy = source.clone();
        let size = 0.02 * diagonal_mm(&source.points);
        for (p, n) in noisy.points.iter_mut().zip(&mut noisy.normals) {
            *p += random() * size;
            // Noise of about an edge length tilts the normals of a mesh by this much.
            *n = (*n + random() * 0.7).normalize();
        }
        near("noise", noisy.moved(&truth), 5.0);
        let end = if seed % 2 == 0 { 1.0 } else { -1.0 };
        near("cut", source.only(|p| end * p.x < 0.3 * LENGTH_MM).moved(&truth), 10.0);
        near("thinned", bean(seed, 1000).moved(&truth), 10.0);
    }
}

#[test]
fn nine_of_ten_warps_of_eight_percent_leave_the_pose_within_10_degrees() {
    let offs: Vec<f64> = (20..30)
        .map(|seed| {
            let (source, truth) = (bean(seed, 1500), pose(seed));
            let warped = bean_with(seed, 1500, bumps(&source.points, 0.08, seed));
            let fitted = absolute_orientation(&source.points, &warped.points, Some(&source.areas), false).unwrap();
            degrees(&search(&source, &warped.moved(&truth)), &truth.after(&fitted))
        })
        .collect();
    assert!(offs.iter().filter(|&&off| off < 10.0).count() >= 9, "{offs:?}");
}

#[test]
fn surfaces_without_area_or_with_two_points_or_nan_have_no_pose() {
    let whole = bean(1, 300);
    let two = whole.only(|p| p.x > whole.points[297].x);
    assert!(search(&two, &whole).is_empty() && search(&whole, &two).is_empty());
    let empty = Cloud { areas: vec![0.0; 300], ..whole.clone() };
    assert!(search(&empty, &whole).is_empty());
    let broken = Cloud { areas: vec![f64::NAN; 300], ..whole.clone() };
    assert!(search(&broken, &whole).is_empty());
    let mut broken = whole.clone();
    broken.points[7].y = f64::NAN;
    assert!(search(&broken, &whole).is_empty());
}

#[test]
fn the_compact_assignment_equals_its_formula() {
    let patches = |seed, motion: u64| Patches::new(&bean(seed, 600).moved(&pose(motion)).oriented(), 40, 90).unwrap();
    let (mut a, mut b) = (patches(6, 0), patches(7, 1));
    let diagonal_mm = a.diagonal_mm;
    describe(&mut a, &mut b, diagonal_mm, false);
    let rotation = pose(30).rotation;
    let source: Vec<Patch> = a.fine.iter().map(|p| p.moved(&rotation, &Vector3::new(1.0, 2.0, -1.0))).collect();
    let sigma = 4.0;
    let affinity = |p: &Patch, q: &Patch| {
        let near = (1.0 - (p.center - q.center).norm_squared() / (8.0 * sigma * sigma)).max(0.0).powi(4);
        let unlike: f64 = p.features.iter().zip(&q.features).map(|(f, g)| (f - g).powi(2)).sum();
        near * p.normal.dot(&q.normal).max(0.0) / (1.0 + 0.25 * unlike).powi(2)
    };
    let flat = TAU * sigma * sigma;
    let density = |at: &Patch, of: &[Patch]| of.iter().map(|q| q.area * affinity(at, q)).sum::<f64>();
    let misfit = |at: &[Patch], of: &[Patch]| {
        let sum: f64 = at.iter().map(|p| -p.area * (density(p, of) / flat + 0.1).ln()).sum();
        sum / at.iter().map(|p| p.area).sum::<f64>()
    };
    let expected = 0.5 * (misfit(&source, &b.fine) + misfit(&b.fine, &source));
    let target = CompactTarget::new(&points_of(&b.fine).collect::<Vec<_>>());
    let mut assignment = CompactAssignment::default();
    let found = assignment.misfit(points_of(&source), &target, sigma);
    assert!((found - expected).abs() < 1e-4, "{found} {expected}");
    let (targets, weights) = assignment.means(points_of(&source), &target, sigma);
    for (p, (at, weight)) in source.iter().zip(targets.iter().zip(weights)) {
        let responsibility = |q: &Patch| {
            let background = 0.1 * flat;
            let share = 1.0 / (background + density(p, &b.fine)) + 1.0 / (background + density(q, &source));
            0.5 * p.area * q.area * affinity(p, q) * share
        };
        let mass: f64 = b.fine.iter().map(responsibility).sum();
        assert!((mass - weight).abs() < 1e-4 * p.area);
        if mass > 0.01 * p.area {
            let mean = b.fine.iter().map(|q| q.center * responsibility(q)).sum::<Vector3<f64>>() / mass;
            assert!((mean - at.coords).norm() < 1e-2, "{mean} {at}");
        }
    }
}

#[test]
fn patches_keep_area_and_centroid() {
    let surface = bean(8, 700);
    let found = Patches::new(&surface.oriented(), 50, 120).unwrap();
    let total: f64 = surface.areas.iter().sum();
    for patches in [&found.coarse, &found.fine] {
        assert!((patches.iter().map(|p| p.area).sum::<f64>() - total).abs() < 1e-9 * total);
        let mean = patches.iter().map(|p| p.center * p.area).sum::<Vector3<f64>>() / total;
        assert!(mean.norm() < 1e-9);
    }
    assert_eq!((found.coarse.len(), found.fine.len()), (50, 120));
}
