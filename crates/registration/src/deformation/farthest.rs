//! Points spread evenly over a set of points.
//!
//! A new point changes the distances only of those that lie closer to it than to all before it, which soon are few. Points
//! are taken in blocks of neighbours in the list, each with its box and its largest distance: a block whose box is farther
//! from the new point than that has nothing to change, and is passed over. The choice is that of the plain method, to the
//! bit, for any order of the points; where points close in space are close in the list, most blocks are passed over.
//!
//! Source: farthest-point sampling, Gonzalez, "Clustering to minimize the maximum intercluster distance", 1985: at
//! most twice as far from any point as the best choice of as many.

use nalgebra::{Point3, Vector3};

/// Points of a block: enough that passing it over saves something, few enough that its box is small.
const BLOCK: usize = 32;

/// Neighbours in the list of points, with their squared distances from the points chosen so far.
struct Block<'a> {
    points: &'a [Point3<f64>],
    low: Point3<f64>,
    high: Point3<f64>,
    squared: Vec<f64>,
    /// The farthest: the lowest index of equals.
    farthest: usize,
}

impl<'a> Block<'a> {
    fn new(points: &'a [Point3<f64>]) -> Self {
        let (low, high) = points.iter().fold((points[0], points[0]), |(low, high), p| (low.inf(p), high.sup(p)));
        Block { points, low, high, squared: vec![f64::INFINITY; points.len()], farthest: 0 }
    }

    fn largest(&self) -> f64 {
        self.squared[self.farthest]
    }

    /// Squared distance of the box from `at`. Every operation rounds monotonically and they are those of the distances of
    /// the points, so that it exceeds none of them, rounding included.
    fn gap_squared(&self, at: &Point3<f64>) -> f64 {
        (self.low - at).sup(&(at - self.high)).sup(&Vector3::zeros()).norm_squared()
    }

    /// `at` is chosen.
    fn choose(&mut self, at: &Point3<f64>) {
        if self.gap_squared(at) >= self.largest() {
            return;
        }
        for (squared, p) in self.squared.iter_mut().zip(self.points) {
            *squared = squared.min((p - at).norm_squared());
        }
        self.farthest = first_largest(self.squared.iter().copied());
    }
}

/// The index of the largest value; the lowest of equals.
fn first_largest(values: impl Iterator<Item = f64>) -> usize {
    let largest = values.enumerate().reduce(|best, next| if next.1 > best.1 { next } else { best });
    largest.map_or(0, |(index, _)| index)
}

/// Indices of up to `n` of `points`, each the farthest from those before it; the first is the farthest from the
/// centroid. Of points equally far the lowest index. Ends early where every other point coincides with a chosen one.
///
/// # Cost
/// `O(n · points / 32)` where points close in space are close in the list, `O(n · points)` at most.
pub fn farthest_points(points: &[Point3<f64>], n: usize) -> Vec<usize> {
    let n = n.min(points.len());
    let mut chosen: Vec<usize> = Vec::with_capacity(n);
    if n == 0 {
        return chosen;
    }
    let center = points.iter().fold(Vector3::zeros(), |s, p| s + p.coords) / points.len() as f64;
    let mut blocks: Vec<Block<'_>> = points.chunks(BLOCK).map(Block::new).collect();
    chosen.push(first_largest(points.iter().map(|p| (p.coords - center).norm_squared())));
    while chosen.len() < n {
        let at = points[chosen[chosen.len() - 1]];
        blocks.iter_mut().for_each(|block| block.choose(&at));
        let farthest = first_largest(blocks.iter().map(Block::largest));
        if blocks[farthest].largest() <= 0.0 {
            break;
        }
        chosen.push(farthest * BLOCK + blocks[farthest].farthest);
    }
    chosen
}
