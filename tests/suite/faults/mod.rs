//! What the service promises when something breaks, shown by breaking it.
//!
//! Each test is named after its point, `a01` to `a23`, and after what it runs on: `sqlite` (with a folder of blobs) or
//! `postgres` (with an S3 server). `make test` runs them short, `make faults` in full length. Those that need PostgreSQL,
//! libfaketime or root are `#[ignore]`d, and both commands run them where `scripts/test` finds that there is such a thing.
//!
//! What they stand on: [`node`] (the service as processes that can be killed), [`postgres`], [`s3`] (servers that end
//! with the test), [`proxy`] (a network that fails), [`disk`] (one that is full), [`site`] (all of them together, and
//! an independent witness of what the database accepted).

mod client;
mod crashes;
mod disk;
mod endings;
mod fences;
mod load;
mod node;
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
mod witness;

use std::time::Duration;

/// Whether the tests have the time that `make faults` gives them.
fn full_length() -> bool {
    std::env::var("HOMOLOG_FAULTS").is_ok_and(|value| value == "full")
}

/// `short` in `make test`, `long` in `make faults`.
fn length(short: u64, long: u64) -> u64 {
    if full_length() { long } else { short }
}

/// As [`length`], in seconds.
fn seconds(short: u64, long: u64) -> Duration {
    Duration::from_secs(length(short, long))
}

/// Makes a test on each backend of `async fn name(Backend)`: `name::sqlite` and `name::postgres`.
macro_rules! on_both {
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
use on_both;

/// Makes a test of `async fn name()` on PostgreSQL, for what has no meaning on SQLite: `name::postgres`.
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
