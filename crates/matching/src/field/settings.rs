//! The settings of single stages: every threshold with its unit and its reason.

/// The choice of the pose: a screening of all, then the first stage for a few.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ChoiceSettings {
    /// Vertices of either surface in the screening of all poses.
    pub screening_samples: usize,
    /// Steps of the screening.
    pub screening_steps: u32,
    /// Of poses of one handedness that are the same within this angle, radians, only the better one is followed: later
    /// stages would lead both to the same pose.
    pub same_pose_rad: f64,
    /// Poses of one handedness that are followed after the screening.
    pub followed: usize,
    /// A rotation about the axis about which the source is most nearly round is better than none only if its misfit is lower by this: of
    /// nearly round copies with noise it was lower by up to 0.006 by chance, and answers were off by 10° to 15°; of 13 beans with warps
    /// of 8 % for which a rotation was followed it was lower by 0.007 to 0.036 in ten.
    pub least_gain_of_rotation: f64,
    /// Steps of the first stage from a pose that an earlier fit has found.
    pub steps_from_known_pose: u32,
}

impl Default for ChoiceSettings {
    fn default() -> Self {
        ChoiceSettings {
            screening_samples: 250,
            screening_steps: 6,
            same_pose_rad: std::f64::consts::FRAC_PI_4,
            followed: 2,
            least_gain_of_rotation: 0.01,
            steps_from_known_pose: 6,
        }
    }
}

/// The fine stage and the settling after it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FineSettings {
    /// Standard deviation of a point along the normal of the other surface, in sampling distances.
    pub along: f64,
    /// Share of the assignment's weight that is kept across the normal. With 0.3 narrow 4 % warps had 0.77 of the vertices within
    /// one edge instead of 0.80, warps of 8 % 0.97 instead of 0.98; with 1 0.69 and 0.91.
    pub across_share: f64,
    /// Residual along the normals, in sampling distances, below which two surfaces are copies of one anatomy.
    pub noise: f64,
    /// Observations of the settling are weighted by `(noise / residual)` to this power: two for the variance, the rest because larger
    /// residuals are correlated over larger areas.
    pub noise_power: f64,
}

impl Default for FineSettings {
    fn default() -> Self {
        FineSettings { along: 0.34, across_share: 0.1, noise: 0.136, noise_power: 6.0 }
    }
}

/// The local stage.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LocalSettings {
    /// Widths of a second kernel that are tried, in diagonals of the source. What varies over a shorter distance, two or three voxels of a
    /// hippocampus, is the outline that somebody drew: with 0.05 as well, landmarks on molars were farther off (3.7 % of the
    /// root of the area, against 3.5 %) and so were narrow warps (0.44 edges, against 0.42).
    pub widths: [f64; 4],
    /// Displacement over the amplitude that the heights show: they are distances to the closest points, and a point that is
    /// displaced along the surface as well has a closer one than its counterpart.
    pub amplitude: f64,
    /// Share of the amplitude that the heights show which counts as noise along the normals: shapes of two subjects differ there where
    /// nothing was displaced.
    pub offset_share: f64,
    /// Points over which the marginal likelihood is evaluated.
    pub evidence_samples: usize,
    /// Gain of the logarithm of the marginal likelihood from which a second kernel is added: the Bayesian information criterion for
    /// its width and its variance.
    pub least_gain: f64,
    /// Least amplitude of a second kernel, in standard deviations of the noise that it leaves: what is lower is taken for noise, whose
    /// neighbors correlate a little. Both are tried in steps of √2. Skulls with an amplitude equal to the noise, a tenth of the sampling,
    /// had landmarks at 0.72 and 0.60 % of the root of the area with that kernel, at 0.60 and 0.49 % without; narrow warps have 1.4 and
    /// more.
    pub least_amplitude: f64,
    /// Noise along the normals of surfaces made of voxels (hippocampi with warps, 0.07 to 0.17), in sampling distances. Curvature is the
    /// noisier the noisier the surface, so what it says across the normals counts by the inverse of the noise's variance, against that
    /// of these. Molars (0.03 to 0.05) had landmarks at 4.23 % of the root of the area without this and at 4.05 % with it (10 pairs), 30
    /// other pairs at 4.32 and 4.21 %.
    pub voxel_noise: f64,
    /// Inducing points of the field with both kernels.
    pub n_inducing: usize,
    /// Steps of the middle and fine stages of that field, which begin at a pose that is known.
    pub stage_steps: [u32; 2],
    /// Points of the last fit. With half as many narrow 4 % warps had 0.73 of the vertices within one edge instead of
    /// 0.78, and bends by 120 degrees 0.90 instead of 0.93.
    pub samples: usize,
    /// Steps of the last fit.
    pub steps: u32,
    /// Weight of each of its points: 1 would take the error of the kernel's amplitude for noise of the points. Of 1, 1.5 and 2,
    /// narrow 4 % warps had 0.78, 0.80 and 0.80 of the vertices within one edge, and narrow 2 % warps a mean error of 0.73, 0.73 and
    /// 0.77 % of the diagonal.
    pub point_weight: f64,
}

impl Default for LocalSettings {
    fn default() -> Self {
        LocalSettings {
            widths: [0.07, 0.1, 0.14, 0.2],
            amplitude: 2.0,
            offset_share: 0.7,
            evidence_samples: 400,
            least_gain: 6.0,
            least_amplitude: 1.2,
            voxel_noise: 0.1,
            n_inducing: 200,
            stage_steps: [5, 5],
            samples: 2400,
            steps: 5,
            point_weight: 1.5,
        }
    }
}

/// The fit from near isometries.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct IsometryFitSettings {
    /// Correspondences that are followed, those of the lowest energies.
    pub followed: usize,
    /// Of them, those that go through all stages at most.
    pub refined: usize,
    /// Mean distance up to which two correspondences count as one, in roots of the area: less than the distance between sites.
    pub same: f64,
    /// Width of a second kernel, in diagonals: joints are narrower than the bends of one structure.
    pub joint_width: f64,
    /// Its standard deviation, in diagonals.
    pub joint_amplitude: f64,
    /// Inducing points of the field with both kernels.
    pub n_inducing: usize,
    /// Times that all stages are run again from where they ended, at most.
    pub passes: usize,
    /// Fall of the misfit at the scale of the sampling for which they are run once more.
    pub least_gain: f64,
    /// Standard deviation of the place where a vertex ended when the stages are run again, in diagonals of the source.
    pub rebased_sigma: f64,
    /// Standard deviation of a correspondence of the forms, in diagonals of the source.
    pub form_sigma: f64,
}

impl Default for IsometryFitSettings {
    fn default() -> Self {
        IsometryFitSettings {
            followed: 8,
            refined: 3,
            same: 0.03,
            joint_width: 0.12,
            joint_amplitude: 0.05,
            n_inducing: 250,
            passes: 6,
            least_gain: 0.005,
            rebased_sigma: 0.01,
            form_sigma: 0.02,
        }
    }
}

/// The thresholds by which the route decides what is tried and what is taken.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RouteSettings {
    /// Residual along the normals, in sampling distances, from which surfaces count as those of two subjects and are fitted in
    /// both directions: warps and copies had 0.09 to 0.11, pairs of subjects 0.20 to 0.33. For one anatomy the fit back only adds its own
    /// error: on ten 8 % warps 96.2 % of the vertices were within one edge with it, 97.6 % without.
    pub two_subjects: f64,
    /// Correlation of curvatures below which another start is tried. Its field is softer: tried for pairs of hippocampi too (0.72 and
    /// 0.9), it changed a quarter of their answers, and labels agreed on 0.964 of the vertices instead of 0.966 (30 pairs). In their
    /// answers pairs of hippocampi have 0.78 and 0.95 or more (30 pairs), copies and smooth warps more; bodies in two poses from a rigid
    /// start 0.35 and 0.59 or more (80 pairs): those that agree have limbs, and are tried in any case.
    pub doubtful_curvature: f64,
    /// The same of the mean cosine between normals.
    pub doubtful_normals: f64,
    /// Difference in the straightness of two center lines from which tubular surfaces that agree are straightened too: bends by 90° are
    /// at 0.18 and more, pairs of hippocampi at 0.14 and less. It only skips hopeless attempts; acceptance uses the misfit.
    pub bent: f64,
    /// An answer by straightened surfaces is taken if one of its starts, mirrored or not, has a misfit that is lower by this than those of
    /// all rigid starts: for bent capsules it is lower by 0.38 to 0.72, for hippocampi with warps and of two subjects by 0.06 at most.
    pub straight: f64,
}

impl Default for RouteSettings {
    fn default() -> Self {
        RouteSettings { two_subjects: 0.17, doubtful_curvature: 0.6, doubtful_normals: 0.87, bent: 0.15, straight: 0.2 }
    }
}
