//! What a study finds of a deformation, in numbers.

use crate::planted::Plant;
use homolog_study::align::vertex_areas;
use homolog_study::findings::Findings;
use std::error::Error;

/// Shares of areas, if a vertex is significant up to 0.05 by some p.
pub(crate) struct Claimed {
    /// Share of the patch that is significant.
    pub(crate) found: f64,
    /// Share of the significant area outside of the whole deformation; 0 if nothing is significant.
    pub(crate) falsely: f64,
}

/// Figures on the normal displacement. The patch is the part that moves by more than half of the height.
pub(crate) struct Figures {
    /// Mean effect over the patch, and mean of what was put there.
    pub(crate) effect_mm: f64,
    pub(crate) expected_mm: f64,
    /// Median standard error (HC3) in the patch.
    pub(crate) se_mm: f64,
    /// Share of the area of the patch whose effect has the right sign and exceeds two standard errors.
    pub(crate) beyond: f64,
    /// By what a study calls significant: the corrected p by enhanced clusters and the false discovery rate.
    pub(crate) significant: Claimed,
    /// By the corrected p of enhanced clusters alone.
    pub(crate) by_tfce: Claimed,
    /// From the largest |t| to the middle of the patch on the mean.
    pub(crate) distance_mm: f64,
}

impl Figures {
    /// Those of a study of normal displacement.
    ///
    /// # Errors
    /// If the study has no permutation test.
    pub(crate) fn of(plant: &Plant, found: &Findings) -> Result<Self, Box<dyn Error>> {
        let map =
            found.statistics.as_ref().and_then(|statistics| statistics.maps.first()).ok_or("there is no statistic")?;
        let (linear, permuted) = map.linear.as_ref().ok_or("there is no permutation test")?;
        let (expected, areas) = (plant.expected(&found.mean), vertex_areas(&found.mean));
        let is_in: Vec<bool> = expected.iter().map(|height| height.abs() > 0.5 * plant.height_mm.abs()).collect();
        let patch: Vec<usize> = (0..is_in.len()).filter(|&v| is_in[v]).collect();
        // An empty sum is −0.
        let area =
            |of: &dyn Fn(usize) -> bool| (0..areas.len()).filter(|&v| of(v)).map(|v| areas[v]).sum::<f64>() + 0.0;
        let whole = area(&|v| is_in[v]).max(f64::MIN_POSITIVE);
        let is_beyond = |v: usize| linear.effect[v] * expected[v].signum() > 2.0 * linear.robust_se[v];
        let claimed = |p: &[f64]| {
            let beside = area(&|v| p[v] <= 0.05 && expected[v] == 0.0);
            Claimed {
                found: area(&|v| is_in[v] && p[v] <= 0.05) / whole,
                falsely: if beside > 0.0 { beside / area(&|v| p[v] <= 0.05) } else { 0.0 },
            }
        };
        let mean = |values: &[f64]| patch.iter().map(|&v| values[v]).sum::<f64>() / patch.len().max(1) as f64;
        let mut errors: Vec<f64> = patch.iter().map(|&v| linear.robust_se[v]).collect();
        errors.sort_by(f64::total_cmp);
        let t = &permuted.t;
        let largest = (0..t.len()).fold(0, |best, v| if t[v].abs() > t[best].abs() { v } else { best });
        Ok(Figures {
            effect_mm: mean(&linear.effect),
            expected_mm: mean(&expected),
            se_mm: errors.get(errors.len() / 2).copied().unwrap_or(f64::NAN),
            beyond: area(&|v| is_in[v] && is_beyond(v)) / whole,
            significant: claimed(&map.p_local()),
            by_tfce: claimed(&permuted.p_tfce),
            distance_mm: (found.mean.vertices()[largest] - plant.middle(&found.mean)).norm(),
        })
    }
}
