//! Sets of points in space: an even sample ([`FarthestPoints`], [`farthest_points`]) and all neighbors within a radius
//! ([`NeighborGrid`]). Lengths in mm.

mod farthest;
mod neighbors;
#[cfg(test)]
mod tests;

pub use farthest::{FarthestPoints, farthest_points};
pub use neighbors::NeighborGrid;
