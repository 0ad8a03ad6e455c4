//! Aligns shapes in one frame: generalized Procrustes analysis over subjects that are read one after the other.
//!
//! All shapes have the template's vertices. The metric is that of the surface: vertex `v` has as weight its share `w_v`
//! of the area. Neither the mean nor the distance of two shapes, `√(Σ w_v ‖p_v − q_v‖²)` (mm, root mean square),
//! therefore depends on the vertex density of the template.
//!
//! Source: Gower, *Generalized Procrustes analysis*, Psychometrika 40, 1975.

use crate::error::StudyError;
use crate::settings::Size;
use homolog_mesh::SurfaceMesh;
use homolog_primitives::observe::{Observer, checkpoint};
use homolog_registration::{ProcrustesOptions, SimilarityTransform, procrustes};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::ops::Range;

/// Subjects read at a time; bounds the memory for any number of threads.
const AT_A_TIME: usize = 32;
const MAX_ITERATIONS: usize = 20;
/// Relative movement of the mean in an iteration below which the mean is final.
const TOLERANCE: f64 = 1e-9;

/// Shapes with the same vertices, read in parts.
pub trait Shapes: Sync {
    /// Number of shapes.
    fn len(&self) -> usize;
    /// Whether there are no shapes.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// Number of vertices of each shape.
    fn n_vertices(&self) -> usize;
    /// Some vertices of one shape, mm, in the shape's own coordinates.
    ///
    /// # Errors
    /// [`StudyError`] if it cannot be read.
    fn read(&self, shape: usize, vertices: Range<usize>) -> Result<Vec<[f32; 3]>, StudyError>;
    /// The name of a shape in messages.
    fn name(&self, shape: usize) -> String;
}

/// Shapes in memory.
impl Shapes for Vec<Vec<[f32; 3]>> {
    fn len(&self) -> usize {
        <[_]>::len(self)
    }
    fn n_vertices(&self) -> usize {
        self.first().map_or(0, Vec::len)
    }
    fn read(&self, shape: usize, vertices: Range<usize>) -> Result<Vec<[f32; 3]>, StudyError> {
        Ok(self[shape][vertices].to_vec())
    }
    fn name(&self, shape: usize) -> String {
        format!("number {}", shape + 1)
    }
}

/// Shapes whose reading ends once an observer asks to stop, which also ends the computations that read them.
pub(crate) struct WatchedShapes<'a> {
    /// The shapes.
    pub(crate) shapes: &'a dyn Shapes,
    /// The observer, asked before every part that is read.
    pub(crate) observer: &'a dyn Observer,
}

impl Shapes for WatchedShapes<'_> {
    fn len(&self) -> usize {
        self.shapes.len()
    }
    fn n_vertices(&self) -> usize {
        self.shapes.n_vertices()
    }
    fn read(&self, shape: usize, vertices: Range<usize>) -> Result<Vec<[f32; 3]>, StudyError> {
        checkpoint(self.observer)?;
        self.shapes.read(shape, vertices)
    }
    fn name(&self, shape: usize) -> String {
        self.shapes.name(shape)
    }
}

/// Points in double precision.
pub(crate) fn points(read: &[[f32; 3]]) -> Vec<Point3<f64>> {
    read.iter().map(|&[x, y, z]| Point3::new(f64::from(x), f64::from(y), f64::from(z))).collect()
}

/// Shapes in one frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Alignment {
    /// The mean shape, mm.
    pub mean: Vec<Point3<f64>>,
    /// Share of the template's area at each vertex; the sum is 1.
    pub weights: Vec<f64>,
    /// For each shape the transform onto the mean.
    pub onto_mean: Vec<SimilarityTransform>,
    /// Number of iterations.
    pub iterations: usize,
}

/// Share of the area of `mesh` at each vertex: a third of each adjacent triangle; the sum is 1.
pub fn area_weights(mesh: &SurfaceMesh) -> Vec<f64> {
    let areas = vertex_areas(mesh);
    let whole: f64 = areas.iter().sum();
    areas.into_iter().map(|area| area / whole).collect()
}

/// Area at each vertex, mm²: an equal part of each adjacent face.
pub fn vertex_areas(mesh: &SurfaceMesh) -> Vec<f64> {
    let mut areas = vec![0.0; mesh.n_vertices()];
    for (face, area) in mesh.faces().zip(mesh.face_vector_areas()) {
        face.iter().for_each(|&v| areas[v as usize] += area.norm() / face.len() as f64);
    }
    areas
}

/// The mean of shapes and the transforms onto it, starting with the vertices of `template` as the mean. With
/// [`Size::Removed`] all shapes are scaled to the mean of their centroid sizes.
///
/// # Errors
/// [`StudyError::Alignment`] for a shape whose points do not determine an orientation; errors of reading.
///
/// # Cost
/// Reads every shape once per iteration, usually three to five times, [`AT_A_TIME`] in memory; sums have a fixed order.
pub fn align(shapes: &dyn Shapes, template: &SurfaceMesh, size: Size) -> Result<Alignment, StudyError> {
    let weights = area_weights(template);
    let (mut mean, n) = (template.vertices().to_vec(), shapes.len());
    let sized = size == Size::Removed;
    let (mut onto_mean, mut iterations) = (Vec::new(), 0);
    let mut wanted_size = None;
    while iterations < MAX_ITERATIONS {
        iterations += 1;
        onto_mean.clear();
        let (mut sum, mut sizes) = (vec![Vector3::zeros(); mean.len()], 0.0);
        for first in (0..n).step_by(AT_A_TIME) {
            let placed: Vec<_> = (first..n.min(first + AT_A_TIME))
                .into_par_iter()
                .map(|shape| place(shapes, shape, &mean, &weights, sized))
                .collect::<Result<_, _>>()?;
            for (transform, moved, size) in placed {
                sum.iter_mut().zip(&moved).for_each(|(sum, p)| *sum += p.coords);
                onto_mean.push(transform);
                sizes += size;
            }
        }
        let mut next: Vec<Point3<f64>> = sum.into_iter().map(|sum| Point3::from(sum / n as f64)).collect();
        if sized {
            let wanted = *wanted_size.get_or_insert(sizes / n as f64);
            scale_to(&mut next, &weights, wanted);
        }
        let moved = rms(&next, &mean, &weights);
        mean = next;
        if moved <= TOLERANCE * centroid_size(&mean, &weights) {
            break;
        }
    }
    Ok(Alignment { mean, weights, onto_mean, iterations })
}

type Placed = (SimilarityTransform, Vec<Point3<f64>>, f64);

fn place(
    shapes: &dyn Shapes,
    shape: usize,
    mean: &[Point3<f64>],
    weights: &[f64],
    sized: bool,
) -> Result<Placed, StudyError> {
    let read = points(&shapes.read(shape, 0..mean.len())?);
    let transform = fit_onto(&read, mean, weights, sized)
        .map_err(|error| StudyError::Alignment { id: shapes.name(shape), error })?;
    let size = centroid_size(&read, weights);
    Ok((transform, read.iter().map(|p| transform.apply(p)).collect(), size))
}

/// The transform of one shape onto the mean.
pub(crate) fn fit_onto(
    shape: &[Point3<f64>],
    mean: &[Point3<f64>],
    weights: &[f64],
    with_scale: bool,
) -> Result<SimilarityTransform, homolog_registration::OrientationError> {
    let options = ProcrustesOptions { with_scale, ..ProcrustesOptions::default() };
    let mut found = procrustes(shape, mean, Some(weights), &options)?.target_from_source;
    if with_scale {
        // Scaled to the size of the mean. Scaling to the least residual would shrink poorly fitting shapes.
        let scale = centroid_size(mean, weights) / centroid_size(shape, weights);
        let (from, to) = (centroid(shape, weights), centroid(mean, weights));
        found = SimilarityTransform { scale, translation: to - scale * (found.rotation * from), ..found };
    }
    Ok(found)
}

fn centroid(points: &[Point3<f64>], weights: &[f64]) -> Vector3<f64> {
    points.iter().zip(weights).map(|(p, w)| p.coords * *w).sum()
}

/// Root mean square distance from the centroid, mm.
pub fn centroid_size(points: &[Point3<f64>], weights: &[f64]) -> f64 {
    let center = centroid(points, weights);
    points.iter().zip(weights).map(|(p, w)| w * (p.coords - center).norm_squared()).sum::<f64>().sqrt()
}

fn scale_to(points: &mut [Point3<f64>], weights: &[f64], size: f64) {
    let (center, factor) = (centroid(points, weights), size / centroid_size(points, weights));
    points.iter_mut().for_each(|p| p.coords = center + factor * (p.coords - center));
}

/// Root mean square distance of corresponding points, mm.
pub fn rms(a: &[Point3<f64>], b: &[Point3<f64>], weights: &[f64]) -> f64 {
    a.iter().zip(b).zip(weights).map(|((p, q), w)| w * (p - q).norm_squared()).sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use homolog_mesh::shapes::ellipsoid;
    use nalgebra::{Isometry3, Vector3};

    fn copies() -> (SurfaceMesh, Vec<Vec<[f32; 3]>>) {
        let mesh = ellipsoid(Vector3::new(9.0, 5.0, 3.0), 3);
        let shapes = (0..40).map(|k| {
            let k = f64::from(k);
            let motion = Isometry3::new(Vector3::new(k, -k, 3.0), Vector3::new(0.1 * k, 0.3, -0.02 * k));
            let scale = 1.0 + 0.01 * k;
            mesh.vertices()
                .iter()
                .map(|p| (motion * Point3::from(p.coords * scale)).coords.map(|x| x as f32).into())
                .collect()
        });
        (mesh.clone(), shapes.collect())
    }

    #[test]
    fn copies_that_were_moved_and_scaled_become_one_shape() {
        let (mesh, shapes) = copies();
        let found = align(&shapes, &mesh, Size::Removed).unwrap();
        for (shape, onto) in shapes.iter().zip(&found.onto_mean) {
            let moved: Vec<_> = points(shape).iter().map(|p| onto.apply(p)).collect();
            assert!(rms(&moved, &found.mean, &found.weights) < 1e-5);
        }
        // With size kept, the remaining difference is size.
        let kept = align(&shapes, &mesh, Size::Kept).unwrap();
        assert!(kept.onto_mean.iter().all(|t| t.scale == 1.0));
        let size = |k: usize| centroid_size(&points(&shapes[k]), &kept.weights);
        let moved: Vec<_> = points(&shapes[39]).iter().map(|p| kept.onto_mean[39].apply(p)).collect();
        let mean_size = centroid_size(&kept.mean, &kept.weights);
        assert!((rms(&moved, &kept.mean, &kept.weights) - (size(39) - mean_size).abs()).abs() < 1e-4);
    }

    #[test]
    fn threads_do_not_matter() {
        let (mesh, shapes) = copies();
        let with = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| align(&shapes, &mesh, Size::Kept).unwrap())
        };
        assert_eq!(with(1), with(3));
    }
}
