//! Settings of single stages: thresholds with their units. Their evidence is in benches/thresholds.toml and
//! docs/findings.md.

/// The choice of the pose: a screening of all poses, then the coarse stage for a few.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ChoiceSettings {
    /// Vertices of either surface in the screening of all poses.
    pub screening_samples: usize,
    /// Steps of the screening.
    pub screening_steps: u32,
    /// Angle within which two poses of one handedness count as one, radians; only the better one is followed.
    pub same_pose_rad: f64,
    /// Poses of one handedness that are followed after the screening, at least.
    pub followed: usize,
    /// Most of them, if they do not explain significantly less than the best of them: a body with three axes of unlike
    /// length has four.
    pub most_followed: usize,
}

impl Default for ChoiceSettings {
    fn default() -> Self {
        ChoiceSettings {
            screening_samples: 250,
            screening_steps: 6,
            same_pose_rad: std::f64::consts::FRAC_PI_4,
            followed: 2,
            most_followed: 4,
        }
    }
}

/// Observations of the fine stage, which slide along the target.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SlidingSettings {
    /// Standard deviation of a point along the normal of the other surface, in sampling distances.
    pub along: f64,
    /// Share of the assignment's weight that is kept across the normal.
    pub across_share: f64,
}

impl Default for SlidingSettings {
    fn default() -> Self {
        SlidingSettings { along: 0.34, across_share: 0.1 }
    }
}

/// The local stage.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LocalSettings {
    /// Widths of a second kernel that are tried, in diagonals of the source. Shorter variation, over two or three
    /// voxels of a hippocampus, is a matter of the manual outline.
    pub widths: [f64; 4],
    /// Ratio of the displacement to the amplitude of the heights. Heights are distances to closest points, which are
    /// smaller than those to the counterparts where points are also displaced along the surface.
    pub amplitude: f64,
    /// Points over which the marginal likelihood is evaluated.
    pub evidence_samples: usize,
    /// Gain of the log marginal likelihood from which a second kernel is added: the Bayesian information criterion for
    /// its width and its variance.
    pub least_gain: f64,
    /// Noise along the normals of surfaces made of voxels, in sampling distances. Noisier surfaces have noisier
    /// curvature, so the weight of curvature across the normals is the inverse of the noise variance, relative to this
    /// noise.
    pub voxel_noise: f64,
    /// Inducing points of the field with both kernels.
    pub n_inducing: usize,
    /// Points of the last fit.
    pub samples: usize,
    /// Steps of the last fit.
    pub steps: u32,
    /// Weight of each point of the last fit. A weight of 1 would treat the error of the kernel's amplitude as noise of
    /// the points.
    pub point_weight: f64,
}

impl Default for LocalSettings {
    fn default() -> Self {
        LocalSettings {
            widths: [0.07, 0.1, 0.14, 0.2],
            amplitude: 2.0,
            evidence_samples: 400,
            least_gain: 6.0,
            voxel_noise: 0.1,
            n_inducing: 120,
            samples: 2400,
            steps: 4,
            point_weight: 1.5,
        }
    }
}

/// The fit from near isometries.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct IsometryFitSettings {
    /// Most correspondences of lowest energy that are followed.
    pub followed: usize,
    /// Mean distance up to which two correspondences count as one, in roots of the area; smaller than the distance
    /// between sites.
    pub same: f64,
    /// Width of a second kernel, in diagonals: joints are narrower than the bends of one structure.
    pub joint_width: f64,
    /// Standard deviation of the second kernel, in diagonals.
    pub joint_amplitude: f64,
    /// Inducing points of the field with both kernels.
    pub n_inducing: usize,
    /// Most repetitions of all stages from their own result.
    pub passes: usize,
    /// Reduction of the misfit at the scale of the sampling that justifies one more repetition.
    pub least_gain: f64,
    /// Standard deviation of the moved vertices as a base of the next repetition, in diagonals of the source.
    pub rebased_sigma: f64,
    /// Standard deviation of a correspondence of a near isometry, in diagonals of the source.
    pub form_sigma: f64,
}

impl Default for IsometryFitSettings {
    fn default() -> Self {
        IsometryFitSettings {
            followed: 3,
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

/// Thresholds by which the route decides which starts to try and which answer to take.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RouteSettings {
    /// Mean cosine between normals below which another start is tried.
    pub doubtful_normals: f64,
    /// Likeness of the shapes that a start must exceed to be an alternative to others: a map that distorts more than
    /// curvatures agree corresponds to nothing.
    pub least_likeness: f64,
    /// Difference in misfit from which the answer of straightened surfaces is taken: its best start, mirrored or not,
    /// against the best rigid start.
    pub straight: f64,
}

impl Default for RouteSettings {
    fn default() -> Self {
        RouteSettings { doubtful_normals: 0.87, least_likeness: 0.0, straight: 0.2 }
    }
}
