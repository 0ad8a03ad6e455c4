//! The memory of a match, estimated before it begins.

use crate::comparison::field_methods;
use crate::surface::form::BendingInvariantForm;
use crate::surface::levels::Levels;
use homolog_contract::parameters::{Algorithm, Bending, DisplacementMode, FeatureKind, MatchParameters};

/// Memory of a match without messages for each vertex of either surface, bytes (568 MiB were measured at 2 × 155,000).
const BYTES_PER_VERTEX: u64 = 2048;

/// Memory for the source at the size of the target, bytes per source vertex (69 MB were measured at 86,709). Always
/// counted, as the numbers of vertices do not show whether sizes differ.
const BYTES_PER_RESIZED_VERTEX: u64 = 800;

/// Memory of belief propagation over distances along the surface on two threads, bytes (47 and 39 MiB were measured at
/// 2 × 5,000, with the forms of both surfaces). The tables of a start take 8 MiB (about 1,900 edges, 32 active labels
/// at either end, 32 bits), and each further thread runs one more start. Always counted, as the numbers of vertices do
/// not show whether surfaces bend.
const BYTES_OF_NEAR_ISOMETRIES: u64 = 44 << 20;

/// Vectors of a surface during the computation of its lowest 80 eigenfunctions: a Krylov basis of 208 and its images,
/// both as matrices, the functions with their images, and signatures.
const SPECTRAL_VECTORS: u64 = 4 * 208 + 3 * 80;

/// Numbers per vertex that descriptors hold during the measurement of features: all channels, and a copy if principal
/// components are computed.
fn described_numbers(parameters: &MatchParameters) -> u64 {
    let channels = |kind: FeatureKind| match kind {
        FeatureKind::SpinImage => 128,
        FeatureKind::ShapeContext => 90,
        FeatureKind::Fpfh => 2 * 33,
        FeatureKind::Shot => 352,
        FeatureKind::HeatKernelSignature | FeatureKind::WaveKernelSignature => 32,
        _ => 0,
    };
    let kinds = || parameters.features.iter().map(|feature| feature.kind);
    let is_spectral = |kind| matches!(kind, FeatureKind::HeatKernelSignature | FeatureKind::WaveKernelSignature);
    let all: u64 = kinds().map(channels).sum();
    let largest = kinds().map(channels).max().unwrap_or(0);
    all + largest + if kinds().any(is_spectral) { SPECTRAL_VECTORS } else { 0 }
}

/// Peak memory of a match of surfaces of these sizes, bytes; accurate to a tenth if messages dominate. `source` is the
/// number of vertices and faces.
///
/// On the level of the energy: the messages and a quarter of them again (those read while they are replaced), in 32 or
/// 16 bits, and two tables of unary potentials in 32; a share for each vertex; the memory of a published method for
/// each vertex of the thinned surfaces, of the bending-invariant forms, and of descriptors of many channels. A closed
/// surface of genus 0 has `V + F − 2` edges.
pub fn match_memory_bytes(source: (usize, usize), target_vertices: usize, parameters: &MatchParameters) -> u64 {
    let (mut vertices, faces, mut labels) = (source.0 as u64, source.1 as u64, target_vertices as u64);
    let of_method = field_methods::limits(parameters.displacement.mode)
        .map_or(0, |(most, bytes)| bytes * (vertices.min(most as u64) + labels.min(most as u64)));
    let bent = || {
        let form = |n_vertices: u64| BendingInvariantForm::heap_bytes_over(n_vertices as usize) as u64;
        form(vertices) + form(labels) + BYTES_OF_NEAR_ISOMETRIES
    };
    let of_field = BYTES_PER_RESIZED_VERTEX * vertices
        + match (parameters.displacement.mode, parameters.displacement.bending) {
            (DisplacementMode::Smooth, Bending::NearIsometry) => bent(),
            (DisplacementMode::Smooth, _) => 0,
            // The second opinion builds its own levels in addition to those of the answer.
            _ => BYTES_PER_VERTEX * (vertices + labels) + bent(),
        };
    let each = BYTES_PER_VERTEX * (vertices + labels) + of_field + of_method;
    if parameters.inference.algorithm == Algorithm::None {
        return each;
    }
    let n_measured = |n: u64| Levels::n_measured(n as usize, parameters.inference.coarse_vertices) as u64;
    let each = each + 8 * described_numbers(parameters) * (n_measured(vertices) + n_measured(labels));
    let mut directed_edges = 2 * (vertices + faces).saturating_sub(2);
    if let Some(coarse) = parameters.inference.coarse_vertices.map(u64::from) {
        labels = labels.min(coarse);
        if coarse < vertices {
            (vertices, directed_edges) = (coarse, 6 * coarse);
        }
    }
    each + (4 * (directed_edges + directed_edges / 4) + 4 * 2 * vertices) * labels
}
