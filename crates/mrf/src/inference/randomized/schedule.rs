//! Cooling of simulated annealing: the temperature of each sweep.
//!
//! Every schedule begins at the initial temperature in the first sweep. Geometric and linear schedules end at the final
//! temperature in the last sweep; the logarithmic schedule does not reach it in any practical number of sweeps.

use super::draws::{Draws, Purpose};
use super::energy::SearchEnergy;

/// Lowest temperature: below it only energy differences within the rounding of 32 bits would be accepted. Divisions by
/// it stay finite.
pub(super) const COLDEST: f64 = 1e-6;

/// Random moves that estimate the initial temperature: the standard deviation is then known to a few percent.
const TRIAL_MOVES: u32 = 1024;

/// The form of the cooling curve; `k` counts sweeps from 1 to `K`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cooling {
    /// `T_k = T_1 (T_K / T_1)^((k−1)/(K−1))`. Kirkpatrick, Gelatt, Vecchi, Science 220, 1983.
    Geometric,
    /// `T_k = T_1 ln 2 / ln(1 + k)`, but never less than the final temperature. Geman, Geman, IEEE PAMI 6(6), 1984;
    /// their proof that the minimum is found requires a `T_1` for which no budget suffices. After 1,000 sweeps the
    /// temperature is still a tenth of the initial one. Another base of the logarithm would reach a colder end, but as
    /// a quench: nearly all of the fall would happen in the first sweeps.
    Logarithmic,
    /// `T_k = T_1 + (T_K − T_1)(k−1)/(K−1)`.
    Linear,
}

/// The temperatures of one run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Temperatures {
    schedule: Cooling,
    initial: f64,
    last: f64,
    sweeps: u32,
}

impl Temperatures {
    /// Temperatures from `initial` to `last` in `sweeps` sweeps. A final temperature above the initial one is replaced
    /// by it, and temperatures below [`COLDEST`] by [`COLDEST`].
    pub(super) fn new(schedule: Cooling, initial: f64, last: f64, sweeps: u32) -> Self {
        let initial = initial.max(COLDEST);
        let last = last.clamp(COLDEST, initial);
        Temperatures { schedule, initial, last, sweeps }
    }

    /// Temperature of sweep `k`, from 1; never rises.
    pub(super) fn at(&self, k: u32) -> f64 {
        if k <= 1 {
            return self.initial;
        }
        let share = f64::from(k - 1) / f64::from(self.sweeps.max(k) - 1);
        let exact = match self.schedule {
            Cooling::Geometric => self.initial * (self.last / self.initial).powf(share),
            Cooling::Logarithmic => self.initial * std::f64::consts::LN_2 / (1.0 + f64::from(k)).ln(),
            Cooling::Linear => self.initial + (self.last - self.initial) * share,
        };
        exact.clamp(self.last, self.initial)
    }
}

/// The spread of the energy: the standard deviation of `ΔE` over random changes of one label, from random labels.
///
/// At this temperature a typical worsening change is accepted about every third time. Returns 1 if no change affects
/// the energy. Source: White, ICCD 1984. Cost `O(degree · log k̄)` per move, 1024 moves.
pub(super) fn energy_spread(energy: &SearchEnergy<'_>, seed: u64) -> f64 {
    let (n, n_labels) = (energy.model.n_variables() as u64, energy.model.n_labels() as u64);
    if n == 0 {
        return 1.0;
    }
    let labels = energy.random_labels(seed, 0);
    let mut draws = Draws::new(seed, Purpose::Temperature, 0, 0);
    let (mut sum, mut squares) = (0.0, 0.0);
    for _ in 0..TRIAL_MOVES {
        let i = draws.below(n) as usize;
        let x = draws.below(n_labels) as u32;
        let delta = energy.site(i, x, &labels).minus(&energy.site(i, labels[i], &labels)).total();
        sum += delta;
        squares += delta * delta;
    }
    let count = f64::from(TRIAL_MOVES);
    let variance = squares / count - (sum / count).powi(2);
    if variance > 0.0 { variance.sqrt() } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const ALL: [Cooling; 3] = [Cooling::Geometric, Cooling::Logarithmic, Cooling::Linear];

    proptest! {
        #[test]
        fn every_schedule_falls_from_the_initial_temperature_and_never_below_the_final_one(
            initial in 1e-3f64..1e3,
            share in 1e-4f64..1.0,
            sweeps in 2u32..2000,
        ) {
            let last = (initial * share).max(COLDEST);
            for schedule in ALL {
                let t = Temperatures::new(schedule, initial, last, sweeps);
                prop_assert_eq!(t.at(1), initial);
                for k in 2..=sweeps {
                    prop_assert!(last <= t.at(k) && t.at(k) <= t.at(k - 1), "{:?} rises in sweep {}", schedule, k);
                }
            }
            for schedule in [Cooling::Geometric, Cooling::Linear] {
                let end = Temperatures::new(schedule, initial, last, sweeps).at(sweeps);
                prop_assert!((end - last).abs() < 1e-9 * initial, "{:?} ends at {}, not {}", schedule, end, last);
            }
        }
    }

    #[test]
    fn the_curves_are_those_of_their_formulas() {
        let at = |schedule, k| Temperatures::new(schedule, 8.0, 2.0, 3).at(k);
        assert_eq!([1, 2, 3].map(|k| at(Cooling::Linear, k)), [8.0, 5.0, 2.0]);
        assert!((at(Cooling::Geometric, 2) - 4.0).abs() < 1e-12);
        assert!((at(Cooling::Logarithmic, 3) - 4.0).abs() < 1e-12);
        assert!((Temperatures::new(Cooling::Logarithmic, 8.0, 0.1, 10).at(7) - 8.0 / 3.0).abs() < 1e-12);
        // The floor: 8 / log₂ 32 would be less than 2.
        assert_eq!(Temperatures::new(Cooling::Logarithmic, 8.0, 2.0, 40).at(31), 2.0);
    }

    #[test]
    fn one_sweep_and_a_final_temperature_of_zero_are_no_special_cases() {
        for schedule in ALL {
            assert_eq!(Temperatures::new(schedule, 2.0, 1.0, 1).at(1), 2.0);
            assert_eq!(Temperatures::new(schedule, 2.0, 3.0, 10).at(5), 2.0);
        }
        assert!((Temperatures::new(Cooling::Linear, 2.0, 0.0, 10).at(10) - COLDEST).abs() < 1e-12);
    }
}
