//! Correspondences of extremities: places where a surface sticks out, such as hands, feet, a head or a tail.
//!
//! Extremities are few and far apart along the surface, so all assignments between those of two surfaces can be
//! examined. The assignments that keep distances along the surface best are starts of belief propagation, which labels
//! the places between them. Bilateral symmetry gives several assignments; the energy of the labelings decides between
//! them.
//!
//! Source: Zhang et al., "Deformation-driven shape correspondence", Computer Graphics Forum 27(5), 2008 (a search over
//! the assignments of extremities, pruned by distances along the surface).

use crate::surface::sites::SiteSubset;

/// Radius along the surface, in roots of the area, within which an extremity has the largest root mean square distance
/// from all places.
const REACH: f64 = 0.25;
/// Most extremities of a surface that are used, the most remote ones.
const MOST: usize = 7;
/// Assignments that are kept. Bodies with two arms and two legs have four that keep all distances.
const KEPT: usize = 12;
/// Cost of an extremity without a counterpart, and the largest cost of a pair of distances, in units of log-likelihood.
/// Costs only rank the assignments.
const ALONE: f64 = 3.0;
const TRUNCATION: f64 = 4.5;

/// Pairs of a place of the source and a place of the target.
pub(crate) type ExtremityPairs = Vec<(usize, usize)>;

/// Assignments of extremities, the likeliest first; each assigns at least one. The result does not depend on the unit
/// of length. `stretch` is the standard deviation of the relative change of a distance by a deformation.
///
/// Cost: all partial assignments of [`MOST`] places, pruned where they cost more than the kept ones, and `O(places²)`.
pub(crate) fn assignments(source: &SiteSubset<'_>, target: &SiteSubset<'_>, stretch: f64) -> Vec<ExtremityPairs> {
    let (a, b) = (Extremities::of(source), Extremities::of(target));
    let costs = Costs {
        // The weight of an extremity does not depend on the number of others.
        pair_weight: 1.0 / (a.places.len().min(b.places.len()).max(2) - 1) as f64,
        stretch,
        a: &a,
        b: &b,
    };
    let mut search = Search { costs, kept: Vec::new(), chosen: Vec::new() };
    search.deeper(0.0);
    let pairs = |chosen: Vec<Option<usize>>| {
        a.places.iter().zip(chosen).filter_map(|(&i, k)| k.map(|k| (i, b.places[k]))).collect()
    };
    search
        .kept
        .into_iter()
        .map(|(_, chosen)| pairs(chosen))
        .filter(|pairs: &ExtremityPairs| !pairs.is_empty())
        .collect()
}

/// Number of extremities, at most [`MOST`], whose root mean square distance from all places is at least `remoteness`.
/// Cost `O(places²)`.
pub(crate) fn number_of_limbs(places: &SiteSubset<'_>, remoteness: f64) -> usize {
    Extremities::of(places).remoteness.iter().filter(|&&r| r >= remoteness).count()
}

/// The extremities of a surface, the most remote first.
struct Extremities {
    places: Vec<usize>,
    /// Root mean square distance of each from all places.
    remoteness: Vec<f64>,
    /// Distances between extremities, row by row.
    apart: Vec<Vec<f64>>,
}

impl Extremities {
    fn of(places: &SiteSubset<'_>) -> Self {
        let n = places.len();
        let mean_square = |i: usize| (0..n).map(|j| places.distance(i, j).powi(2)).sum::<f64>() / n as f64;
        let remoteness: Vec<f64> = (0..n).map(|i| mean_square(i).sqrt()).collect();
        // Equally remote places are ordered by index.
        let order = |&i: &usize, &j: &usize| remoteness[j].total_cmp(&remoteness[i]).then(i.cmp(&j));
        let is_one = |i: &usize| (0..n).all(|j| order(i, &j).is_le() || places.distance(*i, j) > REACH);
        let mut found: Vec<usize> = (0..n).filter(is_one).collect();
        found.sort_by(order);
        found.truncate(MOST);
        Extremities {
            remoteness: found.iter().map(|&i| remoteness[i]).collect(),
            apart: found.iter().map(|&i| found.iter().map(|&j| places.distance(i, j)).collect()).collect(),
            places: found,
        }
    }
}

/// The costs of assignments.
struct Costs<'a> {
    pair_weight: f64,
    stretch: f64,
    a: &'a Extremities,
    b: &'a Extremities,
}

impl Costs<'_> {
    /// The additional cost of assigning the `k`-th extremity of the target to the next one of the source, given the
    /// previous assignments `chosen`.
    fn of_next(&self, k: usize, chosen: &[Option<usize>]) -> f64 {
        let (i, &Costs { stretch, a, b, .. }) = (chosen.len(), self);
        let pairs = chosen.iter().enumerate().filter_map(|(j, l)| l.map(|l| (j, l)));
        let of_pairs: f64 = pairs.map(|(j, l)| unlike(a.apart[i][j], b.apart[k][l], stretch)).sum();
        unlike(a.remoteness[i], b.remoteness[k], stretch) + self.pair_weight * of_pairs
    }
}

/// `−ln` of the likelihood of two corresponding distances.
fn unlike(one: f64, other: f64, stretch: f64) -> f64 {
    let noise = stretch * 0.5 * (one + other);
    (0.5 * ((one - other) / noise).powi(2)).min(TRUNCATION)
}

/// Depth-first search for the assignments of lowest cost: each extremity of the source in turn gets one of the target,
/// or none.
struct Search<'a> {
    costs: Costs<'a>,
    /// The assignments of lowest cost so far, by increasing cost.
    kept: Vec<(f64, Vec<Option<usize>>)>,
    chosen: Vec<Option<usize>>,
}

impl Search<'_> {
    /// Searches all continuations of `chosen`, whose cost is `cost`.
    fn deeper(&mut self, cost: f64) {
        if self.kept.len() == KEPT && self.kept[KEPT - 1].0 <= cost {
            return;
        }
        if self.chosen.len() == self.costs.a.places.len() {
            let at = self.kept.partition_point(|(other, _)| *other <= cost);
            self.kept.insert(at, (cost, self.chosen.clone()));
            self.kept.truncate(KEPT);
            return;
        }
        for k in 0..self.costs.b.places.len() {
            if !self.chosen.contains(&Some(k)) {
                let more = self.costs.of_next(k, &self.chosen);
                self.with(Some(k), cost + more);
            }
        }
        self.with(None, cost + ALONE);
    }

    fn with(&mut self, choice: Option<usize>, cost: f64) {
        self.chosen.push(choice);
        self.deeper(cost);
        self.chosen.pop();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Point2;

    const STRETCH: f64 = 0.15;

    /// Places of a star in the plane whose arms have these directions (degrees) and lengths; distances are along the
    /// arms.
    fn star(arms: &[(f64, f64)]) -> (Vec<f32>, Vec<usize>) {
        const STEPS: usize = 12;
        let mut points = vec![(0, 0.0)];
        let mut tips = Vec::new();
        for (arm, &(_, length)) in arms.iter().enumerate() {
            points.extend((1..=STEPS).map(|s| (arm, length * s as f64 / STEPS as f64)));
            tips.push(points.len() - 1);
        }
        // A distance between two arms is shorter for a smaller angle, as on a web between them.
        let distance = |&(a, r): &(usize, f64), &(b, s): &(usize, f64)| {
            let at = |arm: usize, radius: f64| {
                let angle = arms[arm].0.to_radians();
                Point2::new(radius * angle.cos(), radius * angle.sin())
            };
            if a == b { (r - s).abs() } else { 0.5 * (r + s + (at(a, r) - at(b, s)).norm()) }
        };
        (points.iter().flat_map(|p| points.iter().map(move |q| distance(p, q) as f32)).collect(), tips)
    }

    fn places(distances: &[f32]) -> SiteSubset<'_> {
        SiteSubset { distances, n_sites: distances.len().isqrt(), which: None }
    }

    #[test]
    fn the_tips_correspond_whatever_their_order() {
        let arms = [(0.0, 1.0), (80.0, 0.8), (170.0, 1.3), (250.0, 0.6)];
        let (source, tips) = star(&arms);
        let (target, others) = star(&[arms[2], arms[0], arms[3], arms[1]]);
        let mut expected: ExtremityPairs =
            vec![(tips[0], others[1]), (tips[1], others[3]), (tips[2], others[0]), (tips[3], others[2])];
        let found = assignments(&places(&source), &places(&target), STRETCH);
        let mut first = found[0].clone();
        first.sort_unstable();
        expected.sort_unstable();
        assert_eq!(first, expected);
        assert_eq!(found.len(), KEPT);
        assert!((1..KEPT).all(|k| !found[..k].contains(&found[k])));
    }

    #[test]
    fn limbs_are_the_extremities_that_are_far_out() {
        let (distances, _) = star(&[(0.0, 1.0), (80.0, 0.8), (170.0, 1.3), (250.0, 0.6)]);
        let places = places(&distances);
        let remoteness = Extremities::of(&places).remoteness;
        assert_eq!(remoteness.len(), 4);
        assert!(remoteness.windows(2).all(|w| w[0] >= w[1]));
        assert_eq!([0.0, remoteness[1], 2.0 * remoteness[0]].map(|least| number_of_limbs(&places, least)), [4, 2, 0]);
    }

    #[test]
    fn a_symmetry_gives_both_assignments_first() {
        let (source, tips) = star(&[(0.0, 1.3), (100.0, 0.9), (260.0, 0.9)]);
        let found = assignments(&places(&source), &places(&source), STRETCH);
        let sorted = |mut pairs: ExtremityPairs| {
            pairs.sort_unstable();
            pairs
        };
        let [kept, exchanged] = [[0, 1, 2], [0, 2, 1]].map(|to| (0..3).map(|k| (tips[k], tips[to[k]])).collect());
        let first: Vec<ExtremityPairs> = found[..2].iter().cloned().map(sorted).collect();
        assert!(first.contains(&kept) && first.contains(&exchanged), "{first:?}");
    }

    #[test]
    fn the_kept_assignments_are_the_cheapest_of_all() {
        let (source, _) = star(&[(0.0, 1.0), (90.0, 0.8), (200.0, 0.7)]);
        let (target, _) = star(&[(10.0, 0.9), (120.0, 0.9), (215.0, 0.75), (300.0, 0.5)]);
        let (a, b) = (Extremities::of(&places(&source)), Extremities::of(&places(&target)));
        let (n, m) = (a.places.len(), b.places.len());
        assert!(n >= 3 && m >= 4);
        let costs = Costs { pair_weight: 1.0 / (n.min(m) - 1) as f64, stretch: STRETCH, a: &a, b: &b };
        // All assignments by enumeration: a digit for each extremity of the source, `m` for none.
        let mut all: Vec<f64> = (0..(m + 1).pow(n as u32))
            .filter_map(|code| {
                let chosen: Vec<Option<usize>> =
                    (0..n).map(|i| Some(code / (m + 1).pow(i as u32) % (m + 1)).filter(|&k| k < m)).collect();
                let used: Vec<usize> = chosen.iter().flatten().copied().collect();
                if (1..used.len()).any(|k| used[..k].contains(&used[k])) {
                    return None;
                }
                let of = |i: usize| chosen[i].map_or(ALONE, |k| costs.of_next(k, &chosen[..i]));
                Some((0..n).map(of).sum())
            })
            .collect();
        all.sort_by(f64::total_cmp);
        let mut search = Search { costs, kept: Vec::new(), chosen: Vec::new() };
        search.deeper(0.0);
        assert!(all.len() > KEPT && search.kept.len() == KEPT);
        for (kept, expected) in search.kept.iter().zip(&all) {
            assert!((kept.0 - expected).abs() < 1e-12, "{} {expected}", kept.0);
        }
    }
}
