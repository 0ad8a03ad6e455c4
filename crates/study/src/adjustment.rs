//! Adjusts the comparison of a new subject with a group for covariates such as age and sex.
//!
//! The design is that of the statistics ([`Design`]): numbers are centered, factors have a column for each level except the
//! first. Scores are the subject's deviations from the prediction at its own covariates
//! ([`crate::normative`]). For the p-value of its shape, the regression is fitted to members and subject together, so that
//! all residuals are made alike, and each is divided by √(1 − leverage), its standard deviation over that of the error: if
//! subject and members are exchangeable, so are these residuals.

use crate::align::{Alignment, Shapes, points};
use crate::cohort::{Cohort, Values};
use crate::error::StudyError;
use crate::settings::Analysis;
use crate::statistics::design::Design;
use crate::statistics::linear::{LinearModel, leverage};
use faer::Mat;
use homolog_registration::SimilarityTransform;
use nalgebra::{Matrix3, Vector3};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Fewest degrees of freedom of the residuals, `n − p`.
const FEWEST_DEGREES: usize = 4;
/// Share of a member's value that the other members do not determine, below which the member alone determines a
/// coefficient: a fit without it does not exist.
const ALONE: f64 = 1e-9;

/// Covariates to adjust for, with the values of a new subject, as text: of numbers, or of levels.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Adjustment {
    /// The covariates of the study to adjust for.
    pub covariates: Vec<String>,
    /// The value of each of them for the new subject.
    pub values: BTreeMap<String, String>,
}

/// An adjustment that was made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AdjustmentFacts {
    /// The value of each covariate for the subject.
    pub covariates: BTreeMap<String, String>,
    /// Members that are left out because such a value is missing.
    pub incomplete: usize,
    /// Degrees of freedom of the residuals, the number of members less that of columns of the design.
    pub degrees: f64,
    /// Leverage of the subject, `x (XᵀX)⁻¹ xᵀ`: 1/n in the middle of the group, and larger away from it.
    pub leverage: f64,
    /// Covariates of the subject that lie outside of the range of the group, in words.
    pub warnings: Vec<String>,
}

/// Shapes with the frame they are in.
type FramedShapes = (Vec<Vec<[f32; 3]>>, Alignment);

/// A value of the new subject.
enum Value<'a> {
    Number(f64, &'a [Option<f64>]),
    Level(usize, &'a [Option<usize>]),
}

/// The regression of a group on covariates.
pub(crate) struct Adjusted {
    /// The fit to the members.
    pub(crate) model: LinearModel,
    /// The row of the new subject.
    pub(crate) own: Vec<f64>,
    /// The fit to the members and the subject, the last row.
    together: LinearModel,
    pub(crate) facts: AdjustmentFacts,
}

impl Adjustment {
    /// Whether nothing is adjusted for.
    pub fn is_empty(&self) -> bool {
        self.covariates.is_empty() && self.values.is_empty()
    }

    /// Checks the covariates and the values of the new subject.
    ///
    /// # Errors
    /// [`StudyError::Settings`] for a covariate or a level that the study does not have, for one named twice, and for a
    /// value that is missing, not a number, or not asked for.
    pub fn check(&self, cohort: &Cohort) -> Result<(), StudyError> {
        self.read(cohort).map(|_| ())
    }

    /// The value of each covariate, in the order of `covariates`.
    fn read<'a>(&self, cohort: &'a Cohort) -> Result<Vec<(String, Value<'a>)>, StudyError> {
        let fault = |why: String| Err(StudyError::Settings(why));
        if let Some(name) = self.values.keys().find(|name| !self.covariates.contains(name)) {
            return fault(format!(
                "the subject has a value of {name}, which is not among the covariates to adjust for"
            ));
        }
        let mut read = Vec::new();
        for (k, name) in self.covariates.iter().enumerate() {
            if self.covariates[..k].contains(name) {
                return fault(format!("the covariate {name} is named twice; name it once"));
            }
            let Some(found) = cohort.covariate(name) else {
                let known: Vec<&str> = cohort.covariates.iter().map(|of| of.name.as_str()).collect();
                let known = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
                return fault(format!("the study has no covariate {name}; its covariates are: {known}"));
            };
            let text = self.values.get(name).map_or("", |text| text.trim());
            if text.is_empty() || text == "NA" || text.eq_ignore_ascii_case("nan") {
                return fault(format!("the subject has no value of {name}; state it to adjust for {name}"));
            }
            let value = match &found.values {
                Values::Numbers(of) => match text.parse().ok().filter(|x: &f64| x.is_finite()) {
                    None => return fault(format!("the value of {name} is not a number, as those of the study are")),
                    Some(number) => Value::Number(number, of),
                },
                Values::Factor { levels, of } => match levels.iter().position(|level| level == text) {
                    None => return fault(format!("{name} has no level {text}; it has {}", levels.join(", "))),
                    Some(level) => Value::Level(level, of),
                },
            };
            read.push((name.clone(), value));
        }
        Ok(read)
    }

    /// The members that have a value of every covariate.
    pub(crate) fn complete(&self, cohort: &Cohort, members: &[usize]) -> Result<Vec<usize>, StudyError> {
        self.check(cohort)?;
        let covariates: Vec<_> = self.covariates.iter().filter_map(|name| cohort.covariate(name)).collect();
        let is_complete = |k: &usize| covariates.iter().all(|covariate| covariate.values.is_stated(*k));
        Ok(members.iter().copied().filter(is_complete).collect())
    }

    /// The regression of these members, all of which have every value. `incomplete`: members that lack one.
    ///
    /// # Errors
    /// [`StudyError::Settings`] as of [`Adjustment::check`], and for a level that no member or one member has, columns
    /// that depend on each other, and fewer than four degrees of freedom.
    pub(crate) fn fit(&self, cohort: &Cohort, members: &[usize], incomplete: usize) -> Result<Adjusted, StudyError> {
        let fault = |why: String| StudyError::Settings(why);
        let values = self.read(cohort)?;
        let analysis = Analysis { adjust: self.covariates.clone(), ..Analysis::default() };
        let design = Design::new(cohort, members, &analysis).map_err(fault)?;
        let (n, p) = (design.rows.len(), design.columns.len());
        if n < p + FEWEST_DEGREES {
            return Err(fault(format!(
                "{n} members of the group have all covariates, which is too few for {p} columns of the regression; at least \
                 {} are needed: name fewer covariates or a larger group",
                p + FEWEST_DEGREES
            )));
        }
        let (mut own, mut warnings) = (vec![0.0; p], Vec::new());
        own[0] = 1.0;
        for (name, value) in &values {
            match value {
                Value::Number(number, of) => {
                    let of: Vec<f64> = design.rows.iter().filter_map(|&k| of[k]).collect();
                    let (low, high) =
                        of.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &x| (low.min(x), high.max(x)));
                    if *number < low || *number > high {
                        let range = format!("from {low} to {high}");
                        warnings.push(format!("{name} {number} lies outside of the range of the group, {range}"));
                    }
                    // Centered as the design is.
                    let mean = of.iter().sum::<f64>() / n as f64;
                    if let Some(column) = design.columns.iter().position(|column| column == name) {
                        own[column] = number - mean;
                    }
                }
                Value::Level(level, of) => {
                    let text = self.values.get(name).map_or("", |text| text.trim());
                    if design.rows.iter().all(|&k| of[k] != Some(*level)) {
                        return Err(fault(format!("no member of the group has {name} {text}")));
                    }
                    // The first level has no column.
                    let column = format!("{name}:{text}");
                    if let Some(column) = design.columns.iter().position(|of| *of == column) {
                        own[column] = 1.0;
                    }
                }
            }
        }
        let model = LinearModel::new(&design.matrix);
        if model.free().iter().any(|&free| free < ALONE) {
            let all = self.covariates.join(", ");
            return Err(fault(format!(
                "a value of {all} belongs to one member of the group alone, so no member can be compared with the others; \
                 leave out this covariate or this member"
            )));
        }
        let together = Mat::from_fn(n + 1, p, |i, k| if i < n { design.matrix[(i, k)] } else { own[k] });
        let facts = AdjustmentFacts {
            covariates: self.values.iter().map(|(name, text)| (name.clone(), text.trim().to_owned())).collect(),
            incomplete,
            degrees: model.degrees(),
            leverage: leverage(&model.observation_weights(&own)),
            warnings,
        };
        Ok(Adjusted { model, own, together: LinearModel::new(&together), facts })
    }
}

impl Adjusted {
    /// The mean plus the residuals of each shape, the members' and the subject's last, in the frame of the mean, with the
    /// transforms of this frame, which are none. Memory: 12 bytes for each vertex of each shape.
    pub(crate) fn shapes(&self, shapes: &dyn Shapes, alignment: &Alignment) -> Result<FramedShapes, StudyError> {
        let (n, vertices) = (shapes.len(), shapes.n_vertices());
        let mut moved: Vec<Vec<[f32; 3]>> = (0..n)
            .into_par_iter()
            .map(|i| {
                let onto = &alignment.onto_mean[i];
                let read = points(&shapes.read(i, 0..vertices)?);
                Ok(read.iter().map(|p| onto.apply(p).coords.map(|x| x as f32).into()).collect())
            })
            .collect::<Result<_, StudyError>>()?;
        let scale: Vec<f64> = self.together.free().iter().map(|free| free.sqrt().recip()).collect();
        for v in 0..vertices {
            for axis in 0..3 {
                let y: Vec<f64> = moved.iter().map(|of| f64::from(of[v][axis])).collect();
                let mean = alignment.mean[v][axis];
                for (i, rest) in self.together.residuals(&y).iter().enumerate() {
                    moved[i][v][axis] = (mean + scale[i] * rest) as f32;
                }
            }
        }
        let still = SimilarityTransform { scale: 1.0, rotation: Matrix3::identity(), translation: Vector3::zeros() };
        Ok((moved, Alignment { onto_mean: vec![still; n], ..alignment.clone() }))
    }
}
