//! The initial map of the parametrization: latitude and longitude by heat conduction.
//!
//! One pole of the surface is held hot, the other cold; the temperature in between gives a latitude. A second
//! conduction problem, with a jump of 2π across a date line from pole to pole, gives a longitude. Both are linear
//! systems with one equation per vertex (Brechbühler, Gerig, Kübler 1995).
//!
//! There are two differences from the publication. The poles are the extremes along the longest principal axis instead
//! of z, so a moved copy has the same poles. The temperature changes fast near the poles, so each isotherm is mapped to
//! the latitude that encloses the same share of the sphere as the isotherm encloses of the surface.

use super::HarmonicsError;
use super::sphere::TargetAreas;
use super::weights::WeightedEdges;
use crate::sparse::{Place, factorized};
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::Observer;
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::{PI, TAU};

/// The two extreme vertices along the longest principal axis of the surface.
struct Poles {
    north: usize,
    south: usize,
}

/// A unit vector for every vertex; a few triangles may be folded.
///
/// # Errors
/// [`HarmonicsError::TooCoarse`], [`HarmonicsError::NotPositiveDefinite`].
pub(super) fn initial_directions(
    mesh: &SurfaceMesh,
    edges: &WeightedEdges,
    areas: &TargetAreas,
    observer: &dyn Observer,
) -> Result<Vec<Vector3<f64>>, HarmonicsError> {
    let poles = find_poles(mesh, &areas.of_vertices());
    if edges.graph.neighbors(poles.north).binary_search(&(poles.south as u32)).is_ok() {
        return Err(HarmonicsError::TooCoarse { n_vertices: mesh.n_vertices() });
    }
    let temperature = temperatures(edges, &poles, observer)?;
    let longitude = longitudes(edges, &poles, &temperature, observer)?;
    let heights = equal_area_heights(&temperature, areas);
    Ok((0..mesh.n_vertices())
        .map(|k| match k {
            k if k == poles.north => Vector3::z(),
            k if k == poles.south => -Vector3::z(),
            k => {
                let (sin, cos) = longitude[k].sin_cos();
                let ring = (1.0 - heights[k] * heights[k]).max(0.0).sqrt();
                Vector3::new(ring * cos, ring * sin, heights[k])
            }
        })
        .collect())
}

fn find_poles(mesh: &SurfaceMesh, vertex_areas: &[f64]) -> Poles {
    let v = mesh.vertices();
    let total: f64 = vertex_areas.iter().sum();
    let center = v.iter().zip(vertex_areas).fold(Vector3::zeros(), |s, (p, a)| s + p.coords * *a) / total;
    let covariance = v.iter().zip(vertex_areas).fold(Matrix3::zeros(), |s, (p, &area)| {
        let d = p.coords - center;
        s + area * d * d.transpose()
    });
    let eigen = covariance.symmetric_eigen();
    let axis = eigen.eigenvectors.column(eigen.eigenvalues.imax()).into_owned();
    let along: Vec<f64> = v.iter().map(|p| axis.dot(&(p.coords - center))).collect();
    let (mut north, mut south) = (0, 0);
    for (k, &x) in along.iter().enumerate() {
        if x > along[north] {
            north = k;
        }
        if x < along[south] {
            south = k;
        }
    }
    Poles { north, south }
}

/// Solves `Σ_j w_ij (x_i − x_j) = b_i` for all vertices except `held` ones, which keep their given values.
fn conduct(
    edges: &WeightedEdges,
    held: &[Option<f64>],
    mut b: Vec<f64>,
    observer: &dyn Observer,
) -> Result<Vec<f64>, HarmonicsError> {
    let mut unknown = vec![usize::MAX; held.len()];
    let free: Vec<usize> = (0..held.len()).filter(|&k| held[k].is_none()).collect();
    for (row, &k) in free.iter().enumerate() {
        unknown[k] = row;
    }
    let capacity = edges.graph.n_directed_edges() / 2 + free.len();
    let (mut places, mut values) = (Vec::with_capacity(capacity), Vec::with_capacity(capacity));
    for (row, &k) in free.iter().enumerate() {
        let mut diagonal = 0.0;
        for (j, w) in edges.neighbors(k) {
            match held[j] {
                // NaN marks a vertex outside the system.
                Some(value) if value.is_nan() => {}
                Some(value) => {
                    diagonal += w;
                    b[k] += w * value;
                }
                None => {
                    diagonal += w;
                    if unknown[j] < row {
                        places.push(Place::new(row, unknown[j]));
                        values.push(-w);
                    }
                }
            }
        }
        places.push(Place::new(row, row));
        values.push(diagonal);
    }
    let n = free.len();
    let failed = HarmonicsError::NotPositiveDefinite;
    let factor = factorized(n, &places, &values, observer)?.ok_or(failed.clone())?;
    let solved = factor.solve(n, 1, &|row, _| b[free[row]]);
    let x: Vec<f64> = (0..held.len()).map(|k| held[k].unwrap_or_else(|| solved[(unknown[k], 0)])).collect();
    if free.iter().any(|&k| !x[k].is_finite()) { Err(failed) } else { Ok(x) }
}

/// The temperature of every vertex: 0 at the north pole, π at the south pole.
fn temperatures(edges: &WeightedEdges, poles: &Poles, observer: &dyn Observer) -> Result<Vec<f64>, HarmonicsError> {
    let mut held = vec![None; edges.n_vertices()];
    held[poles.north] = Some(0.0);
    held[poles.south] = Some(PI);
    conduct(edges, &held, vec![0.0; held.len()], observer)
}

/// The longitude of every vertex except the poles, radians, up to multiples of 2π.
fn longitudes(
    edges: &WeightedEdges,
    poles: &Poles,
    temperature: &[f64],
    observer: &dyn Observer,
) -> Result<Vec<f64>, HarmonicsError> {
    let line = date_line(edges, poles, temperature);
    let [_, first, .., _] = line[..] else {
        return Err(HarmonicsError::TooCoarse { n_vertices: edges.n_vertices() });
    };
    let mut b = vec![0.0; edges.n_vertices()];
    for at in line.windows(3) {
        let [before, here, after] = [at[0], at[1], at[2]];
        // Facing south on the outside, west is to the right: counter-clockwise from the previous vertex to the next.
        for west in edges.between(here as u32, before as u32, after as u32) {
            let west = west as usize;
            // Across the date line a neighbor to the west is 2π ahead.
            if let Some((_, w)) = edges.neighbors(here).find(|&(j, _)| j == west) {
                b[here] -= w * TAU;
                b[west] += w * TAU;
            }
        }
    }
    let mut held = vec![None; edges.n_vertices()];
    // The poles have no longitude, and one vertex fixes the zero.
    held[poles.north] = Some(f64::NAN);
    held[poles.south] = Some(f64::NAN);
    held[first] = Some(0.0);
    conduct(edges, &held, b, observer)
}

/// The path from the north to the south pole through the warmest neighbors. The temperature has no maximum in between,
/// so the path arrives, and only consecutive vertices of it are neighbors.
fn date_line(edges: &WeightedEdges, poles: &Poles, temperature: &[f64]) -> Vec<usize> {
    let mut line = vec![poles.north];
    let mut here = poles.north;
    while here != poles.south {
        let warmest =
            edges.neighbors(here).map(|(j, _)| j).reduce(|a, b| if temperature[b] > temperature[a] { b } else { a });
        match warmest {
            // Rounding can create a plateau; there the path ends and the map gets folds.
            Some(next) if temperature[next] > temperature[here] => here = next,
            _ => break,
        }
        line.push(here);
    }
    line
}

/// For every vertex the height `z` on the unit sphere above which the share of the sphere equals the share of the
/// surface that is colder than the vertex.
///
/// The area of a triangle is assumed to be uniform over the range of the temperatures of its corners.
fn equal_area_heights(temperature: &[f64], areas: &TargetAreas) -> Vec<f64> {
    let n = temperature.len();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&a, &b| temperature[a].total_cmp(&temperature[b]).then(a.cmp(&b)));
    let mut rank = vec![0; n];
    for (r, &k) in order.iter().enumerate() {
        rank[k] = r;
    }
    // Change of the density (area per temperature) at each rank, and area at a single temperature.
    let (mut bends, mut jumps) = (vec![0.0; n], vec![0.0; n]);
    for (t, area) in areas.triangles.iter().zip(&areas.areas) {
        let (mut low, mut high) = (t[0], t[0]);
        for &k in &t[1..] {
            low = if rank[k] < rank[low] { k } else { low };
            high = if rank[k] > rank[high] { k } else { high };
        }
        let span = temperature[high] - temperature[low];
        if span > 1e-9 {
            bends[rank[low]] += area / span;
            bends[rank[high]] -= area / span;
        } else {
            jumps[rank[high]] += area;
        }
    }
    let mut heights = vec![0.0; n];
    let (mut below, mut density, mut last) = (0.0, 0.0, temperature[order[0]]);
    for (r, &k) in order.iter().enumerate() {
        below += density * (temperature[k] - last) + jumps[r];
        density += bends[r];
        last = temperature[k];
        heights[k] = (1.0 - 2.0 * below / (4.0 * PI)).clamp(-1.0, 1.0);
    }
    heights
}
