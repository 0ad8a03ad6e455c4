//! Fault injection: the guarantees of the service when something breaks.
//!
//! The name of each test begins with its number, `a01` to `a25`, and ends with its backend: `sqlite` (with a folder of
//! blobs) or `postgres` (with an S3 server). `make test` runs them in a short form, `make faults` in full length. Tests
//! that need PostgreSQL, libfaketime or root are `#[ignore]`d; both commands run them if `scripts/test` finds their
//! requirements.
//!
//! Infrastructure: [`node`] (the service as processes that can be killed), [`postgres`] and [`s3`] (servers that stop
//! with the test), [`proxy`] (a network that fails), [`disk`] (a disk that can be filled), [`site`] (all of them
//! together), and [`witness`] (an independent record of what the database accepted).

pub(crate) mod client;
mod clock;
mod crashes;
mod disk;
mod endings;
mod fences;
mod load;
pub(crate) mod node;
mod outages;
mod postgres;
mod proxy;
mod purge;
mod queue;
mod races;
mod s3;
mod schema;
pub(crate) mod site;
mod tenants;
pub(crate) mod witness;

use std::time::Duration;

/// Whether the tests run in full length, as in `make faults`.
fn full_length() -> bool {
    std::env::var("HOMOLOG_FAULTS").is_ok_and(|value| value == "full")
}

/// `short` in `make test`, `long` in `make faults`.
pub(crate) fn length(short: u64, long: u64) -> u64 {
    if full_length() { long } else { short }
}

/// As [`length`], in seconds.
fn seconds(short: u64, long: u64) -> Duration {
    Duration::from_secs(length(short, long))
}

/// Defines a test of `async fn name(Backend)` on each backend: `name::sqlite` and `name::postgres`.
macro_rules! on_both {
    (needs $reason:literal: $($name:ident),+ $(,)?) => {$(
        mod $name {
            use crate::faults::site::Backend;

            #[tokio::test]
            #[ignore = $reason]
            async fn sqlite() {
                super::$name(Backend::Sqlite).await;
            }

            #[tokio::test]
            #[ignore = $reason]
            async fn postgres() {
                super::$name(Backend::Postgres).await;
            }
        }
    )+};
    ($($name:ident),+ $(,)?) => {$(
        mod $name {
            use crate::faults::site::Backend;

            #[tokio::test]
            async fn sqlite() {
                super::$name(Backend::Sqlite).await;
            }

            #[tokio::test]
            #[ignore = "needs PostgreSQL"]
            async fn postgres() {
                super::$name(Backend::Postgres).await;
            }
        }
    )+};
}
pub(crate) use on_both;

/// Defines a test of `async fn name()` on PostgreSQL only, for behavior that SQLite does not have: `name::postgres`.
macro_rules! on_postgres {
    ($($name:ident),+ $(,)?) => { on_postgres!(needs "needs PostgreSQL": $($name),+); };
    (needs $reason:literal: $($name:ident),+ $(,)?) => {$(
        mod $name {
            #[tokio::test]
            #[ignore = $reason]
            async fn postgres() {
                super::$name().await;
            }
        }
    )+};
}
use on_postgres;
