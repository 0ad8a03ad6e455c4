//! The shape of one subject: a tube about a bent center line, with a head, bumps and a thin curved tail.
//!
//! A surface point is `c(s) + ρ(s, φ) (a cos φ · wide + b sin φ · narrow)`, where `c` is the center line, `ρ` the
//! radius with its bumps, and `a`, `b` flatten the section. The same formula tells whether a point is inside, so that
//! the triangle surface and the label volume of a subject have the same shape.
//!
//! The sizes are textbook values of a human hippocampus: 35 to 45 mm long, a head about 11 mm wide, a tail of about
//! half that width. The parameters that vary between subjects are drawn in the order of [`Phantom::new`].

use super::random::{Draws, Stream};
use super::spine::Spine;
use nalgebra::{Point3, Vector3};
use std::f64::consts::{PI, TAU};

/// Part of the structure that contains a point; the numbers are those of the label volumes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Head: label 1.
    Anterior,
    /// Body and tail: label 2.
    Posterior,
}

impl Part {
    /// The label in a volume.
    pub fn label(self) -> u8 {
        match self {
            Part::Anterior => 1,
            Part::Posterior => 2,
        }
    }
}

/// A bump on the radius, Gaussian in the share of the length and in the angle.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Bump {
    s: f64,
    phi: f64,
    height: f64,
    width_s: f64,
    width_phi: f64,
}

/// One synthetic subject, in its own millimeter frame: x to the right, y to the front, z up, head in front.
#[derive(Debug, Clone, PartialEq)]
pub struct Phantom {
    seed: u64,
    spine: Spine,
    head_radius: f64,
    body_radius: f64,
    tail_radius: f64,
    head_end: f64,
    flatten: f64,
    bumps: Vec<Bump>,
}

/// Upper bound of the distance of surface points from the center line, mm.
const REACH_MM: f64 = 14.0;

impl Phantom {
    /// The subject generated from this seed.
    pub fn new(seed: u64) -> Self {
        let mut d = Draws::new(Stream::Shape, seed);
        let length_mm = d.around(41.0, 2.2);
        let head_radius = d.around(6.0, 0.4);
        let body_radius = d.around(4.8, 0.3);
        let tail_radius = d.around(3.0, 0.25);
        let head_end = d.around(0.38, 0.025);
        let flatten = d.around(1.16, 0.05);
        let yaw_bend = d.around(0.75, 0.15);
        let pitch_bend = d.around(0.65, 0.12);
        let head_hook = d.around(0.55, 0.12);
        let tail_hook = d.around(0.8, 0.15);
        let twist = d.around(0.45, 0.25);
        let direction = move |s: f64| {
            // The head turns inwards (to the left of the frame), the tail inwards and up.
            let yaw = yaw_bend * (s - 0.5) - head_hook * (1.0 - smooth_step(s / 0.35))
                + tail_hook * smooth_step((s - 0.65) / 0.35);
            let pitch = pitch_bend * (s - 0.35) + 0.5 * tail_hook * smooth_step((s - 0.7) / 0.3);
            Vector3::new(-yaw.sin() * pitch.cos(), -yaw.cos() * pitch.cos(), pitch.sin())
        };
        let spine = Spine::new(length_mm, direction, move |s| twist * (s - 0.5));
        let mut bumps = Vec::new();
        // Digitations of the head: three or four, side by side on its upper side.
        let n_digitations = 3 + d.below(2);
        for k in 0..n_digitations {
            let side = (k as f64 + 0.5) / n_digitations as f64;
            bumps.push(Bump {
                s: d.around(0.1 + 0.16 * side, 0.015),
                phi: d.around(0.25 * PI + 0.9 * PI * side, 0.12),
                height: d.uniform(0.18, 0.32),
                width_s: d.uniform(0.04, 0.06),
                width_phi: d.uniform(0.25, 0.38),
            });
        }
        // The uncus: one broad bump on the inner side of the head.
        bumps.push(Bump {
            s: d.around(0.2, 0.03),
            phi: d.around(1.2 * PI, 0.15),
            height: d.uniform(0.15, 0.3),
            width_s: 0.07,
            width_phi: 0.5,
        });
        // Low swellings and dents elsewhere.
        for _ in 0..9 {
            bumps.push(Bump {
                s: d.uniform(0.12, 0.9),
                phi: d.uniform(0.0, TAU),
                height: d.uniform(-0.12, 0.16),
                width_s: d.uniform(0.05, 0.1),
                width_phi: d.uniform(0.35, 0.7),
            });
        }
        Phantom { seed, spine, head_radius, body_radius, tail_radius, head_end, flatten, bumps }
    }

    /// The seed of the subject.
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// Length of the center line, mm.
    pub fn length_mm(&self) -> f64 {
        self.spine.length_mm()
    }

    /// Radius of the section at share `s` of the length, without bumps, mm; 0 at both ends.
    fn radius(&self, s: f64) -> f64 {
        let to_body = smooth_step((s - 0.12) / (self.head_end - 0.08));
        let to_tail = smooth_step((s - 0.5) / 0.4);
        let wall = self.head_radius + (self.body_radius - self.head_radius) * to_body
            - (self.body_radius - self.tail_radius) * to_tail;
        // Half ellipses close the ends; they are as long as the wall is wide there.
        let cap = |distance: f64, depth: f64| {
            let x = 1.0 - (distance / depth).clamp(0.0, 1.0);
            (1.0 - x * x).sqrt()
        };
        wall * cap(s, 0.16) * cap(1.0 - s, 0.07)
    }

    /// Factor of the bumps on the radius at `(s, φ)`.
    fn bump_factor(&self, s: f64, phi: f64) -> f64 {
        let raised: f64 = self
            .bumps
            .iter()
            .map(|b| {
                let turn = (phi - b.phi + PI).rem_euclid(TAU) - PI;
                let (u, v) = ((s - b.s) / b.width_s, turn / b.width_phi);
                b.height * (-0.5 * (u * u + v * v)).exp()
            })
            .sum();
        (1.0 + raised).max(0.5)
    }

    /// Point of the surface, mm, at share `s` of the length (0 is the tip of the head, 1 the tip of the tail) and angle
    /// `φ`.
    pub fn surface_point(&self, s: f64, phi: f64) -> Point3<f64> {
        let frame = self.spine.frame(s);
        let rho = self.radius(s) * self.bump_factor(s, phi);
        let (sin, cos) = phi.sin_cos();
        frame.point + frame.wide * (rho * self.flatten * cos) + frame.narrow * (rho / self.flatten * sin)
    }

    /// The part that contains `p`, or `None` outside. `O(samples of the center line)`.
    pub fn part_at(&self, p: &Point3<f64>) -> Option<Part> {
        let foot = self.spine.foot(p, REACH_MM)?;
        let (x, y) = (foot.across[0] / self.flatten, foot.across[1] * self.flatten);
        let inside = x.hypot(y) <= self.radius(foot.s) * self.bump_factor(foot.s, y.atan2(x));
        inside.then(|| self.part_of(foot.s))
    }

    /// The part at share `s` of the length.
    pub fn part_of(&self, s: f64) -> Part {
        if s < self.head_end { Part::Anterior } else { Part::Posterior }
    }
}

/// 0 below 0, 1 above 1, and a curve with flat ends between.
fn smooth_step(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}
