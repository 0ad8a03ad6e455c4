//! The predicted demand of a match: cores by method and sizes of the surfaces, memory as `matching` counts it, processor time by the
//! counts of its stages.

use super::price::Exceeded;
use crate::jobs::{Demand, SurfaceSize};
use homolog_contract::parameters::{Algorithm, DisplacementMode, MatchParameters};
use homolog_run::match_memory_bytes;
use homolog_study::price::{Price, match_price};

/// A match gets one core for this many vertices, counted as the geometric mean of its two surfaces.
///
/// A compromise between throughput and the time of a single job: pairs of hippocampi at 1 mm, about 2,500 vertices each,
/// arrive in batches and run side by side on a core each, while a user waits for a large match, which gets more. Before
/// changing it, measure with `make bench-service PART=schedule-gain` what all cores gain for one match.
const VERTICES_PER_CORE: f64 = 4_000.0;
/// The same for methods that fit a field, or minimize the energy on coarse levels: the rest of their work grows with the number of vertices,
/// not with the product of the two numbers.
const VERTICES_PER_CORE_COARSE: f64 = 20_000.0;

/// The predicted demand of a match with these parameters.
pub(crate) fn predict(parameters: &MatchParameters, source: SurfaceSize, target: SurfaceSize) -> Demand {
    let (vertices, faces) = (source.n_vertices as usize, source.n_faces as usize);
    let memory_bytes = match_memory_bytes((vertices, faces), target.n_vertices as usize, parameters);
    let size = (f64::from(source.n_vertices) * f64::from(target.n_vertices)).sqrt();
    let cores = match parameters.inference.algorithm {
        // Registration alone is short.
        Algorithm::None if parameters.displacement.mode != DisplacementMode::Smooth => 1,
        _ if parameters.inference.coarse_vertices.is_some() => ((size / VERTICES_PER_CORE_COARSE) as usize).max(1),
        _ => ((size / VERTICES_PER_CORE) as usize).max(1),
    };
    Demand { cores, memory_bytes, processor_time: price(parameters, source, target).processor_time }
}

fn price(parameters: &MatchParameters, source: SurfaceSize, target: SurfaceSize) -> Price {
    match_price(parameters, (source.n_vertices as usize, source.n_faces as usize), target.n_vertices as usize)
}

/// Why a match is refused that costs too much: the numbers, and what to change.
pub(crate) fn too_dear(
    parameters: &MatchParameters,
    source: SurfaceSize,
    target: SurfaceSize,
    exceeded: Exceeded,
) -> String {
    let what = format!("a match of {} to {} vertices with these parameters", source.n_vertices, target.n_vertices);
    exceeded.said_of(&what, price(parameters, source, target).advice)
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_contract::parameters::{Method, preset};

    fn cores(method: Method, source: u32, target: u32) -> usize {
        let size = |n_vertices| SurfaceSize { n_vertices, n_faces: 2 * n_vertices - 4 };
        predict(&preset(method), size(source), size(target)).cores
    }

    #[test]
    fn small_pairs_take_one_core_and_larger_ones_more() {
        let sizes = [4, 600, 2_500, 10_000, 40_000, 160_000];
        let of = |method| -> Vec<_> { sizes.iter().map(|&n| cores(method, n, n)).collect() };
        assert_eq!(of(Method::Thesis), [1, 1, 1, 2, 10, 40]);
        assert_eq!(of(Method::Balanced), [1, 1, 1, 1, 2, 8]);
    }

    #[test]
    fn the_demand_of_cores_is_symmetric_in_the_two_surfaces() {
        for (source, target) in [(40_000, 100), (1_000, 64_000), (5_000, 20_000)] {
            let [one, other] = [(source, target), (target, source)].map(|(s, t)| cores(Method::Balanced, s, t));
            assert_eq!(one, other);
        }
    }

    #[test]
    fn registration_alone_takes_one_core() {
        for method in Method::ALL {
            let is_alone = preset(method).inference.algorithm == Algorithm::None && method != Method::Balanced;
            assert_eq!(cores(method, 50_000, 50_000) == 1, is_alone, "{}", method.name());
        }
    }
}
