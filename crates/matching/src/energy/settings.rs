//! The settings of the energy of near isometries.

/// All settings of the energy and of its minimization.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct IsometrySettings {
    /// Number of variables.
    pub n_variables: usize,
    /// Edges join variables closer than this, in spacings of the variables.
    pub near: f64,
    /// Steps in the list of the variables that give each variable further edges. In farthest-point order the index of a
    /// variable says nothing about its place, so any step leads far away.
    pub far_steps: [usize; 4],
    /// Standard deviation of the distance between a label and the true place, in spacings of the labels.
    pub label_noise: f64,
    /// Standard deviation of the relative change of a distance by a deformation.
    pub stretch: f64,
    /// Weight of a pairwise potential, below 1 because distances with a common end are not independent.
    pub pair_weight: f64,
    /// Most that a pairwise term (before its weight) and a unary term cost, in units of log-likelihood, so that a wrong
    /// term can be outvoted.
    pub truncation: f32,
    pub unary_truncation: f64,
    /// Standard deviation of the difference of a feature at corresponding places, in standard deviations of the feature
    /// over the surface.
    pub feature_noise: f64,
    /// Width of the neighborhood of chirality, in roots of the area.
    pub chirality_width: f64,
    /// Most that a bias costs before its weight, in units of log-likelihood.
    pub bias_truncation: f64,
    /// Weight of a bias.
    pub bias_weight: f64,
    /// Iterations of belief propagation, from each bias and from none.
    pub iterations: usize,
    /// Active labels of a variable.
    pub active_labels: usize,
    /// Change of a message up to which propagation has converged.
    pub tolerance: f32,
    /// Search for a labeling elsewhere: most that a label near a known one costs, in units of log-likelihood, and the
    /// distance along the surface over which this cost falls off, in roots of the area.
    pub repulsion: f64,
    pub repulsion_width: f64,
    /// Share of the previous message in each new message.
    pub damping: f32,
    /// Sweeps of conditional modes after belief propagation.
    pub sweeps: usize,
    /// Radius around the best label within which labels take part in the mean that is the image, in spacings.
    pub blended: f64,
}

impl Default for IsometrySettings {
    fn default() -> Self {
        IsometrySettings {
            n_variables: 160,
            near: 2.2,
            far_steps: [37, 53, 71, 89],
            label_noise: 0.35,
            stretch: 0.15,
            pair_weight: 0.5,
            truncation: 3.0,
            unary_truncation: 4.5,
            feature_noise: 0.5,
            chirality_width: 0.08,
            bias_truncation: 6.0,
            bias_weight: 0.5,
            iterations: 10,
            active_labels: 32,
            tolerance: 0.01,
            repulsion: 6.0,
            repulsion_width: 0.25,
            damping: 0.4,
            sweeps: 10,
            blended: 1.5,
        }
    }
}

/// Why settings are invalid.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub(crate) enum SettingsError {
    /// A length, a weight or a truncation is not a positive number.
    #[error("{name} is {value}, not a positive number")]
    NotPositive { name: &'static str, value: f64 },
    /// A count is 0.
    #[error("{name} is 0")]
    Zero { name: &'static str },
    /// With a damping of 1 messages never change.
    #[error("damping is {damping}, not in [0, 1)")]
    Damping { damping: f32 },
}

impl IsometrySettings {
    /// Checks that each setting is in its range.
    ///
    /// # Errors
    /// [`SettingsError`] for the first setting that is out of its range.
    pub(crate) fn check(&self) -> Result<(), SettingsError> {
        for (name, value) in [
            ("near", self.near),
            ("label_noise", self.label_noise),
            ("stretch", self.stretch),
            ("pair_weight", self.pair_weight),
            ("truncation", f64::from(self.truncation)),
            ("unary_truncation", self.unary_truncation),
            ("feature_noise", self.feature_noise),
            ("chirality_width", self.chirality_width),
            ("repulsion", self.repulsion),
            ("repulsion_width", self.repulsion_width),
            ("bias_truncation", self.bias_truncation),
            ("bias_weight", self.bias_weight),
            ("blended", self.blended),
        ] {
            if !(value.is_finite() && value > 0.0) {
                return Err(SettingsError::NotPositive { name, value });
            }
        }
        for (name, count) in [
            ("n_variables", self.n_variables),
            ("iterations", self.iterations),
            ("active_labels", self.active_labels),
            ("sweeps", self.sweeps),
        ] {
            if count == 0 {
                return Err(SettingsError::Zero { name });
            }
        }
        if !(0.0..1.0).contains(&self.damping) {
            return Err(SettingsError::Damping { damping: self.damping });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_defaults_make_an_energy_and_settings_out_of_range_do_not() {
        let settings = IsometrySettings::default();
        assert_eq!(settings.check(), Ok(()));
        let stretch = IsometrySettings { stretch: 0.0, ..settings };
        assert_eq!(stretch.check(), Err(SettingsError::NotPositive { name: "stretch", value: 0.0 }));
        assert!(IsometrySettings { near: f64::NAN, ..settings }.check().is_err());
        assert_eq!(IsometrySettings { sweeps: 0, ..settings }.check(), Err(SettingsError::Zero { name: "sweeps" }));
        assert!(IsometrySettings { damping: 1.0, ..settings }.check().is_err());
    }
}
