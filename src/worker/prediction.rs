//! What a match is predicted to take: cores by its method and the sizes of its surfaces, memory as `matching` counts it.

use crate::jobs::{Demand, SurfaceSize};
use crate::matching::parameters::{Algorithm, MatchParameters};
use crate::run::match_memory_bytes;

/// Vertices of a surface for each core that a match gains from; of two surfaces, the geometric mean.
pub const VERTICES_PER_CORE: f64 = 4_000.0;

/// What a match with these parameters takes of a machine.
pub fn predict(parameters: &MatchParameters, source: SurfaceSize, target: SurfaceSize) -> Demand {
    let (vertices, faces) = (source.n_vertices as usize, source.n_faces as usize);
    let memory_bytes = match_memory_bytes((vertices, faces), target.n_vertices as usize);
    let size = (f64::from(source.n_vertices) * f64::from(target.n_vertices)).sqrt();
    let cores = match parameters.inference.algorithm {
        // Registration alone is over in a moment.
        Algorithm::None => 1,
        _ => ((size / VERTICES_PER_CORE) as usize).max(1),
    };
    Demand { cores, memory_bytes }
}
