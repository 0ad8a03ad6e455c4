//! Extends the answer for a simplified surface to all vertices of the original.
//!
//! A vertex dropped by simplification lies on or near a triangle of the simplified surface. Its corresponding point is
//! the mean of the corresponding points of the triangle's corners, with its barycentric coordinates as weights,
//! projected to the closest point of the other surface before simplification.

use crate::intake::PreparedSurface;
use homolog_contract::result::Correspondences;
use homolog_mesh::{ClosestPoint, ClosestPointIndex, SurfaceMesh};
use nalgebra::{Point3, Vector3};

/// Converts `pairs` of the simplified surfaces to pairs of the whole surfaces: rows for all vertices, ascending, and
/// corresponding points on triangles of the whole surface. Returns the same pairs if neither surface was simplified.
///
/// For a dropped vertex, `confidence` and `spread_mm` are the weighted means over the corners, and `inlier` and
/// `outlier` are taken from the corner with the largest weight.
pub(crate) fn of_whole(pairs: Correspondences, source: &PreparedSurface, target: &PreparedSurface) -> Correspondences {
    if source.dropped().is_empty() && target.dropped().is_empty() {
        return pairs;
    }
    let Correspondences { inverse, .. } = &pairs;
    let inverse = inverse.as_deref().map(|inverse| Box::new(one_way(inverse, target, source)));
    Correspondences { inverse, ..one_way(&pairs, source, target) }
}

fn one_way(pairs: &Correspondences, source: &PreparedSurface, target: &PreparedSurface) -> Correspondences {
    let surface = target.uploaded();
    let index = ClosestPointIndex::new(surface);
    let images: Vec<Option<Point3<f64>>> = (0..pairs.source.len()).map(|row| image(surface, pairs, row)).collect();
    let mut whole = Correspondences::default();
    let mut row_of = vec![usize::MAX; source.uploaded().n_vertices()];
    for (row, &vertex) in pairs.source.iter().enumerate() {
        if let Some(slot) = row_of.get_mut(vertex as usize) {
            *slot = row;
        }
        if target.dropped().is_empty() {
            whole.triangle.push(pairs.triangle[row]);
            whole.barycentric.push(pairs.barycentric[row]);
            whole.target.push(pairs.target[row]);
        } else {
            whole.push_image(&images[row].map_or_else(|| at_vertex(pairs.target[row]), |image| index.closest(&image)));
        }
        whole.source.push(vertex);
        whole.confidence.push(pairs.confidence[row]);
        whole.inlier.push(pairs.inlier[row]);
        whole.spread_mm.push(pairs.spread_mm[row]);
        whole.outlier.push(pairs.outlier[row]);
    }
    for dropped in source.dropped() {
        let rows = dropped.triangle.map(|vertex| row_of[vertex as usize]);
        let corners: Option<Vec<(usize, Point3<f64>)>> =
            rows.into_iter().map(|row| Some((row, (*images.get(row)?)?))).collect();
        let Some(corners) = corners else { continue };
        let weighted = || corners.iter().zip(dropped.barycentric);
        let mean: Vector3<f64> = weighted().map(|((_, image), weight)| image.coords * weight).sum();
        let value = |values: &[f64]| weighted().map(|((row, _), weight)| values[*row] * weight).sum();
        let heaviest = weighted().max_by(|a, b| a.1.total_cmp(&b.1)).map_or(corners[0].0, |((row, _), _)| *row);
        whole.push_image(&index.closest(&Point3::from(mean)));
        whole.source.push(dropped.vertex);
        whole.confidence.push(value(&pairs.confidence));
        whole.inlier.push(pairs.inlier[heaviest]);
        whole.spread_mm.push(value(&pairs.spread_mm));
        whole.outlier.push(pairs.outlier[heaviest]);
    }
    sorted(&whole)
}

trait PushImage {
    fn push_image(&mut self, at: &ClosestPoint);
}

impl PushImage for Correspondences {
    fn push_image(&mut self, at: &ClosestPoint) {
        self.triangle.push(at.triangle);
        self.barycentric.push(at.barycentric);
        self.target.push(at.nearest_corner());
    }
}

/// The corresponding point of a row.
fn image(target: &SurfaceMesh, pairs: &Correspondences, row: usize) -> Option<Point3<f64>> {
    let corners = pairs.triangle.get(row)?.iter().zip(pairs.barycentric.get(row)?);
    let mut point = Vector3::zeros();
    for (&vertex, &weight) in corners {
        point += target.vertices().get(vertex as usize)?.coords * weight;
    }
    Some(point.into())
}

fn at_vertex(vertex: u32) -> ClosestPoint {
    ClosestPoint { point: Point3::origin(), triangle: [vertex; 3], barycentric: [1.0, 0.0, 0.0] }
}

/// The rows by source vertex.
fn sorted(rows: &Correspondences) -> Correspondences {
    let mut order: Vec<usize> = (0..rows.source.len()).collect();
    order.sort_unstable_by_key(|&row| rows.source[row]);
    fn pick<T: Copy>(order: &[usize], values: &[T]) -> Vec<T> {
        order.iter().map(|&row| values[row]).collect()
    }
    Correspondences {
        source: pick(&order, &rows.source),
        target: pick(&order, &rows.target),
        confidence: pick(&order, &rows.confidence),
        inlier: pick(&order, &rows.inlier),
        spread_mm: pick(&order, &rows.spread_mm),
        outlier: pick(&order, &rows.outlier),
        triangle: pick(&order, &rows.triangle),
        barycentric: pick(&order, &rows.barycentric),
        inverse: None,
    }
}

#[cfg(test)]
mod tests {
    use crate::intake::IntakeLimits;
    use crate::{InputFile, RunOutput, run_match};
    use homolog_contract::parameters::resolve;
    use homolog_contract::result::WarpDirection;
    use homolog_formats::write_ply;
    use homolog_laboratory::phantom::PhantomPair;
    use homolog_mesh::ClosestPointIndex;
    use homolog_primitives::observe::Silent;
    use serde_json::json;

    #[test]
    fn all_vertices_of_simplified_surfaces_are_answered_nearly_as_without() {
        let pair = PhantomPair::against_template(0).unwrap().meshes(1.0).unwrap();
        let files = pair.each_ref().map(write_ply);
        let run = |parameters: serde_json::Value| -> RunOutput {
            let [source, target] = files.each_ref().map(|bytes| InputFile { bytes, name: None });
            run_match(source, target, &resolve(&parameters).unwrap(), &IntakeLimits::default(), &Silent).unwrap()
        };
        let full = run(json!({"both_directions": true}));
        let n = [0, 1].map(|k| pair[k].n_vertices());
        let small = run(json!({"both_directions": true, "input": {"max_vertices": 700}}));
        assert_eq!(
            [&small.document.provenance.source, &small.document.provenance.target].map(|p| p.n_vertices),
            [700; 2]
        );
        let columns = small.document.correspondences.as_ref().unwrap();
        assert_eq!(columns.source, (0..n[0] as u32).collect::<Vec<_>>());
        assert_eq!(columns.inverse.as_ref().unwrap().source, (0..n[1] as u32).collect::<Vec<_>>());
        assert_eq!([&small.source, &small.target], [&full.source, &full.target]);
        for direction in [WarpDirection::Forward, WarpDirection::Inverse] {
            let [a, b] = [&small, &full].map(|output| output.warped(direction).unwrap().mesh);
            let index = ClosestPointIndex::new(match direction {
                WarpDirection::Forward => &full.target,
                WarpDirection::Inverse => &full.source,
            });
            let apart: Vec<f64> = a.vertices().iter().zip(b.vertices()).map(|(a, b)| (a - b).norm()).collect();
            let mean = apart.iter().sum::<f64>() / apart.len() as f64;
            assert!(mean < 1.0, "{mean} mm with edges of 1 mm");
            assert!(a.vertices().iter().all(|p| (index.closest(p).point - p).norm() < 1e-6), "on the whole surface");
        }
    }
}
