//! Local descriptors: at every vertex a list of numbers that describes the surface around it.
//!
//! [`shape_index()`] and [`curvedness()`] are functions of the curvatures. [`heat_kernel_signature()`] and
//! [`wave_kernel_signature()`] come from the spectrum. [`spin_images`], [`shape_contexts`], [`fpfh()`] and [`shot()`]
//! are histograms over a ball around the vertex. [`principal_components`] reduces the channels of two surfaces to a
//! few, by the same combinations on both.
//!
//! All descriptors are dimensionless and independent of size: the caller chooses the radius of a ball in proportion to
//! the surface. Samples are weighted by the area they represent, so that a finely sampled part does not count for more.
//! Scaling a surface and its radius by a power of two changes no bit. Every vertex is computed independently, so any
//! number of threads gives the same bits.

mod fpfh;
mod histogram;
mod principal;
mod samples;
mod shape_context;
mod shape_index;
mod shot;
mod signatures;
mod spin_image;
#[cfg(test)]
mod testing;

pub use fpfh::fpfh;
pub use principal::{Components, MAX_COMPONENTS, principal_components};
pub use shape_context::shape_contexts;
pub use shape_index::{curvedness, shape_index};
pub use shot::shot;
pub use signatures::{heat_kernel_signature, unit_spectrum, wave_kernel_signature};
pub use spin_image::spin_images;

use homolog_primitives::observe::{Cancelled, Observer, checkpoint_within};
use rayon::prelude::*;

/// Several dimensionless numbers at every vertex of a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Descriptor {
    /// Numbers per vertex.
    pub n_channels: usize,
    /// The numbers of vertex `i` start at index `i · n_channels`.
    pub values: Vec<f64>,
}

impl Descriptor {
    /// The `row` of each of `n` vertices, on all threads. Numbers that are not finite, such as those of a vertex
    /// without a normal, become 0. A ball may hold the whole surface, so `observer` is asked at every vertex.
    fn of_rows(
        n: usize,
        n_channels: usize,
        observer: &dyn Observer,
        row: impl Fn(usize, &mut [f64]) + Sync,
    ) -> Result<Self, Cancelled> {
        let mut values = vec![0.0; n * n_channels];
        values.par_chunks_mut(n_channels).enumerate().try_for_each(|(i, values)| {
            checkpoint_within(observer)?;
            row(i, values);
            values.iter_mut().filter(|v| !v.is_finite()).for_each(|v| *v = 0.0);
            Ok(())
        })?;
        Ok(Descriptor { n_channels, values })
    }

    /// Number of vertices.
    pub fn n_vertices(&self) -> usize {
        self.values.len() / self.n_channels.max(1)
    }

    /// The numbers of vertex `i`.
    pub fn row(&self, i: usize) -> &[f64] {
        &self.values[i * self.n_channels..(i + 1) * self.n_channels]
    }
}
