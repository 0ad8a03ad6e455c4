//! The random streams of the randomized minimizers: one for every variable in every sweep.
//!
//! A stream is named by `(seed, purpose, sweep, variable)` alone, so draws depend neither on the thread nor on earlier
//! draws. The generator is xoshiro256++ (Blackman, Vigna, ACM Trans. Math. Softw. 47(4), 2021).

use rand_core::{Rng, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

/// Purpose of a stream; the arbitrary constants only keep streams apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Purpose {
    /// Random labels to start from.
    Start = 0x2357_1113,
    /// Moves that measure the spread of the energy.
    Temperature = 0x1719_2329,
    /// The change of one variable in one sweep.
    Site = 0x3137_4143,
}

/// A seeded source of uniform numbers.
#[derive(Debug, Clone)]
pub(super) struct Draws(Xoshiro256PlusPlus);

impl Draws {
    /// The stream of `variable` in `sweep`.
    pub(super) fn new(seed: u64, purpose: Purpose, sweep: u32, variable: u32) -> Self {
        // Seeds and counters are scrambled in sequence, so that neighboring names do not give neighboring states.
        let key = scramble(seed ^ purpose as u64);
        let key = scramble(key ^ (u64::from(sweep) << 32 | u64::from(variable)));
        Draws(Xoshiro256PlusPlus::seed_from_u64(key))
    }

    /// Uniform in `[0, 1)`, from the 53 high bits of one draw.
    pub(super) fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in `0..n`, `n > 0`, as the high word of a product (Lemire, ACM Trans. Model. Comput. Simul. 29(1),
    /// 2019). Without his rejection step a value is preferred by at most `n / 2⁶⁴`.
    pub(super) fn below(&mut self, n: u64) -> u64 {
        ((u128::from(self.0.next_u64()) * u128::from(n)) >> 64) as u64
    }
}

/// The finalizer of MurmurHash3: a bijection in which every output bit depends on every input bit.
fn scramble(mut z: u64) -> u64 {
    z = (z ^ (z >> 33)).wrapping_mul(0xff51_afd7_ed55_8ccd);
    z = (z ^ (z >> 33)).wrapping_mul(0xc4ce_b9fe_1a85_ec53);
    z ^ (z >> 33)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_repeat_and_differ_in_every_part_of_their_name() {
        let first = |seed, purpose, sweep, variable| Draws::new(seed, purpose, sweep, variable).below(u64::MAX);
        let one = first(7, Purpose::Site, 3, 9);
        assert_eq!(one, first(7, Purpose::Site, 3, 9));
        for other in [
            first(8, Purpose::Site, 3, 9),
            first(7, Purpose::Start, 3, 9),
            first(7, Purpose::Site, 4, 9),
            first(7, Purpose::Site, 3, 10),
        ] {
            assert_ne!(one, other);
        }
    }

    /// First numbers of many neighboring streams: mean and variance of each, and no correlation along the counters.
    #[test]
    fn first_draws_of_neighboring_streams_are_uniform_and_uncorrelated() {
        let unit = |sweep, variable| Draws::new(1, Purpose::Site, sweep, variable).unit() - 0.5;
        let n = 40_000u32;
        let along_variables: Vec<f64> = (0..n).map(|i| unit(1, i)).collect();
        let along_sweeps: Vec<f64> = (0..n).map(|k| unit(k, 1)).collect();
        for values in [along_variables, along_sweeps] {
            let mean = values.iter().sum::<f64>() / f64::from(n);
            let variance = values.iter().map(|v| v * v).sum::<f64>() / f64::from(n);
            let lagged = values.windows(2).map(|w| w[0] * w[1]).sum::<f64>() / f64::from(n);
            // Four standard errors each.
            assert!(mean.abs() < 4.0 * 0.2887 / 200.0, "mean {mean}");
            assert!((variance - 1.0 / 12.0).abs() < 4.0 * 0.0745 / 200.0, "variance {variance}");
            assert!(lagged.abs() < 4.0 / 12.0 / 200.0, "lagged product {lagged}");
        }
    }

    #[test]
    fn every_value_below_a_bound_is_drawn_equally_often() {
        let mut draws = Draws::new(5, Purpose::Start, 0, 0);
        let mut counts = [0u32; 7];
        for _ in 0..70_000 {
            counts[draws.below(7) as usize] += 1;
        }
        assert!(counts.iter().all(|&c| (c as f64 - 10_000.0).abs() < 400.0), "{counts:?}");
    }
}
