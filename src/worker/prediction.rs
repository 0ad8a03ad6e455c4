//! What a match is predicted to take: cores by its method and the sizes of its surfaces, memory as `matching` counts it.

use crate::jobs::{Demand, SurfaceSize};
use homolog_contract::parameters::{Algorithm, MatchParameters};
use homolog_run::match_memory_bytes;

/// Vertices of a surface for each core that a match is given; of two surfaces, the geometric mean.
///
/// A choice between jobs an hour and the time of one: pairs of hippocampi at 1 mm, about 2,500 vertices each, come in
/// batches and run side by side; a large one is waited for and gets more. `make bench-service
/// PART=schedule-gain` measures what all cores are worth to one match, and is what to look at before changing this.
pub const VERTICES_PER_CORE: f64 = 4_000.0;
/// The same where the energy is that of coarse levels: the rest grows with the vertices, not with their product.
pub const VERTICES_PER_CORE_COARSE: f64 = 20_000.0;

/// What a match with these parameters takes of a machine.
pub fn predict(parameters: &MatchParameters, source: SurfaceSize, target: SurfaceSize) -> Demand {
    let (vertices, faces) = (source.n_vertices as usize, source.n_faces as usize);
    let memory_bytes = match_memory_bytes((vertices, faces), target.n_vertices as usize, parameters);
    let size = (f64::from(source.n_vertices) * f64::from(target.n_vertices)).sqrt();
    let cores = match parameters.inference.algorithm {
        // Registration alone is over in a moment.
        Algorithm::None => 1,
        _ if parameters.inference.coarse_vertices.is_some() => ((size / VERTICES_PER_CORE_COARSE) as usize).max(1),
        _ => ((size / VERTICES_PER_CORE) as usize).max(1),
    };
    Demand { cores, memory_bytes }
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
    fn small_pairs_take_a_core_and_larger_ones_more() {
        let sizes = [4, 600, 2_500, 10_000, 40_000, 160_000];
        let of = |method| -> Vec<_> { sizes.iter().map(|&n| cores(method, n, n)).collect() };
        assert_eq!(of(Method::Thesis), [1, 1, 1, 2, 10, 40]);
        assert_eq!(of(Method::Balanced), [1, 1, 1, 1, 2, 8]);
    }

    #[test]
    fn of_two_surfaces_both_count_whichever_moves() {
        for (source, target) in [(40_000, 100), (1_000, 64_000), (5_000, 20_000)] {
            let [one, other] = [(source, target), (target, source)].map(|(s, t)| cores(Method::Balanced, s, t));
            assert_eq!(one, other);
        }
    }

    #[test]
    fn registration_alone_takes_one_core() {
        for method in Method::ALL {
            let is_alone = preset(method).inference.algorithm == Algorithm::None;
            assert_eq!(cores(method, 50_000, 50_000) == 1, is_alone, "{}", method.name());
        }
    }
}
