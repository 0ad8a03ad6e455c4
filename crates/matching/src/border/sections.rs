//! Moments of the sections of a closed surface across its long axis.
//!
//! The frame is that of the principal axes of the volume inside: `s` along the longest, `m` along the middle, `h` along
//! the shortest, mm from its center. Sections are slabs of Gaussian profile around the planes `s − t h = u`, because the
//! border that raters draw lies in such a plane; the area and the moments of each are features.

use super::weights::TILT;
use homolog_mesh::SurfaceMesh;
use homolog_registration::{principal_directions, weighted_moments};
use nalgebra::{Matrix3, Point3, Vector3};
use std::f64::consts::TAU;

/// Positions of the sections, mm along the axis, and the standard deviation of each.
const FIRST_MM: f64 = -18.0;
const STEP_MM: f64 = 1.5;
const N_SECTIONS: usize = 25;
const WIDTH_MM: f64 = 1.2;
/// Numbers of each section: area, two means, three second and two third moments.
const N_MOMENTS: usize = 8;
/// Numbers of a profile.
pub(super) const N_FEATURES: usize = N_SECTIONS * N_MOMENTS;

/// Layers of points from the center outwards.
const LAYERS: usize = 12;
/// The volume is first sorted into bins along `u`: from their sums the sections of every orientation follow.
const BIN_MM: f64 = 0.25;
const REACH_MM: f64 = 24.0;
const N_BINS: usize = 193;
/// Powers of `m` and of `h` whose sums a bin holds.
const POWERS: [(i32, i32); N_MOMENTS] = [(0, 0), (1, 0), (0, 1), (2, 0), (0, 2), (1, 1), (3, 0), (0, 3)];
/// Least area, mm², and variances, mm², so that a section beyond the tips has finite features.
const LEAST_AREA: f64 = 1.0;
const LEAST_VARIANCE: f64 = 0.3;
const LEAST_SKEWED: f64 = 1.0;

/// Which way each principal axis points: three signs.
pub(super) type Signs = [f64; 3];

/// All eight.
pub(super) const ORIENTATIONS: [Signs; 8] = {
    const P: f64 = 1.0;
    const N: f64 = -1.0;
    [[P, P, P], [P, P, N], [P, N, P], [P, N, N], [N, P, P], [N, P, N], [N, N, P], [N, N, N]]
};

/// Sums over the volume in bins along `u`.
type Bins = Vec<[f64; N_MOMENTS]>;

/// The sections of one surface.
pub(super) struct Sections {
    center: Point3<f64>,
    /// Principal axes as columns, longest first.
    pub axes: Matrix3<f64>,
    /// For planes of tilt `−t` and `t`.
    leaning: [Bins; 2],
}

impl Sections {
    /// The sections of a closed `mesh`, mm. `None` where it encloses no volume.
    ///
    /// Cost `O(n)`, about a microsecond a triangle.
    pub(super) fn new(mesh: &SurfaceMesh) -> Option<Sections> {
        let (points, volumes) = interior_points(mesh);
        let total: f64 = volumes.iter().sum();
        let (center, scatter) = weighted_moments(&points, &volumes, total)?;
        let covariance = scatter / total;
        // Also `None` where the volume is too small to divide by.
        if !covariance.iter().all(|c| c.is_finite()) || covariance.trace() <= 0.0 {
            return None;
        }
        let axes = principal_directions(&covariance);
        // The volume of a surface whose faces are oriented inwards is negative.
        let volumes: Vec<f64> = volumes.iter().map(|w| w * total.signum()).collect();
        let mut found = Sections { center: center.into(), axes, leaning: [Vec::new(), Vec::new()] };
        found.leaning = [-TILT, TILT].map(|lean| found.bins(&points, &volumes, lean));
        Some(found)
    }

    /// `s, m, h` of `point`, mm, where the axes point as `signs` say.
    pub(super) fn coordinates(&self, signs: Signs, point: &Point3<f64>) -> [f64; 3] {
        let along = self.axes.tr_mul(&(point - self.center));
        std::array::from_fn(|k| signs[k] * along[k])
    }

    /// The features of all sections from the tail on, where the axes point as `signs` say: the logarithm of each area
    /// (mm²), the means of `m` and `h` (mm), the logarithms of their variances (mm²), their covariance (mm²), and the
    /// skewness of either; of one kind all sections, then those of the next.
    pub(super) fn profile(&self, signs: Signs) -> Vec<f64> {
        let bins = &self.leaning[usize::from(signs[0] * signs[2] < 0.0)];
        let mut features = vec![0.0; N_FEATURES];
        for section in 0..N_SECTIONS {
            let at = signs[0] * (FIRST_MM + STEP_MM * section as f64);
            let mut sums = [0.0; N_MOMENTS];
            for (k, bin) in bins.iter().enumerate() {
                let away = (k as f64 * BIN_MM - REACH_MM - at) / WIDTH_MM;
                let kernel = (-0.5 * away * away).exp() / (WIDTH_MM * TAU.sqrt());
                for (sum, value) in sums.iter_mut().zip(bin) {
                    *sum += kernel * value;
                }
            }
            for (sum, (m, h)) in sums.iter_mut().zip(POWERS) {
                *sum *= signs[1].powi(m) * signs[2].powi(h);
            }
            for (kind, value) in moments(sums).into_iter().enumerate() {
                features[kind * N_SECTIONS + section] = value;
            }
        }
        features
    }

    /// The sums of every bin along `s + lean · h`, each point shared between the two bins around it.
    fn bins(&self, points: &[Point3<f64>], volumes: &[f64], lean: f64) -> Bins {
        let mut bins = vec![[0.0; N_MOMENTS]; N_BINS];
        for (point, volume) in points.iter().zip(volumes) {
            let [s, m, h] = self.coordinates([1.0; 3], point);
            let at = (s + lean * h + REACH_MM) / BIN_MM;
            if at < 0.0 || at >= (N_BINS - 1) as f64 {
                continue;
            }
            let share = at.fract();
            let values = POWERS.map(|(p, q)| volume * m.powi(p) * h.powi(q));
            for (bin, part) in [(at as usize, 1.0 - share), (at as usize + 1, share)] {
                for (sum, value) in bins[bin].iter_mut().zip(values) {
                    *sum += part * value;
                }
            }
        }
        bins
    }
}

/// The features of a section from its sums.
fn moments(sums: [f64; N_MOMENTS]) -> [f64; N_MOMENTS] {
    let area = sums[0].max(LEAST_AREA);
    let [one, m, h, mm, hh, mh, mmm, hhh] = sums.map(|sum| sum / area);
    let third = |mean: f64, second: f64, third: f64| {
        third - 3.0 * mean * second + 2.0 * mean.powi(3) + (1.0 - one) * mean.powi(3)
    };
    let (var_m, var_h) = (mm - m * m, hh - h * h);
    [
        area.ln(),
        m,
        h,
        var_m.max(LEAST_VARIANCE).ln(),
        var_h.max(LEAST_VARIANCE).ln(),
        mh - m * h,
        third(m, mm, mmm) / var_m.max(LEAST_SKEWED).powf(1.5),
        third(h, hh, hhh) / var_h.max(LEAST_SKEWED).powf(1.5),
    ]
}

/// Points inside a closed surface and the volume that each stands for, mm³: the tetrahedra between its triangles and the
/// mean of its vertices, cut into layers.
fn interior_points(mesh: &SurfaceMesh) -> (Vec<Point3<f64>>, Vec<f64>) {
    let vertices = mesh.vertices();
    let middle = vertices.iter().fold(Vector3::zeros(), |sum, p| sum + p.coords) / vertices.len() as f64;
    let mut points = Vec::with_capacity(LAYERS * mesh.n_faces());
    let mut volumes = Vec::with_capacity(LAYERS * mesh.n_faces());
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|k| vertices[k as usize].coords - middle);
        let (volume, centroid) = (a.dot(&b.cross(&c)) / 6.0, (a + b + c) / 3.0);
        for layer in 0..LAYERS {
            let (inner, outer) = (layer as f64 / LAYERS as f64, (layer + 1) as f64 / LAYERS as f64);
            let share = outer.powi(3) - inner.powi(3);
            points.push(Point3::from(middle + centroid * 0.75 * (outer.powi(4) - inner.powi(4)) / share));
            volumes.push(volume * share);
        }
    }
    (points, volumes)
}
