//! Shared by all sections: their pairs, and the clock.

use super::hippocampi::{Hippocampi, Subject};
use super::measure::measure_match;
use super::pairs::{Pair, PhantomRecipe, SolidRecipe, copy_pair, cross_pair, phantom_pair, solid_pair, warped_pair};
use super::solids::Form;
use super::units::{Unit, Work};
use super::{Clock, ExperimentOptions, MemoryMeter};
use serde::Serialize;
use serde_json::{Value, json};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Name of the kind of pair made of phantoms.
pub(super) const SYNTHETIC: &str = "synthetic";
/// Name of the kind of pair made of different real subjects.
pub(super) const REAL: &str = "real";
/// Name of the kind of pair made of real subjects and their rotated copies.
pub(super) const COPIES: &str = "copies";
/// Name of the kind of pair made of real subjects and their deformed copies.
pub(super) const WARPED: &str = "warped";
/// Name of the kind of pair made of bumped solids.
pub(super) const SOLIDS: &str = "solids";

/// RMS deformation of the synthetic pairs, as a share of the diagonal.
pub(super) const DEFORM_SHARE: f64 = 0.04;

/// Recipe of a pair.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum PairRecipe {
    Phantom(PhantomRecipe),
    Solid(SolidRecipe),
    Copy { subject: usize, hash: String, seed: u64 },
    Warped { subject: usize, hash: String, deform_share: f64, seed: u64 },
    Cross { source: usize, target: usize, hashes: [String; 2], seed: u64 },
}

/// A pair with a name.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Case {
    pub(super) group: &'static str,
    pub(super) name: String,
    pub(super) recipe: PairRecipe,
}

/// A named setting: the parameters of a match, as in a request.
pub(super) type Setting = (String, Value);

pub(super) struct Study<'o> {
    /// Whether the report is the quick one.
    pub(super) quick: bool,
    pub(super) clock: &'o Clock,
    pub(super) memory: Option<&'o MemoryMeter>,
    hippocampi: Option<Hippocampi>,
    pairs: RefCell<BTreeMap<String, Rc<Pair>>>,
    subjects: RefCell<BTreeMap<usize, Rc<Subject>>>,
}

impl<'o> Study<'o> {
    pub(super) fn new(options: &'o ExperimentOptions) -> Self {
        Study {
            quick: options.quick,
            clock: &options.clock,
            memory: options.memory.as_ref(),
            hippocampi: Hippocampi::open(&options.data),
            pairs: RefCell::default(),
            subjects: RefCell::default(),
        }
    }

    /// `quick` in the quick report, else `full`.
    pub(super) fn either<T>(&self, quick: T, full: T) -> T {
        if self.quick { quick } else { full }
    }

    /// Mean edge length of phantoms, mm: about 300 vertices in the quick report, 800 in the full one.
    pub(super) fn edge_mm(&self) -> f64 {
        self.either(2.2, 1.4)
    }

    /// Synthetic pairs, at most two in the quick report.
    pub(super) fn phantoms(&self, full: u64) -> Vec<Case> {
        self.phantoms_with(full, self.edge_mm(), 0.0)
    }

    /// Synthetic pairs with this mean edge length, mm, and noise as a share of the diagonal.
    pub(super) fn phantoms_with(&self, full: u64, edge_mm: f64, noise_share: f64) -> Vec<Case> {
        let recipe = |number| PhantomRecipe { number, edge_mm, deform_share: DEFORM_SHARE, noise_share };
        (1..=self.either(full.min(2), full))
            .map(|number| Case {
                group: SYNTHETIC,
                name: format!("phantom {number}"),
                recipe: PairRecipe::Phantom(recipe(number)),
            })
            .collect()
    }

    /// Bumped solids of a shape with their rotated copies.
    pub(super) fn solids(&self, form: Form, full: u64) -> Vec<Case> {
        // 162 vertices cannot represent the bumps, 642 can.
        let recipe = |number| SolidRecipe { form, number, levels: 3 };
        (1..=self.either(full.min(2), full))
            .map(|number| Case {
                group: SOLIDS,
                name: format!("{} {number}", form.name()),
                recipe: PairRecipe::Solid(recipe(number)),
            })
            .collect()
    }

    /// Pairs of different real subjects, spread over the folder; none without data or in the quick report.
    pub(super) fn real(&self, full: usize) -> Vec<Case> {
        let Some(data) = self.hippocampi.as_ref().filter(|_| !self.quick) else { return Vec::new() };
        let n = full.min(data.len() / 2);
        let step = data.len() / (2 * n).max(1);
        (0..n)
            .map(|k| {
                let (source, target) = (2 * k * step, (2 * k + 1) * step);
                let hashes = [data.hash(source), data.hash(target)];
                Case {
                    group: REAL,
                    name: format!("subjects {source} and {target}"),
                    recipe: PairRecipe::Cross { source, target, hashes, seed: 300 + k as u64 },
                }
            })
            .collect()
    }

    /// Real subjects with their rotated copies.
    pub(super) fn copies(&self, full: usize) -> Vec<Case> {
        let Some(data) = self.hippocampi.as_ref().filter(|_| !self.quick) else { return Vec::new() };
        let n = full.min(data.len());
        let step = data.len() / n.max(1);
        (0..n)
            .map(|k| Case {
                group: COPIES,
                name: format!("subject {}", k * step),
                recipe: PairRecipe::Copy { subject: k * step, hash: data.hash(k * step), seed: 100 + k as u64 },
            })
            .collect()
    }

    /// Real subjects with copies that are deformed as much as phantoms and rotated; other subjects than in
    /// [`Study::copies`].
    pub(super) fn warped(&self, full: usize) -> Vec<Case> {
        let Some(data) = self.hippocampi.as_ref().filter(|_| !self.quick) else { return Vec::new() };
        let n = full.min(data.len());
        let step = data.len() / n.max(1);
        (0..n)
            .map(|k| {
                let (subject, seed) = (k * step + step / 2, 600 + k as u64);
                let recipe = PairRecipe::Warped { subject, hash: data.hash(subject), deform_share: DEFORM_SHARE, seed };
                Case { group: WARPED, name: format!("subject {subject}"), recipe }
            })
            .collect()
    }

    /// The reason why there are no real pairs, if there are none.
    pub(super) fn real_absent(&self) -> Option<String> {
        if self.quick {
            return Some("The quick report has no real data.".to_owned());
        }
        let absent = "No real data: the data folder has no hippocampus/*.nii.gz.";
        self.hippocampi.is_none().then(|| absent.to_owned())
    }

    /// The pair of a recipe; made once and cached.
    pub(super) fn pair(&self, recipe: &PairRecipe) -> Result<Rc<Pair>, String> {
        let name = json!(recipe).to_string();
        if let Some(pair) = self.pairs.borrow().get(&name) {
            return Ok(Rc::clone(pair));
        }
        let pair = Rc::new(match recipe {
            PairRecipe::Phantom(recipe) => phantom_pair(recipe)?,
            PairRecipe::Solid(recipe) => solid_pair(recipe)?,
            PairRecipe::Copy { subject, seed, .. } => copy_pair(&*self.subject(*subject)?, *seed)?,
            PairRecipe::Warped { subject, deform_share, seed, .. } => {
                let data = self.hippocampi.as_ref().ok_or("there are no real data")?;
                warped_pair(&*self.subject(*subject)?, &data.volume(*subject)?, *deform_share, *seed)?
            }
            PairRecipe::Cross { source, target, seed, .. } => {
                cross_pair(&*self.subject(*source)?, &*self.subject(*target)?, *seed)?
            }
        });
        self.pairs.borrow_mut().insert(name, Rc::clone(&pair));
        Ok(pair)
    }

    /// Frees the pairs made so far.
    pub(super) fn clear_pairs(&self) {
        self.pairs.borrow_mut().clear();
    }

    fn subject(&self, index: usize) -> Result<Rc<Subject>, String> {
        if let Some(subject) = self.subjects.borrow().get(&index) {
            return Ok(Rc::clone(subject));
        }
        let data = self.hippocampi.as_ref().ok_or("there are no real data")?;
        let subject = Rc::new(data.subject(index)?);
        self.subjects.borrow_mut().insert(index, Rc::clone(&subject));
        Ok(subject)
    }

    /// A unit that does `work` on the pair of `case`. `inputs`: everything besides the pair on which the numbers depend.
    pub(super) fn unit<'a>(
        &'a self,
        case: &Case,
        configuration: &str,
        inputs: Value,
        work: impl Fn(&Pair) -> Result<super::units::Measurement, String> + 'a,
    ) -> Unit<'a> {
        let recipe = case.recipe.clone();
        let inputs = json!({"pair": recipe, "inputs": inputs});
        let work: Work<'a> = Box::new(move || work(&*self.pair(&recipe)?));
        Unit {
            group: case.group.to_owned(),
            configuration: configuration.to_owned(),
            case: case.name.clone(),
            inputs,
            work,
        }
    }

    /// A match of every case with every setting, case by case; each setting is run on the same pairs.
    pub(super) fn matches<'a>(&'a self, cases: &[Case], settings: &[Setting]) -> Vec<Unit<'a>> {
        let mut units = Vec::new();
        for case in cases {
            for (name, request) in settings {
                let of = request.clone();
                units.push(self.unit(case, name, request.clone(), move |pair| measure_match(pair, &of, self.clock)));
            }
        }
        units
    }
}
