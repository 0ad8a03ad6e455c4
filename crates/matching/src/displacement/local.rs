//! The local stage: narrower displacements, where the residual heights show that there are some.
//!
//! After the fine stage the wide field has taken up what is smooth over a third of the structure. What remains along the
//! normals is either the noise of sampling or displacement over shorter distances. Their marginal likelihood decides, and
//! gives the width and the variance of a second kernel and the noise. The sum of both kernels is then fitted as one field:
//! normals of different directions within one width determine the displacement along the surface as well, and where they
//! do not, the posterior covariance says so.

use super::fine::{Refined, outwards};
use super::functions::Functions;
use super::prior;
use super::stages::{Base, Displacement, displaced, kernel, precision_of_features};
use crate::MatchError;
use faer::Mat;
use homolog_primitives::observe::checkpoint;
use homolog_registration::alignment::{OrientedPoints, assign};
use homolog_registration::deformation::{FittedField, KernelEvidence, fit_field, most_probable_kernel};
use nalgebra::{Point3, Vector3};

/// Widths that are tried, in diagonals of the source. What varies over a shorter distance, two or three voxels of a
/// hippocampus, is the outline that somebody drew: with 0.05 as well, landmarks on molars were farther off (3.7 % of the
/// root of the area, against 3.5 %) and so were narrow warps (0.44 edges, against 0.42).
const WIDTHS: [f64; 4] = [0.07, 0.1, 0.14, 0.2];
/// Amplitude of the kernel that counts as noise along the normals; 0.3 to 1 gave the same errors within their spread.
const OFFSET_SHARE: f64 = 0.7;
/// Points over which the marginal likelihood is evaluated.
const EVIDENCE_SAMPLES: usize = 400;
/// Gain of the logarithm of the marginal likelihood from which a second kernel is added.
const LEAST_GAIN: f64 = 20.0;
/// Inducing points of the field with both kernels.
const N_INDUCING: usize = 300;
/// Points and steps of the fit.
const SAMPLES: usize = 1200;
const STEPS: u32 = 5;

impl Displacement<'_> {
    /// The field with a second, narrower kernel, from the source after the rigid `pose` (`all_base`) and after the fine stage
    /// (`moved`); `None` where the heights over the target are no more than noise.
    pub(super) fn local(
        &self,
        base: &Base,
        all_base: &[Point3<f64>],
        moved: Vec<Point3<f64>>,
        feature_precision: Vec<f64>,
        residual_mm: f64,
    ) -> Result<Option<Refined>, MatchError> {
        let Some(found) = self.evidence(&moved) else { return Ok(None) };
        if found.gain < LEAST_GAIN {
            return Ok(None);
        }
        checkpoint(self.observer)?;
        let mut prior = prior(self.diagonal_mm, self.options);
        prior.kernels.push(found.kernel);
        // Shapes of two subjects differ along the normals where nothing was displaced.
        let noise_mm = found.noise_mm.hypot(OFFSET_SHARE * found.kernel.amplitude_mm);
        let Some(functions) = self.functions.with_prior(self.source.mesh.vertices(), prior, N_INDUCING) else {
            return Ok(None);
        };
        let fitted = self.fitted(base, &functions, noise_mm, all_base, moved, feature_precision)?;
        Ok(fitted.map(|field| Refined {
            base: base.clone(),
            base_functions: self.functions.clone(),
            field,
            functions,
            residual_mm,
            is_local: true,
        }))
    }

    /// The kernel under which the heights of the source, moved to `moved`, below the target are most probable.
    fn evidence(&self, moved: &[Point3<f64>]) -> Option<KernelEvidence> {
        let source = self.source.mesh.vertices();
        let step = source.len().div_ceil(EVIDENCE_SAMPLES);
        let picked: Vec<usize> = (0..source.len()).step_by(step).collect();
        let mut heights = Vec::with_capacity(picked.len());
        let mut normals = Vec::with_capacity(picked.len());
        for &i in &picked {
            let at = self.closest.index.closest(&moved[i]);
            let normal = at.blend(|k| self.target.normals[k]).try_normalize(1e-9)?;
            heights.push(normal.dot(&(at.point - moved[i])));
            normals.push(normal);
        }
        let points: Vec<Point3<f64>> = picked.iter().map(|&i| source[i]).collect();
        let points = self.functions.coordinates(&points);
        let widths = WIDTHS.map(|w| w * self.diagonal_mm);
        most_probable_kernel(&points, &normals, &heights, &widths)
    }

    /// The field of `functions` after some steps from `moved`, with noise of `noise_mm` along the normals.
    fn fitted(
        &self,
        start: &Base,
        functions: &Functions,
        noise_mm: f64,
        all_base: &[Point3<f64>],
        mut moved: Vec<Point3<f64>>,
        mut precision: Vec<f64>,
    ) -> Result<Option<FittedField>, MatchError> {
        let thinned = self.source.thinned(SAMPLES);
        let target = self.target.samples();
        let all_values = functions.values(self.source.mesh.vertices());
        let values =
            Mat::from_fn(thinned.vertices.len(), all_values.ncols(), |i, k| all_values[(thinned.vertices[i], k)]);
        let guides = self.guides.with_functions(functions);
        let guided = self.guides.observations(start);
        let values = guides.below(&values);
        let base: Vec<Point3<f64>> = thinned.vertices.iter().map(|&i| all_base[i]).collect();

        let sigma_mm = self.diagonal_mm * self.options.sigma[3];
        let mean_area = thinned.areas.iter().sum::<f64>() / thinned.areas.len() as f64;
        let along = 1.0 / (mean_area * noise_mm * noise_mm);
        let across = self.density(3, 3, 1.0) / (sigma_mm * sigma_mm);
        let outwards = outwards(&start.pose);
        let mut fitted = None;
        for _ in 0..STEPS {
            checkpoint(self.observer)?;
            let Ok(mesh) = self.source.mesh.with_vertices(moved) else { return Ok(None) };
            let normals = mesh.vertex_normals();
            let normals: Vec<Vector3<f64>> = thinned.vertices.iter().map(|&i| normals[i] * outwards).collect();
            let points: Vec<Point3<f64>> = thinned.vertices.iter().map(|&i| mesh.vertices()[i]).collect();
            let samples = OrientedPoints { points: &points, normals: &normals, ..thinned.samples() };
            let assigned = assign(&samples, &target, &kernel(sigma_mm, precision));
            let (observed, _) = self.sliding(&assigned, &samples, &base, along, across);
            let observed = [observed, guided.clone()].concat();
            let Some(next) = fit_field(values.as_ref(), &observed) else { return Ok(None) };
            moved = displaced(all_base, &next, &all_values);
            precision = precision_of_features(&assigned.feature_variance);
            fitted = Some(next);
        }
        Ok(fitted)
    }
}
