//! Tells whether the values of a volume name structures or measure an intensity.
//!
//! A label is a name: its voxels lie together, so most neighbors of a voxel have the same value, whatever the number
//! is. An intensity is a measurement: it changes by noise or gradually, so equal neighbors are rare except in saturated
//! regions. [`ValueStatistics`] counts, for each value, how many of the face-adjacent pairs of foreground voxels that
//! contain it are equal. In label volumes, with two labels or a thousand, nearly all values keep together. In intensity
//! images, probability maps, distance maps and interpolated labels nearly none do.

use super::LabelVolume;
use std::collections::HashMap;

/// Share of the ends of its pairs in pairs of equal values from which a value keeps together. A cube of 2×2×2 voxels
/// among other values has a half, a straight line of many voxels a third.
const TOGETHER: f64 = 1.0 / 3.0;

/// Fewest values from which a conclusion is drawn: a few labels may all be specks.
const FEWEST_VALUES: usize = 8;

/// Spatial distribution of the values of a volume.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ValueStatistics {
    /// Different values other than 0.
    pub n_values: usize,
    /// Number of values whose voxels keep together.
    pub n_together: usize,
    /// Share of pairs of equal values among all face-adjacent pairs of voxels other than 0; 1 if there are none.
    pub equal_share: f64,
    /// Share of voxels other than 0 on the faces of the volume.
    pub border_share: f64,
}

impl ValueStatistics {
    /// Counts the values of `volume`. Cost `O(voxels)`.
    pub fn of(volume: &LabelVolume) -> Self {
        let [nx, ny, nz] = volume.dims();
        let labels = volume.labels();
        let mut ends = Ends::new(labels.iter().copied().max().unwrap_or(0));
        let mut equal_pairs = 0u64;
        let mut pairs = 0u64;
        let mut count = |a: u32, b: u32| {
            if a == 0 || b == 0 {
                return;
            }
            pairs += 1;
            if a == b {
                equal_pairs += 1;
                ends.add(a, 2, 2);
            } else {
                ends.add(a, 0, 1);
                ends.add(b, 0, 1);
            }
        };
        for (row, line) in labels.chunks_exact(nx).enumerate() {
            line.windows(2).for_each(|pair| count(pair[0], pair[1]));
            if (row + 1) % ny != 0 {
                line.iter().zip(&labels[(row + 1) * nx..]).for_each(|(&a, &b)| count(a, b));
            }
            if row + ny < ny * nz {
                line.iter().zip(&labels[(row + ny) * nx..]).for_each(|(&a, &b)| count(a, b));
            }
        }
        let n_values = volume.label_counts().len();
        let n_together = ends.n_together();
        let equal_share = if pairs == 0 { 1.0 } else { equal_pairs as f64 / pairs as f64 };
        ValueStatistics { n_values, n_together, equal_share, border_share: border_share(volume) }
    }

    /// Whether the values measure something: there are many of them, and for most values, or in most places, neighbors
    /// have other values.
    pub fn look_like_an_image(&self) -> bool {
        self.n_values >= FEWEST_VALUES && (2 * self.n_together < self.n_values || self.equal_share < 0.5)
    }
}

/// Ends of pairs by value: in pairs of equal values, and in total.
enum Ends {
    /// Indexed by value.
    Dense(Vec<[u32; 2]>),
    /// For values so large that a list of all values would take more memory than a volume.
    Sparse(HashMap<u32, [u32; 2]>),
}

/// Largest value for which [`Ends::Dense`] is used.
const LARGEST_DENSE: u32 = 1 << 20;

impl Ends {
    fn new(largest: u32) -> Self {
        if largest <= LARGEST_DENSE {
            Ends::Dense(vec![[0; 2]; largest as usize + 1])
        } else {
            Ends::Sparse(HashMap::new())
        }
    }

    fn add(&mut self, value: u32, equal: u32, all: u32) {
        let counts = match self {
            Ends::Dense(counts) => &mut counts[value as usize],
            Ends::Sparse(counts) => counts.entry(value).or_default(),
        };
        *counts = [counts[0].saturating_add(equal), counts[1].saturating_add(all)];
    }

    fn n_together(&self) -> usize {
        let together = |[equal, all]: &[u32; 2]| *all > 0 && f64::from(*equal) >= TOGETHER * f64::from(*all);
        match self {
            Ends::Dense(counts) => counts.iter().filter(|counts| together(counts)).count(),
            Ends::Sparse(counts) => counts.values().filter(|counts| together(counts)).count(),
        }
    }
}

fn border_share(volume: &LabelVolume) -> f64 {
    let [nx, ny, nz] = volume.dims();
    let (mut n, mut n_border) = (0u64, 0u64);
    for (row, line) in volume.labels().chunks_exact(nx).enumerate() {
        let (y, z) = (row % ny, row / ny);
        let ends: &[usize] = if nx > 1 { &[0, nx - 1] } else { &[0] };
        if y == 0 || y + 1 == ny || z == 0 || z + 1 == nz {
            n_border += nx as u64;
            n += line.iter().filter(|&&label| label != 0).count() as u64;
        } else {
            n_border += ends.len() as u64;
            n += ends.iter().filter(|&&x| line[x] != 0).count() as u64;
        }
    }
    n as f64 / n_border.max(1) as f64
}

#[cfg(test)]
#[path = "values_tests.rs"]
mod tests;
