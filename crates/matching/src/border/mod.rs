//! Where a hippocampus parts into anterior and posterior, seen from its form, and a map that respects it.
//!
//! Along a hippocampus a smooth field finds little to hold on to: at the border that raters draw behind the uncus, the
//! maps between 669 pairs of the given subjects were off by 1.7 mm (root mean square), as much with rigid registration.
//! Raters see the uncus end; so do the moments of the sections across the long axis. A linear model of them, learned from
//! labelled volumes, tells a subject's border that it was not trained on to 1.1 mm, where the mean border of all subjects
//! is off by 1.7 mm. What the borders of source and target, so predicted, disagree with a map by is an estimate of the
//! map's error there; a share of it is taken off by sliding the images along the target.
//!
//! Only pairs whose sections look like those the model has seen are touched, and no image slides by more than
//! [`MAX_SLIDE_MM`]. What slides depends on the form: a thicker subject's head is taken to reach further back. Studies in
//! which thickness is what is measured can do without (`displacement.anatomy: any`).

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

/// Root mean square of a profile's features, in standard deviations of the training, above which it is of something else.
/// Among the hippocampi trained on the median is 0.95 and the largest 1.97.
pub const MAX_DISTANCE: f64 = 2.2;
/// Least cosine between an axis of the source, turned onto the target, and the same axis of the target.
const MIN_COSINE: f64 = 0.5;
/// Share of the disagreement that is the map's error: of offsets and of slopes, by regression over 435 pairs of maps.
const SHARES: [f64; 2] = [0.6, 0.9];
/// Width of the weights around the source's border with which it is followed into the target, mm.
const FOLLOW_MM: f64 = 3.0;
/// No image slides by more.
pub const MAX_SLIDE_MM: f64 = 3.0;
/// The slide fades away from this place, mm from the center towards the head, with this standard deviation.
const SLIDE_AT_MM: f64 = 2.0;
const SLIDE_WIDTH_MM: f64 = 10.0;

/// What the model sees in the sections of one surface whose axes point as `signs` say.
#[derive(Clone, Copy)]
struct Reading {
    signs: Signs,
    /// How unlike the training it is, in its standard deviations.
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

/// One surface with its axes named.
struct Body {
    sections: Sections,
    reading: Reading,
}

impl Body {
    fn coordinates(&self, point: &Point3<f64>) -> [f64; 3] {
        self.sections.coordinates(self.reading.signs, point)
    }

    /// How far `point` lies before the border, towards the head, mm along the long axis.
    fn before_border(&self, point: &Point3<f64>) -> f64 {
        let [s, m, h] = self.coordinates(point);
        s - self.reading.border[0] - self.reading.border[1] * m - TILT * h
    }
}

/// By how much the images of a map slide along the long axis of the target.
pub struct Slide {
    target: Body,
    /// How unlike the training source and target are, in its standard deviations.
    pub distances: [f64; 2],
    /// The slide at `m = 0` before it fades, mm towards the head, and what a millimetre of `m` adds.
    pub offset_mm: f64,
    pub slope: f64,
}

impl Slide {
    /// What takes the border of `source`, by `images` of its vertices (mm), nearer to that of `target`; `turn` is the
    /// linear part of the rigid transform between them. `None` unless both look like hippocampi that lie the same way.
    ///
    /// Cost `O(n + n')`.
    pub fn new(
        source: &SurfaceMesh,
        target: &SurfaceMesh,
        images: &[Point3<f64>],
        turn: &Matrix3<f64>,
    ) -> Option<Slide> {
        let (a, b) = rayon::join(|| Sections::new(source), || Sections::new(target));
        let (source_body, target_body) = named(a?, b?, turn)?;
        let distances = [source_body.reading.distance, target_body.reading.distance];
        if distances.iter().any(|d| *d > MAX_DISTANCE) {
            return None;
        }
        let carried = carried_border(source, &source_body, &target_body, images)?;
        let [offset_mm, slope] = [0, 1].map(|k| SHARES[k] * (target_body.reading.border[k] - carried[k]));
        Some(Slide { target: target_body, distances, offset_mm, slope })
    }

    /// `images`, mm, each slid along the surface whose closest points are `closest`. How far one lies beside the surface
    /// stays. Cost `O(n log n')`.
    pub fn moved(&self, closest: &ClosestPointIndex, images: &[Point3<f64>]) -> Vec<Point3<f64>> {
        let axis: Vector3<f64> = self.target.sections.axes.column(0) * self.target.reading.signs[0];
        images
            .par_iter()
            .map(|image| {
                let slid = image + self.by_mm(image) * axis;
                image + (closest.closest(&slid).point - closest.closest(image).point)
            })
            .collect()
    }

    /// Root mean square over `images` of how far they slide, mm.
    pub fn rms_mm(&self, images: &[Point3<f64>]) -> f64 {
        let squares: f64 = images.iter().map(|p| self.by_mm(p).powi(2)).sum();
        (squares / images.len().max(1) as f64).sqrt()
    }

    /// How far a point of the target slides, mm towards the head.
    fn by_mm(&self, image: &Point3<f64>) -> f64 {
        let [s, m, _] = self.target.coordinates(image);
        let away = (s - SLIDE_AT_MM) / SLIDE_WIDTH_MM;
        (self.offset_mm + self.slope * m).clamp(-MAX_SLIDE_MM, MAX_SLIDE_MM) * (-0.5 * away * away).exp()
    }
}

/// Both surfaces with the axes named so that both together are most like the training, where those of the target point
/// as `turn` takes those of the source. `None` where the axes do not correspond.
fn named(source: Sections, target: Sections, turn: &Matrix3<f64>) -> Option<(Body, Body)> {
    let cosines = [0, 1, 2].map(|k| (turn * source.axes.column(k)).normalize().dot(&target.axes.column(k)));
    if !cosines.iter().all(|c| c.abs() >= MIN_COSINE) {
        return None;
    }
    let readings = ORIENTATIONS.map(|signs| {
        let of_target = std::array::from_fn(|k| signs[k] * cosines[k].signum());
        (Reading::new(&source, signs), Reading::new(&target, of_target))
    });
    let unlikeness = |(a, b): &(Reading, Reading)| a.distance.powi(2) + b.distance.powi(2);
    let (a, b) = readings.into_iter().min_by(|a, b| unlikeness(a).total_cmp(&unlikeness(b)))?;
    Some((Body { sections: source, reading: a }, Body { sections: target, reading: b }))
}

/// Offset and slope of the plane in the target around which the border of the source lands: weighted least squares of
/// `s' = c₀ + c₁ m' + c₂ h' + c₃ r` over the images, `r` how far before the source's border a vertex lies. `None` for
/// images in one plane.
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
