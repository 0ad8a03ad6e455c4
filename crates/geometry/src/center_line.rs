//! The center line of a tubular surface, and coordinates along and across it.
//!
//! The first non-constant eigenfunction of the Laplace-Beltrami operator runs from one end of an elongated surface to
//! the other, however it is bent, so its level sets are cross sections. Their centers form the center line, which
//! carries a frame with as little rotation as possible. In these coordinates the surface is a straight tube:
//!
//! `p = c(s) + a t(s) + x u(s) + y v(s)` lies at `(s + a, x, y)`.
//!
//! Sources: Chung et al., "Hot spots conjecture and its application to modeling tubular structures", MLMI 2011 (level sets of the
//! first eigenfunction); Wang et al., "Computation of rotation minimizing frames", ACM Trans. Graph. 27(1), 2008.

use crate::spectrum::spectrum;
use homolog_mesh::repair::largest_component;
use homolog_mesh::{ClosestPointIndex, SurfaceMesh};
use homolog_primitives::observe::Silent;
use nalgebra::{Matrix3, Point3, Vector3};
use rayon::prelude::*;

/// Settings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CenterLineOptions {
    /// Number of cross sections between the ends; they cut off equal areas.
    pub n_sections: usize,
    /// Number of times that centers are averaged with their neighbors, because sections of a coarse surface jitter.
    pub n_smoothings: usize,
}

impl Default for CenterLineOptions {
    fn default() -> Self {
        CenterLineOptions { n_sections: 40, n_smoothings: 4 }
    }
}

/// The center line of a surface, with the coordinates of its vertices.
#[derive(Debug, Clone)]
pub struct CenterLine {
    /// Points from one end of the surface to the other.
    pub points: Vec<Point3<f64>>,
    /// Length of the line up to each of the points.
    pub lengths: Vec<f64>,
    /// Frames at the points: the tangent, and two axes of the cross section.
    pub frames: Vec<Matrix3<f64>>,
    /// `(s + a, x, y)` of every vertex.
    pub straight: Vec<Point3<f64>>,
}

impl CenterLine {
    /// The center line of the piece of `mesh` with the most vertices, and the coordinates of all vertices; `None` if
    /// that piece has no eigenfunction, or one without an extent. Points of other pieces get the section of the closest
    /// point of that piece.
    pub fn of(mesh: &SurfaceMesh, options: &CenterLineOptions) -> Option<CenterLine> {
        // On a surface with several pieces the first functions distinguish the pieces and do not run along any of them.
        let piece = &largest_component(mesh).mesh;
        let found = spectrum(piece, 2, &Silent).ok().flatten()?;
        if found.values.len() < 2 {
            return None;
        }
        let along: Vec<f64> = (0..piece.n_vertices()).map(|i| found.functions[(i, 1)]).collect();
        let mut order: Vec<usize> = (0..along.len()).collect();
        order.sort_by(|&a, &b| along[a].total_cmp(&along[b]).then(a.cmp(&b)));
        let ends = [order[0], *order.last()?];
        let levels = levels(&along, &found.areas, &order, options.n_sections);
        let mut values = vec![along[ends[0]]];
        let mut points = vec![piece.vertices()[ends[0]]];
        for level in levels {
            if let Some(center) = center_of_section(piece, &along, level)
                && level > *values.last()?
            {
                values.push(level);
                points.push(center);
            }
        }
        values.push(along[ends[1]]);
        points.push(piece.vertices()[ends[1]]);
        for _ in 0..options.n_smoothings {
            let before = points.clone();
            for k in 1..points.len() - 1 {
                let sum = before[k - 1].coords + 2.0 * before[k].coords + before[k + 1].coords;
                points[k] = Point3::from(sum / 4.0);
            }
        }
        let mut lengths = vec![0.0];
        for pair in points.windows(2) {
            lengths.push(lengths.last()? + (pair[1] - pair[0]).norm());
        }
        if lengths.windows(2).any(|w| w[1] <= w[0]) || !lengths.last()?.is_finite() {
            return None;
        }
        let frames = frames_that_turn_least(&points)?;
        let along = if piece.n_vertices() == mesh.n_vertices() {
            along
        } else {
            let closest = ClosestPointIndex::new(piece);
            mesh.vertices().par_iter().map(|p| closest.closest(p).blend(|k| along[k])).collect()
        };
        let mut line = CenterLine { points, lengths, frames, straight: Vec::new() };
        line.straight =
            mesh.vertices().iter().zip(&along).map(|(p, value)| line.straightened(p, &values, *value)).collect();
        Some(line)
    }

    /// The coordinates of a point on the level set `value`.
    fn straightened(&self, p: &Point3<f64>, values: &[f64], value: f64) -> Point3<f64> {
        let k = values.partition_point(|v| *v <= value).clamp(1, values.len() - 1);
        let share = ((value - values[k - 1]) / (values[k] - values[k - 1])).clamp(0.0, 1.0);
        let center = self.points[k - 1] + (self.points[k] - self.points[k - 1]) * share;
        let frame = self.frames[k - 1] * (1.0 - share) + self.frames[k] * share;
        let length = self.lengths[k - 1] + (self.lengths[k] - self.lengths[k - 1]) * share;
        let local = frame.tr_mul(&(p - center));
        Point3::new(length + local.x, local.y, local.z)
    }

    /// Root mean square distance of the vertices from the line.
    pub fn radius(&self) -> f64 {
        let squares: f64 = self.straight.iter().map(|p| p.y * p.y + p.z * p.z).sum();
        (squares / self.straight.len() as f64).sqrt()
    }

    /// Length of the line.
    pub fn length(&self) -> f64 {
        self.lengths.last().copied().unwrap_or(0.0)
    }

    /// Length of the line over the root mean square distance of the vertices from it; `None` if either is zero.
    pub fn slenderness(&self) -> Option<f64> {
        let ratio = self.length() / self.radius();
        (ratio.is_finite() && ratio > 0.0).then_some(ratio)
    }

    /// Coordinates about the middle of the line, for a tube of radius 1 and length `ratio`.
    pub fn normalized(&self, ratio: f64) -> Vec<Point3<f64>> {
        let (length, radius) = (self.length(), self.radius());
        let scaled = |p: &Point3<f64>| Point3::new(ratio * (p.x / length - 0.5), p.y / radius, p.z / radius);
        self.straight.iter().map(scaled).collect()
    }
}

/// Values of the function that separate equal areas, ascending. `order` sorts the vertices by it.
fn levels(along: &[f64], areas: &[f64], order: &[usize], n: usize) -> Vec<f64> {
    let total: f64 = areas.iter().sum();
    let (mut levels, mut below) = (Vec::with_capacity(n), 0.0);
    for &i in order {
        below += areas[i];
        while levels.len() < n && below >= total * (levels.len() + 1) as f64 / (n + 1) as f64 {
            levels.push(along[i]);
        }
    }
    levels
}

/// The centroid of the curve on which the function has the value `level`; `None` if the curve crosses no triangle.
fn center_of_section(mesh: &SurfaceMesh, along: &[f64], level: f64) -> Option<Point3<f64>> {
    let v = mesh.vertices();
    let (mut sum, mut length) = (Vector3::zeros(), 0.0);
    for triangle in mesh.triangles() {
        let corners = triangle.map(|k| k as usize);
        let mut ends: [Point3<f64>; 2] = [Point3::origin(); 2];
        let mut n = 0;
        for k in 0..3 {
            let (a, b) = (corners[k], corners[(k + 1) % 3]);
            // A value that equals the level counts as above it, so that each curve is closed.
            if (along[a] < level) != (along[b] < level) && n < 2 {
                ends[n] = v[a] + (v[b] - v[a]) * ((level - along[a]) / (along[b] - along[a]));
                n += 1;
            }
        }
        if n == 2 {
            let own = (ends[1] - ends[0]).norm();
            sum += (ends[0].coords + ends[1].coords) * (0.5 * own);
            length += own;
        }
    }
    (length > 0.0).then(|| Point3::from(sum / length))
}

/// Frames along a line, by the double reflection of Wang et al.: columns are the tangent and two axes across it.
fn frames_that_turn_least(points: &[Point3<f64>]) -> Option<Vec<Matrix3<f64>>> {
    let last = points.len() - 1;
    let tangents: Option<Vec<Vector3<f64>>> =
        (0..=last).map(|k| (points[(k + 1).min(last)] - points[k.saturating_sub(1)]).try_normalize(0.0)).collect();
    let tangents = tangents?;
    // The axis across the first tangent is arbitrary: the angle between two surfaces is searched for.
    let least = tangents[0].iamin();
    let mut axis = tangents[0].cross(&Vector3::ith(least, 1.0)).normalize();
    let mut frames = Vec::with_capacity(points.len());
    for k in 0..=last {
        if k > 0 {
            let between = points[k] - points[k - 1];
            let reflected = |x: &Vector3<f64>, by: &Vector3<f64>| x - by * (2.0 * by.dot(x) / by.norm_squared());
            let (moved_axis, moved_tangent) = (reflected(&axis, &between), reflected(&tangents[k - 1], &between));
            let second = tangents[k] - moved_tangent;
            axis = if second.norm_squared() > 0.0 { reflected(&moved_axis, &second) } else { moved_axis };
            // Rounding errors add up along the line.
            axis = (axis - tangents[k] * axis.dot(&tangents[k])).try_normalize(0.0)?;
        }
        frames.push(Matrix3::from_columns(&[tangents[k], axis, tangents[k].cross(&axis)]));
    }
    Some(frames)
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use std::f64::consts::TAU;

    /// A flattened, tapering tube without symmetry, straight.
    fn tube() -> SurfaceMesh {
        let mesh = ellipsoid(Vector3::new(18.0, 4.0, 3.0), 4);
        let shaped = |p: &Point3<f64>| {
            let wide = 1.0 + 0.02 * p.x;
            Point3::new(p.x, p.y * wide + 0.5 * (0.2 * p.x).sin(), p.z * wide)
        };
        mesh.with_vertices(mesh.vertices().iter().map(shaped).collect()).unwrap()
    }

    /// Its axis bent into an arc of `angle` radians.
    fn bent(p: &Point3<f64>, angle: f64) -> Point3<f64> {
        let radius = 36.0 / angle;
        let at = p.x / radius;
        Point3::new((radius - p.y) * at.sin(), radius - (radius - p.y) * at.cos(), p.z)
    }

    #[test]
    fn another_piece_changes_no_center_line_and_lies_beside_it() {
        let mesh = tube();
        let line = CenterLine::of(&mesh, &CenterLineOptions::default()).unwrap();
        let mut vertices = mesh.vertices().to_vec();
        let n = vertices.len() as u32;
        // A copy of one triangle, a little farther out.
        let corners = mesh.triangles()[300].map(|k| vertices[k as usize]);
        let out = 1e-3 * (corners[1] - corners[0]).cross(&(corners[2] - corners[0])).normalize();
        vertices.extend(corners.map(|p| p + out));
        let indices = mesh.indices().iter().copied().chain([n, n + 1, n + 2]).collect();
        let both = SurfaceMesh::new(vertices, mesh.arity(), indices).unwrap();
        let found = CenterLine::of(&both, &CenterLineOptions::default()).unwrap();
        assert_eq!(found.points, line.points);
        assert_eq!(found.straight.len(), both.n_vertices());
        for (p, q) in found.straight.iter().zip(&line.straight) {
            assert!((p - q).norm() < 1e-9);
        }
        for (k, corner) in mesh.triangles()[300].into_iter().enumerate() {
            assert!((found.straight[n as usize + k] - line.straight[corner as usize]).norm() < 2e-3);
        }
    }

    #[test]
    fn the_center_line_of_a_bent_tube_is_its_arc() {
        let angle = TAU / 4.0;
        let mesh = ellipsoid(Vector3::new(18.0, 4.0, 4.0), 4);
        let mesh = mesh.with_vertices(mesh.vertices().iter().map(|p| bent(p, angle)).collect()).unwrap();
        let line = CenterLine::of(&mesh, &CenterLineOptions::default()).unwrap();
        let center = Point3::new(0.0, 36.0 / angle, 0.0);
        // The last sections consist of a few triangles, and the ends are vertices: 0.28 was found there, with a bound
        // of 0.2.
        for p in &line.points[4..line.points.len() - 4] {
            assert!(((p - center).norm() - 36.0 / angle).abs() < 0.05 * 4.0, "{p}");
        }
        assert!((line.lengths.last().unwrap() - 36.0).abs() < 0.02 * 36.0);
    }

    #[test]
    fn frames_along_a_plane_curve_keep_its_normal_and_on_a_helix_lag_by_its_torsion() {
        let arc: Vec<_> = (0..40).map(|k| bent(&Point3::new(f64::from(k), 0.0, 0.0), 3.0)).collect();
        let frames = frames_that_turn_least(&arc).unwrap();
        let z = |f: &Matrix3<f64>| f.tr_mul(&Vector3::z());
        for f in &frames {
            assert!((z(f) - z(&frames[0])).norm() < 1e-9);
            assert!((f.determinant() - 1.0).abs() < 1e-12);
        }
        // A helix of radius 1 and pitch 2π b: a frame without rotation lags behind the principal normal by b / √(1 +
        // b²) per radian.
        let (b, n) = (0.5, 4000);
        let at = |t: f64| Point3::new(t.cos(), t.sin(), b * t);
        let helix: Vec<_> = (0..=n).map(|k| at(TAU * f64::from(k) / f64::from(n))).collect();
        let frames = frames_that_turn_least(&helix).unwrap();
        let angle = |k: usize| {
            let inward =
                -Vector3::new((TAU * k as f64 / f64::from(n)).cos(), (TAU * k as f64 / f64::from(n)).sin(), 0.0);
            let local = frames[k].tr_mul(&inward);
            local.z.atan2(local.y)
        };
        let turned = (angle(n as usize) - angle(0)).rem_euclid(TAU);
        let expected = (TAU * b / (1.0f64 + b * b).sqrt()).rem_euclid(TAU);
        let gap = (turned - expected).abs().min((turned - (TAU - expected)).abs());
        assert!(gap < 0.02, "{turned} {expected}");
    }
}
