//! Feedback from registration to the energy.
//!
//! **Hard** clamping (thesis, section 5.6): the unary potential of an inlier variable becomes 0 at its label and `T`
//! elsewhere. **Soft** clamping adds to every unary potential terms for the distance of the registered vertex from the
//! label and for the angle between their normals.

use homolog_registration::RigidTransform;
use nalgebra::{Point3, Vector3};

/// Weights of soft clamping: `λ·min(‖R p_i + t − p'_x‖²/σ_g², τ_g) + ν·(1 − ⟨R n_i, n'_x⟩)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SoftWeights {
    /// `λ`.
    pub distance: f64,
    /// `σ_g`, mm.
    pub sigma_mm: f64,
    /// `τ_g`.
    pub cap: f64,
    /// `ν`.
    pub normal: f64,
}

/// The target side of soft clamping in 32 bits, one array per coordinate, so that the loop over labels vectorizes.
pub(crate) struct SoftClamp {
    weights: SoftWeights,
    source: Vec<([f32; 3], [f32; 3])>,
    position: [Vec<f32>; 3],
    normal: [Vec<f32>; 3],
}

impl SoftClamp {
    /// Feedback of `transform` for source and target vertices (mm) with their unit normals.
    pub(crate) fn new(
        weights: SoftWeights,
        transform: &RigidTransform,
        source: (&[Point3<f64>], &[Vector3<f64>]),
        target: (&[Point3<f64>], &[Vector3<f64>]),
    ) -> Self {
        // A reflection reverses the orientation of faces; normals follow the mirrored surface.
        let outwards = if transform.is_reflection() { -1.0 } else { 1.0 };
        // Relative to the first target vertex, so that 32 bits represent differences of large coordinates.
        let origin = target.0.first().map_or(Vector3::zeros(), |p| p.coords);
        let narrow = |v: Vector3<f64>| [v.x as f32, v.y as f32, v.z as f32];
        let axis = |values: &mut dyn Iterator<Item = Vector3<f64>>| {
            let all: Vec<[f32; 3]> = values.map(narrow).collect();
            std::array::from_fn(|k| all.iter().map(|v| v[k]).collect())
        };
        SoftClamp {
            weights,
            source: source
                .0
                .iter()
                .zip(source.1)
                .map(|(p, n)| (narrow(transform.apply(p).coords - origin), narrow(transform.rotation * n * outwards)))
                .collect(),
            position: axis(&mut target.0.iter().map(|p| p.coords - origin)),
            normal: axis(&mut target.1.iter().copied()),
        }
    }

    /// Adds the feedback of variable `i` to its row of unary potentials.
    pub(crate) fn add(&self, i: usize, row: &mut [f32]) {
        let (p, n) = self.source[i];
        let scale = (self.weights.distance / (self.weights.sigma_mm * self.weights.sigma_mm)) as f32;
        let cap = (self.weights.distance * self.weights.cap) as f32;
        let normal_weight = self.weights.normal as f32;
        let [px, py, pz] = &self.position;
        let [nx, ny, nz] = &self.normal;
        for (x, theta) in row.iter_mut().enumerate() {
            let (dx, dy, dz) = (px[x] - p[0], py[x] - p[1], pz[x] - p[2]);
            let distance = scale * (dx * dx + dy * dy + dz * dz);
            let agreement = nx[x] * n[0] + ny[x] * n[1] + nz[x] * n[2];
            *theta += if distance < cap { distance } else { cap } + normal_weight * (1.0 - agreement);
        }
    }
}

/// Fixes the row of an inlier variable to its label: 0 there, `T` elsewhere.
pub(crate) fn clamp_hard(label: u32, truncation: f64, row: &mut [f32]) {
    row.fill(truncation as f32);
    row[label as usize] = 0.0;
}
