//! A surface prepared for a displacement field: slightly smoothed, with curvature features.

use super::robust::median;
use super::side::POSITION_SCALE;
use super::surface_index::SurfaceIndex;
use crate::error::MatchError;
use homolog_geometry::curvature::{Curvatures, ScaleSpace, angle_defect_curvatures, vertex_areas};
use homolog_mesh::SurfaceMesh;
use homolog_registration::alignment::{AssignmentTarget, OrientedPoints};
use nalgebra::{Point3, Vector3};
use rayon::prelude::*;
use std::sync::OnceLock;

/// Scales of the features, in roots of the area. They are finer than those of the pose search, because the poses are
/// already close. The first is also the scale of the normals.
const FEATURE_SCALES: [f64; 3] = [0.025, 0.05, LARGEST_SCALE];
/// The largest scale of the features, in roots of the area.
pub(crate) const LARGEST_SCALE: f64 = 0.0875;
/// Number of features: Gaussian and mean curvature at each scale.
pub(crate) const N_FEATURES: usize = 2 * FEATURE_SCALES.len();
/// One surface, prepared for a displacement field.
pub(crate) struct SmoothSurface {
    /// Positions at [`POSITION_SCALE`].
    pub mesh: SurfaceMesh,
    /// Unit normals of its vertices.
    pub normals: Vec<Vector3<f64>>,
    /// Area of each vertex, mm².
    pub areas: Vec<f64>,
    /// Weight of the displacement of each vertex, mm²: its area, reduced at the rim of a part.
    counted: Vec<f64>,
    /// Factor on all scales: 1 for a surface without noise, larger for noisy ones.
    pub coarsening: f64,
    /// `n × N_FEATURES`.
    pub features: Vec<f64>,
    /// Its closest points, built on first use.
    closest: OnceLock<SurfaceIndex>,
}

/// Every `k`-th vertex of a surface, with areas that sum to the area of the surface.
pub(crate) struct Subsample {
    /// Indices of the vertices.
    pub vertices: Vec<usize>,
    pub points: Vec<Point3<f64>>,
    pub normals: Vec<Vector3<f64>>,
    pub areas: Vec<f64>,
    /// Weights of the displacements, mm².
    pub counted: Vec<f64>,
    pub features: Vec<f64>,
}

/// A surface with its scale space.
pub(crate) struct Flow<'a> {
    mesh: &'a SurfaceMesh,
    space: ScaleSpace<'a>,
    root_mm: f64,
    /// At [`POSITION_SCALE`].
    smoothed: SurfaceMesh,
}

impl<'a> Flow<'a> {
    pub(crate) fn new(mesh: &'a SurfaceMesh, root_mm: f64) -> Result<Self, MatchError> {
        let space = ScaleSpace::new(mesh);
        let smoothed = at(&space, POSITION_SCALE * root_mm)?;
        Ok(Flow { mesh, space, root_mm, smoothed })
    }

    /// Median distance that light smoothing moves a vertex, mm.
    pub(crate) fn grain_mm(&self) -> f64 {
        let (rough, smooth) = (self.mesh.vertices(), self.smoothed.vertices());
        let mut moved: Vec<f64> = rough.iter().zip(smooth).map(|(p, q)| (p - q).norm()).collect();
        median(&mut moved)
    }

    /// The surface without features, and the values of the features before standardization; all scales are multiplied
    /// by `coarsening`.
    pub(crate) fn surface(self, coarsening: f64) -> Result<(SmoothSurface, Vec<Vec<f64>>), MatchError> {
        let at_scales: Vec<(SurfaceMesh, Curvatures)> = FEATURE_SCALES
            .into_par_iter()
            .map(|scale| {
                let smoothed = at(&self.space, coarsening * scale * self.root_mm)?;
                let measured = angle_defect_curvatures(&smoothed);
                Ok((smoothed, measured))
            })
            .collect::<Result<_, MatchError>>()?;
        let normals = at_scales[0].0.vertex_normals();
        let values = at_scales.into_iter().flat_map(|(_, measured)| [measured.mean, measured.gaussian]).collect();
        let mesh =
            if coarsening > 1.0 { at(&self.space, coarsening * POSITION_SCALE * self.root_mm)? } else { self.smoothed };
        let areas = vertex_areas(&mesh);
        let surface = SmoothSurface {
            normals,
            counted: areas.clone(),
            areas,
            features: vec![0.0; mesh.n_vertices() * N_FEATURES],
            closest: OnceLock::new(),
            coarsening,
            mesh,
        };
        Ok((surface, values))
    }
}

fn at(space: &ScaleSpace<'_>, scale_mm: f64) -> Result<SurfaceMesh, MatchError> {
    space.smoothed(scale_mm).map_err(|_| MatchError::ScaleSpace { scale_mm })
}

impl SmoothSurface {
    /// Reduces the weight of vertices near the rim, within about `width_mm`. Their counterparts lie partly beyond the
    /// rim, where this surface is missing, and would pull them outwards.
    pub(crate) fn discount_rim(&mut self, width_mm: f64) {
        let Some(on_rim) = self.mesh.boundary_vertices() else { return };
        let points = self.mesh.vertices();
        let rim: Vec<Point3<f64>> = points.iter().zip(&on_rim).filter(|(_, on)| **on).map(|(p, _)| *p).collect();
        let counted = |p: &Point3<f64>| {
            let squared = rim.iter().map(|q| (p - q).norm_squared()).fold(f64::INFINITY, f64::min);
            1.0 - (-0.5 * squared / (width_mm * width_mm)).exp()
        };
        let shares: Vec<f64> = points.par_iter().map(counted).collect();
        self.counted.iter_mut().zip(&shares).for_each(|(area, share)| *area *= share);
    }

    /// Closest points of the surface, with its normals.
    pub(crate) fn closest(&self) -> &SurfaceIndex {
        self.closest.get_or_init(|| SurfaceIndex::with_normals(&self.mesh, self.normals.clone()))
    }

    pub(crate) fn samples(&self) -> OrientedPoints<'_> {
        OrientedPoints {
            points: self.mesh.vertices(),
            normals: &self.normals,
            areas: &self.areas,
            features: &self.features,
        }
    }

    /// All vertices as the target of assignments.
    pub(crate) fn assignment_target(&self) -> AssignmentTarget {
        AssignmentTarget::new(&self.samples())
    }

    /// At most `n` vertices. Canonical numbering follows a space-filling curve, so every `k`-th vertex is an even
    /// sample.
    pub(crate) fn thinned(&self, n: usize) -> Subsample {
        let step = self.mesh.n_vertices().div_ceil(n);
        let picked = || (0..self.mesh.n_vertices()).step_by(step);
        Subsample {
            vertices: picked().collect(),
            points: picked().map(|i| self.mesh.vertices()[i]).collect(),
            normals: picked().map(|i| self.normals[i]).collect(),
            areas: picked().map(|i| self.areas[i] * step as f64).collect(),
            counted: picked().map(|i| self.counted[i] * step as f64).collect(),
            features: picked().flat_map(|i| self.features[i * N_FEATURES..][..N_FEATURES].to_vec()).collect(),
        }
    }
}

impl Subsample {
    pub(crate) fn samples(&self) -> OrientedPoints<'_> {
        OrientedPoints { points: &self.points, normals: &self.normals, areas: &self.areas, features: &self.features }
    }

    /// These vertices as the target of assignments.
    pub(crate) fn assignment_target(&self) -> AssignmentTarget {
        AssignmentTarget::new(&self.samples())
    }
}
