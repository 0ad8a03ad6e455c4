//! All points within a radius of a query, found with a uniform grid of cubes.

use nalgebra::{Point3, Vector3};

/// Largest number of cubes along an axis. Wide sets get larger cubes, which costs time but changes no result.
const MAX_CUBES: usize = 96;

/// Points sorted into the cubes of a uniform grid.
pub struct NeighborGrid<'a> {
    points: &'a [Point3<f64>],
    low: Point3<f64>,
    cube_mm: f64,
    counts: [usize; 3],
    /// Start of each cube's points in `members`.
    starts: Vec<u32>,
    members: Vec<u32>,
}

impl<'a> NeighborGrid<'a> {
    /// Sorts `points`, mm, into cubes of a size suited to queries of radius `radius_mm`. Cost `O(points + cubes)`.
    pub fn new(points: &'a [Point3<f64>], radius_mm: f64) -> Self {
        let start = (Point3::from([f64::INFINITY; 3]), Point3::from([f64::NEG_INFINITY; 3]));
        let (low, high) = points.iter().fold(start, |(low, high), p| (low.inf(p), high.sup(p)));
        let extent = if points.is_empty() { Vector3::zeros() } else { high - low };
        let cube_mm = radius_mm.max(extent.max() / MAX_CUBES as f64).max(f64::MIN_POSITIVE);
        let counts = std::array::from_fn(|k| (extent[k] / cube_mm) as usize + 1);
        let mut grid = NeighborGrid { points, low, cube_mm, counts, starts: Vec::new(), members: Vec::new() };
        let cubes: Vec<usize> = points.iter().map(|p| grid.cube(p)).collect();
        let mut starts = vec![0u32; counts.iter().product::<usize>() + 1];
        for &cube in &cubes {
            starts[cube + 1] += 1;
        }
        for k in 1..starts.len() {
            starts[k] += starts[k - 1];
        }
        let mut next = starts.clone();
        grid.members = vec![0; points.len()];
        for (i, &cube) in cubes.iter().enumerate() {
            grid.members[next[cube] as usize] = i as u32;
            next[cube] += 1;
        }
        grid.starts = starts;
        grid
    }

    fn cube(&self, p: &Point3<f64>) -> usize {
        let at = |k: usize| (((p[k] - self.low[k]) / self.cube_mm) as usize).min(self.counts[k] - 1);
        (at(2) * self.counts[1] + at(1)) * self.counts[0] + at(0)
    }

    /// Calls `visit` with the index and the squared distance, mm², of every point within `radius_mm` of `query`. The
    /// order depends on the points alone.
    pub fn within(&self, query: &Point3<f64>, radius_mm: f64, mut visit: impl FnMut(u32, f64)) {
        let limit = radius_mm * radius_mm;
        let range = |k: usize| {
            let from = ((query[k] - radius_mm - self.low[k]) / self.cube_mm).floor().max(0.0) as usize;
            let to = ((query[k] + radius_mm - self.low[k]) / self.cube_mm).floor();
            // The range is empty where `from` lies beyond the last cube or `to` before the first.
            let end = if to < 0.0 { 0 } else { (to as usize + 1).min(self.counts[k]) };
            from..end
        };
        for z in range(2) {
            for y in range(1) {
                let row = (z * self.counts[1] + y) * self.counts[0];
                let x = range(0);
                if x.is_empty() {
                    continue;
                }
                // Consecutive cubes along x are stored consecutively.
                let (first, last) = (self.starts[row + x.start] as usize, self.starts[row + x.end] as usize);
                for &i in &self.members[first..last] {
                    let squared = (self.points[i as usize] - query).norm_squared();
                    if squared <= limit {
                        visit(i, squared);
                    }
                }
            }
        }
    }
}
