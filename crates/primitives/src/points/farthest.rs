//! Farthest-point sampling: a subset that covers a set of points evenly.
//!
//! A new sample changes the distances of only those points that lie closer to it than to every earlier sample, and
//! these soon become few. Points are therefore processed in blocks of consecutive indices, each with its bounding box
//! and its largest distance. A block is skipped when its box is farther from the new sample than that distance. The
//! result equals the plain method to the bit, for any order of the points. Most blocks are skipped when points that are
//! close in space have close indices.
//!
//! Source: Gonzalez, "Clustering to minimize the maximum intercluster distance", 1985: no point is more than twice as
//! far from its nearest sample as with the best choice of the same number of samples.

use nalgebra::{Point3, Vector3};

/// Points per block: enough that skipping a block saves work, few enough that its box is small.
const BLOCK: usize = 32;

/// Consecutive points, with their squared distances from the nearest sample.
struct Block<'a> {
    points: &'a [Point3<f64>],
    low: Point3<f64>,
    high: Point3<f64>,
    squared: Vec<f64>,
    /// Number of the nearest sample for each point; ties go to the earliest.
    nearest: Vec<u32>,
    /// Index within the block of the point farthest from all samples; ties go to the lowest index.
    farthest: usize,
}

impl<'a> Block<'a> {
    fn new(points: &'a [Point3<f64>]) -> Self {
        let (low, high) = points.iter().fold((points[0], points[0]), |(low, high), p| (low.inf(p), high.sup(p)));
        let (squared, nearest) = (vec![f64::INFINITY; points.len()], vec![0; points.len()]);
        Block { points, low, high, squared, nearest, farthest: 0 }
    }

    fn largest(&self) -> f64 {
        self.squared[self.farthest]
    }

    /// Squared distance of the bounding box from `at`. It uses the same operations as the point distances. Each rounds
    /// monotonically, so the result exceeds none of them even after rounding.
    fn gap_squared(&self, at: &Point3<f64>) -> f64 {
        (self.low - at).sup(&(at - self.high)).sup(&Vector3::zeros()).norm_squared()
    }

    /// Updates the distances for the new sample number `sample` at `at`.
    fn add_sample(&mut self, sample: u32, at: &Point3<f64>) {
        if self.gap_squared(at) >= self.largest() {
            return;
        }
        for ((squared, nearest), p) in self.squared.iter_mut().zip(&mut self.nearest).zip(self.points) {
            let to_sample = (p - at).norm_squared();
            if to_sample < *squared {
                (*squared, *nearest) = (to_sample, sample);
            }
        }
        self.farthest = first_largest(self.squared.iter().copied());
    }
}

/// The index of the largest value; ties go to the lowest index.
fn first_largest(values: impl Iterator<Item = f64>) -> usize {
    let largest = values.enumerate().reduce(|best, next| if next.1 > best.1 { next } else { best });
    largest.map_or(0, |(index, _)| index)
}

/// Farthest-point sampling that can be continued: the first samples of a large sample form a small sample.
pub struct FarthestPoints<'a> {
    points: &'a [Point3<f64>],
    start: Point3<f64>,
    blocks: Vec<Block<'a>>,
    samples: Vec<usize>,
}

impl<'a> FarthestPoints<'a> {
    /// Prepares `points`, mm, without choosing any; the first sample will be the point farthest from `start`. Cost
    /// `O(n)`.
    pub fn new(points: &'a [Point3<f64>], start: Point3<f64>) -> Self {
        FarthestPoints { points, start, blocks: points.chunks(BLOCK).map(Block::new).collect(), samples: Vec::new() }
    }

    /// Adds samples until there are `n`. Each is the point farthest from all samples before it; ties go to the lowest
    /// index. Ends early when every point coincides with a sample.
    ///
    /// # Cost
    /// A sample costs `O(points / 32)` when points that are close in space have close indices, `O(points)` at most.
    pub fn extend_to(&mut self, n: usize) {
        while self.samples.len() < n.min(self.points.len()) {
            let next = if self.samples.is_empty() {
                first_largest(self.points.iter().map(|p| (p - self.start).norm_squared()))
            } else {
                let farthest = first_largest(self.blocks.iter().map(Block::largest));
                if self.blocks[farthest].largest() <= 0.0 {
                    return;
                }
                farthest * BLOCK + self.blocks[farthest].farthest
            };
            let (sample, at) = (self.samples.len() as u32, self.points[next]);
            self.blocks.iter_mut().for_each(|block| block.add_sample(sample, &at));
            self.samples.push(next);
        }
    }

    /// Indices of the samples, in the order in which they were chosen.
    pub fn samples(&self) -> &[usize] {
        &self.samples
    }

    /// For every point the position in [`Self::samples`] of its nearest sample; ties go to the earliest sample.
    pub fn nearest_samples(&self) -> impl Iterator<Item = usize> + '_ {
        self.blocks.iter().flat_map(|block| block.nearest.iter().map(|&sample| sample as usize))
    }
}

/// Indices of up to `n` of `points` by farthest-point sampling from the centroid ([`FarthestPoints::extend_to`]).
///
/// # Cost
/// `O(n · points / 32)` when points that are close in space have close indices, `O(n · points)` at most.
pub fn farthest_points(points: &[Point3<f64>], n: usize) -> Vec<usize> {
    let center = points.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / points.len() as f64;
    let mut sampling = FarthestPoints::new(points, Point3::from(center));
    sampling.extend_to(n);
    sampling.samples
}
