//! A stationary velocity field and its flow.

use homolog_primitives::observe::{Cancelled, Observer, checkpoint_within};
use nalgebra::{Matrix3, Point3, Vector3};
use rayon::prelude::*;

/// Points per chunk, fixed so that the work is divided in the same way on any number of threads.
const CHUNK: usize = 32;

/// `v(x) = Σ_k exp(−‖x − c_k‖²/2w²) m_k`.
#[derive(Debug, Clone, PartialEq)]
pub struct VelocityField {
    control: Vec<Point3<f64>>,
    momenta: Vec<Vector3<f64>>,
    width: f64,
}

/// Positions of points after a step of the flow, and halfway through it.
pub(super) struct Step {
    pub at: Vec<Point3<f64>>,
    /// Midpoints of the preceding step; empty at the start.
    halfway: Vec<Point3<f64>>,
}

impl VelocityField {
    /// The zero field.
    pub(super) fn new(control: Vec<Point3<f64>>, width: f64) -> Self {
        let momenta = vec![Vector3::zeros(); control.len()];
        VelocityField { control, momenta, width }
    }

    pub(super) fn with_momenta(&self, momenta: Vec<Vector3<f64>>) -> Self {
        VelocityField { control: self.control.clone(), momenta, width: self.width }
    }

    /// The momenta at the control points.
    pub fn momenta(&self) -> &[Vector3<f64>] {
        &self.momenta
    }

    fn kernel(&self, d: &Vector3<f64>) -> f64 {
        (-d.norm_squared() / (2.0 * self.width * self.width)).exp()
    }

    /// The velocity at `x`. Cost `O(control)`.
    pub fn velocity(&self, x: &Point3<f64>) -> Vector3<f64> {
        self.control.iter().zip(&self.momenta).fold(Vector3::zeros(), |v, (c, m)| v + m * self.kernel(&(x - c)))
    }

    /// The velocity at `x` and its derivative.
    fn with_derivative(&self, x: &Point3<f64>) -> (Vector3<f64>, Matrix3<f64>) {
        let inverse = 1.0 / (self.width * self.width);
        self.control.iter().zip(&self.momenta).fold((Vector3::zeros(), Matrix3::zeros()), |(v, j), (c, m)| {
            let d = x - c;
            let k = self.kernel(&d);
            (v + m * k, j - m * d.transpose() * (k * inverse))
        })
    }

    /// `points` after the flow for `time`, by `n_steps` steps of the classical Runge-Kutta method; `−1` undoes `1`.
    ///
    /// Cost `O(n · control · n_steps)`.
    ///
    /// # Errors
    /// [`Cancelled`]; the observer is asked at every point.
    pub fn flowed(
        &self,
        points: &[Point3<f64>],
        time: f64,
        n_steps: usize,
        observer: &dyn Observer,
    ) -> Result<Vec<Point3<f64>>, Cancelled> {
        let h = time / n_steps as f64;
        points
            .par_iter()
            .with_min_len(CHUNK)
            .map(|p| {
                checkpoint_within(observer)?;
                let mut x = *p;
                for _ in 0..n_steps {
                    let a = self.velocity(&x);
                    let b = self.velocity(&(x + a * (h / 2.0)));
                    let c = self.velocity(&(x + b * (h / 2.0)));
                    let d = self.velocity(&(x + c * h));
                    x += (a + 2.0 * b + 2.0 * c + d) * (h / 6.0);
                }
                Ok(x)
            })
            .collect()
    }

    /// The Jacobian of the flow for one unit of time at each of `points`, and the smallest determinant on the way.
    ///
    /// Cost `O(n · control · n_steps)`.
    pub fn jacobians(&self, points: &[Point3<f64>], n_steps: usize) -> Vec<(Matrix3<f64>, f64)> {
        let h = 1.0 / n_steps as f64;
        points
            .par_iter()
            .with_min_len(CHUNK)
            .map(|p| {
                let (mut x, mut f, mut least) = (*p, Matrix3::identity(), 1.0f64);
                for _ in 0..n_steps {
                    let (a, ja) = self.with_derivative(&x);
                    let fa = ja * f;
                    let (b, jb) = self.with_derivative(&(x + a * (h / 2.0)));
                    let fb = jb * (f + fa * (h / 2.0));
                    let (c, jc) = self.with_derivative(&(x + b * (h / 2.0)));
                    let fc = jc * (f + fb * (h / 2.0));
                    let (d, jd) = self.with_derivative(&(x + c * h));
                    let fd = jd * (f + fc * h);
                    x += (a + 2.0 * b + 2.0 * c + d) * (h / 6.0);
                    f += (fa + 2.0 * fb + 2.0 * fc + fd) * (h / 6.0);
                    least = least.min(f.determinant());
                }
                (f, least)
            })
            .collect()
    }

    /// The path of `points` in `n_steps` steps of the midpoint method, the start first.
    pub(super) fn path(&self, points: &[Point3<f64>], n_steps: usize) -> Vec<Step> {
        let h = 1.0 / n_steps as f64;
        let mut path = vec![Step { at: points.to_vec(), halfway: Vec::new() }];
        for step in 0..n_steps {
            let (halfway, at) = path[step]
                .at
                .par_iter()
                .with_min_len(CHUNK)
                .map(|x| {
                    let half = x + self.velocity(x) * (h / 2.0);
                    (half, x + self.velocity(&half) * h)
                })
                .unzip();
            path.push(Step { at, halfway });
        }
        path
    }

    /// The gradient with respect to the momenta of a function whose gradient with respect to the points at the end of
    /// `path` is `gradient`.
    pub(super) fn back_through(&self, path: &[Step], mut gradient: Vec<Vector3<f64>>) -> Vec<Vector3<f64>> {
        let h = 1.0 / (path.len() - 1) as f64;
        let mut of_momenta = vec![Vector3::zeros(); self.momenta.len()];
        for k in (1..path.len()).rev() {
            let (before, halfway) = (&path[k - 1].at, &path[k].halfway);
            // The change of the points before this step, and the velocities at both of its places.
            let back: Vec<(Vector3<f64>, Vector3<f64>, Vector3<f64>)> = gradient
                .par_iter()
                .zip(before)
                .zip(halfway)
                .with_min_len(CHUNK)
                .map(|((g, x), half)| {
                    let at_half = g * h;
                    let of_half = self.with_derivative(half).1.tr_mul(&at_half);
                    let at_start = of_half * (h / 2.0);
                    (g + of_half + self.with_derivative(x).1.tr_mul(&at_start), at_half, at_start)
                })
                .collect();
            of_momenta.par_iter_mut().zip(&self.control).with_min_len(CHUNK).for_each(|(sum, c)| {
                for (((_, at_half, at_start), x), half) in back.iter().zip(before).zip(halfway) {
                    *sum += at_half * self.kernel(&(half - c)) + at_start * self.kernel(&(x - c));
                }
            });
            gradient = back.into_iter().map(|(g, ..)| g).collect();
        }
        of_momenta
    }

    /// `weight Σ_kl K_kl m_k · m_l`; its gradient is added to `gradient`.
    pub(super) fn energy(&self, gradient: &mut [Vector3<f64>], weight: f64) -> f64 {
        let mut energy = 0.0;
        for ((c, m), g) in self.control.iter().zip(&self.momenta).zip(gradient) {
            let v = self.velocity(c);
            energy += weight * m.dot(&v);
            *g += v * (2.0 * weight);
        }
        energy
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_primitives::observe::Silent;

    fn field() -> VelocityField {
        let control = vec![Point3::new(0.0, 0.0, 0.0), Point3::new(0.3, 0.1, -0.2), Point3::new(-0.2, 0.2, 0.1)];
        let momenta = vec![Vector3::new(0.2, -0.1, 0.1), Vector3::new(-0.1, 0.2, 0.05), Vector3::new(0.1, 0.1, -0.2)];
        VelocityField::new(control, 0.25).with_momenta(momenta)
    }

    #[test]
    fn jacobians_are_those_of_finite_differences() {
        let field = field();
        let p = Point3::new(0.05, 0.1, -0.1);
        let (jacobian, least) = field.jacobians(&[p], 40)[0];
        for k in 0..3 {
            let mut d = Vector3::zeros();
            d[k] = 1e-5;
            let moved = field.flowed(&[p + d, p - d], 1.0, 40, &Silent).unwrap();
            let column = (moved[0] - moved[1]) / 2e-5;
            assert!((column - jacobian.column(k)).norm() < 1e-7);
        }
        assert!(least > 0.0 && least <= jacobian.determinant());
    }

    #[test]
    fn the_flow_back_is_the_inverse() {
        let field = field();
        let points: Vec<_> = (0..50).map(|k| Point3::new(0.02 * f64::from(k) - 0.5, 0.1, 0.05)).collect();
        let back = field.flowed(&field.flowed(&points, 1.0, 20, &Silent).unwrap(), -1.0, 20, &Silent).unwrap();
        assert!(points.iter().zip(&back).all(|(p, q)| (p - q).norm() < 1e-6));
        assert!(
            field.flowed(&points, 1.0, 20, &Silent).unwrap().iter().zip(&points).any(|(p, q)| (p - q).norm() > 0.05)
        );
    }

    #[test]
    fn half_the_time_twice_is_the_whole() {
        let field = field();
        let points = [Point3::new(0.1, 0.0, 0.0)];
        let twice = field.flowed(&field.flowed(&points, 0.5, 20, &Silent).unwrap(), 0.5, 20, &Silent).unwrap();
        assert!((twice[0] - field.flowed(&points, 1.0, 40, &Silent).unwrap()[0]).norm() < 1e-12);
    }
}
