//! Sites of one surface, the variables and labels of the energy of near isometries, and the distances between them
//! along the surface. Computed once per surface.

use homolog_geometry::curvature::vertex_areas;
use homolog_geometry::geodesic::distances_among;
use homolog_geometry::hierarchy::coarsen;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::points::farthest_points;
use nalgebra::Point3;
use std::mem::size_of;

/// Number of sites of a surface. Their spacing as labels is 0.044 roots of the area.
pub(crate) const N_SITES: usize = 512;

/// Evenly spread sites of one surface.
#[derive(Debug, Clone)]
pub(crate) struct Sites {
    /// The vertex of the surface at each site.
    pub vertices: Vec<u32>,
    /// For each vertex of the surface the site whose cell contains it.
    pub cells: Vec<u32>,
    /// Triangles between sites.
    pub triangles: Vec<[u32; 3]>,
    /// Sites in farthest-point order: each is as far as possible from all previous ones.
    pub order: Vec<u32>,
    /// Distances between sites along the surface, in roots of its area, row by row.
    pub distances: Vec<f32>,
    /// Root mean square distance of each site from all points of the surface, in roots of its area.
    pub eccentricity: Vec<f64>,
}

/// Some sites of a surface, and the distances between them along the surface.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SiteSubset<'a> {
    /// Distances between all sites, row by row.
    pub distances: &'a [f32],
    pub n_sites: usize,
    /// The site at each place; `None`: all sites.
    pub which: Option<&'a [u32]>,
}

impl SiteSubset<'_> {
    pub(crate) fn len(&self) -> usize {
        self.which.map_or(self.n_sites, <[u32]>::len)
    }

    /// The distance between two places along the surface, in roots of its area.
    pub(crate) fn distance(&self, i: usize, j: usize) -> f64 {
        let [i, j] = [i, j].map(|k| self.which.map_or(k, |which| which[k] as usize));
        f64::from(self.distances[i * self.n_sites + j])
    }
}

impl Sites {
    /// The sites of `mesh`, which must be in canonical numbering and smoothed to the scale of its noise. Cost `O(n log
    /// n + sites² · 12)` for each of about ten sweeps.
    pub(crate) fn new(mesh: &SurfaceMesh) -> Sites {
        let n = mesh.n_vertices();
        let coarse = coarsen(mesh, N_SITES);
        let (level, vertices, cells) = match &coarse {
            Some(coarse) => (&coarse.mesh, coarse.sites.clone(), coarse.cells.clone()),
            None => (mesh, (0..n as u32).collect(), (0..n as u32).collect()),
        };
        let mut areas = vec![0.0; vertices.len()];
        cells.iter().zip(vertex_areas(mesh)).for_each(|(&cell, area)| areas[cell as usize] += area);
        let total: f64 = areas.iter().sum();
        let root_mm = total.sqrt().max(f64::MIN_POSITIVE);
        let mut distances = distances_among(level);
        distances.iter_mut().for_each(|d| *d /= root_mm as f32);
        let mean_square = |row: &[f32]| {
            row.iter().zip(&areas).map(|(&d, area)| area * f64::from(d) * f64::from(d)).sum::<f64>() / total
        };
        let eccentricity = distances.chunks_exact(vertices.len()).map(|row| mean_square(row).sqrt()).collect();
        let order = farthest_points(level.vertices(), vertices.len()).into_iter().map(|k| k as u32).collect();
        Sites { triangles: level.triangles(), vertices, cells, order, distances, eccentricity }
    }

    pub(crate) fn len(&self) -> usize {
        self.vertices.len()
    }

    /// Distances of `site` from all sites.
    pub(crate) fn row(&self, site: usize) -> &[f32] {
        &self.distances[site * self.len()..][..self.len()]
    }

    /// The first `n` sites of [`Self::order`], which cover the surface evenly.
    pub(crate) fn first(&self, n: usize) -> &[u32] {
        &self.order[..n.min(self.len())]
    }

    /// All sites as places, in the order of their numbers.
    pub(crate) fn all(&self) -> SiteSubset<'_> {
        SiteSubset { distances: &self.distances, n_sites: self.len(), which: None }
    }

    /// The sites of `which`, as places.
    pub(crate) fn picked<'a>(&'a self, which: &'a [u32]) -> SiteSubset<'a> {
        SiteSubset { distances: &self.distances, n_sites: self.len(), which: Some(which) }
    }

    /// Positions of the sites on `mesh`, mm.
    pub(crate) fn places(&self, mesh: &SurfaceMesh) -> Vec<Point3<f64>> {
        self.vertices.iter().map(|&v| mesh.vertices()[v as usize]).collect()
    }

    /// Memory of the sites of a surface with this many vertices, bytes.
    pub(crate) fn heap_bytes_over(n_vertices: usize) -> usize {
        let n = n_vertices.min(N_SITES);
        n * n * size_of::<f32>() + n * (size_of::<f64>() + size_of::<[u32; 8]>()) + n_vertices * size_of::<u32>()
    }
}
