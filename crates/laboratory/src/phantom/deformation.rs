//! Known deformations and poses: the pointwise map between the two phantoms of a pair.

use super::PhantomError;
use super::random::{Draws, Stream};
use nalgebra::{Isometry3, Matrix3, Point3, Quaternion, Translation3, UnitQuaternion, Vector3};

/// Number of Gaussian bumps in a deformation.
const N_BUMPS: usize = 12;
/// Least Jacobian determinant of a deformation at its sample points, which keeps it away from folding.
pub const MIN_JACOBIAN: f64 = 0.1;
/// Largest RMS displacement, as a share of the diagonal of the bounding box.
pub const MAX_RMS_SHARE: f64 = 0.15;

/// A smooth displacement field `u(p) = Σ a_k exp(−‖p − c_k‖² / 2 w²)`; the deformation is `p + u(p)`.
#[derive(Debug, Clone, PartialEq)]
pub struct Deformation {
    centers: Vec<Point3<f64>>,
    amplitudes: Vec<Vector3<f64>>,
    width_mm: f64,
    rms_mm: f64,
}

impl Deformation {
    /// A deformation of the surface with these vertices. It preserves orientation, and its RMS displacement over the
    /// vertices is `rms_share` of the diagonal of their bounding box.
    ///
    /// Draws per bump: the vertex at its center, then its direction. The width starts at 0.22 of the diagonal and grows
    /// by a quarter until the Jacobian determinant is above [`MIN_JACOBIAN`] at every vertex and on a grid over the
    /// box; strong deformations are therefore smoother.
    ///
    /// # Errors
    /// [`PhantomError::ShareOutOfRange`]; [`PhantomError::Folds`] if no width suffices; [`PhantomError::NoVertices`].
    pub fn new(vertices: &[Point3<f64>], rms_share: f64, seed: u64) -> Result<Self, PhantomError> {
        if !(0.0..=MAX_RMS_SHARE).contains(&rms_share) {
            return Err(PhantomError::ShareOutOfRange { rms_share });
        }
        if vertices.is_empty() {
            return Err(PhantomError::NoVertices);
        }
        let mut draws = Draws::new(Stream::Deformation, seed);
        let mut centers = Vec::with_capacity(N_BUMPS);
        let mut directions = Vec::with_capacity(N_BUMPS);
        for _ in 0..N_BUMPS {
            centers.push(vertices[draws.below(vertices.len() as u64) as usize]);
            directions.push(draws.normal_vector());
        }
        let infinity = Point3::from([f64::INFINITY; 3]);
        let (low, high) = vertices.iter().fold((infinity, -infinity), |(l, h), p| (l.inf(p), h.sup(p)));
        let diagonal = (high - low).norm();
        let mut probes = vertices.to_vec();
        const GRID: u32 = 12;
        for k in 0..GRID.pow(3) {
            let share = Vector3::new(k % GRID, k / GRID % GRID, k / GRID / GRID).map(|c| f64::from(c) / 11.0);
            probes.push(low + (high - low).component_mul(&share));
        }
        let mut width_mm = 0.22 * diagonal;
        for _ in 0..8 {
            let unit = Deformation { centers: centers.clone(), amplitudes: directions.clone(), width_mm, rms_mm: 0.0 };
            let squares: f64 = vertices.iter().map(|p| unit.displacement(p).norm_squared()).sum();
            let rms = (squares / vertices.len() as f64).sqrt();
            let rms_mm = rms_share * diagonal;
            let scale = rms_mm / rms.max(f64::MIN_POSITIVE);
            let scaled = Deformation { amplitudes: directions.iter().map(|a| a * scale).collect(), rms_mm, ..unit };
            if probes.iter().all(|p| scaled.jacobian_determinant(p) > MIN_JACOBIAN) {
                return Ok(scaled);
            }
            width_mm *= 1.25;
        }
        Err(PhantomError::Folds { rms_share })
    }

    /// The image of `p` under the deformation.
    pub fn apply(&self, p: &Point3<f64>) -> Point3<f64> {
        p + self.displacement(p)
    }

    /// The point whose image is `q`, by Newton's method from `q`. `None` if it does not converge, as may happen far
    /// outside the surface.
    pub fn invert(&self, q: &Point3<f64>) -> Option<Point3<f64>> {
        let mut p = *q;
        for _ in 0..50 {
            let residual = self.apply(&p) - q;
            if residual.norm() < 1e-9 {
                return Some(p);
            }
            let step = self.jacobian(&p).lu().solve(&residual)?;
            // Steps longer than half a width would leave the region in which the linear model holds.
            p -= step * (0.5 * self.width_mm / step.norm().max(f64::MIN_POSITIVE)).min(1.0);
        }
        None
    }

    /// Determinant of the derivative of `p + u(p)`; positive where orientation is preserved.
    pub fn jacobian_determinant(&self, p: &Point3<f64>) -> f64 {
        self.jacobian(p).determinant()
    }

    /// RMS displacement over the vertices passed to [`Self::new`], mm.
    pub fn rms_mm(&self) -> f64 {
        self.rms_mm
    }

    /// Width of a bump, mm.
    pub fn width_mm(&self) -> f64 {
        self.width_mm
    }

    fn displacement(&self, p: &Point3<f64>) -> Vector3<f64> {
        self.terms(p).map(|(a, _, g)| a * g).sum()
    }

    fn jacobian(&self, p: &Point3<f64>) -> Matrix3<f64> {
        let w2 = self.width_mm * self.width_mm;
        self.terms(p).fold(Matrix3::identity(), |j, (a, offset, g)| j - a * offset.transpose() * (g / w2))
    }

    fn terms(&self, p: &Point3<f64>) -> impl Iterator<Item = (&Vector3<f64>, Vector3<f64>, f64)> {
        let (p, w2) = (*p, self.width_mm * self.width_mm);
        self.centers.iter().zip(&self.amplitudes).map(move |(c, a)| {
            let offset = p - c;
            (a, offset, (-offset.norm_squared() / (2.0 * w2)).exp())
        })
    }
}

/// A rigid pose: a rotation drawn uniformly from all rotations, and a translation of up to 40 mm along each axis.
///
/// Four normals make the quaternion, three uniforms the translation.
pub fn random_pose(seed: u64) -> Isometry3<f64> {
    let mut draws = Draws::new(Stream::Pose, seed);
    let [w, i, j, k] = std::array::from_fn(|_| draws.normal());
    let [x, y, z] = std::array::from_fn(|_| draws.uniform(-40.0, 40.0));
    Isometry3::from_parts(Translation3::new(x, y, z), UnitQuaternion::new_normalize(Quaternion::new(w, i, j, k)))
}

/// A permutation of `0..n` drawn uniformly (Fisher and Yates): old index `k` becomes `permutation[k]`.
pub fn random_permutation(n: usize, seed: u64) -> Vec<u32> {
    let mut draws = Draws::new(Stream::Permutation, seed);
    let mut permutation: Vec<u32> = (0..n as u32).collect();
    for k in (1..n).rev() {
        permutation.swap(k, draws.below(k as u64 + 1) as usize);
    }
    permutation
}
