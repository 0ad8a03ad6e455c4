//! How well a labeling preserves the topology of the surfaces: neighbors stay together, faces keep their orientation.

use homolog_mesh::SurfaceMesh;
use homolog_primitives::graph::{EdgeGraph, Reach};
use nalgebra::Vector3;
use rayon::prelude::*;

/// An image triangle with less than this share of the mean area of target triangles is degenerate.
pub(crate) const DEGENERATE_AREA_SHARE: f64 = 1e-6;

/// The measures of [`topology_consistency`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TopologyConsistency {
    /// Share of source edges whose images lie within `r` edges on the target; 0 if there are no edges.
    pub consistency: f64,
    /// Share of target vertices that are the image of a source vertex.
    pub coverage: f64,
    /// Source triangles, every quad cut along its first diagonal into two.
    pub n_triangles: usize,
    /// Triangles whose image is oriented against the target surface.
    pub n_flipped: usize,
    /// Triangles whose image has too little area for an orientation. They are not counted as flipped.
    pub n_degenerate: usize,
}

/// Why a labeling cannot be measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub(crate) enum LabelingError {
    /// The number of values is not the number of source vertices.
    #[error("{found} values are given for {n_vertices} source vertices")]
    LengthMismatch {
        /// Values given.
        found: usize,
        /// Source vertices.
        n_vertices: usize,
    },
    /// A label is not a target vertex.
    #[error("source vertex {vertex} has label {label}, but there are only {n_labels}")]
    NoSuchLabel {
        /// Source vertex.
        vertex: usize,
        /// Its label.
        label: u32,
        /// Target vertices.
        n_labels: usize,
    },
}

/// Topology consistency of the map that takes source vertex `i` to target vertex `labeling[i]`, with neighborhoods of
/// `r` edges. `variables` is the edge graph of `source`, `labels` is `N_r` over that of `target`.
///
/// The image of a source triangle is the triangle between the labels of its corners, in their order. It is
/// *degenerate* if two of its labels coincide or its area is below [`DEGENERATE_AREA_SHARE`] of the mean area of the
/// target's triangles; otherwise it is *flipped* if its normal has a negative product with the sum of the target's
/// unit vertex normals at its corners. Faces of both surfaces are oriented outwards; to measure a map onto a mirrored
/// structure, mirror the source first ([`SurfaceMesh::moved`]), or every triangle is flipped.
///
/// # Errors
/// [`LabelingError`].
///
/// # Cost
/// `O(edges + faces)` where neighbors have images that are close, on all threads.
pub(crate) fn topology_consistency(
    source: &SurfaceMesh,
    variables: &EdgeGraph,
    target: &SurfaceMesh,
    labeling: &[u32],
    labels: &Reach<'_>,
) -> Result<TopologyConsistency, LabelingError> {
    check_labeling(labeling, source.n_vertices(), target.n_vertices())?;
    let kept_from = |i: usize| {
        let later = variables.neighbors(i).iter().filter(|&&j| j as usize > i);
        later.filter(|&&j| keeps_edge(labels, labeling, i, j as usize)).count()
    };
    let n_kept: usize = (0..variables.n_vertices()).into_par_iter().map(kept_from).sum();
    let n_edges = variables.n_directed_edges() / 2;
    let mut hit = vec![false; target.n_vertices()];
    for &x in labeling {
        hit[x as usize] = true;
    }
    let n_hit = hit.iter().filter(|&&h| h).count();
    let triangles = source.triangles();
    let images = Images::new(target);
    let count = |triangle: &[u32; 3]| match images.kind(triangle.map(|v| labeling[v as usize])) {
        Image::Upright => (0, 0),
        Image::Flipped => (1, 0),
        Image::Degenerate => (0, 1),
    };
    let sum = |a: (usize, usize), b: (usize, usize)| (a.0 + b.0, a.1 + b.1);
    let (n_flipped, n_degenerate) = triangles.par_iter().map(count).reduce(|| (0, 0), sum);
    Ok(TopologyConsistency {
        consistency: n_kept as f64 / n_edges.max(1) as f64,
        coverage: n_hit as f64 / hit.len().max(1) as f64,
        n_triangles: triangles.len(),
        n_flipped,
        n_degenerate,
    })
}

/// Whether the images of `i` and `j` lie within one neighborhood.
pub(crate) fn keeps_edge(labels: &Reach<'_>, labeling: &[u32], i: usize, j: usize) -> bool {
    labels.within(labeling[i], labeling[j])
}

pub(crate) fn check_labeling(labeling: &[u32], n_vertices: usize, n_labels: usize) -> Result<(), LabelingError> {
    if labeling.len() != n_vertices {
        return Err(LabelingError::LengthMismatch { found: labeling.len(), n_vertices });
    }
    match labeling.iter().position(|&x| x as usize >= n_labels) {
        Some(vertex) => Err(LabelingError::NoSuchLabel { vertex, label: labeling[vertex], n_labels }),
        None => Ok(()),
    }
}

/// The class of an image triangle.
enum Image {
    Upright,
    Flipped,
    Degenerate,
}

/// The target, with data to classify image triangles.
struct Images<'a> {
    target: &'a SurfaceMesh,
    normals: Vec<Vector3<f64>>,
    smallest_area: f64,
}

impl<'a> Images<'a> {
    fn new(target: &'a SurfaceMesh) -> Self {
        let n_triangles = target.n_faces() * (target.arity().n_corners() - 2);
        let smallest_area = DEGENERATE_AREA_SHARE * target.area() / n_triangles as f64;
        Images { target, normals: target.vertex_normals(), smallest_area }
    }

    fn kind(&self, [a, b, c]: [u32; 3]) -> Image {
        let v = self.target.vertices();
        let [p, q, s] = [a, b, c].map(|x| v[x as usize]);
        let vector_area = (q - p).cross(&(s - p)) / 2.0;
        if a == b || b == c || c == a || vector_area.norm() < self.smallest_area {
            return Image::Degenerate;
        }
        let outwards: Vector3<f64> = [a, b, c].iter().map(|&x| self.normals[x as usize]).sum();
        if vector_area.dot(&outwards) < 0.0 { Image::Flipped } else { Image::Upright }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::FaceArity;
    use homolog_mesh::shapes::{ellipsoid, torus};
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    fn of_meshes(
        source: &SurfaceMesh,
        target: &SurfaceMesh,
        labeling: &[u32],
        rings: usize,
    ) -> Result<TopologyConsistency, LabelingError> {
        let (variables, graph) = (source.edge_graph(), target.edge_graph());
        topology_consistency(source, &variables, target, labeling, &Reach { graph: &graph, rings })
    }

    fn shapes() -> [SurfaceMesh; 3] {
        [
            ellipsoid(Vector3::new(9.0, 6.0, 5.0), 2),
            torus(10.0, 4.0, 16, 9, FaceArity::Triangle),
            torus(10.0, 4.0, 16, 9, FaceArity::Quad),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        #[test]
        fn shares_are_those_counted_edge_by_edge(
            seed in prop::collection::vec(any::<u32>(), 1..200),
            rings in 0usize..4,
        ) {
            for mesh in shapes() {
                // The identity at most vertices, with some labels changed.
                let n = mesh.n_vertices();
                let mut labeling: Vec<u32> = (0..n as u32).collect();
                for (k, &number) in seed.iter().enumerate() {
                    labeling[(k * 7) % n] = number % n as u32;
                }
                let found = of_meshes(&mesh, &mesh, &labeling, rings).unwrap();
                let graph = mesh.edge_graph();
                let mut n_kept = 0;
                for i in 0..n {
                    // All labels within reach, ring by ring.
                    let mut reached = BTreeSet::from([labeling[i]]);
                    for _ in 0..rings {
                        let around = reached.iter().flat_map(|&x| graph.neighbors(x as usize)).copied();
                        reached = around.chain(reached.iter().copied()).collect();
                    }
                    n_kept += graph.neighbors(i).iter().filter(|&&j| reached.contains(&labeling[j as usize])).count();
                }
                let images: BTreeSet<u32> = labeling.iter().copied().collect();
                prop_assert_eq!(found.consistency, n_kept as f64 / graph.n_directed_edges() as f64);
                prop_assert_eq!(found.coverage, images.len() as f64 / n as f64);
                prop_assert!(found.n_flipped + found.n_degenerate <= found.n_triangles);
            }
        }
    }

    #[test]
    fn the_identity_is_perfect() {
        for mesh in shapes() {
            let labeling: Vec<u32> = (0..mesh.n_vertices() as u32).collect();
            let found = of_meshes(&mesh, &mesh, &labeling, 1).unwrap();
            let n_triangles = mesh.triangles().len();
            let perfect =
                TopologyConsistency { consistency: 1.0, coverage: 1.0, n_triangles, n_flipped: 0, n_degenerate: 0 };
            assert_eq!(found, perfect);
        }
    }

    #[test]
    fn a_map_onto_one_vertex_keeps_all_edges_and_no_triangle() {
        for mesh in shapes() {
            let found = of_meshes(&mesh, &mesh, &vec![3; mesh.n_vertices()], 0).unwrap();
            assert_eq!((found.consistency, found.coverage), (1.0, 1.0 / mesh.n_vertices() as f64));
            assert_eq!((found.n_degenerate, found.n_flipped), (found.n_triangles, 0));
        }
    }

    #[test]
    fn a_reflection_flips_every_triangle() {
        // Every vertex is mapped to its mirror image, which is also a vertex.
        let mesh = torus(10.0, 4.0, 16, 8, FaceArity::Quad);
        let mirror = |p: &nalgebra::Point3<f64>| {
            let distance = |q: &nalgebra::Point3<f64>| (q - nalgebra::Point3::new(p.x, p.y, -p.z)).norm();
            mesh.vertices().iter().position(|q| distance(q) < 1e-9).unwrap() as u32
        };
        let labeling: Vec<u32> = mesh.vertices().iter().map(mirror).collect();
        let found = of_meshes(&mesh, &mesh, &labeling, 1).unwrap();
        assert_eq!((found.consistency, found.coverage), (1.0, 1.0));
        assert_eq!((found.n_flipped, found.n_degenerate), (found.n_triangles, 0));
    }

    #[test]
    fn two_swapped_neighbors_flip_or_flatten_the_triangles_between_them() {
        let mesh = ellipsoid(Vector3::repeat(6.0), 3);
        let mut labeling: Vec<u32> = (0..mesh.n_vertices() as u32).collect();
        let [a, b] = mesh.edges()[500];
        labeling.swap(a as usize, b as usize);
        let found = of_meshes(&mesh, &mesh, &labeling, 2).unwrap();
        // The two triangles at the edge are flipped; both vertices are still within two edges of all neighbors.
        assert_eq!((found.consistency, found.coverage, found.n_degenerate), (1.0, 1.0, 0));
        assert!((2..=10).contains(&found.n_flipped), "{found:?}");
        // With one label for both vertices the same two triangles have no area.
        labeling[a as usize] = labeling[b as usize];
        let found = of_meshes(&mesh, &mesh, &labeling, 2).unwrap();
        assert_eq!(found.n_degenerate, 2);
    }

    #[test]
    fn an_invalid_labeling_is_an_error_that_names_the_fault() {
        let mesh = ellipsoid(Vector3::repeat(6.0), 1);
        let short = LabelingError::LengthMismatch { found: 3, n_vertices: 42 };
        assert_eq!(of_meshes(&mesh, &mesh, &[0; 3], 1).unwrap_err(), short);
        let mut labeling = vec![0; 42];
        labeling[7] = 42;
        let outside = LabelingError::NoSuchLabel { vertex: 7, label: 42, n_labels: 42 };
        assert_eq!(of_meshes(&mesh, &mesh, &labeling, 1).unwrap_err(), outside);
    }
}
