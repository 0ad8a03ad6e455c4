//! Allowed values of parameters: one table of bounds for numbers, one for lengths of lists, and the rules between
//! parameters. The check of a request, the tests of the extremes and descriptions of the parameters all read these
//! tables.

use super::{Algorithm, ClampingMode, FieldStarts, InitialPose, LabelChoice, MatchParameters, ParameterError, Repair};

/// The indices of a value in the lists that its name passes through, and the value; `None` stands for `null`.
type Visit<'v> = &'v mut dyn FnMut(&[usize], Option<f64>);

/// The allowed values of one numeric parameter.
#[derive(Clone, Copy)]
pub struct Bounds {
    /// Dotted name in a request, such as `energy.alpha`. `[]` stands for every element of a list.
    pub name: &'static str,
    /// Lowest value; not itself allowed if `exclusive_minimum`.
    pub minimum: f64,
    /// Highest value; not itself allowed if `exclusive_maximum`.
    pub maximum: f64,
    /// Whether the minimum itself is excluded.
    pub exclusive_minimum: bool,
    /// Whether the maximum itself is excluded.
    pub exclusive_maximum: bool,
    /// Unit of the value: `mm`, or empty for a number without one.
    pub unit: &'static str,
    /// Whether `null` is also allowed.
    pub nullable: bool,
    /// Whether only whole numbers are allowed.
    pub is_whole: bool,
    values: fn(&MatchParameters, Visit<'_>),
}

impl Bounds {
    const fn number(name: &'static str, minimum: f64, maximum: f64, values: fn(&MatchParameters, Visit<'_>)) -> Self {
        Bounds {
            name,
            minimum,
            maximum,
            exclusive_minimum: false,
            exclusive_maximum: false,
            unit: "",
            nullable: false,
            is_whole: false,
            values,
        }
    }

    const fn whole(name: &'static str, minimum: u32, maximum: u32, values: fn(&MatchParameters, Visit<'_>)) -> Self {
        Bounds { is_whole: true, ..Bounds::number(name, minimum as f64, maximum as f64, values) }
    }

    const fn above_minimum(self) -> Self {
        Bounds { exclusive_minimum: true, ..self }
    }

    const fn below_maximum(self) -> Self {
        Bounds { exclusive_maximum: true, ..self }
    }

    const fn mm(self) -> Self {
        Bounds { unit: "mm", ..self }
    }

    const fn or_null(self) -> Self {
        Bounds { nullable: true, ..self }
    }

    /// Whether `value` is allowed.
    pub fn allows(&self, value: f64) -> bool {
        let above = if self.exclusive_minimum { value > self.minimum } else { value >= self.minimum };
        let below = if self.exclusive_maximum { value < self.maximum } else { value <= self.maximum };
        above && below && (!self.is_whole || value.fract() == 0.0)
    }

    /// The lowest allowed number.
    pub fn lowest(&self) -> f64 {
        if self.exclusive_minimum { self.minimum.next_up() } else { self.minimum }
    }

    /// The highest allowed number.
    pub fn highest(&self) -> f64 {
        if self.exclusive_maximum { self.maximum.next_down() } else { self.maximum }
    }

    /// The allowed values, as the end of a sentence: "must be from 0 to 10 mm, or null".
    fn demand(&self) -> String {
        let Bounds { minimum, maximum, unit, .. } = *self;
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        let or_null = if self.nullable { ", or null" } else { "" };
        let demand = match (self.exclusive_minimum, self.exclusive_maximum) {
            _ if maximum == f64::MAX => "must be a finite number".to_owned(),
            (true, true) => format!("must be more than {minimum}, below {maximum}{unit}"),
            (true, false) => format!("must be more than {minimum}, at most {maximum}{unit}"),
            (false, true) => format!("must be from {minimum} to below {maximum}{unit}"),
            (false, false) => format!("must be from {minimum} to {maximum}{unit}"),
        };
        demand + or_null
    }
}

impl Bounds {
    /// The requirement on a value that is not a number.
    pub(super) fn demand_of_number(&self) -> String {
        let number = if self.is_whole { "must be a whole number" } else { "must be a number" };
        match self.demand().strip_prefix("must be ") {
            Some(rest) if rest.starts_with("from") => format!("{number} {rest}"),
            Some(rest) if rest.starts_with("more than") => format!("{number} of {rest}"),
            _ => self.demand(),
        }
    }
}

/// The allowed lengths of one list.
#[derive(Clone, Copy)]
pub struct Lengths {
    /// Dotted name in a request, such as `landmarks`. `[]` stands for every element of a list.
    pub name: &'static str,
    /// Smallest number of elements.
    pub minimum: usize,
    /// Largest number of elements.
    pub maximum: usize,
    lengths: fn(&MatchParameters, Visit<'_>),
}

/// The bounds of every numeric parameter except `seed` and the labels of a volume, which may be any non-negative whole
/// numbers of their types (64 and 32 bits).
pub const BOUNDS: &[Bounds] = &[
    Bounds::number("input.smoothing_mm", 0.0, 1000.0, |p, visit| visit(&[], p.input.smoothing_mm)).mm().or_null(),
    Bounds::number("input.fraction", 0.0, 1.0, |p, visit| visit(&[], Some(p.input.fraction))).above_minimum(),
    Bounds::whole("input.max_vertices", 100, 1_000_000, |p, visit| visit(&[], p.input.max_vertices.map(f64::from)))
        .or_null(),
    Bounds::number("features[].scales[]", 0.0, 1.0, |p, visit| {
        for (k, feature) in p.features.iter().enumerate() {
            feature.scales.iter().enumerate().for_each(|(s, scale)| visit(&[k, s], Some(*scale)));
        }
    }),
    Bounds::number("features[].scales_mm[]", 0.0, 10_000.0, |p, visit| {
        for (k, feature) in p.features.iter().enumerate() {
            for (s, scale) in feature.scales_mm.iter().flatten().enumerate() {
                visit(&[k, s], Some(*scale));
            }
        }
    })
    .mm(),
    Bounds::number("features[].radius_mm", 0.0, 100.0, |p, visit| {
        p.features.iter().enumerate().for_each(|(k, feature)| visit(&[k], feature.radius_mm));
    })
    .above_minimum()
    .mm()
    .or_null(),
    Bounds::number("features[].support", 0.01, 1.0, |p, visit| {
        p.features.iter().enumerate().for_each(|(k, feature)| visit(&[k], Some(feature.support)));
    }),
    Bounds::number("features[].weight", 0.0, 100.0, |p, visit| {
        p.features.iter().enumerate().for_each(|(k, feature)| visit(&[k], Some(feature.weight)));
    })
    .above_minimum(),
    Bounds::number("energy.alpha", 0.0, 1000.0, |p, visit| visit(&[], Some(p.energy.alpha))),
    Bounds::number("energy.beta", 0.0, 1000.0, |p, visit| visit(&[], Some(p.energy.beta))),
    Bounds::number("energy.truncation", 0.0, 60.0, |p, visit| visit(&[], p.energy.truncation))
        .above_minimum()
        .or_null(),
    Bounds::whole("energy.neighborhood_rings", 1, 4, |p, visit| {
        visit(&[], Some(p.energy.neighborhood_rings.into()));
    }),
    Bounds::number("energy.minkowski_p", 0.1, 10.0, |p, visit| visit(&[], Some(p.energy.minkowski_p))),
    Bounds::number("energy.feature_cap", 0.0, 100.0, |p, visit| visit(&[], Some(p.energy.feature_cap))).above_minimum(),
    Bounds::whole("inference.coarse_vertices", 100, 20_000, |p, visit| {
        visit(&[], p.inference.coarse_vertices.map(f64::from));
    })
    .or_null(),
    Bounds::whole("inference.max_iterations", 1, 100_000, |p, visit| {
        visit(&[], Some(p.inference.max_iterations.into()));
    }),
    Bounds::number("inference.damping", 0.0, 1.0, |p, visit| visit(&[], Some(p.inference.damping))).below_maximum(),
    Bounds::number("inference.tolerance", 0.0, 1.0, |p, visit| visit(&[], Some(p.inference.tolerance))),
    Bounds::number("inference.annealing.initial_temperature", 0.0, 1e6, |p, visit| {
        visit(&[], p.inference.annealing.initial_temperature);
    })
    .above_minimum()
    .or_null(),
    Bounds::number("inference.annealing.final_temperature", 0.0, 1e6, |p, visit| {
        visit(&[], p.inference.annealing.final_temperature);
    })
    .above_minimum()
    .or_null(),
    Bounds::number("inference.target_energy", f64::MIN, f64::MAX, |p, visit| visit(&[], p.inference.target_energy))
        .or_null(),
    Bounds::whole("inference.restart_after", 1, 10_000, |p, visit| {
        visit(&[], Some(p.inference.restart_after.into()));
    }),
    Bounds::whole("inference.lower_bound_iterations", 0, 10_000, |p, visit| {
        visit(&[], Some(p.inference.lower_bound_iterations.into()));
    }),
    Bounds::whole("clamping.max_rounds", 0, 20, |p, visit| visit(&[], Some(p.clamping.max_rounds.into()))),
    Bounds::number("registration.tolerance_mm", 0.0, 1000.0, |p, visit| visit(&[], p.registration.tolerance_mm))
        .above_minimum()
        .mm()
        .or_null(),
    Bounds::number("registration.confidence", 0.0, 1.0, |p, visit| visit(&[], Some(p.registration.confidence)))
        .below_maximum(),
    Bounds::whole("registration.max_trials", 1, 10_000_000, |p, visit| {
        visit(&[], Some(p.registration.max_trials.into()));
    }),
    Bounds::number("landmarks[].source_mm[]", -1e6, 1e6, |p, visit| {
        for (k, landmark) in p.landmarks.iter().enumerate() {
            landmark.source_mm.iter().enumerate().for_each(|(axis, x)| visit(&[k, axis], Some(*x)));
        }
    })
    .mm(),
    Bounds::number("landmarks[].target_mm[]", -1e6, 1e6, |p, visit| {
        for (k, landmark) in p.landmarks.iter().enumerate() {
            landmark.target_mm.iter().enumerate().for_each(|(axis, x)| visit(&[k, axis], Some(*x)));
        }
    })
    .mm(),
    Bounds::number("landmarks[].sigma_mm", 0.01, 100.0, |p, visit| {
        p.landmarks.iter().enumerate().for_each(|(k, landmark)| visit(&[k], Some(landmark.sigma_mm)));
    })
    .mm(),
];

/// The bounds of the lengths of lists.
pub const LENGTHS: &[Lengths] = &[
    Lengths { name: "features", minimum: 1, maximum: 8, lengths: |p, visit| visit(&[], Some(p.features.len() as f64)) },
    Lengths {
        name: "features[].scales",
        minimum: 1,
        maximum: 8,
        lengths: |p, visit| {
            p.features.iter().enumerate().for_each(|(k, feature)| visit(&[k], Some(feature.scales.len() as f64)));
        },
    },
    Lengths {
        name: "features[].scales_mm",
        minimum: 1,
        maximum: 8,
        lengths: |p, visit| {
            for (k, scales_mm) in p.features.iter().enumerate().filter_map(|(k, f)| Some((k, f.scales_mm.as_ref()?))) {
                visit(&[k], Some(scales_mm.len() as f64));
            }
        },
    },
    Lengths {
        name: "landmarks",
        minimum: 0,
        maximum: 1000,
        lengths: |p, visit| visit(&[], Some(p.landmarks.len() as f64)),
    },
];

/// The JSON pointer of the value with this dotted `name` at `indices` of the lists it passes through.
fn pointer(name: &str, indices: &[usize]) -> String {
    let mut pointer = String::from("/");
    let mut indices = indices.iter();
    for (k, part) in name.split("[]").enumerate() {
        if k > 0
            && let Some(index) = indices.next()
        {
            pointer.push_str(&format!("/{index}"));
        }
        // After a list the separator in the name already equals that of the pointer.
        pointer.push_str(&part.replace('.', "/"));
    }
    pointer
}

/// A fault at `pointer`.
pub(super) fn fault(pointer: &str, code: &str, detail: String) -> ParameterError {
    ParameterError { pointer: pointer.to_owned(), code: code.to_owned(), detail }
}

impl MatchParameters {
    /// Checks every value against [`BOUNDS`] and [`LENGTHS`], and against values that exclude it.
    ///
    /// # Errors
    /// Every fault, each with its JSON pointer: first values and lengths out of bounds, then values that exclude each
    /// other.
    pub fn check(&self) -> Result<(), Vec<ParameterError>> {
        let mut faults = Vec::new();
        for bounds in BOUNDS {
            (bounds.values)(self, &mut |indices, value| {
                let allowed = value.map_or(bounds.nullable, |value| bounds.allows(value));
                if !allowed {
                    faults.push(fault(&pointer(bounds.name, indices), "out_of_range", bounds.demand()));
                }
            });
        }
        for list in LENGTHS {
            let Lengths { name, minimum, maximum, .. } = *list;
            (list.lengths)(self, &mut |indices, length| {
                if !length.is_some_and(|n| (minimum as f64..=maximum as f64).contains(&n)) {
                    let detail = format!("must have from {minimum} to {maximum} elements");
                    faults.push(fault(&pointer(name, indices), "out_of_range", detail));
                }
            });
        }
        self.check_rules(&mut |holds, pointer, detail| {
            if !holds {
                faults.push(fault(pointer, "out_of_range", detail.to_owned()));
            }
        });
        if faults.is_empty() { Ok(()) } else { Err(faults) }
    }

    /// Constraints that are not bounds of a single number.
    fn check_rules(&self, check: &mut dyn FnMut(bool, &str, &str)) {
        let input = &self.input;
        for (labels, pointer) in [
            (&input.labels, "/input/labels"),
            (&input.source.labels, "/input/source/labels"),
            (&input.target.labels, "/input/target/labels"),
        ] {
            let labels = labels.as_deref();
            check(labels.is_none_or(|l| !l.is_empty()), pointer, "name at least one label, or null");
            check(
                labels.is_none_or(|l| !l.contains(&LabelChoice::Number(0))),
                pointer,
                "label 0 is the background; name labels from 1 on",
            );
        }
        check(
            input.max_vertices.is_some() || !input.repair.iter().flatten().any(|r| *r == Repair::Simplify),
            "/input/repair",
            "simplify needs the number of vertices in input.max_vertices",
        );
        let i = &self.inference;
        if let (Some(first), Some(last)) = (i.annealing.initial_temperature, i.annealing.final_temperature) {
            check(
                last <= first,
                "/inference/annealing/final_temperature",
                "must not be above inference.annealing.initial_temperature",
            );
        }
        let alone = i.algorithm == Algorithm::None;
        check(
            !alone || self.registration.initial != InitialPose::Ransac,
            "/registration/initial",
            "must not be ransac where inference.algorithm is none: there is no correspondence to draw from",
        );
        check(
            alone || self.registration.initial == InitialPose::Ransac,
            "/registration/initial",
            "must be ransac unless inference.algorithm is none",
        );
        check(
            self.registration.initial != InitialPose::Search || self.displacement.starts != FieldStarts::Initial,
            "/displacement/starts",
            "must not be initial where registration.initial is search: there is no initial pose to keep",
        );
        check(
            !alone || self.clamping.mode == ClampingMode::None,
            "/clamping/mode",
            "must be none where inference.algorithm is none: there is no energy to feed back to; name an algorithm",
        );
        check(
            !alone || i.lower_bound_iterations == 0,
            "/inference/lower_bound_iterations",
            "must be 0 where inference.algorithm is none: there is no energy to bound; name an algorithm",
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameters::{Landmark, Method, preset};

    #[test]
    fn every_preset_is_allowed() {
        for method in Method::ALL {
            assert_eq!(preset(method).check(), Ok(()), "{}", method.name());
        }
    }

    #[test]
    fn extremes_are_allowed_and_nothing_beyond_them() {
        for bounds in BOUNDS {
            let (lowest, highest) = (bounds.lowest(), bounds.highest());
            assert!(bounds.allows(lowest) && bounds.allows(highest), "{}", bounds.name);
            assert!(!bounds.allows(lowest.next_down()) && !bounds.allows(highest.next_up()), "{}", bounds.name);
            assert!(!bounds.allows(f64::NAN), "{}", bounds.name);
        }
    }

    #[test]
    fn faults_name_the_place_and_what_is_allowed() {
        let mut p = preset(Method::Balanced);
        p.features[1].scales_mm = Some(vec![1.0, 2.0, -1.0]);
        p.features[0].radius_mm = Some(0.0);
        p.energy.truncation = Some(61.0);
        p.inference.damping = 1.0;
        p.inference.coarse_vertices = Some(99);
        p.inference.target_energy = Some(f64::INFINITY);
        p.landmarks = vec![Landmark { source_mm: [0.0, 2e6, 0.0], target_mm: [0.0; 3], sigma_mm: f64::NAN }];
        p.features[1].scales.resize(9, 0.1);
        let found: Vec<_> = p.check().unwrap_err().into_iter().map(|f| (f.pointer, f.detail)).collect();
        let expected = [
            ("/features/1/scales_mm/2", "must be from 0 to 10000 mm"),
            ("/features/0/radius_mm", "must be more than 0, at most 100 mm, or null"),
            ("/energy/truncation", "must be more than 0, at most 60, or null"),
            ("/inference/coarse_vertices", "must be from 100 to 20000, or null"),
            ("/inference/damping", "must be from 0 to below 1"),
            ("/inference/target_energy", "must be a finite number, or null"),
            ("/landmarks/0/source_mm/1", "must be from -1000000 to 1000000 mm"),
            ("/landmarks/0/sigma_mm", "must be from 0.01 to 100 mm"),
            ("/features/1/scales", "must have from 1 to 8 elements"),
        ];
        assert_eq!(found, expected.map(|(pointer, detail)| (pointer.to_owned(), detail.to_owned())));
    }

    /// Every number in the parameters has a row in the table, under the name it has in a request.
    #[cfg(feature = "serde")]
    #[test]
    fn no_number_is_without_bounds() {
        use serde_json::Value;
        fn collect(value: &Value, name: &str, found: &mut std::collections::BTreeSet<String>) {
            match value {
                Value::Object(fields) => {
                    for (key, value) in fields {
                        collect(value, &if name.is_empty() { key.clone() } else { format!("{name}.{key}") }, found);
                    }
                }
                Value::Array(items) => items.iter().for_each(|item| collect(item, &format!("{name}[]"), found)),
                Value::Number(_) => {
                    found.insert(name.to_owned());
                }
                _ => {}
            }
        }
        let mut p = preset(Method::Balanced);
        p.input.smoothing_mm = Some(1.0);
        p.input.max_vertices = Some(1000);
        p.features[0].scales_mm = Some(vec![1.0]);
        p.features[0].radius_mm = Some(1.0);
        p.inference.target_energy = Some(1.0);
        p.inference.annealing.initial_temperature = Some(1.0);
        p.inference.annealing.final_temperature = Some(1.0);
        p.registration.tolerance_mm = Some(1.0);
        p.landmarks = vec![Landmark { source_mm: [0.0; 3], target_mm: [0.0; 3], sigma_mm: 1.0 }];
        let mut found = std::collections::BTreeSet::new();
        collect(&serde_json::to_value(&p).unwrap(), "", &mut found);
        found.remove("seed");
        let named = BOUNDS.iter().map(|b| b.name.to_owned()).collect();
        assert_eq!(found, named);
    }

    /// The bounds stated in the generated schema equal those of the table.
    #[cfg(feature = "openapi")]
    #[test]
    fn the_schema_states_no_other_bounds() {
        use utoipa::PartialSchema;
        let stated = [
            ("input", serde_json::to_value(crate::parameters::InputParameters::schema()).unwrap()),
            ("inference", serde_json::to_value(crate::parameters::InferenceParameters::schema()).unwrap()),
            ("energy", serde_json::to_value(crate::parameters::EnergyParameters::schema()).unwrap()),
            ("landmarks[]", serde_json::to_value(Landmark::schema()).unwrap()),
        ];
        let mut n_stated = 0;
        for (group, schema) in stated {
            for (key, property) in schema["properties"].as_object().unwrap() {
                let name = format!("{group}.{key}");
                let Some(bounds) = BOUNDS.iter().find(|b| b.name == name) else { continue };
                for (word, value) in [("minimum", bounds.minimum), ("maximum", bounds.maximum)] {
                    if let Some(found) = property.get(word).and_then(|v| v.as_f64())
                        // For a count, the schema states the minimum 0 because of its type.
                        && (word, found) != ("minimum", 0.0)
                    {
                        assert_eq!(found, value, "{name} {word}");
                        n_stated += 1;
                    }
                }
            }
        }
        assert!(n_stated >= 10, "{n_stated}");
    }
}
