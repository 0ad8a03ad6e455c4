//! The bending-invariant form of a surface: points in space whose Euclidean distances approximate the geodesic
//! distances of the surface, as closely as three dimensions allow.
//!
//! Bending, folding or moving the limbs of a surface hardly changes its geodesic distances, and hardly changes its
//! form, whatever the pose. A rigid registration of the forms can therefore start a correspondence where a rigid
//! registration of the surfaces cannot.
//!
//! 1. Geodesic distances `d_ij` between all pairs of sites, along edges and across the two triangles of an edge.
//! 2. Classical scaling: the three largest eigenvectors of `−½ J D² J`.
//! 3. Majorization (SMACOF) of the stress `Σ w_ij (‖x_i − x_j‖ − d_ij)²` with `w_ij = 1 / d_ij`, starting from the
//!    scaling.
//! 4. The mirror image whose neighborhoods have the same handedness as on the surface.
//!
//! Source: Elad, Kimmel, "On bending invariant signatures for surfaces", IEEE PAMI 25(10), 2003; de Leeuw, "Applications of
//! convex analysis to multidimensional scaling", 1977 (SMACOF).

use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use nalgebra::{Matrix3, Point3, Vector3};
use rayon::prelude::*;

/// Steps of majorization; further steps change the stress by less than a percent.
const STEPS: usize = 30;

/// Number of sites in a neighborhood: the site itself and two rings.
pub const NEIGHBORS: usize = 13;

/// The form of a surface over a set of sites on it.
#[derive(Debug, Clone, PartialEq)]
pub struct CanonicalForm {
    /// A point for each site, relative to the origin, mm.
    pub points: Vec<Point3<f64>>,
    /// For each site the nearest sites along the surface, itself first: [`NEIGHBORS`], or all if there are fewer.
    pub neighbors: Vec<Vec<u32>>,
    /// `√(Σ w_ij (‖x_i − x_j‖ − d_ij)² / Σ w_ij d_ij²)`: 0 for a surface whose geodesic distances three dimensions can
    /// hold exactly.
    pub stress: f64,
}

/// The form of a surface over its `sites`, from their distances along the surface, all in mm. `None` with fewer than
/// four sites or if a number is not finite.
///
/// # Cost
/// `O(sites³)`.
pub fn canonical_form(sites: &[Point3<f64>], distance: impl Fn(usize, usize) -> f64) -> Option<CanonicalForm> {
    let n = sites.len();
    if n < 4 {
        return None;
    }
    let largest = (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).map(|(i, j)| distance(i, j)).fold(0.0, f64::max);
    if !(largest.is_finite() && largest > 0.0) {
        return None;
    }
    // Relative to the largest distance, so that thresholds inside decompositions mean the same for surfaces of any
    // size.
    let d = Mat::from_fn(n, n, |i, j| 0.5 * (distance(i, j) + distance(j, i)) / largest);
    let start = classical_scaling(&d)?;
    let (points, stress) = majorized(&d, start)?;
    let mut points: Vec<Point3<f64>> = points.iter().map(|x| Point3::from(x * largest)).collect();
    let neighbors = nearest(&d);
    if handedness(sites, &points, &neighbors) < 0.0 {
        points.iter_mut().for_each(|p| p.x = -p.x);
    }
    Some(CanonicalForm { points, neighbors, stress })
}

/// Points from the three largest eigenvectors of the centered squared distances.
fn classical_scaling(d: &Mat<f64>) -> Option<Vec<Vector3<f64>>> {
    let n = d.nrows();
    let squared = |i: usize, j: usize| d[(i, j)] * d[(i, j)];
    let row: Vec<f64> = (0..n).map(|i| (0..n).map(|j| squared(i, j)).sum::<f64>() / n as f64).collect();
    let mean = row.iter().sum::<f64>() / n as f64;
    let centered = Mat::from_fn(n, n, |i, j| -0.5 * (squared(i, j) - row[i] - row[j] + mean));
    let eigen = centered.self_adjoint_eigen(Side::Lower).ok()?;
    let (vectors, values) = (eigen.U(), eigen.S().column_vector());
    // Eigenvalues are ascending; the largest are the last.
    let axis = |i: usize, k: usize| vectors[(i, n - 1 - k)] * values[n - 1 - k].max(0.0).sqrt();
    Some((0..n).map(|i| Vector3::new(axis(i, 0), axis(i, 1), axis(i, 2))).collect())
}

/// `x` after majorization, and its relative stress.
fn majorized(d: &Mat<f64>, mut x: Vec<Vector3<f64>>) -> Option<(Vec<Vector3<f64>>, f64)> {
    let n = d.nrows();
    let weight = |i: usize, j: usize| if i == j || d[(i, j)] <= 0.0 { 0.0 } else { 1.0 / d[(i, j)] };
    let degree: Vec<f64> = (0..n).map(|i| (0..n).map(|j| weight(i, j)).sum()).collect();
    // The Laplacian of the weights plus a constant, which makes it invertible and has no effect on centered points.
    let scale = degree.iter().sum::<f64>() / (n * n) as f64;
    let laplacian = Mat::from_fn(n, n, |i, j| scale + if i == j { degree[i] } else { -weight(i, j) });
    let factor = laplacian.llt(Side::Lower).ok()?;
    for _ in 0..STEPS {
        let pulled: Vec<Vector3<f64>> = (0..n)
            .into_par_iter()
            .map(|i| {
                (0..n).fold(Vector3::zeros(), |sum, j| {
                    let apart = x[i] - x[j];
                    let length = apart.norm();
                    // `w d = 1`.
                    if i == j || length <= 0.0 || d[(i, j)] <= 0.0 { sum } else { sum + apart / length }
                })
            })
            .collect();
        let next = factor.solve(Mat::from_fn(n, 3, |i, a| pulled[i][a]));
        x = (0..n).map(|i| Vector3::new(next[(i, 0)], next[(i, 1)], next[(i, 2)])).collect();
    }
    let (mut missed, mut total) = (0.0, 0.0);
    for i in 0..n {
        for j in 0..i {
            missed += weight(i, j) * ((x[i] - x[j]).norm() - d[(i, j)]).powi(2);
            total += d[(i, j)];
        }
    }
    let stress = (missed / total).sqrt();
    stress.is_finite().then_some((x, stress))
}

/// For each site the nearest sites, itself first.
fn nearest(d: &Mat<f64>) -> Vec<Vec<u32>> {
    let n = d.nrows();
    (0..n)
        .into_par_iter()
        .map(|i| {
            let mut order: Vec<u32> = (0..n as u32).collect();
            order.sort_by(|&a, &b| d[(i, a as usize)].total_cmp(&d[(i, b as usize)]).then(a.cmp(&b)));
            order.truncate(NEIGHBORS);
            order
        })
        .collect()
}

/// Positive where a map keeps the handedness of neighborhoods, negative where it mirrors them: the sum of the
/// determinants of the covariances between the `neighbors` of each point and their `images`. Neighborhoods that are
/// flat on either side count little.
fn handedness(points: &[Point3<f64>], images: &[Point3<f64>], neighbors: &[Vec<u32>]) -> f64 {
    let of_neighborhood = |near: &Vec<u32>| {
        let mean = |p: &[Point3<f64>]| {
            near.iter().fold(Vector3::zeros(), |s, &k| s + p[k as usize].coords) / near.len() as f64
        };
        let (a, b) = (mean(points), mean(images));
        let covariance = near
            .iter()
            .map(|&k| k as usize)
            .fold(Matrix3::zeros(), |s, k| s + (points[k].coords - a) * (images[k].coords - b).transpose());
        covariance.determinant()
    };
    neighbors.iter().map(of_neighborhood).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geodesic::distances_from;
    use homolog_mesh::SurfaceMesh;
    use homolog_mesh::shapes::ellipsoid;

    /// A long and thin surface without symmetry.
    fn straight() -> SurfaceMesh {
        let mesh = ellipsoid(Vector3::new(20.0, 2.5, 2.0), 3);
        let lopsided =
            mesh.vertices().iter().map(|p| Point3::new(p.x, p.y * (1.0 + 0.02 * p.x), p.z + 0.01 * p.x * p.y));
        mesh.with_vertices(lopsided.collect()).unwrap()
    }

    /// `straight` with its axis on an arc of `angle` radians.
    fn bent(angle: f64) -> SurfaceMesh {
        let mesh = straight();
        let radius = 40.0 / angle;
        let on_arc = |p: &Point3<f64>| {
            let phi = p.x / radius;
            Point3::new((radius - p.y) * phi.sin(), radius - (radius - p.y) * phi.cos(), p.z)
        };
        mesh.with_vertices(mesh.vertices().iter().map(on_arc).collect()).unwrap()
    }

    fn over(mesh: &SurfaceMesh, sites: &[u32]) -> Option<CanonicalForm> {
        let places: Vec<Point3<f64>> = sites.iter().map(|&k| mesh.vertices()[k as usize]).collect();
        let rows = distances_from(mesh, sites);
        canonical_form(&places, |i, j| rows[i][sites[j] as usize])
    }

    fn form(mesh: &SurfaceMesh) -> CanonicalForm {
        over(mesh, &(0..mesh.n_vertices() as u32).step_by(4).collect::<Vec<u32>>()).unwrap()
    }

    /// Root mean square difference between the distances within two sets of points, relative to their root mean square.
    fn difference(a: &[Point3<f64>], b: &[Point3<f64>]) -> f64 {
        let (mut all, mut apart) = (0.0, 0.0);
        for i in 0..a.len() {
            for j in 0..i {
                let distance = |p: &[Point3<f64>]| (p[i] - p[j]).norm();
                all += distance(a).powi(2);
                apart += (distance(a) - distance(b)).powi(2);
            }
        }
        (apart / all).sqrt()
    }

    #[test]
    fn bending_changes_the_distances_within_a_surface_but_hardly_those_within_its_form() {
        let [a, b] = [straight(), bent(2.4)];
        let of_surfaces = difference(a.vertices(), b.vertices());
        let of_forms = difference(&form(&a).points, &form(&b).points);
        assert!(of_surfaces > 0.1 && of_forms < 0.7 * of_surfaces, "{of_surfaces} {of_forms}");
    }

    #[test]
    fn a_form_has_the_handedness_of_its_surface_and_a_small_stress() {
        let mesh = bent(1.5);
        let found = form(&mesh);
        let own: Vec<Point3<f64>> = mesh.vertices().iter().step_by(4).copied().collect();
        assert!(handedness(&own, &found.points, &found.neighbors) > 0.0);
        let mirrored: Vec<Point3<f64>> = found.points.iter().map(|p| Point3::new(p.x, -p.y, p.z)).collect();
        assert!(handedness(&own, &mirrored, &found.neighbors) < 0.0);
        assert!(found.stress < 0.1, "{}", found.stress);
    }

    #[test]
    fn a_form_scales_with_its_surface_to_the_bit() {
        let mesh = bent(1.0);
        let factor = 2f64.powi(-7);
        let scaled = mesh.with_vertices(mesh.vertices().iter().map(|p| p * factor).collect()).unwrap();
        let (a, b) = (form(&mesh), form(&scaled));
        assert_eq!(a.points.iter().map(|p| p * factor).collect::<Vec<_>>(), b.points);
        assert_eq!(a.stress, b.stress);
    }

    #[test]
    fn pieces_are_as_far_apart_as_through_space() {
        let one = straight();
        let shift = Vector3::new(0.0, 30.0, 0.0);
        let vertices: Vec<Point3<f64>> =
            one.vertices().iter().copied().chain(one.vertices().iter().map(|p| p + shift)).collect();
        let n = one.n_vertices() as u32;
        let indices = one.indices().iter().copied().chain(one.indices().iter().map(|k| k + n)).collect();
        let both = SurfaceMesh::new(vertices, one.arity(), indices).unwrap();
        let found = form(&both);
        assert!(found.points.iter().all(|p| p.coords.norm().is_finite()));
    }

    #[test]
    fn few_sites_have_no_form() {
        for sites in [vec![0, 1, 2], vec![0; 4]] {
            let mesh = straight();
            assert!(over(&mesh, &sites).is_none());
        }
    }
}
