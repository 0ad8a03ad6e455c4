//! Beliefs of single variables: the whole row, and its spread over the target.

use nalgebra::{Point3, Vector3};

/// Number of messages multiplied before the product is scaled to maximum 1 again. Messages are above 10⁻⁴⁵ in 32 bits,
/// so the product of four of them stays above the smallest number of 64 bits.
const MESSAGES_PER_SCALING: usize = 4;

/// The belief `φ(x) Π m(x)` over the labels, in 64 bits, summing to 1; all 0 if all products vanish.
pub(super) fn belief_row(phi: &[f32], messages: impl Iterator<Item: AsRef<[f32]>>) -> Vec<f64> {
    let mut belief: Vec<f64> = phi.iter().map(|&p| f64::from(p)).collect();
    for (at, message) in messages.enumerate() {
        for (b, &m) in belief.iter_mut().zip(message.as_ref()) {
            *b *= f64::from(m);
        }
        if at % MESSAGES_PER_SCALING == MESSAGES_PER_SCALING - 1 {
            let top = belief.iter().copied().fold(0.0, f64::max);
            divide(&mut belief, top);
        }
    }
    let sum: f64 = belief.iter().sum();
    divide(&mut belief, sum);
    belief
}

fn divide(values: &mut [f64], by: f64) {
    if by > 0.0 {
        values.iter_mut().for_each(|v| *v /= by);
    }
}

/// Square root of the belief-weighted mean squared distance from the belief-weighted mean position, in the unit of
/// `positions` (mm). 0 for a belief in one label, and for a belief without weight.
///
/// `belief`: a weight `≥ 0` for each label, in any scale; `positions`: the positions of the labels. Distances are
/// straight, not along the surface. Cost `O(n)`.
pub fn belief_spread(belief: &[f32], positions: &[Point3<f64>]) -> f64 {
    let weighted = || belief.iter().map(|&b| f64::from(b)).zip(positions);
    let total: f64 = weighted().map(|(b, _)| b).sum();
    if total <= 0.0 {
        return 0.0;
    }
    let mean = weighted().fold(Vector3::zeros(), |sum, (b, p)| sum + p.coords * b) / total;
    let squares: f64 = weighted().map(|(b, p)| b * (p.coords - mean).norm_squared()).sum();
    (squares / total).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_equal_beliefs_spread_by_half_their_distance() {
        let positions = [Point3::new(1.0, 2.0, 3.0), Point3::new(1.0, 2.0, 9.0), Point3::new(50.0, 0.0, 0.0)];
        assert!((belief_spread(&[0.5, 0.5, 0.0], &positions) - 3.0).abs() < 1e-12);
        assert!((belief_spread(&[7.0, 7.0, 0.0], &positions) - 3.0).abs() < 1e-12);
        assert_eq!(belief_spread(&[0.0, 1.0, 0.0], &positions), 0.0);
        assert_eq!(belief_spread(&[0.0; 3], &positions), 0.0);
    }

    #[test]
    fn products_of_many_small_messages_do_not_vanish() {
        let small = [1e-40f32, 2e-40, 0.0];
        let belief = belief_row(&[1.0, 1.0, 1.0], (0..30).map(|_| small.as_slice()));
        assert!((belief.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        assert!(belief[1] > 0.999_999 && belief[2] == 0.0);
    }
}
