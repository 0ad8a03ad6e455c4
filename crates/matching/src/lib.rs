#![doc = include_str!("../README.md")]
#![cfg_attr(not(test), warn(clippy::disallowed_methods, clippy::disallowed_types))]

mod answer;
mod comparison;
mod energy;
mod error;
mod field;
mod machine;
mod memory;
mod pair;
mod pipeline;
mod poses;
mod starts;
mod surface;
#[cfg(test)]
mod testing;
#[cfg(test)]
mod tests;
mod thesis;

pub use answer::outcome::MatchOutcome;
pub use energy::near_isometry::{NearIsometryModel, near_isometry_model};
pub use error::MatchError;
pub use homolog_contract::parameters::{self, MatchParameters, Method, preset};
pub use homolog_contract::result;
pub use homolog_mesh::{FaceArity, MeshError, SurfaceMesh, shapes};
pub use homolog_primitives::observe::{Cancelled, Observer, Phase, Quantity, Silent, TracePoint};
pub use machine::read_caches;
pub use memory::match_memory_bytes;
pub use pipeline::{match_levels, match_surfaces};
pub use surface::levels::Levels;
pub use thesis::prepare::{coarse_energy_model, energy_model};
