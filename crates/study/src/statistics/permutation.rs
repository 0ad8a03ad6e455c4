//! Permutation tests of a contrast over all vertices.
//!
//! Residuals of the model without the contrast are permuted among subjects and the whole model is fitted to them
//! (Freedman, Lane 1983), so that covariates keep their place. Each permutation gives a map of t. The largest |t| and
//! the largest enhanced |t| over all vertices are kept; their distribution controls the error over the whole surface.
//! The first permutation is the unpermuted data, so that no p is below `1 / permutations`.
//!
//! Differences within pairs have no order to permute: their signs are flipped, which needs symmetric errors
//! ([`Exchange::SignFlips`]).
//!
//! The model without the contrast is the part of the design orthogonal to the contrast's weights `a`
//! ([`LinearModel::observation_weights`]), so no column has to be chosen for it.
//!
//! Sources: Winkler et al., *Permutation inference for the general linear model*, NeuroImage 92, 2014; Holmes et al. 1996
//! (the distribution of the maximum).

use super::VertexValues;
use super::linear::{LinearModel, dot, norm};
use super::tfce::Enhancer;
use homolog_primitives::observe::{Cancelled, Observer, checkpoint};
use rand_core::Rng;
use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::SeedableRng;
use rayon::prelude::*;

/// Results of the permutations for a contrast, at each vertex.
#[derive(Debug, Clone, PartialEq)]
pub struct PermutationMap {
    /// t of the data.
    pub t: Vec<f64>,
    /// Enhanced t of the data.
    pub tfce: Vec<f64>,
    /// Two-sided p of t, uncorrected, for each vertex.
    pub p: Vec<f64>,
    /// Two-sided p of t, corrected for all vertices.
    pub p_fwe: Vec<f64>,
    /// Two-sided p of the enhanced t, corrected for all vertices.
    pub p_tfce: Vec<f64>,
    /// Number of permutations, the data included.
    pub permutations: usize,
}

/// Vertices between two calls of the observer: with a thousand subjects and 256 columns about 10 ms of work.
const AT_ONCE: usize = 64;
/// Permutations per task.
const OF_TASK: usize = 64;
/// Tasks whose counts, one per vertex, are in memory at the same time.
const TASKS: usize = 32;

/// Exchanges that do not change the distribution of residuals if there is no effect.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exchange {
    /// Another order of the subjects.
    Permutations,
    /// Another sign of each subject.
    SignFlips,
}

/// An exchange of residuals: subject `k` has the residual of subject `from[k]`, times `sign[k]`.
struct Shuffle {
    from: Vec<usize>,
    sign: Vec<f64>,
}

impl Shuffle {
    fn of_order(from: Vec<usize>) -> Self {
        let sign = vec![1.0; from.len()];
        Shuffle { from, sign }
    }

    /// The exchange of a number; 0 leaves the data as they are.
    fn new(exchange: Exchange, n: usize, seed: u64, number: u64) -> Self {
        match exchange {
            Exchange::Permutations => Self::of_order(order(n, seed, number)),
            Exchange::SignFlips => Shuffle { from: (0..n).collect(), sign: signs(n, seed, number) },
        }
    }
}

/// The signs of subjects in a flip: a function of seed and number alone.
fn signs(n: usize, seed: u64, number: u64) -> Vec<f64> {
    let mut random = Xoshiro256PlusPlus::seed_from_u64(seed ^ number.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let mut draw = || if random.next_u64() >> 63 == 0 { 1.0 } else { -1.0 };
    (0..n).map(|_| if number == 0 { 1.0 } else { draw() }).collect()
}

/// The order of subjects in a permutation: a function of seed and number alone.
fn order(n: usize, seed: u64, number: u64) -> Vec<usize> {
    let mut order: Vec<usize> = (0..n).collect();
    if number > 0 {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(seed ^ number.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        for k in (1..n).rev() {
            // The bias of the remainder is below n / 2^64.
            order.swap(k, (random.next_u64() % (k as u64 + 1)) as usize);
        }
    }
    order
}

/// Prepared maps of t for any order of subjects.
struct Test<'a> {
    model: &'a LinearModel,
    unit: Vec<f64>,
    /// Residuals of the model without the contrast, by vertex.
    reduced: Vec<f64>,
    squares: Vec<f64>,
    n: usize,
}

impl<'a> Test<'a> {
    fn new(
        model: &'a LinearModel,
        values: &VertexValues,
        contrast: &[f64],
        observer: &dyn Observer,
    ) -> Result<Self, Cancelled> {
        let a = model.observation_weights(contrast);
        let length = norm(&a);
        let unit: Vec<f64> = a.iter().map(|x| x / length).collect();
        let n = values.n_subjects();
        let mut reduced = Vec::with_capacity(n * values.n_vertices());
        for (vertex, y) in values.vertices().enumerate() {
            if vertex.is_multiple_of(AT_ONCE) {
                checkpoint(observer)?;
            }
            let along = dot(&unit, y);
            reduced.extend(model.residuals(y).into_iter().zip(&unit).map(|(x, a)| x + along * a));
        }
        let squares = reduced.chunks_exact(n.max(1)).map(|e| dot(e, e)).collect();
        Ok(Test { model, unit, reduced, squares, n })
    }

    /// t at every vertex after an exchange of residuals.
    fn t(&self, shuffle: &Shuffle, observer: &dyn Observer) -> Result<Vec<f64>, Cancelled> {
        // Permuting the few columns of the design in reverse gives the same products as permuting all residuals.
        let moved = |column: &[f64]| {
            let mut moved = vec![0.0; self.n];
            let exchanged = shuffle.from.iter().zip(&shuffle.sign).zip(column);
            exchanged.for_each(|((&from, sign), &x)| moved[from] = sign * x);
            moved
        };
        let (unit, basis) = (moved(&self.unit), self.model.basis().iter().map(|q| moved(q)).collect::<Vec<_>>());
        let degrees = self.model.degrees();
        let mut each = Vec::with_capacity(self.squares.len());
        for (vertex, (e, squares)) in self.reduced.chunks_exact(self.n.max(1)).zip(&self.squares).enumerate() {
            if vertex.is_multiple_of(AT_ONCE) {
                checkpoint(observer)?;
            }
            let explained: f64 = basis.iter().map(|q| dot(q, e).powi(2)).sum();
            let rest = (squares - explained).max(0.0);
            // A constant vertex has only rounding left.
            let is_constant = rest <= 1e-20 * squares || *squares == 0.0;
            each.push(if is_constant { 0.0 } else { dot(&unit, e) / (rest / degrees).sqrt() });
        }
        Ok(each)
    }
}

/// Tests a contrast by `permutations` exchanges of residuals, the data included. `enhancer` belongs to the mesh of the
/// vertices.
///
/// The result depends on the seed, not on threads. `O(permutations · V · (n p + log V))`, with counts of 4 bytes per
/// vertex for each of 32 tasks.
///
/// # Errors
/// [`Cancelled`], within some ten milliseconds of work after `observer` asks to stop.
pub fn test(
    model: &LinearModel,
    values: &VertexValues,
    contrast: &[f64],
    enhancer: &Enhancer<'_>,
    permutations: usize,
    seed: u64,
    observer: &dyn Observer,
) -> Result<PermutationMap, Cancelled> {
    test_by(Exchange::Permutations, model, values, contrast, enhancer, (permutations, seed), observer)
}

/// As [`test()`], by permutations or sign flips; `how_many`: their number and seed.
///
/// # Errors
/// [`Cancelled`].
pub fn test_by(
    exchange: Exchange,
    model: &LinearModel,
    values: &VertexValues,
    contrast: &[f64],
    enhancer: &Enhancer<'_>,
    (permutations, seed): (usize, u64),
    observer: &dyn Observer,
) -> Result<PermutationMap, Cancelled> {
    let shuffle = |n: usize, number: u64| Shuffle::new(exchange, n, seed, number);
    let test = Test::new(model, values, contrast, observer)?;
    let permutations = permutations.max(1);
    let t = test.t(&shuffle(test.n, 0), observer)?;
    let tfce = enhancer.clone().enhance(&t);
    let largest = |map: &[f64]| map.iter().fold(0.0f64, |top, x| top.max(x.abs()));
    let numbers: Vec<u64> = (1..permutations as u64).collect();
    let (mut counts, mut tops) = (vec![0u32; t.len()], Vec::with_capacity(permutations));
    // Only some counters are in memory at a time; sums of whole numbers do not depend on their order.
    for numbers in numbers.chunks(OF_TASK * TASKS) {
        let parts: Vec<(Vec<u32>, Vec<[f64; 2]>)> = numbers
            .par_chunks(OF_TASK)
            .map(|numbers| {
                let (mut enhancer, mut counts) = (enhancer.clone(), vec![0u32; t.len()]);
                let tops = numbers.iter().map(|&number| {
                    let other = test.t(&shuffle(test.n, number), observer)?;
                    counts.iter_mut().zip(&other).zip(&t).for_each(|((count, other), own)| {
                        *count += u32::from(reaches(other.abs(), own.abs()));
                    });
                    Ok([largest(&other), largest(&enhancer.enhance(&other))])
                });
                let tops = tops.collect::<Result<_, Cancelled>>()?;
                Ok((counts, tops))
            })
            .collect::<Result<_, Cancelled>>()?;
        for (part, of_part) in parts {
            counts.iter_mut().zip(part).for_each(|(count, more)| *count += more);
            tops.extend(of_part);
        }
    }
    let share = |count: u32| f64::from(count + 1) / permutations as f64;
    let p = counts.into_iter().map(share).collect();
    let corrected = |own: &[f64], which: usize| {
        let mut tops: Vec<f64> = tops.iter().map(|top| top[which]).collect();
        tops.push(largest(own));
        tops.sort_by(f64::total_cmp);
        let each = own.iter().map(|x| {
            let below = tops.partition_point(|&top| !reaches(top, x.abs()));
            (tops.len() - below) as f64 / permutations as f64
        });
        each.collect()
    };
    let (p_fwe, p_tfce) = (corrected(&t, 0), corrected(&tfce, 1));
    Ok(PermutationMap { t, tfce, p, p_fwe, p_tfce, permutations })
}

/// The maps of t for given orders of subjects: subject `k` has the residual of subject `order[k]`.
///
/// # Errors
/// [`Cancelled`].
pub fn t_of_orders(
    model: &LinearModel,
    values: &VertexValues,
    contrast: &[f64],
    orders: &[Vec<usize>],
    observer: &dyn Observer,
) -> Result<Vec<Vec<f64>>, Cancelled> {
    let test = Test::new(model, values, contrast, observer)?;
    orders.iter().map(|order| test.t(&Shuffle::of_order(order.clone()), observer)).collect()
}

/// Whether a permuted statistic is as large as that of the data, up to rounding: orders that only exchange equal
/// subjects must count.
fn reaches(other: f64, own: f64) -> bool {
    other >= own * (1.0 - 1e-9)
}

#[cfg(test)]
mod tests {
    use super::*;
    use faer::Mat;
    use homolog_mesh::shapes::ellipsoid;
    use homolog_primitives::observe::Silent;

    /// A number from -1/2 to 1/2.
    fn draw(random: &mut Xoshiro256PlusPlus) -> f64 {
        (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    }

    fn data(effect: f64) -> (Mat<f64>, VertexValues) {
        let mut random = Xoshiro256PlusPlus::seed_from_u64(9);
        let ages: Vec<f64> = (0..20).map(|_| draw(&mut random)).collect();
        let group = |i: usize| f64::from(u8::from(i.is_multiple_of(2)));
        let matrix = Mat::from_fn(20, 3, |i, k| [1.0, group(i), ages[i]][k]);
        let subjects: Vec<Vec<f64>> = (0..20)
            .map(|i| {
                (0..42)
                    .map(|v| draw(&mut random) + 2.0 * ages[i] + effect * group(i) * f64::from(u8::from(v < 12)))
                    .collect()
            })
            .collect();
        (matrix, VertexValues::from_subjects(&subjects))
    }

    #[test]
    fn t_of_an_order_is_that_of_fitting_the_model_to_permuted_residuals() {
        let (matrix, values) = data(0.3);
        let model = LinearModel::new(&matrix);
        let contrast = [0.0, 1.0, 0.0];
        let test = Test::new(&model, &values, &contrast, &Silent).unwrap();
        // By hand: residuals of the mean and the age alone.
        let reduced = LinearModel::new(&Mat::from_fn(20, 2, |i, k| matrix[(i, 2 * k)]));
        for number in [0, 1, 2] {
            let order = order(20, 4, number);
            let subjects: Vec<Vec<f64>> = {
                let residuals: Vec<Vec<f64>> = values.vertices().map(|y| reduced.residuals(y)).collect();
                (0..20).map(|i| residuals.iter().map(|e| e[order[i]]).collect()).collect()
            };
            let expected = model.contrast(&VertexValues::from_subjects(&subjects), &contrast, &Silent).unwrap().t;
            for (a, b) in test.t(&Shuffle::of_order(order), &Silent).unwrap().iter().zip(&expected) {
                assert!((a - b).abs() < 1e-9, "{a} {b}");
            }
        }
        // The unpermuted data.
        let own = model.contrast(&values, &contrast, &Silent).unwrap().t;
        assert!(
            test.t(&Shuffle::of_order(order(20, 4, 0)), &Silent)
                .unwrap()
                .iter()
                .zip(&own)
                .all(|(a, b)| (a - b).abs() < 1e-9)
        );
    }

    #[test]
    fn t_of_flipped_signs_is_that_of_flipped_differences() {
        let (_, values) = data(0.3);
        let model = LinearModel::new(&Mat::from_fn(20, 1, |_, _| 1.0));
        let test = Test::new(&model, &values, &[1.0], &Silent).unwrap();
        for number in [0, 1, 5] {
            let signs = signs(20, 4, number);
            assert_eq!(signs.contains(&-1.0), number > 0);
            let flipped: Vec<Vec<f64>> =
                (0..20).map(|i| values.vertices().map(|y| signs[i] * y[i]).collect()).collect();
            let expected = model.contrast(&VertexValues::from_subjects(&flipped), &[1.0], &Silent).unwrap().t;
            let found = test.t(&Shuffle::new(Exchange::SignFlips, 20, 4, number), &Silent).unwrap();
            assert!(found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-9));
        }
    }

    #[test]
    fn a_true_effect_is_found_where_it_is_on_any_number_of_threads() {
        let mesh = ellipsoid([3.0, 2.0, 1.0].into(), 1);
        let (graph, areas) = (mesh.edge_graph(), crate::align::vertex_areas(&mesh));
        let (matrix, values) = data(1.5);
        let run = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let model = LinearModel::new(&matrix);
            pool.install(|| {
                test(&model, &values, &[0.0, 1.0, 0.0], &Enhancer::new(&graph, &areas), 300, 1, &Silent).unwrap()
            })
        };
        let found = run(1);
        assert_eq!(found, run(3));
        assert!(found.p_fwe[..12].iter().all(|&p| p <= 2.0 / 300.0), "{:?}", &found.p_fwe[..12]);
        assert!(found.p_fwe[12..].iter().all(|&p| p > 0.05));
        assert!(found.p_tfce.iter().zip(&found.p).all(|(corrected, _)| *corrected >= 1.0 / 300.0));
        assert!(found.p_fwe.iter().zip(&found.p).all(|(corrected, single)| corrected >= single));
    }
}
