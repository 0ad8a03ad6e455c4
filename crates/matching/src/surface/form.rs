//! The bending-invariant form of one surface ([`homolog_geometry::canonical_form`]).

use super::sites::Sites;
use homolog_geometry::canonical_form::{NEIGHBORS, canonical_form};
use homolog_mesh::SurfaceMesh;
use homolog_registration::absolute_orientation;
use nalgebra::{Matrix3, Point3};
use rayon::prelude::*;

/// Most places of a form.
const N_PLACES: usize = 256;

/// The bending-invariant form of one surface.
#[derive(Clone, Debug)]
pub(crate) struct BendingInvariantForm {
    /// The vertex of the surface at each place.
    pub vertices: Vec<u32>,
    /// The places on the form, mm.
    pub points: Vec<Point3<f64>>,
    /// For each place the nearest places along the surface, itself first.
    pub neighbors: Vec<Vec<u32>>,
    /// For each vertex of the surface the place nearest to it along the surface.
    pub place_of: Vec<u32>,
}

impl BendingInvariantForm {
    /// The form of `mesh` over some of its sites; `None` if there are too few, or if a distance between them is
    /// infinite. Cost `O(places³ + n)`.
    pub(crate) fn new(mesh: &SurfaceMesh, sites: &Sites) -> Option<BendingInvariantForm> {
        if sites.len() <= N_PLACES {
            return None;
        }
        // Ascending: canonical numbering keeps places that are close in space close in the list.
        let mut chosen = sites.first(N_PLACES).to_vec();
        chosen.sort_unstable();
        let vertices: Vec<u32> = chosen.iter().map(|&site| sites.vertices[site as usize]).collect();
        let own: Vec<Point3<f64>> = vertices.iter().map(|&v| mesh.vertices()[v as usize]).collect();
        let root_mm = mesh.area().sqrt();
        let places = sites.picked(&chosen);
        let form = canonical_form(&own, |i, j| root_mm * places.distance(i, j))?;
        let nearest = |site: usize| {
            let row = sites.row(site);
            let distance = |k: &u32| row[chosen[*k as usize] as usize];
            (0..chosen.len() as u32).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
        };
        let place_of_site: Vec<u32> = (0..sites.len()).map(nearest).collect();
        Some(BendingInvariantForm {
            vertices,
            points: form.points,
            neighbors: form.neighbors,
            place_of: sites.cells.iter().map(|&site| place_of_site[site as usize]).collect(),
        })
    }

    /// Memory of the form of a surface with this many vertices, bytes.
    pub(crate) fn heap_bytes_over(n_vertices: usize) -> usize {
        let place = size_of::<Vec<u32>>() + size_of::<Point3<f64>>() + (NEIGHBORS + 1) * size_of::<u32>();
        N_PLACES * place + n_vertices * size_of::<u32>()
    }

    /// The places on the surface, mm.
    pub(crate) fn places(&self, mesh: &SurfaceMesh) -> Vec<Point3<f64>> {
        self.vertices.iter().map(|&k| mesh.vertices()[k as usize]).collect()
    }
}

/// The rotation that takes the surroundings of each of the `sites` of a surface (the site and its `neighbors` along the
/// surface) to the form. With `allow_reflection`, a reflection if it fits better.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::side::SurfaceLevel;
    use homolog_mesh::canonicalize;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::Vector3;

    /// A round body with a tail, mm. The tail is a third of the length, and thinner than the spacing of sites.
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
    fn places_cover_ends_that_are_thinner_than_their_spacing() {
        let mesh = canonicalize(&with_a_tail()).mesh;
        let side = SurfaceLevel::new(&mesh);
        let form = side.form().unwrap();
        assert_eq!(form.vertices.len(), N_PLACES);
        // The spacing is the root of the area per place.
        let spacing = (mesh.area() / N_PLACES as f64).sqrt();
        let places = form.places(&mesh);
        let away = |(p, &place): (&Point3<f64>, &u32)| (p - places[place as usize]).norm();
        let farthest = mesh.vertices().iter().zip(&form.place_of).map(away).fold(0.0, f64::max);
        // A tail thinner than the spacing of sites has few sites.
        assert!(farthest < 3.0 * spacing, "{farthest} mm from any place, {spacing} apart");
        let tip = places.iter().map(|p| p.x).fold(0.0, f64::max);
        assert!(tip > 38.0 - 2.0 * spacing, "the last place is at {tip} mm of 38");
    }

    #[test]
    fn the_counted_memory_bounds_that_of_a_form() {
        for level in [3, 4, 5] {
            let mesh = ellipsoid(Vector3::new(20.0, 10.0, 9.0), level);
            let side = SurfaceLevel::new(&mesh);
            let BendingInvariantForm { vertices, points, neighbors, place_of } = side.form().unwrap();
            let of_neighbors = neighbors.iter().map(|near| size_of_val(near.as_slice()) + size_of::<Vec<u32>>());
            let made = size_of_val(vertices.as_slice())
                + size_of_val(points.as_slice())
                + of_neighbors.sum::<usize>()
                + size_of_val(place_of.as_slice());
            let counted = BendingInvariantForm::heap_bytes_over(mesh.n_vertices());
            assert!(made <= counted && 10 * counted < 12 * made, "{made} bytes of {counted} counted");
        }
    }
}
