//! The center line of a phantom: a curve in space with a frame that moves along it.
//!
//! The curve is integrated from two angles of its direction (yaw and pitch) at fixed steps. The frame is propagated by
//! double reflection (Wang, Jüttler, Zheng, Liu, ACM Trans. Graph. 27(1), 2008), which minimizes its rotation about the
//! curve, and is then rotated by the twist.

use nalgebra::{Point3, Vector3};

/// Number of samples of a spine; linear interpolation between them errs by less than 1e-4 mm at the bends used.
const N_STEPS: usize = 512;

/// A point of the center line with its frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SpineFrame {
    /// Position on the center line, mm.
    pub(crate) point: Point3<f64>,
    /// Unit tangent, from head to tail.
    pub(crate) tangent: Vector3<f64>,
    /// First unit normal, across the wide side.
    pub(crate) wide: Vector3<f64>,
    /// Second unit normal; the three are right-handed as (wide, narrow, tangent).
    pub(crate) narrow: Vector3<f64>,
}

/// The center line, sampled at equal arc length.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Spine {
    length_mm: f64,
    frames: Vec<SpineFrame>,
}

/// Position of a point relative to the center line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SpineFoot {
    /// Share of the length at which the normal plane contains the point.
    pub(crate) s: f64,
    /// Coordinates in that plane along the wide and the narrow normal, mm.
    pub(crate) across: [f64; 2],
}

impl Spine {
    /// `direction(s)` is the unit direction at share `s` of the length, `twist(s)` the angle of the frame, radians.
    pub(crate) fn new(length_mm: f64, direction: impl Fn(f64) -> Vector3<f64>, twist: impl Fn(f64) -> f64) -> Self {
        let step = length_mm / N_STEPS as f64;
        let at = |k: usize| k as f64 / N_STEPS as f64;
        let mut point = Point3::origin();
        let mut tangent = direction(0.0);
        // The wide side begins across the left-right axis.
        let mut reference = (Vector3::x() - tangent * tangent.x).normalize();
        let mut frames = Vec::with_capacity(N_STEPS + 1);
        for k in 0..=N_STEPS {
            let side = tangent.cross(&reference);
            let (sin, cos) = twist(at(k)).sin_cos();
            let wide = reference * cos + side * sin;
            frames.push(SpineFrame { point, tangent, wide, narrow: tangent.cross(&wide) });
            if k == N_STEPS {
                break;
            }
            let next_tangent = direction(at(k + 1));
            let chord = (tangent + next_tangent).normalize() * step;
            let reflect = |v: Vector3<f64>, m: Vector3<f64>| v - m * (2.0 * m.dot(&v) / m.norm_squared());
            let (reference_1, tangent_1) = (reflect(reference, chord), reflect(tangent, chord));
            let mirror = next_tangent - tangent_1;
            reference = if mirror.norm_squared() > 1e-24 { reflect(reference_1, mirror) } else { reference_1 };
            reference = (reference - next_tangent * next_tangent.dot(&reference)).normalize();
            point += chord;
            tangent = next_tangent;
        }
        let middle = frames[N_STEPS / 2].point.coords;
        for frame in &mut frames {
            frame.point -= middle;
        }
        Spine { length_mm, frames }
    }

    pub(crate) fn length_mm(&self) -> f64 {
        self.length_mm
    }

    /// The frame at share `s` of the length, linear between samples.
    pub(crate) fn frame(&self, s: f64) -> SpineFrame {
        let x = s.clamp(0.0, 1.0) * N_STEPS as f64;
        let k = (x as usize).min(N_STEPS - 1);
        let w = x - k as f64;
        let (a, b) = (&self.frames[k], &self.frames[k + 1]);
        let tangent = (a.tangent * (1.0 - w) + b.tangent * w).normalize();
        let wide = a.wide * (1.0 - w) + b.wide * w;
        let wide = (wide - tangent * tangent.dot(&wide)).normalize();
        SpineFrame { point: a.point + (b.point - a.point) * w, tangent, wide, narrow: tangent.cross(&wide) }
    }

    /// The nearest place whose normal plane contains `p`; `None` if `p` lies before the first or behind the last plane,
    /// or farther away than `reach_mm`. Cost `O(samples)`.
    pub(crate) fn foot(&self, p: &Point3<f64>, reach_mm: f64) -> Option<SpineFoot> {
        let nearest = (0..=N_STEPS).min_by(|&a, &b| {
            let d = |k: usize| (self.frames[k].point - p).norm_squared();
            d(a).total_cmp(&d(b))
        })?;
        if (self.frames[nearest].point - p).norm() > reach_mm {
            return None;
        }
        let height = |s: f64| {
            let f = self.frame(s);
            (p - f.point).dot(&f.tangent)
        };
        // The height changes sign between the neighbors of the nearest sample; bisection finds the zero.
        let step = 1.0 / N_STEPS as f64;
        let s = nearest as f64 * step;
        let (mut low, mut high) = ((s - step).max(0.0), (s + step).min(1.0));
        if height(low) < 0.0 || height(high) > 0.0 {
            return None;
        }
        for _ in 0..24 {
            let middle = (low + high) / 2.0;
            if height(middle) >= 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        let s = (low + high) / 2.0;
        let frame = self.frame(s);
        let offset = p - frame.point;
        Some(SpineFoot { s, across: [offset.dot(&frame.wide), offset.dot(&frame.narrow)] })
    }
}
