//! The measurements of a section, and the tables and curves that most sections make from them.

use super::document::{Cell, Column, PlotPoint, Series, Table};
use super::statistics::Summary;
use super::units::{Ending, FinishedUnit, Measurement};

/// A column of a table over settings.
#[derive(Debug, Clone, Copy)]
pub(super) struct Metric {
    /// Key in [`Measurement`].
    pub(super) key: &'static str,
    /// Heading.
    pub(super) name: &'static str,
    /// Unit as printed.
    pub(super) unit: &'static str,
    /// Conversion factor from the measured to the printed unit.
    pub(super) factor: f64,
    /// Decimals when printed.
    pub(super) digits: usize,
}

impl Metric {
    /// A share that is printed in percent.
    pub(super) const fn percent(key: &'static str, name: &'static str) -> Self {
        Metric { key, name, unit: "%", factor: 100.0, digits: 1 }
    }

    /// A number that is printed in the unit in which it is measured.
    pub(super) const fn number(key: &'static str, name: &'static str, unit: &'static str, digits: usize) -> Self {
        Metric { key, name, unit, factor: 1.0, digits }
    }
}

/// The finished units of a section, in the order of its plan.
pub(super) struct Results {
    units: Vec<FinishedUnit>,
}

/// The units of one kind of pair.
pub(super) struct Group<'a> {
    units: Vec<&'a FinishedUnit>,
}

impl Results {
    pub(super) fn new(units: Vec<FinishedUnit>) -> Self {
        Results { units }
    }

    pub(super) fn group(&self, name: &str) -> Group<'_> {
        Group { units: self.units.iter().filter(|u| u.group == name).collect() }
    }

    pub(super) fn n_units(&self) -> usize {
        self.units.len()
    }

    pub(super) fn n_failed(&self) -> usize {
        self.units.iter().filter(|u| matches!(u.ending, Ending::Failed(_))).count()
    }

    pub(super) fn seconds(&self) -> f64 {
        self.units.iter().map(|u| u.seconds).sum()
    }

    /// Every distinct reason for which units failed, with its number of units, in order of first occurrence.
    pub(super) fn failures(&self) -> Vec<(String, usize)> {
        let mut reasons: Vec<(String, usize)> = Vec::new();
        for unit in &self.units {
            let Ending::Failed(reason) = &unit.ending else { continue };
            let reason = format!("{}: {reason}", unit.configuration);
            match reasons.iter_mut().find(|(known, _)| *known == reason) {
                Some((_, n)) => *n += 1,
                None => reasons.push((reason, 1)),
            }
        }
        reasons
    }
}

impl<'a> Group<'a> {
    pub(super) fn is_empty(&self) -> bool {
        self.units.is_empty()
    }

    /// Settings, in the order of the plan.
    pub(super) fn configurations(&self) -> Vec<&'a str> {
        self.names(|u| &u.configuration)
    }

    /// Pairs or problems, in the order of the plan.
    pub(super) fn cases(&self) -> Vec<&'a str> {
        self.names(|u| &u.case)
    }

    fn names(&self, name: impl Fn(&'a FinishedUnit) -> &'a String) -> Vec<&'a str> {
        let mut names: Vec<&str> = Vec::new();
        for unit in &self.units {
            if !names.contains(&name(unit).as_str()) {
                names.push(name(unit));
            }
        }
        names
    }

    /// Measurements of a setting, by case.
    pub(super) fn measured(&self, configuration: &str) -> Vec<(&'a str, &'a Measurement)> {
        let of = |u: &&'a FinishedUnit| match &u.ending {
            Ending::Measured(m) if u.configuration == configuration => Some((u.case.as_str(), m)),
            _ => None,
        };
        self.units.iter().filter_map(of).collect()
    }

    /// A number measured for one case.
    pub(super) fn value(&self, configuration: &str, case: &str, key: &str) -> Option<f64> {
        let measured = self.measured(configuration);
        measured.iter().find(|(c, _)| *c == case).and_then(|(_, m)| m.values.get(key).copied())
    }

    /// The summary of a number over all cases of a setting.
    pub(super) fn summary(&self, configuration: &str, key: &str) -> Option<Summary> {
        Summary::of(self.measured(configuration).iter().filter_map(|(_, m)| m.values.get(key).copied()))
    }

    /// The mean of a number over all cases of a setting.
    pub(super) fn mean(&self, configuration: &str, key: &str) -> Option<f64> {
        self.summary(configuration, key).map(|s| s.mean)
    }

    /// The setting with the largest (or smallest) mean; ties go to the first.
    pub(super) fn best(&self, key: &str, largest: bool) -> Option<(&'a str, Summary)> {
        let all = self.configurations().into_iter().filter_map(|c| Some((c, self.summary(c, key)?)));
        all.reduce(|best, next| {
            let better = if largest { next.1.mean > best.1.mean } else { next.1.mean < best.1.mean };
            if better { next } else { best }
        })
    }

    /// A table with a row for each setting: cases measured and failed, then the metrics.
    pub(super) fn table(&self, id: &str, title: &str, setting: &str, metrics: &[Metric]) -> Table {
        let mut columns = vec![Column::plain(setting), Column::plain("pairs"), Column::plain("failed")];
        columns.extend(metrics.iter().map(|m| Column::new(m.name, m.unit, m.digits)));
        let rows = self.configurations().into_iter().map(|configuration| {
            let of = |u: &&&FinishedUnit| u.configuration == configuration;
            let (n, measured) = (self.units.iter().filter(of).count(), self.measured(configuration).len());
            let mut row =
                vec![Cell::text(configuration), Cell::Count(measured as u64), Cell::Count((n - measured) as u64)];
            row.extend(
                metrics.iter().map(|m| Cell::spread(self.summary(configuration, m.key).map(|s| s.scaled(m.factor)))),
            );
            row
        });
        Table { id: id.to_owned(), title: title.to_owned(), rows: rows.collect(), columns }
    }

    /// A curve over settings: mean and spread of a metric, at the horizontal position `x` of each setting.
    pub(super) fn series(&self, name: &str, metric: &Metric, x: impl Fn(&str) -> Option<f64>) -> Series {
        let point = |configuration: &str| {
            let summary = self.summary(configuration, metric.key)?.scaled(metric.factor);
            Some(PlotPoint::of(x(configuration)?, &summary))
        };
        let points = self.configurations().into_iter().filter_map(point).collect();
        Series { name: name.to_owned(), points }
    }

    /// A bar for each setting, in the order of the plan.
    pub(super) fn bars(&self, name: &str, metric: &Metric) -> Series {
        let settings = self.configurations();
        self.series(name, metric, |c| settings.iter().position(|s| *s == c).map(|k| k as f64))
    }

    /// The settings as names of categories.
    pub(super) fn categories(&self) -> Vec<String> {
        self.configurations().into_iter().map(str::to_owned).collect()
    }

    /// A curve measured for one case of a setting.
    pub(super) fn curve(&self, name: &str, configuration: &str, case: &str, curve: &str) -> Option<Series> {
        let measured = self.measured(configuration);
        let (_, m) = measured.iter().find(|(c, _)| *c == case)?;
        let points = m.curves.get(curve)?.iter().map(|[x, y]| PlotPoint::at(*x, *y)).collect();
        Some(Series { name: name.to_owned(), points })
    }
}
