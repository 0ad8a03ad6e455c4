//! How long jobs and results are kept, and what was removed.

use super::job::Tenant;
use std::collections::BTreeMap;
use std::str::FromStr;
use std::time::Duration;

/// How long jobs and results are kept; `None` is for ever.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Retention {
    /// Results and traces after the end of their job: as long as was promised when it ended, or for this long, whichever is
    /// shorter, so that an operator can make room.
    pub results: Option<Duration>,
    /// Records of jobs, and with them everything else, after the end of the job. Also uploads that no job refers to, the
    /// feed of changes and the log of deliveries.
    pub jobs: Option<Duration>,
}

/// How long jobs and results of each tenant are kept.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Retentions {
    others: Retention,
    of_tenants: BTreeMap<String, Retention>,
}

/// Whom a retention concerns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Concerned {
    /// This tenant only; empty: all tenants that are not excepted.
    pub(crate) tenant: String,
    /// Tenants that are excepted: each between commas, which no tenant contains.
    pub(crate) excepted: String,
}

impl From<Retention> for Retentions {
    /// The same for all tenants.
    fn from(others: Retention) -> Self {
        Retentions { others, of_tenants: BTreeMap::new() }
    }
}

impl Retentions {
    /// `others` for all tenants, except for what is said of a tenant; the last one counts of a tenant that is given twice.
    pub fn new(others: Retention, results: &[TenantDays], jobs: &[TenantDays]) -> Self {
        let mut of_tenants = BTreeMap::new();
        for TenantDays(tenant, keep) in results {
            of_tenants.entry(tenant.clone()).or_insert(others).results = *keep;
        }
        for TenantDays(tenant, keep) in jobs {
            of_tenants.entry(tenant.clone()).or_insert(others).jobs = *keep;
        }
        Retentions { others, of_tenants }
    }

    /// How long jobs and results of a tenant are kept.
    pub fn of(&self, tenant: &Tenant) -> Retention {
        self.of_tenants.get(tenant.name()).copied().unwrap_or(self.others)
    }

    /// Each retention, with whom it concerns.
    pub(crate) fn all(&self) -> impl Iterator<Item = (Concerned, Retention)> {
        let excepted: String = self.of_tenants.keys().flat_map(|tenant| [",", tenant]).collect::<String>() + ",";
        let others = (Concerned { tenant: String::new(), excepted }, self.others);
        let of_one = |(tenant, keep): (&String, &Retention)| {
            (Concerned { tenant: tenant.clone(), excepted: String::new() }, *keep)
        };
        std::iter::once(others).chain(self.of_tenants.iter().map(of_one))
    }
}

/// How long something of one tenant is kept, written `tenant=days`; 0 days are for ever.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TenantDays(String, Option<Duration>);

impl FromStr for TenantDays {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parsed = text.split_once('=').and_then(|(tenant, days)| {
            let days: f64 = days.trim().parse().ok().filter(|days| (0.0..=MAX_DAYS).contains(days))?;
            Some(TenantDays(Tenant::new(tenant.trim())?.name().to_owned(), kept(days)))
        });
        parsed.ok_or_else(|| format!("TENANT=DAYS is needed here, with a number from 0 to {MAX_DAYS}"))
    }
}

/// Longest retention, days.
pub const MAX_DAYS: f64 = 36_500.0;

/// A retention of days; `None`, for ever, if there are 0.
pub fn kept(days: f64) -> Option<Duration> {
    (days > 0.0).then(|| Duration::from_secs_f64(days * 86_400.0))
}

/// Counts of a purge, or of a dry run of one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
pub struct Purged {
    /// Jobs whose result and trace were removed; their records stay.
    pub results: u64,
    /// Jobs that were removed entirely.
    pub jobs: u64,
    /// Studies that were removed, with their jobs.
    pub studies: u64,
    /// Uploads that no job refers to.
    pub meshes: u64,
    /// Entries of the feed of changes.
    pub changes: u64,
    /// Entries of the log of deliveries.
    pub deliveries: u64,
    /// Expired idempotency keys.
    pub idempotency_keys: u64,
}

impl Purged {
    /// Whether nothing was removed.
    pub fn is_nothing(&self) -> bool {
        *self == Purged::default()
    }

    /// Adds what else was removed.
    pub fn add(&mut self, other: &Purged) {
        self.results += other.results;
        self.jobs += other.jobs;
        self.studies += other.studies;
        self.meshes += other.meshes;
        self.changes += other.changes;
        self.deliveries += other.deliveries;
        self.idempotency_keys += other.idempotency_keys;
    }
}

/// Jobs that were ended because they exceeded a time limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Overdue {
    /// Queued past their deadline.
    pub expired: u32,
    /// Exceeded their run time, and their worker did not end them.
    pub stuck: u32,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_tenant_has_its_own_retention_or_that_of_all() {
        let day = Duration::from_secs(86_400);
        let others = Retention { results: Some(90 * day), jobs: Some(365 * day) };
        let parse = |texts: &[&str]| texts.iter().map(|text| text.parse().unwrap()).collect::<Vec<TenantDays>>();
        let all = Retentions::new(others, &parse(&["trial=7", "kept = 0"]), &parse(&["trial=0.5"]));
        let of = |name: &str| all.of(&Tenant::new(name).unwrap());
        assert_eq!(of("other"), others);
        assert_eq!(of("trial"), Retention { results: Some(7 * day), jobs: Some(day / 2) });
        assert_eq!(of("kept"), Retention { results: None, jobs: Some(365 * day) });
        let concerned: Vec<Concerned> = all.all().map(|(concerned, _)| concerned).collect();
        assert_eq!((concerned[0].tenant.as_str(), concerned[0].excepted.as_str()), ("", ",kept,trial,"));
        assert_eq!((concerned[2].tenant.as_str(), concerned[2].excepted.as_str()), ("trial", ""));
        for wrong in ["", "a", "a=", "a=-1", "a=x", "a=36501", "A=1", "a=nan"] {
            assert!(wrong.parse::<TenantDays>().is_err(), "{wrong}");
        }
    }
}
