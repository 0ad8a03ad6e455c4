//! Limited-memory BFGS with a preconditioner and a backtracking line search.
//!
//! Source: Nocedal, Wright, *Numerical Optimization*, 2006, algorithms 7.4 and 3.1; the preconditioner is the
//! initial inverse Hessian, scaled as in their equation 7.20.

use crate::observe::{Cancelled, Observer, checkpoint, checkpoint_within};
use std::collections::VecDeque;

/// Number of stored pairs of steps and gradient changes.
const MEMORY: usize = 10;
/// A step is accepted if the value falls by at least this share of the linear prediction (Armijo condition).
const SUFFICIENT: f64 = 1e-4;
/// Largest number of halvings of a step.
const HALVINGS: usize = 40;
/// Number of steps over which the decrease of the value is measured.
const WINDOW: usize = 10;

/// A function to minimize.
pub trait Objective {
    /// The value at `x`, infinite where it is not defined, and its gradient into `gradient`.
    fn evaluate(&self, x: &[f64], gradient: &mut [f64]) -> f64;
    /// An approximation of the inverse Hessian, symmetric and positive definite, times `v`.
    fn precondition(&self, v: &[f64]) -> Vec<f64>;
}

/// The result of a minimization.
pub struct Minimum {
    /// Where the value is lowest.
    pub x: Vec<f64>,
    /// Steps taken.
    pub iterations: u32,
    /// Whether the value stopped decreasing before the steps ran out.
    pub converged: bool,
}

struct Pair {
    step: Vec<f64>,
    change: Vec<f64>,
    inverse_product: f64,
}

/// Minimizes `objective` from `x`, where it must be finite. The value falls with every step. The iteration ends when
/// ten consecutive steps together lower the value by less than the share `tolerance`.
///
/// # Errors
/// [`Cancelled`]; the observer is asked before every evaluation except the first.
pub fn minimize(
    objective: &dyn Objective,
    mut x: Vec<f64>,
    max_iterations: u32,
    tolerance: f64,
    observer: &dyn Observer,
) -> Result<Minimum, Cancelled> {
    let mut gradient = vec![0.0; x.len()];
    let mut value = objective.evaluate(&x, &mut gradient);
    let mut history = VecDeque::from([value]);
    let mut memory: VecDeque<Pair> = VecDeque::new();
    let mut scale = 1.0;
    let mut iterations = 0;
    while iterations < max_iterations {
        checkpoint(observer)?;
        let direction = descent_direction(objective, &gradient, &memory, scale);
        let Some(step) = line_search(objective, &x, value, &gradient, &direction, observer)? else {
            if memory.is_empty() {
                // The preconditioned gradient does not descend either: a minimum to rounding.
                return Ok(Minimum { x, iterations, converged: true });
            }
            memory.clear();
            continue;
        };
        let moved = difference(&step.x, &x);
        let change = difference(&step.gradient, &gradient);
        let product = dot(&moved, &change);
        // A pair without positive curvature could make the next direction ascend.
        if product > 1e-12 * dot(&moved, &moved).sqrt() * dot(&change, &change).sqrt() {
            scale = product / dot(&change, &objective.precondition(&change));
            memory.push_back(Pair { step: moved, change, inverse_product: 1.0 / product });
            if memory.len() > MEMORY {
                memory.pop_front();
            }
        }
        Evaluated { x, value, gradient } = step;
        iterations += 1;
        history.push_back(value);
        if history.len() > WINDOW {
            let before = history.pop_front().unwrap_or(value);
            if before - value < tolerance * value.abs() {
                return Ok(Minimum { x, iterations, converged: true });
            }
        }
    }
    Ok(Minimum { x, iterations, converged: false })
}

/// The negative gradient times the inverse Hessian implied by the stored pairs (two-loop recursion).
fn descent_direction(objective: &dyn Objective, gradient: &[f64], memory: &VecDeque<Pair>, scale: f64) -> Vec<f64> {
    let mut q = gradient.to_vec();
    let mut shares = Vec::with_capacity(memory.len());
    for pair in memory.iter().rev() {
        let share = pair.inverse_product * dot(&pair.step, &q);
        add(&mut q, -share, &pair.change);
        shares.push(share);
    }
    let mut r = objective.precondition(&q);
    r.iter_mut().for_each(|value| *value *= scale);
    for (pair, share) in memory.iter().zip(shares.iter().rev()) {
        let back = pair.inverse_product * dot(&pair.change, &r);
        add(&mut r, share - back, &pair.step);
    }
    r.iter_mut().for_each(|value| *value = -*value);
    r
}

struct Evaluated {
    x: Vec<f64>,
    value: f64,
    gradient: Vec<f64>,
}

/// Halves the step until the value falls sufficiently; `None` if it never does.
fn line_search(
    objective: &dyn Objective,
    x: &[f64],
    value: f64,
    gradient: &[f64],
    direction: &[f64],
    observer: &dyn Observer,
) -> Result<Option<Evaluated>, Cancelled> {
    let slope = dot(gradient, direction);
    if slope >= 0.0 {
        return Ok(None);
    }
    let mut trial = Evaluated { x: vec![0.0; x.len()], value: 0.0, gradient: vec![0.0; x.len()] };
    let mut length = 1.0;
    for _ in 0..HALVINGS {
        checkpoint_within(observer)?;
        trial.x.copy_from_slice(x);
        add(&mut trial.x, length, direction);
        trial.value = objective.evaluate(&trial.x, &mut trial.gradient);
        if trial.value <= value + SUFFICIENT * length * slope && trial.value < value {
            return Ok(Some(trial));
        }
        length /= 2.0;
    }
    Ok(None)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn difference(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a - b).collect()
}

fn add(to: &mut [f64], factor: f64, what: &[f64]) {
    to.iter_mut().zip(what).for_each(|(a, b)| *a += factor * b);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observe::Silent;

    /// Rosenbrock's valley, undefined left of −2.
    struct Valley;

    impl Objective for Valley {
        fn evaluate(&self, x: &[f64], gradient: &mut [f64]) -> f64 {
            if x[0] < -2.0 {
                return f64::INFINITY;
            }
            let (a, b) = (1.0 - x[0], x[1] - x[0] * x[0]);
            gradient[0] = -2.0 * a - 400.0 * x[0] * b;
            gradient[1] = 200.0 * b;
            a * a + 100.0 * b * b
        }

        fn precondition(&self, v: &[f64]) -> Vec<f64> {
            vec![v[0] / 800.0, v[1] / 200.0]
        }
    }

    #[test]
    fn the_minimum_of_a_curved_valley_is_reached() {
        let found = minimize(&Valley, vec![-1.2, 1.0], 500, 1e-14, &Silent).unwrap();
        assert!(found.converged && (found.x[0] - 1.0).abs() < 1e-6 && (found.x[1] - 1.0).abs() < 1e-6, "{:?}", found.x);
        let short = minimize(&Valley, vec![-1.2, 1.0], 3, 1e-14, &Silent).unwrap();
        assert!(!short.converged && short.iterations == 3);
    }
}
