//! Values of labels, intensities and mixtures of labels, made by rules and at random.

use super::*;
use nalgebra::Matrix4;
use proptest::prelude::*;
use rand_core::{Rng, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

const N: usize = 24;

fn volume(value: impl FnMut(usize) -> u32) -> LabelVolume {
    LabelVolume::new([N; 3], (0..N * N * N).map(value).collect(), Matrix4::identity()).unwrap()
}

fn place(k: usize) -> [f64; 3] {
    [k % N, k / N % N, k / (N * N)].map(|c| c as f64 - (N as f64 - 1.0) / 2.0)
}

fn radius(k: usize) -> f64 {
    place(k).iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// Cells around `n` random sites.
fn cells(n: usize, seed: u64) -> LabelVolume {
    let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
    let mut number = || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64 * N as f64;
    let sites: Vec<[f64; 3]> = (0..n).map(|_| [number(), number(), number()].map(|c| c - N as f64 / 2.0)).collect();
    let far = |k: usize, s: &[f64; 3]| (0..3).map(|a| (place(k)[a] - s[a]).powi(2)).sum::<f64>();
    volume(|k| {
        let nearest = (0..n).min_by(|&a, &b| far(k, &sites[a]).total_cmp(&far(k, &sites[b])));
        if radius(k) < 11.0 { nearest.unwrap_or(0) as u32 * 7 + 1 } else { 0 }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// For any number of structures that touch anywhere: cells of about 18 voxels and more.
    #[test]
    fn cells_are_labels(n in 1..300usize, seed in 0..u64::MAX) {
        let statistics = ValueStatistics::of(&cells(n, seed));
        prop_assert!(!statistics.look_like_an_image(), "{:?}", statistics);
        prop_assert!(statistics.border_share < 0.1);
    }

    /// An intensity that rises across the volume or from its middle, with or without noise, masked or not.
    #[test]
    fn intensities_are_no_labels(
        range in 40.0..2000.0f64, noise in 0.0..0.2f64, masked: bool, round: bool, seed in 0..u64::MAX,
    ) {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
        let mut number = || (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
        let image = volume(|k| {
            let [x, y, z] = place(k);
            let slope = if round { radius(k) / 21.0 } else { 0.5 + (x + 0.7 * y + 0.4 * z) / 60.0 };
            let value = range * (slope + noise * (number() - 0.5)).max(0.0);
            if masked && radius(k) > 9.0 { 0 } else { 1 + value as u32 }
        });
        let statistics = ValueStatistics::of(&image);
        prop_assert!(statistics.look_like_an_image(), "{:?}", statistics);
    }
}

#[test]
fn probabilities_and_interpolated_labels_are_no_labels() {
    // 100 inside, falling to 0 over 4 voxels; and the label 17 resampled between voxels.
    for top in [100.0, 17.0] {
        let soft = volume(|k| (top * ((11.0 - radius(k)) / 4.0).clamp(0.0, 1.0)).round() as u32);
        let statistics = ValueStatistics::of(&soft);
        assert!(statistics.look_like_an_image(), "{statistics:?}");
    }
}

#[test]
fn layers_and_specks_are_labels() {
    // Ten layers, each one voxel thick; and a structure with five specks.
    let layers = volume(|k| if radius(k) < 10.0 { radius(k).floor() as u32 + 1 } else { 0 });
    assert!(!ValueStatistics::of(&layers).look_like_an_image(), "{:?}", ValueStatistics::of(&layers));
    let specks = volume(|k| if radius(k) < 6.0 { if k % 997 < 1 { 2 + (k % 5) as u32 } else { 1 } } else { 0 });
    assert!(!ValueStatistics::of(&specks).look_like_an_image(), "{:?}", ValueStatistics::of(&specks));
}

#[test]
fn large_values_are_counted_as_small_ones_are() {
    let small = cells(20, 1);
    let labels = small.labels().iter().map(|&l| if l == 0 { 0 } else { l + (1 << 24) }).collect();
    let large = LabelVolume::new(small.dims(), labels, Matrix4::identity()).unwrap();
    assert_eq!(ValueStatistics::of(&small), ValueStatistics::of(&large));
}

#[test]
fn the_border_is_all_six_faces() {
    let full = ValueStatistics::of(&volume(|_| 3));
    assert_eq!((full.border_share, full.equal_share, full.n_values, full.n_together), (1.0, 1.0, 1, 1));
    let one_face = ValueStatistics::of(&volume(|k| u32::from(k % N == 0)));
    let n_border = (N * N * N - (N - 2) * (N - 2) * (N - 2)) as f64;
    assert_eq!(one_face.border_share, (N * N) as f64 / n_border);
}
