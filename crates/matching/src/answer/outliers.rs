//! Outliers among the correspondences, and their reasons.

use super::consistency::{LabelingError, check_labeling, keeps_edge};
use homolog_contract::result::OutlierReason;
use homolog_primitives::graph::{EdgeGraph, Reach};
use rayon::prelude::*;

/// For every source vertex the reason why it is an outlier. `Neighborhood`: more than half of its edges break, because the images of
/// these neighbors do not lie within `r` edges of its own.
///
/// `variables` is the edge graph of the source, `labels` is `N_r` over the target; `residuals_mm` holds the distance of
/// each registered source vertex from its label. A residual that is not a number exceeds every tolerance. A vertex next
/// to outliers is not an outlier itself if at least half of its edges hold.
///
/// # Errors
/// [`LabelingError`], also if the number of residuals is not the number of vertices.
///
/// # Cost
/// `O(|E→|)` if neighbors have images that are close, on all threads.
pub(crate) fn identify_outliers(
    variables: &EdgeGraph,
    labels: &Reach<'_>,
    labeling: &[u32],
    residuals_mm: &[f64],
    tolerance_mm: f64,
) -> Result<Vec<OutlierReason>, LabelingError> {
    let n_vertices = variables.n_vertices();
    check_labeling(labeling, n_vertices, labels.graph.n_vertices())?;
    if residuals_mm.len() != n_vertices {
        return Err(LabelingError::LengthMismatch { found: residuals_mm.len(), n_vertices });
    }
    let reasons = breaks_neighborhood(variables, labels, labeling).into_iter().zip(residuals_mm).map(|(breaks, r)| {
        let within = *r <= tolerance_mm;
        match (within, breaks) {
            (true, false) => OutlierReason::None,
            (false, false) => OutlierReason::Residual,
            (true, true) => OutlierReason::Neighborhood,
            (false, true) => OutlierReason::Both,
        }
    });
    Ok(reasons.collect())
}

/// For each vertex of `variables`, whether more than half of its edges break under `labeling`.
fn breaks_neighborhood(variables: &EdgeGraph, labels: &Reach<'_>, labeling: &[u32]) -> Vec<bool> {
    (0..variables.n_vertices())
        .into_par_iter()
        .map(|i| {
            let neighbors = variables.neighbors(i);
            let n_broken = neighbors.iter().filter(|&&j| !keeps_edge(labels, labeling, i, j as usize)).count();
            2 * n_broken > neighbors.len()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::FaceArity;
    use homolog_mesh::SurfaceMesh;
    use homolog_mesh::shapes::{ellipsoid, torus};
    use homolog_primitives::graph::LabelNeighborhoods;
    use nalgebra::Vector3;
    use proptest::prelude::*;
    use rand_core::{Rng, SeedableRng};
    use rand_xoshiro::Xoshiro256PlusPlus;

    fn neighborhoods(mesh: &SurfaceMesh, rings: usize) -> LabelNeighborhoods {
        LabelNeighborhoods::new(&mesh.edge_graph(), rings, |_, _| 0.0)
    }

    fn residuals(mesh: &SurfaceMesh, labeling: &[u32]) -> Vec<f64> {
        let v = mesh.vertices();
        labeling.iter().zip(v).map(|(&x, p)| (v[x as usize] - p).norm()).collect()
    }

    /// Vertices drawn at random, no two of them within two edges of each other, so that no vertex loses more than one
    /// edge to a neighbor.
    fn scattered(mesh: &SurfaceMesh, random: &mut Xoshiro256PlusPlus, n_drawn: usize) -> Vec<usize> {
        let within_two = neighborhoods(mesh, 2);
        let mut chosen: Vec<usize> = Vec::new();
        for _ in 0..n_drawn {
            let v = (random.next_u64() % mesh.n_vertices() as u64) as usize;
            if chosen.iter().all(|&c| within_two.distance_within(c, v).is_none()) {
                chosen.push(v);
            }
        }
        chosen
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        #[test]
        fn planted_outliers_are_found_exactly(seed in any::<u64>(), n_drawn in 0usize..60, rings in 1usize..4) {
            for mesh in [ellipsoid(Vector3::new(9.0, 6.0, 5.0), 3), torus(10.0, 4.0, 24, 12, FaceArity::Quad)] {
                let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
                let planted = scattered(&mesh, &mut random, n_drawn);
                let labels = neighborhoods(&mesh, rings);
                let mut labeling: Vec<u32> = (0..mesh.n_vertices() as u32).collect();
                let v = mesh.vertices();
                // A planted label from outside a neighborhood of one more ring lies in the neighborhood of no neighbor.
                let wider = neighborhoods(&mesh, rings + 1);
                for &at in &planted {
                    let is_far = |x: usize| (v[x] - v[at]).norm() > 8.0 && wider.distance_within(at, x).is_none();
                    let far: Vec<usize> = (0..v.len()).filter(|&x| is_far(x)).collect();
                    labeling[at] = far[(random.next_u64() % far.len() as u64) as usize] as u32;
                }
                let variables = mesh.edge_graph();
                let found =
                    identify_outliers(&variables, &labels.reach(), &labeling, &residuals(&mesh, &labeling), 4.0).unwrap();
                for (at, reason) in found.iter().enumerate() {
                    prop_assert_eq!(*reason, if planted.contains(&at) { OutlierReason::Both } else { OutlierReason::None }, "vertex {}", at);
                }
            }
        }
    }

    #[test]
    fn a_patch_that_moves_together_breaks_only_at_its_rim() {
        // Half of a torus is rotated against the other half: only edges along the two seams break.
        let (around, across) = (40u32, 12u32);
        let mesh = torus(10.0, 4.0, around, across, FaceArity::Quad);
        let labeling: Vec<u32> = (0..around * across)
            .map(|v| {
                let (i, j) = (v / across, v % across);
                if i < around / 2 { v } else { i * across + (j + across / 2) % across }
            })
            .collect();
        let labels = neighborhoods(&mesh, 1);
        let own = residuals(&mesh, &labeling);
        let found = identify_outliers(&mesh.edge_graph(), &labels.reach(), &labeling, &own, 1.0).unwrap();
        for (v, reason) in found.iter().enumerate() {
            let moved = v as u32 / across >= around / 2;
            assert_eq!(*reason, if moved { OutlierReason::Residual } else { OutlierReason::None }, "vertex {v}");
        }
    }

    #[test]
    fn a_torn_neighborhood_is_an_outlier_even_within_the_tolerance() {
        let mesh = ellipsoid(Vector3::repeat(6.0), 3);
        let mut labeling: Vec<u32> = (0..mesh.n_vertices() as u32).collect();
        let v = mesh.vertices();
        let far = (0..v.len()).max_by(|&a, &b| (v[a] - v[100]).norm().total_cmp(&(v[b] - v[100]).norm())).unwrap();
        labeling[100] = far as u32;
        let own = residuals(&mesh, &labeling);
        let found =
            identify_outliers(&mesh.edge_graph(), &neighborhoods(&mesh, 2).reach(), &labeling, &own, 100.0).unwrap();
        assert_eq!(found[100], OutlierReason::Neighborhood);
        assert_eq!(found.iter().filter(|r| **r != OutlierReason::None).count(), 1);
    }

    #[test]
    fn exactly_half_of_the_edges_may_break() {
        // A path of five variables over five labels in a row; the label of the last variable is far away.
        let path = EdgeGraph::from_edges(5, &[[0, 1], [1, 2], [2, 3], [3, 4]]);
        let labels = LabelNeighborhoods::new(&path, 1, |_, _| 0.0);
        let found = identify_outliers(&path, &labels.reach(), &[0, 1, 2, 3, 0], &[0.0; 5], 1.0).unwrap();
        assert_eq!(
            found,
            [OutlierReason::None; 4].into_iter().chain([OutlierReason::Neighborhood]).collect::<Vec<_>>()
        );
    }

    #[test]
    fn a_residual_that_is_not_a_number_is_an_outlier() {
        let path = EdgeGraph::from_edges(3, &[[0, 1], [1, 2]]);
        let labels = LabelNeighborhoods::new(&path, 1, |_, _| 0.0);
        let own = [1.0, f64::NAN, 1.0];
        let found = identify_outliers(&path, &labels.reach(), &[0, 1, 2], &own, 2.0).unwrap();
        assert_eq!(found, [OutlierReason::None, OutlierReason::Residual, OutlierReason::None]);
    }

    #[test]
    fn lengths_that_differ_are_an_error() {
        let path = EdgeGraph::from_edges(3, &[[0, 1], [1, 2]]);
        let labels = LabelNeighborhoods::new(&path, 1, |_, _| 0.0);
        let short = LabelingError::LengthMismatch { found: 2, n_vertices: 3 };
        assert_eq!(identify_outliers(&path, &labels.reach(), &[0, 1], &[0.0; 3], 1.0).unwrap_err(), short);
        assert_eq!(identify_outliers(&path, &labels.reach(), &[0, 1, 2], &[0.0; 2], 1.0).unwrap_err(), short);
    }
}
