//! The bending-invariant form of one surface ([`homolog_geometry::canonical_form`]), with the distances along the surface that it is made of.

use homolog_geometry::canonical_form::{NEIGHBORS, canonical_form};
use homolog_geometry::geodesic::distances_from;
use homolog_geometry::hierarchy::coarsen;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::points::farthest_points;
use homolog_registration::alignment::OrientedPoints;
use homolog_registration::{absolute_orientation, surroundings};
use nalgebra::{Matrix3, Point3, Vector3};
use rayon::prelude::*;

/// Sites of a form.
const N_SITES: usize = 256;
/// Places of a surface that are labels of the field between two surfaces ([`crate::energy`]).
const N_LABELS: usize = 512;
/// Vertices of the surface on which distances between them are measured.
const N_MEASURED: usize = 2500;
/// Radii, in roots of the area, of the balls whose contents describe the surroundings of a site.
const RADII: [f64; 2] = [0.15, 0.25];

/// The bending-invariant form of one surface.
#[derive(Clone, Debug)]
pub(crate) struct BendingInvariantForm {
    /// Vertices of the surface.
    pub sites: Vec<u32>,
    /// The sites on the form, mm.
    pub points: Vec<Point3<f64>>,
    pub normals: Vec<Vector3<f64>>,
    /// For each site those nearest along the surface, itself first.
    pub neighbors: Vec<Vec<u32>>,
    /// The site of the cell that each vertex of the surface belongs to, along edges.
    pub site_of: Vec<u32>,
    /// Area of the surface that each site stands for, mm².
    pub areas: Vec<f64>,
    /// Surroundings of each site on the surface itself, four numbers each.
    surroundings: Vec<f64>,
    /// Distances along the surface.
    pub measured: Measured,
}

/// Distances along a surface, on a coarser level of it.
#[derive(Clone, Debug)]
pub(crate) struct Measured {
    /// The coarser level, mm.
    pub mesh: SurfaceMesh,
    /// The vertex of the surface that each vertex of it is.
    pub vertices: Vec<u32>,
    /// The sites of the form.
    pub sites: Places,
    /// Even samples, twice as dense.
    pub labels: Places,
}

/// Some vertices of the coarser level and their distances to all of its vertices.
#[derive(Clone, Debug)]
pub(crate) struct Places {
    pub vertices: Vec<u32>,
    /// A row for each of them, in roots of the area.
    pub rows: Vec<Vec<f64>>,
}

impl Places {
    /// Those of `vertices` whose distances in mm are `rows`.
    fn new(vertices: Vec<u32>, mut rows: Vec<Vec<f64>>, root_mm: f64) -> Places {
        rows.iter_mut().flatten().for_each(|d| *d /= root_mm);
        Places { vertices, rows }
    }

    /// The distance between two of them, the same in both directions.
    pub(crate) fn distance(&self, i: usize, j: usize) -> f64 {
        0.5 * (self.rows[i][self.vertices[j] as usize] + self.rows[j][self.vertices[i] as usize])
    }

    /// Those that are listed.
    pub(crate) fn picked(&self, which: &[u32]) -> Places {
        Places {
            vertices: which.iter().map(|&k| self.vertices[k as usize]).collect(),
            rows: which.iter().map(|&k| self.rows[k as usize].clone()).collect(),
        }
    }
}

impl BendingInvariantForm {
    /// The form of `mesh`; `None` where it has too few vertices or pieces that no form holds.
    pub(crate) fn new(
        mesh: &SurfaceMesh,
        normals: &[Vector3<f64>],
        vertex_areas: &[f64],
    ) -> Option<BendingInvariantForm> {
        let coarser = coarsen(mesh, N_MEASURED);
        let (fine, to_mesh): (&SurfaceMesh, Vec<u32>) = match &coarser {
            Some(level) => (&level.mesh, level.sites.clone()),
            None => (mesh, (0..mesh.n_vertices() as u32).collect()),
        };
        if fine.n_vertices() <= N_SITES {
            return None;
        }
        // Ascending, as canonical numbering keeps what is close in space close. No mesh joins them: the cells around a tip that is
        // thinner than their spacing form none, and its sites would be lost.
        let mut fine_sites: Vec<u32> =
            farthest_points(fine.vertices(), N_SITES).into_iter().map(|k| k as u32).collect();
        fine_sites.sort_unstable();
        let rows = distances_from(fine, &fine_sites);
        let form = canonical_form(fine, &fine_sites, &rows)?;
        let sites: Vec<u32> = fine_sites.iter().map(|&k| to_mesh[k as usize]).collect();
        let nearest_site: Vec<u32> = (0..fine.n_vertices()).map(|v| nearest_row(&rows, v)).collect();
        let cell = |i: usize| coarser.as_ref().map_or(i, |c| c.cells[i] as usize);
        let site_of: Vec<u32> = (0..mesh.n_vertices()).map(|i| nearest_site[cell(i)]).collect();
        let mut areas = vec![0.0; sites.len()];
        site_of.iter().zip(vertex_areas).for_each(|(&site, area)| areas[site as usize] += area);
        let points: Vec<Point3<f64>> = sites.iter().map(|&k| mesh.vertices()[k as usize]).collect();
        let site_normals: Vec<Vector3<f64>> = sites.iter().map(|&k| normals[k as usize]).collect();
        let root_mm = mesh.area().sqrt();
        let labels: Vec<u32> = farthest_points(fine.vertices(), N_LABELS).into_iter().map(|k| k as u32).collect();
        let label_rows = distances_from(fine, &labels);
        let measured = Measured {
            mesh: fine.clone(),
            sites: Places::new(fine_sites, rows, root_mm),
            labels: Places::new(labels, label_rows, root_mm),
            vertices: to_mesh,
        };
        let around: Vec<_> = points.iter().zip(&areas).map(|(p, &area)| (p.coords, area)).collect();
        let radii_mm = RADII.map(|radius| radius * root_mm);
        let surroundings = points
            .iter()
            .zip(&site_normals)
            .flat_map(|(p, normal)| surroundings(&p.coords, normal, &around, radii_mm))
            .collect();
        let rotations = rotations(&points, &form.points, &form.neighbors, false);
        Some(BendingInvariantForm {
            sites,
            normals: rotations.iter().zip(&site_normals).map(|(rotation, normal)| rotation * normal).collect(),
            neighbors: form.neighbors,
            site_of,
            points: form.points,
            areas,
            surroundings,
            measured,
        })
    }

    /// Memory of the form of a surface with so many vertices, bytes: nearly all of it are distances along the surface.
    pub(crate) fn heap_bytes_over(n_vertices: usize) -> usize {
        let n_measured = n_vertices.min(N_MEASURED);
        let distances = (N_SITES + N_LABELS) * n_measured * size_of::<f64>();
        // A vertex has two triangles, its position, and its index on the finer surface.
        let measured = n_measured * (size_of::<Point3<f64>>() + 7 * size_of::<u32>());
        let site = 4 * size_of::<Vec<f64>>() + (NEIGHBORS + 2) * size_of::<u32>() + 7 * size_of::<f64>();
        distances + measured + (N_SITES + N_LABELS) * site + n_vertices * size_of::<u32>()
    }

    /// The sites on the surface itself, mm.
    pub(crate) fn places(&self, mesh: &SurfaceMesh) -> Vec<Point3<f64>> {
        self.sites.iter().map(|&k| mesh.vertices()[k as usize]).collect()
    }

    pub(crate) fn diagonal_mm(&self) -> f64 {
        let along = |axis: usize| {
            let values = self.points.iter().map(|p| p[axis]);
            values.clone().fold(f64::NEG_INFINITY, f64::max) - values.fold(f64::INFINITY, f64::min)
        };
        Vector3::from_fn(|axis, _| along(axis)).norm()
    }

    pub(crate) fn oriented(&self) -> OrientedPoints<'_> {
        OrientedPoints {
            points: &self.points,
            normals: &self.normals,
            areas: &self.areas,
            features: &self.surroundings,
        }
    }
}

/// The rotation that takes the surroundings of each of the `sites` of a surface to the form: the site and its `neighbors` along the
/// surface. A reflection where that fits better and `allow_reflection`.
pub(crate) fn rotations(
    sites: &[Point3<f64>],
    form: &[Point3<f64>],
    neighbors: &[Vec<u32>],
    allow_reflection: bool,
) -> Vec<Matrix3<f64>> {
    let rotation = |near: &Vec<u32>| {
        let at = |p: &[Point3<f64>]| -> Vec<Point3<f64>> { near.iter().map(|&k| p[k as usize]).collect() };
        let fitted = absolute_orientation(&at(sites), &at(form), None, allow_reflection);
        fitted.map_or(Matrix3::identity(), |t| t.rotation)
    };
    neighbors.par_iter().map(rotation).collect()
}

/// The row with the lowest number at `v`, the first of equal ones.
fn nearest_row(rows: &[Vec<f64>], v: usize) -> u32 {
    let nearest = rows.iter().map(|row| row[v]).zip(0..).min_by(|a, b| a.0.total_cmp(&b.0));
    nearest.map_or(0, |(_, k)| k)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::side::Side;
    use homolog_mesh::shapes::ellipsoid;

    /// A round body with a thin tail, mm: the tail is a third of the length, and thinner than the spacing of sites.
    fn with_a_tail() -> SurfaceMesh {
        let mesh = ellipsoid(Vector3::new(20.0, 10.0, 9.0), 5);
        let drawn_out = |p: &Point3<f64>| {
            let beyond = (p.x - 14.0).max(0.0);
            let thin = 1.0 / (1.0 + 4.0 * beyond);
            Point3::new(p.x + 3.0 * beyond, p.y * thin, p.z * thin)
        };
        mesh.with_vertices(mesh.vertices().iter().map(drawn_out).collect()).unwrap()
    }

    #[test]
    fn sites_cover_ends_that_are_thinner_than_their_spacing() {
        let mesh = with_a_tail();
        let side = Side::new(&mesh);
        let form = side.form().unwrap();
        let rows = &form.measured.sites.rows;
        let farthest =
            (0..form.measured.mesh.n_vertices()).map(|v| rows[nearest_row(rows, v) as usize][v]).fold(0.0, f64::max);
        // The spacing is the root of a site's share of the area.
        let spacing = 1.0 / (N_SITES as f64).sqrt();
        assert!(farthest < 2.0 * spacing, "{farthest} roots of the area from any site, {spacing} apart");
        assert_eq!(form.sites.len(), N_SITES);
        let tip = form.sites.iter().map(|&k| mesh.vertices()[k as usize].x).fold(0.0, f64::max);
        assert!(tip > 34.0, "the last site is at {tip} mm of 38");
        assert!(form.normals.iter().all(|n| (n.norm() - 1.0).abs() < 1e-6));
    }

    #[test]
    fn the_counted_memory_bounds_that_of_a_form() {
        for level in [3, 4, 5] {
            let mesh = ellipsoid(Vector3::new(20.0, 10.0, 9.0), level);
            let side = Side::new(&mesh);
            let BendingInvariantForm { sites, points, normals, neighbors, site_of, areas, surroundings, measured } =
                side.form().unwrap();
            let of_places = |places: &Places| {
                let rows = places.rows.iter().map(|row| size_of_val(row.as_slice()) + size_of::<Vec<f64>>());
                size_of_val(places.vertices.as_slice()) + rows.sum::<usize>()
            };
            let of_neighbors = neighbors.iter().map(|near| size_of_val(near.as_slice()) + size_of::<Vec<u32>>());
            let made = size_of_val(sites.as_slice())
                + size_of_val(points.as_slice())
                + size_of_val(normals.as_slice())
                + of_neighbors.sum::<usize>()
                + size_of_val(site_of.as_slice())
                + size_of_val(areas.as_slice())
                + size_of_val(surroundings.as_slice())
                + measured.mesh.heap_bytes()
                + size_of_val(measured.vertices.as_slice())
                + of_places(&measured.sites)
                + of_places(&measured.labels);
            let counted = BendingInvariantForm::heap_bytes_over(mesh.n_vertices());
            assert!(made <= counted && 10 * counted < 12 * made, "{made} bytes of {counted} counted");
        }
    }
}
