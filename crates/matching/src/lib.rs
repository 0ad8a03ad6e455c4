//! Matches two surfaces: a dense correspondence and a rigid transform.
//!
//! A match runs in four stages, each of which hands an immutable value to the next:
//!
//! 1. **Coarse.** Builds the energy of labels on a coarse level of the surfaces, if one is asked for: a Markov random
//!    field over curvature in scale space, whose variables are source vertices and whose labels are target vertices.
//! 2. **Posed.** A minimizer finds a labeling; RANSAC finds the rigid transform that most of its pairs agree with;
//!    clamping feeds that transform back into the energy, round by round; ICP refines it. Registration alone finds a
//!    pose without an energy. By default the displacement field searches poses instead.
//! 3. **Displaced.** A smooth displacement field moves the source, from the pose that fits best after the deformation,
//!    and every source vertex gets an image on the target, between vertices. Without a field the images are vertices.
//! 4. **Measured.** Support, distances, outliers, topology, and the inverse map.
//!
//! The [`Method`]s are presets of [`MatchParameters`]: the minimizer, if any, and the work of each stage.
//!
//! ```
//! use homolog_matching::{Method, Silent, SurfaceMesh, match_surfaces, preset, shapes};
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let source: SurfaceMesh = shapes::ellipsoid([16.0, 8.0, 6.0].into(), 2);
//! let tapered = source.vertices().iter().map(|p| [p.x, p.y * (1.0 + 0.03 * p.x), p.z].into());
//! let target = source.with_vertices(tapered.collect())?;
//! let outcome = match_surfaces(&source, &target, &preset(Method::Balanced), &Silent)?;
//! println!("distance {:.2} mm, {:?}", outcome.surface_distance.mean_mm, outcome.transform.matrix);
//! for (source_vertex, target_vertex) in outcome.correspondences.source.iter().zip(&outcome.correspondences.target) {
//!     println!("{source_vertex} corresponds to {target_vertex}");
//! }
//! # Ok(())
//! # }
//! ```
//!
//! Parameters are checked by [`MatchParameters::check`], not by [`match_surfaces`]. An [`Observer`] is told phases,
//! progress and the energy trace, and may cancel. This crate reads no files, runs only on the threads of the current
//! rayon pool, and has a wire form only with its feature `serde`.

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
pub use answer::{consistency, outliers};
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
