//! A surface as displacement sees it: slightly smoothed, with curvature features as numbers of comparable size.

use crate::curvature::{ScaleSpace, gaussian_curvature, mean_curvature, vertex_areas};
use crate::deformation::Samples;
use crate::matching::MatchError;
use crate::mesh::SurfaceMesh;
use nalgebra::{Point3, Vector3};

/// Scales of the features, mm: finer than those that find the pose, because the poses are close already.
const FEATURE_SCALES_MM: [f64; 3] = [1.0, 2.0, 3.5];
/// Gaussian and mean curvature at each scale.
pub(super) const N_FEATURES: usize = 2 * FEATURE_SCALES_MM.len();
/// Features count up to this many robust standard deviations from the median.
const FEATURE_CAP: f64 = 3.0;
/// Scale of the positions that fields and rigid transforms are fitted to, mm: takes off the steps that voxels leave.
const POSITION_SCALE_MM: f64 = 0.7;
/// Scale of the normals, mm.
const NORMAL_SCALE_MM: f64 = 1.0;

/// One surface, prepared.
pub(super) struct SmoothSurface {
    /// Positions at [`POSITION_SCALE_MM`].
    pub mesh: SurfaceMesh,
    /// Unit normals of its vertices.
    pub normals: Vec<Vector3<f64>>,
    /// Area of each vertex, mm².
    pub areas: Vec<f64>,
    /// `n × N_FEATURES`.
    pub features: Vec<f64>,
}

/// Every `k`-th vertex of a surface, with the area of all.
pub(super) struct Thinned {
    /// Which.
    pub vertices: Vec<usize>,
    pub points: Vec<Point3<f64>>,
    pub normals: Vec<Vector3<f64>>,
    pub areas: Vec<f64>,
    pub features: Vec<f64>,
}

/// Both surfaces; features are brought to the median and the median absolute deviation of both together.
///
/// # Errors
/// [`MatchError::ScaleSpace`].
pub(super) fn prepare(
    source: &SurfaceMesh,
    target: &SurfaceMesh,
) -> Result<(SmoothSurface, SmoothSurface), MatchError> {
    let (a, b) = rayon::join(|| SmoothSurface::new(source), || SmoothSurface::new(target));
    let ((mut a, a_values), (mut b, b_values)) = (a?, b?);
    for (feature, (of_a, of_b)) in a_values.iter().zip(&b_values).enumerate() {
        let mut all: Vec<f64> = of_a.iter().chain(of_b).copied().collect();
        let center = median(&mut all);
        all.iter_mut().for_each(|x| *x = (*x - center).abs());
        // A sphere has the same curvature everywhere: then the feature says nothing, and nothing is divided by 0.
        let scale = (1.4826 * median(&mut all)).max(f64::MIN_POSITIVE.sqrt());
        for (values, side) in [(of_a, &mut a), (of_b, &mut b)] {
            for (i, x) in values.iter().enumerate() {
                side.features[i * N_FEATURES + feature] = ((x - center) / scale).clamp(-FEATURE_CAP, FEATURE_CAP);
            }
        }
    }
    Ok((a, b))
}

/// The middle of `values` in ascending order, the upper one of two; orders them partly.
pub(super) fn median(values: &mut [f64]) -> f64 {
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

impl SmoothSurface {
    /// The surface without features, and their values as they are.
    fn new(mesh: &SurfaceMesh) -> Result<(Self, Vec<Vec<f64>>), MatchError> {
        let flow = ScaleSpace::new(mesh);
        let at = |scale_mm: f64| flow.smoothed(scale_mm).map_err(|_| MatchError::ScaleSpace { scale_mm });
        let mut values = Vec::with_capacity(N_FEATURES);
        for scale_mm in FEATURE_SCALES_MM {
            let smoothed = at(scale_mm)?;
            values.push(mean_curvature(&smoothed));
            values.push(gaussian_curvature(&smoothed));
        }
        let surface = SmoothSurface {
            mesh: at(POSITION_SCALE_MM)?,
            normals: at(NORMAL_SCALE_MM)?.vertex_normals(),
            areas: vertex_areas(mesh),
            features: vec![0.0; mesh.n_vertices() * N_FEATURES],
        };
        Ok((surface, values))
    }

    pub fn samples(&self) -> Samples<'_> {
        Samples { points: self.mesh.vertices(), normals: &self.normals, areas: &self.areas, features: &self.features }
    }

    /// At most `n` vertices. Canonical numbering follows a curve through space, so every `k`-th is an even sample.
    pub fn thinned(&self, n: usize) -> Thinned {
        let step = self.mesh.n_vertices().div_ceil(n);
        let picked = || (0..self.mesh.n_vertices()).step_by(step);
        Thinned {
            vertices: picked().collect(),
            points: picked().map(|i| self.mesh.vertices()[i]).collect(),
            normals: picked().map(|i| self.normals[i]).collect(),
            areas: picked().map(|i| self.areas[i] * step as f64).collect(),
            features: picked().flat_map(|i| self.features[i * N_FEATURES..][..N_FEATURES].to_vec()).collect(),
        }
    }
}

impl Thinned {
    pub fn samples(&self) -> Samples<'_> {
        Samples { points: &self.points, normals: &self.normals, areas: &self.areas, features: &self.features }
    }
}
