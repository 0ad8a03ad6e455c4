//! The border between the anterior and the posterior part of a hippocampus, predicted from its shape, and a map that
//! respects it.
//!
//! Along a hippocampus the shape determines a smooth field poorly: at the border that raters draw behind the uncus, the maps
//! between 669 pairs of subjects were off by 1.7 mm (root mean square), no less than with rigid registration. Raters go by
//! the end of the uncus, which the moments of the sections across the long axis show, too. A linear model of these moments,
//! learned from labelled volumes, predicts the border of a subject outside the training set to 1.1 mm, where the mean
//! border of all subjects is off by 1.7 mm. The disagreement of a map with the predicted borders of source and target
//! estimates its error there; a share of it is corrected by sliding the images along the target.
//!
//! Only pairs whose sections resemble the training set are affected, and no image slides by more than [`MAX_SLIDE_MM`]. The
//! slide depends on shape: the head of a thicker subject is taken to reach further back. Studies that measure thickness can
//! turn the prior off (`displacement.anatomy: any`).

mod sections;
#[cfg(test)]
mod tests;
#[cfg_attr(feature = "left-out", path = "weights_left_out.rs")]
mod weights;

use homolog_geometry::curvature::vertex_areas;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use nalgebra::{Matrix3, Matrix4, Point3, Vector3, Vector4};
use rayon::prelude::*;
use sections::{ORIENTATIONS, Sections, Signs};
use weights::{FEATURES, MEAN_BORDER, TILT};

/// Root mean square of a profile's features, in standard deviations of the training set, above which the surface is not
/// taken for a hippocampus. In the training set the median is 0.95 and the largest value 1.97.
pub(crate) const MAX_DISTANCE: f64 = 2.2;
/// Least cosine between an axis of the source, rotated onto the target, and the same axis of the target.
const MIN_COSINE: f64 = 0.5;
/// Share of the disagreement that is corrected, of offsets and of slopes; by regression over 435 pairs of maps.
const SHARES: [f64; 2] = [0.6, 0.9];
/// Width of the weights around the source's border with which it is mapped to the target, mm.
const FOLLOW_MM: f64 = 3.0;
/// Most that an image slides, mm.
pub(crate) const MAX_SLIDE_MM: f64 = 3.0;
/// The slide fades away from this place, mm from the center towards the head, with this standard deviation.
const SLIDE_AT_MM: f64 = 2.0;
const SLIDE_WIDTH_MM: f64 = 10.0;

/// The model's prediction for one surface whose axes point as `signs` say.
#[derive(Clone, Copy)]
struct Reading {
    signs: Signs,
    /// Distance from the training set, in its standard deviations.
    distance: f64,
    /// The border is where `s = p₀ + p₁ m + t h`.
    border: [f64; 2],
}

impl Reading {
    fn new(sections: &Sections, signs: Signs) -> Reading {
        let (mut squares, mut border) = (0.0, MEAN_BORDER);
        for (value, [mean, inverse, offset, slope]) in sections.profile(signs).into_iter().zip(FEATURES) {
            let z = (value - mean) * inverse;
            squares += z * z;
            border[0] += z * offset;
            border[1] += z * slope;
        }
        Reading { signs, distance: (squares / FEATURES.len() as f64).sqrt(), border }
    }
}

/// One surface with the directions of its axes determined.
struct Body {
    sections: Sections,
    reading: Reading,
}

impl Body {
    fn coordinates(&self, point: &Point3<f64>) -> [f64; 3] {
        self.sections.coordinates(self.reading.signs, point)
    }

    /// Distance of `point` before the border, towards the head, mm along the long axis.
    fn before_border(&self, point: &Point3<f64>) -> f64 {
        let [s, m, h] = self.coordinates(point);
        s - self.reading.border[0] - self.reading.border[1] * m - TILT * h
    }
}

/// The slide of the images of a map along the long axis of the target.
pub(crate) struct Slide {
    target: Body,
    /// Distances of source and target from the training set, in its standard deviations.
    pub distances: [f64; 2],
    /// The slide at `m = 0` before it fades, mm towards the head, and what a millimetre of `m` adds.
    pub offset_mm: f64,
    pub slope: f64,
}

impl Slide {
    /// The slide that takes the border of `source`, mapped by `images` of its vertices (mm), nearer to that of `target`;
    /// `rotation` is the linear part of the rigid transform between them. `None` unless both resemble hippocampi whose axes
    /// correspond.
    ///
    /// Cost `O(n + n')`.
    pub(crate) fn new(
        source: &SurfaceMesh,
        target: &SurfaceMesh,
        images: &[Point3<f64>],
        rotation: &Matrix3<f64>,
    ) -> Option<Slide> {
        let (a, b) = rayon::join(|| Sections::new(source), || Sections::new(target));
        let (source_body, target_body) = oriented(a?, b?, rotation)?;
        let distances = [source_body.reading.distance, target_body.reading.distance];
        if distances.iter().any(|d| *d > MAX_DISTANCE) {
            return None;
        }
        let carried = carried_border(source, &source_body, &target_body, images)?;
        let [offset_mm, slope] = [0, 1].map(|k| SHARES[k] * (target_body.reading.border[k] - carried[k]));
        Some(Slide { target: target_body, distances, offset_mm, slope })
    }

    /// `images`, mm, each slid along the surface whose closest points are `closest`. Their distances from the surface stay.
    /// Cost `O(n log n')`.
    pub(crate) fn moved(&self, closest: &ClosestPointIndex, images: &[Point3<f64>]) -> Vec<Point3<f64>> {
        let axis: Vector3<f64> = self.target.sections.axes.column(0) * self.target.reading.signs[0];
        images
            .par_iter()
            .map(|image| {
                let slid = image + self.by_mm(image) * axis;
                image + (closest.closest(&slid).point - closest.closest(image).point)
            })
            .collect()
    }

    /// Root mean square slide of `images`, mm.
    pub(crate) fn rms_mm(&self, images: &[Point3<f64>]) -> f64 {
        let squares: f64 = images.iter().map(|p| self.by_mm(p).powi(2)).sum();
        (squares / images.len().max(1) as f64).sqrt()
    }

    /// Slide of a point of the target, mm towards the head.
    fn by_mm(&self, image: &Point3<f64>) -> f64 {
        let [s, m, _] = self.target.coordinates(image);
        let away = (s - SLIDE_AT_MM) / SLIDE_WIDTH_MM;
        (self.offset_mm + self.slope * m).clamp(-MAX_SLIDE_MM, MAX_SLIDE_MM) * (-0.5 * away * away).exp()
    }
}

/// Both surfaces with the directions of their axes such that both together are closest to the training set, where those of
/// the target follow those of the source under `rotation`. `None` where the axes do not correspond.
fn oriented(source: Sections, target: Sections, rotation: &Matrix3<f64>) -> Option<(Body, Body)> {
    let cosines = [0, 1, 2].map(|k| (rotation * source.axes.column(k)).normalize().dot(&target.axes.column(k)));
    if !cosines.iter().all(|c| c.abs() >= MIN_COSINE) {
        return None;
    }
    let readings = ORIENTATIONS.map(|signs| {
        let of_target = std::array::from_fn(|k| signs[k] * cosines[k].signum());
        (Reading::new(&source, signs), Reading::new(&target, of_target))
    });
    let distance = |(a, b): &(Reading, Reading)| a.distance.powi(2) + b.distance.powi(2);
    let (a, b) = readings.into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    Some((Body { sections: source, reading: a }, Body { sections: target, reading: b }))
}

/// Offset and slope of the plane in the target to which the border of the source is mapped: weighted least squares of
/// `s' = c₀ + c₁ m' + c₂ h' + c₃ r` over the images, with `r` the distance of a vertex before the source's border. `None`
/// for images in one plane.
fn carried_border(
    source: &SurfaceMesh,
    source_body: &Body,
    target_body: &Body,
    images: &[Point3<f64>],
) -> Option<[f64; 2]> {
    let (mut normal, mut right) = (Matrix4::zeros(), Vector4::zeros());
    for ((point, image), area) in source.vertices().iter().zip(images).zip(vertex_areas(source)) {
        let before = source_body.before_border(point);
        let weight = area * (-0.5 * (before / FOLLOW_MM).powi(2)).exp();
        let [s, m, h] = target_body.coordinates(image);
        let row = Vector4::new(1.0, m, h, before);
        normal += weight * row * row.transpose();
        right += weight * s * row;
    }
    let plane = normal.cholesky()?.solve(&right);
    plane.iter().all(|c| c.is_finite()).then(|| [plane[0], plane[1]])
}
