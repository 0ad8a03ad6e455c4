//! The settings of the energy of near isometries.

/// Every number of the energy and of its minimization.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct IsometrySettings {
    /// Variables.
    pub n_variables: usize,
    /// Edges join variables closer than this, in spacings of the variables.
    pub near: f64,
    /// Steps in the list of the variables at which each has more edges. Farthest-point order leaves no trace of where a variable is, so
    /// any step leads far away.
    pub far_steps: [usize; 4],
    /// Standard deviation of a label's distance from the place it stands for, in spacings of the labels.
    pub label_noise: f64,
    /// Standard deviation of the change of a distance by a deformation, relative to it.
    pub stretch: f64,
    /// Weight of a pairwise potential: distances that share an end are not independent.
    pub pair_weight: f64,
    /// Most that a pairwise term costs before its weight, and a unary one, in units of log-likelihood: a wrong one can be outvoted.
    pub truncation: f32,
    pub unary_truncation: f64,
    /// Standard deviation of the difference of a feature at corresponding places, in its standard deviation over the surface.
    pub feature_noise: f64,
    /// Width over which chirality is, in roots of the area.
    pub chirality_width: f64,
    /// The most that a bias costs before its weight, in units of log-likelihood.
    pub bias_truncation: f64,
    /// The weight of a bias.
    pub bias_weight: f64,
    /// Iterations of belief propagation with a bias.
    pub iterations: usize,
    /// Active labels of a variable. With 32 of 512 the energies of hippocampi are 0 to 2 % above those over all labels; on 15 pairs of bodies 48
    /// and 96 led to the same correspondences.
    pub active_labels: usize,
    /// Change of a message up to which propagation has converged.
    pub tolerance: f32,
    /// A labeling elsewhere is looked for where each variable pays for labels near those that are known: by so much, falling off over this
    /// distance along the surface, in roots of the area.
    pub repulsion: f64,
    pub repulsion_width: f64,
    /// Share of the message before that each message keeps.
    pub damping: f32,
    /// Sweeps of conditional modes after belief propagation.
    pub sweeps: usize,
    /// Labels within so many spacings of the best one take part in the mean that is the image.
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

/// Why settings have no energy.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub(crate) enum SettingsError {
    /// A length, a weight or a truncation has to be a number above 0.
    #[error("{name} is {value}, not a positive number")]
    NotPositive { name: &'static str, value: f64 },
    /// A count has to be 1 or more.
    #[error("{name} is 0")]
    Zero { name: &'static str },
    /// Messages that keep all of the messages before them never change.
    #[error("damping is {damping}, not in [0, 1)")]
    Damping { damping: f32 },
}

impl IsometrySettings {
    /// Whether these settings make an energy.
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
