//! The memory of a match, estimated before it begins.

use crate::comparison::field_methods;
use crate::surface::form::BendingInvariantForm;
use crate::surface::levels::Levels;
use homolog_contract::parameters::{Algorithm, Bending, DisplacementMode, FeatureKind, MatchParameters};

/// Memory of the levels of a surface, bytes per vertex: two meshes, normals, trees of closest points, features.
const BYTES_PER_VERTEX: u64 = 640;

/// Memory of a displacement field besides the levels, bytes: its functions, and their matrices.
const BYTES_OF_FIELD: u64 = 14 << 20;

/// Memory of a displacement field for each vertex of the level that it is fitted on, bytes.
const BYTES_PER_FITTED_VERTEX: u64 = 500;

/// Memory of a displacement field for each vertex of the source: its images, and the levels and images of the source
/// at the size of the target. Always counted, as the numbers of vertices do not show whether sizes differ.
const BYTES_PER_MOVED_VERTEX: u64 = 1350;

/// Memory of a displacement field for each vertex of the target, bytes.
const BYTES_PER_TARGET_VERTEX: u64 = 500;

/// Memory of a source that has a level of its own for the field, bytes.
const BYTES_OF_MIDDLE: u64 = 5 << 20;

/// Memory of belief propagation over distances along the surface on two threads, bytes. The tables of a start take 8
/// MiB (about 1,900 edges, 32 active labels at either end, 32 bits), and each further thread runs one more start.
const BYTES_OF_NEAR_ISOMETRIES: u64 = 16 << 20;

/// Memory of belief propagation for each label and each label within the neighborhood radius of it, bytes.
const BYTES_PER_NEAR_LABEL: u64 = 144;

/// Vectors of a surface during the computation of its lowest 80 eigenfunctions: a Krylov basis of 208 and its images,
/// as matrices and in products, the functions with their images, and signatures.
const SPECTRAL_VECTORS: u64 = 6 * 208 + 3 * 80;

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

/// Peak memory of a match of surfaces of these sizes on two threads, bytes; `source` is the number of vertices and
/// faces. At least what it takes, and at most twice that, for surfaces whose sizes differ (`tests/memory.rs`).
///
/// Not counted: the files and the result, and the scratch space for matrix products that each thread keeps, which
/// depends on the processor.
///
/// The levels of both surfaces are held while the parts of a match follow each other: the energy, a published method,
/// and the field or, for answers without one, the second opinion, which makes levels of its own.
pub fn match_memory_bytes(source: (usize, usize), target_vertices: usize, parameters: &MatchParameters) -> u64 {
    let (vertices, labels) = (source.0 as u64, target_vertices as u64);
    let levels = BYTES_PER_VERTEX * (vertices + labels);
    let of_field = match parameters.displacement.mode {
        DisplacementMode::Smooth => field_bytes(vertices, labels, parameters.displacement.bending),
        _ => levels + field_bytes(vertices, labels, Bending::NearIsometry),
    };
    let of_method = field_methods::limits(parameters.displacement.mode)
        .map_or(0, |(most, bytes)| bytes * (vertices.min(most as u64) + labels.min(most as u64)));
    let energy = EnergyBytes::of(source, target_vertices, parameters);
    // A field is fitted while the messages are still held.
    let held = if parameters.displacement.mode == DisplacementMode::Smooth { energy.most } else { energy.held };
    levels + (held + of_field.max(of_method)).max(energy.most)
}

/// Memory of a displacement field between surfaces of these numbers of vertices besides their levels, bytes.
fn field_bytes(vertices: u64, labels: u64, bending: Bending) -> u64 {
    let fitted = |n: u64| Levels::n_measured(n as usize, Some(1)) as u64;
    let of_middle = if fitted(vertices) < vertices { BYTES_OF_MIDDLE } else { 0 };
    let of_distances = if bending == Bending::NearIsometry {
        let form = |n: u64| BendingInvariantForm::heap_bytes_over(n as usize) as u64;
        form(vertices) + form(labels) + BYTES_OF_NEAR_ISOMETRIES
    } else {
        0
    };
    BYTES_OF_FIELD
        + BYTES_PER_FITTED_VERTEX * (fitted(vertices) + fitted(labels))
        + BYTES_PER_MOVED_VERTEX * vertices
        + BYTES_PER_TARGET_VERTEX * labels
        + of_middle
        + of_distances
}

/// Memory of the energy over features besides the levels, bytes.
#[derive(Default)]
struct EnergyBytes {
    /// During its minimization: descriptors of many channels, two tables of unary potentials, and the messages.
    most: u64,
    /// Afterwards, until the end of the match: a table of unary potentials.
    held: u64,
}

impl EnergyBytes {
    fn of(source: (usize, usize), target_vertices: usize, parameters: &MatchParameters) -> Self {
        let (mut vertices, faces, mut labels) = (source.0 as u64, source.1 as u64, target_vertices as u64);
        let n_measured = |n: u64| Levels::n_measured(n as usize, parameters.inference.coarse_vertices) as u64;
        let described = 8 * described_numbers(parameters) * (n_measured(vertices) + n_measured(labels));
        // A closed surface of genus 0 has `V + F − 2` edges.
        let mut directed_edges = 2 * (vertices + faces).saturating_sub(2);
        if let Some(coarse) = parameters.inference.coarse_vertices.map(u64::from) {
            labels = labels.min(coarse);
            if coarse < vertices {
                (vertices, directed_edges) = (coarse, 6 * coarse);
            }
        }
        let table = 4 * vertices * labels;
        let of_messages = match parameters.inference.algorithm {
            Algorithm::None => return EnergyBytes::default(),
            Algorithm::Gibbs | Algorithm::Metropolis | Algorithm::LasVegas => 0,
            Algorithm::MaxProduct | Algorithm::SumProduct | Algorithm::TreeReweighted => {
                let rings = u64::from(parameters.energy.neighborhood_rings);
                let near = (1 + 3 * rings * (rings + 1)).min(labels);
                // A quarter more for the messages that are read while they are replaced.
                4 * (directed_edges + directed_edges / 4) * labels + BYTES_PER_NEAR_LABEL * near * labels
            }
        };
        EnergyBytes { most: described + 2 * table + of_messages, held: table }
    }
}
