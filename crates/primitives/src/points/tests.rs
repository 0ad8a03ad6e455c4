//! Fast point queries against the definitions.

use super::*;
use nalgebra::{Point3, Vector3};
use proptest::prelude::*;

/// Points in a box of 40 × 20 × 10 mm.
fn clouds(n: std::ops::Range<usize>) -> impl Strategy<Value = Vec<Point3<f64>>> {
    let point = (0.0f64..40.0, 0.0f64..20.0, 0.0f64..10.0).prop_map(|(x, y, z)| Point3::new(x, y, z));
    proptest::collection::vec(point, n)
}

/// The first of the points farthest from all samples so far, with every distance computed again.
fn farthest_by_definition(points: &[Point3<f64>], n: usize) -> Vec<usize> {
    let center = points.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / points.len() as f64;
    let mut samples: Vec<usize> = Vec::new();
    while samples.len() < n.min(points.len()) {
        let from_samples = |p: &Point3<f64>| {
            samples.iter().map(|&c: &usize| (p - points[c]).norm_squared()).fold(f64::INFINITY, f64::min)
        };
        let distance = |p: &Point3<f64>| {
            if samples.is_empty() { (p.coords - center).norm_squared() } else { from_samples(p) }
        };
        let all: Vec<f64> = points.iter().map(distance).collect();
        let largest = all.iter().copied().fold(0.0, f64::max);
        if !samples.is_empty() && largest == 0.0 {
            break;
        }
        samples.extend(all.iter().position(|&d| d == largest));
    }
    samples
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn a_grid_query_equals_the_search_over_all_points(
        points in clouds(0..80),
        queries in clouds(10..11),
        radius in 0.1f64..30.0,
    ) {
        let grid = NeighborGrid::new(&points, radius);
        for query in queries.iter().map(|p| Point3::from(p.coords * 2.0 - Vector3::repeat(10.0))) {
            let mut found = Vec::new();
            grid.within(&query, radius, |i, squared| found.push((i as usize, squared)));
            found.sort_by_key(|f| f.0);
            let expected: Vec<(usize, f64)> = points
                .iter()
                .map(|p| (p - query).norm_squared())
                .enumerate()
                .filter(|&(_, squared)| squared <= radius * radius)
                .collect();
            prop_assert_eq!(found, expected);
        }
    }

    #[test]
    fn farthest_points_follow_the_definition(points in clouds(1..400), n in 1usize..60, on_grid: bool) {
        // On a coarse grid many points are equally far, and some coincide.
        let snapped = |p: Point3<f64>| if on_grid { p.map(|c| (c / 4.0).round() * 4.0) } else { p };
        let points: Vec<Point3<f64>> = points.into_iter().map(snapped).collect();
        prop_assert_eq!(farthest_points(&points, n), farthest_by_definition(&points, n));
    }

    #[test]
    fn sampling_in_two_parts_equals_sampling_at_once_and_knows_the_nearest_sample(
        points in clouds(1..400),
        n in 1usize..60,
        on_grid: bool,
    ) {
        let snapped = |p: Point3<f64>| if on_grid { p.map(|c| (c / 4.0).round() * 4.0) } else { p };
        let points: Vec<Point3<f64>> = points.into_iter().map(snapped).collect();
        let (mut whole, mut parts) = (FarthestPoints::new(&points, points[0]), FarthestPoints::new(&points, points[0]));
        whole.extend_to(n);
        for m in [n / 3, n] {
            parts.extend_to(m);
            let samples: Vec<Point3<f64>> = parts.samples().iter().map(|&i| points[i]).collect();
            if !samples.is_empty() {
                for (p, nearest) in points.iter().zip(parts.nearest_samples()) {
                    let squared: Vec<f64> = samples.iter().map(|s| (p - s).norm_squared()).collect();
                    let least = squared.iter().copied().fold(f64::INFINITY, f64::min);
                    prop_assert_eq!(Some(nearest), squared.iter().position(|&d| d == least));
                }
            }
        }
        prop_assert_eq!(whole.samples(), parts.samples());
    }
}

#[test]
fn coincident_points_are_chosen_once() {
    assert_eq!(farthest_points(&[Point3::origin(); 5], 3), [0]);
    assert!(farthest_points(&[], 3).is_empty());
}
