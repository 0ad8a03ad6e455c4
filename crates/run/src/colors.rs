//! Colors of both surfaces: by correspondence, by confidence, by residual.

use homolog_contract::result::{Correspondences, OutlierReason};
use homolog_mesh::SurfaceMesh;
use nalgebra::{Point3, Vector3};

/// A color, red, green and blue.
type Color = [u8; 3];

/// Color of a vertex without a value.
const GRAY: Color = [176, 180, 186];
/// The color map viridis (Smith, van der Walt, 2015) at equal steps.
const VIRIDIS: [Color; 9] = [
    [68, 1, 84],
    [71, 45, 123],
    [59, 82, 139],
    [44, 114, 142],
    [33, 145, 140],
    [40, 174, 128],
    [94, 201, 98],
    [173, 220, 48],
    [253, 231, 37],
];

/// Colors of the vertices of both surfaces by correspondence, by confidence and by residual: red, green and blue
/// (sRGB), one vertex after the other. A vertex without a counterpart is gray.
#[derive(Debug, Clone, PartialEq)]
pub struct Colors {
    /// Colors of the source.
    pub source: [Vec<u8>; 3],
    /// Colors of the target.
    pub target: [Vec<u8>; 3],
    /// The residual at the end of the color scale, mm: the 95th percentile.
    pub largest_residual_mm: f64,
}

impl Colors {
    /// `rigid` and `bent` are the source, moved rigidly onto the target and deformed onto it.
    pub fn new(pairs: &Correspondences, rigid: &SurfaceMesh, bent: &SurfaceMesh, target: &SurfaceMesh) -> Self {
        let n = rigid.n_vertices();
        let (mut confidence, mut residual) = (vec![None; n], vec![None; n]);
        for (row, &vertex) in pairs.source.iter().enumerate() {
            let vertex = vertex as usize;
            if pairs.outlier.get(row) == Some(&OutlierReason::NoCounterpart) || vertex >= n {
                continue;
            }
            confidence[vertex] = pairs.confidence.get(row).copied();
            residual[vertex] = Some((bent.vertices()[vertex] - rigid.vertices()[vertex]).norm());
        }
        let mut sorted: Vec<f64> = residual.iter().flatten().copied().collect();
        sorted.sort_by(f64::total_cmp);
        let largest = sorted.get(sorted.len() * 19 / 20).copied().unwrap_or(0.0).max(f64::MIN_POSITIVE);
        let of_place = Places::over(target.vertices());
        let places = (0..n).map(|v| confidence[v].map_or(GRAY, |_| of_place.color(&bent.vertices()[v])));
        let source = [places.flatten().collect(), bytes(&confidence, 1.0), bytes(&residual, largest)];
        let target_confidence = carried(pairs, target, &confidence);
        let target_residual = carried(pairs, target, &residual);
        let target = [
            target.vertices().iter().flat_map(|p| of_place.color(p)).collect(),
            bytes(&target_confidence, 1.0),
            bytes(&target_residual, largest),
        ];
        Colors { source, target, largest_residual_mm: largest }
    }
}

/// Colors by position: red, green and blue each encode an axis of the box around the points.
struct Places {
    low: Vector3<f64>,
    size: Vector3<f64>,
}

impl Places {
    fn over(points: &[Point3<f64>]) -> Self {
        let low = points.iter().fold(Vector3::repeat(f64::INFINITY), |low, p| low.inf(&p.coords));
        let high = points.iter().fold(Vector3::repeat(f64::NEG_INFINITY), |high, p| high.sup(&p.coords));
        Places { low, size: (high - low).map(|side| side.max(f64::MIN_POSITIVE)) }
    }

    fn color(&self, p: &Point3<f64>) -> Color {
        std::array::from_fn(|k| (255.0 * (0.1 + 0.85 * ((p[k] - self.low[k]) / self.size[k]).clamp(0.0, 1.0))) as u8)
    }
}

/// Values of source vertices on the target. Each target vertex has the mean, by barycentric weight, of the source
/// vertices whose corresponding points lie on its triangles; other target vertices have the mean of their neighbors
/// with a value.
fn carried(pairs: &Correspondences, target: &SurfaceMesh, values: &[Option<f64>]) -> Vec<Option<f64>> {
    let mut sums = vec![(0.0, 0.0); target.n_vertices()];
    for (row, &vertex) in pairs.source.iter().enumerate() {
        let (Some(Some(value)), Some(triangle), Some(weights)) =
            (values.get(vertex as usize), pairs.triangle.get(row), pairs.barycentric.get(row))
        else {
            continue;
        };
        for (&corner, &weight) in triangle.iter().zip(weights) {
            if let Some(sum) = sums.get_mut(corner as usize) {
                sum.0 += weight * value;
                sum.1 += weight;
            }
        }
    }
    let mut carried: Vec<Option<f64>> =
        sums.iter().map(|&(sum, weight)| (weight > 1e-9).then(|| sum / weight)).collect();
    let triangles = target.triangles();
    // Two rings; vertices farther from every corresponding point have no value.
    for _ in 0..2 {
        let mut around = vec![(0.0, 0.0); carried.len()];
        for triangle in &triangles {
            for &value in triangle.iter().filter_map(|&v| carried[v as usize].as_ref()) {
                for &v in triangle {
                    around[v as usize].0 += value;
                    around[v as usize].1 += 1.0;
                }
            }
        }
        for (value, (sum, n)) in carried.iter_mut().zip(around) {
            if value.is_none() && n > 0.0 {
                *value = Some(sum / n);
            }
        }
    }
    carried
}

/// Colors of values from 0 to their 95th percentile, as in [`Colors`].
pub fn value_colors(values: &[f64]) -> Vec<u8> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let largest = sorted.get(sorted.len() * 19 / 20).copied().unwrap_or(0.0).max(f64::MIN_POSITIVE);
    values.iter().flat_map(|value| viridis(value / largest)).collect()
}

/// Colors of values from 0 to `largest`.
fn bytes(values: &[Option<f64>], largest: f64) -> Vec<u8> {
    values.iter().flat_map(|value| value.map_or(GRAY, |value| viridis(value / largest))).collect()
}

/// The color of a share from 0 to 1.
fn viridis(share: f64) -> Color {
    let place = share.clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
    let step = (place as usize).min(VIRIDIS.len() - 2);
    let within = place - step as f64;
    std::array::from_fn(|k| {
        (f64::from(VIRIDIS[step][k]) * (1.0 - within) + f64::from(VIRIDIS[step + 1][k]) * within).round() as u8
    })
}

/// The color map as a bar, drawn in SVG because the policy of the page allows no style attributes.
pub(crate) fn ramp_svg() -> String {
    let bars: String = (0..32)
        .map(|k| {
            let [r, g, b] = viridis(f64::from(k) / 31.0);
            format!("<rect x=\"{}\" width=\"5.5\" height=\"10\" fill=\"#{r:02x}{g:02x}{b:02x}\"/>", 5 * k)
        })
        .collect();
    format!("<svg class=\"ramp\" viewBox=\"0 0 160 10\" preserveAspectRatio=\"none\" aria-hidden=\"true\">{bars}</svg>")
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;

    #[test]
    fn corresponding_points_have_one_color_and_values_are_carried() {
        let mesh = ellipsoid(Vector3::new(3.0, 2.0, 1.0), 2);
        let n = mesh.n_vertices() as u32;
        let pairs = Correspondences {
            source: (0..n).collect(),
            target: (0..n).collect(),
            confidence: (0..n).map(|v| f64::from(v) / f64::from(n)).collect(),
            inlier: vec![true; n as usize],
            spread_mm: vec![0.0; n as usize],
            outlier: (0..n).map(|v| if v == 0 { OutlierReason::NoCounterpart } else { OutlierReason::None }).collect(),
            triangle: (0..n).map(|v| [v; 3]).collect(),
            barycentric: vec![[1.0, 0.0, 0.0]; n as usize],
            inverse: None,
        };
        let colors = Colors::new(&pairs, &mesh, &mesh, &mesh);
        for mode in 0..2 {
            assert_eq!(colors.source[mode][3..], colors.target[mode][3..], "mode {mode}");
        }
        assert_eq!(colors.source[1][..3], GRAY, "no counterpart");
        assert_ne!(colors.target[1][..3], GRAY, "its neighbors have values");
        assert_eq!((viridis(0.0), viridis(1.0)), (VIRIDIS[0], VIRIDIS[8]));
    }
}
