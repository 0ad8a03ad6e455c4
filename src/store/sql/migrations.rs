//! The migrations of both databases.

use sqlx::SqlSafeStr as _;
use sqlx::migrate::{Migration, MigrationType, Migrator};

/// Migrations in order: version, description, text. Listed by hand because sqlx's macro, which reads the folder at compile
/// time, would build both database drivers a second time for the host.
pub(super) const SQLITE: &[(i64, &str, &str)] = &[
    (1, "jobs", include_str!("migrations/sqlite/0001_jobs.sql")),
    (2, "service", include_str!("migrations/sqlite/0002_service.sql")),
    (3, "fairness", include_str!("migrations/sqlite/0003_fairness.sql")),
    (4, "audit", include_str!("migrations/sqlite/0004_audit.sql")),
    (5, "verdict", include_str!("migrations/sqlite/0005_verdict.sql")),
    (6, "encryption", include_str!("migrations/sqlite/0006_encryption.sql")),
    (7, "audit_anchor", include_str!("migrations/sqlite/0007_audit_anchor.sql")),
    (8, "tickets", include_str!("migrations/sqlite/0008_tickets.sql")),
    (9, "studies", include_str!("migrations/sqlite/0009_studies.sql")),
    (10, "clock", include_str!("migrations/sqlite/0010_clock.sql")),
    (11, "waits", include_str!("migrations/sqlite/0011_waits.sql")),
    (12, "workers", include_str!("migrations/sqlite/0012_workers.sql")),
];
/// Migrations of PostgreSQL, in the form of [`SQLITE`].
pub(super) const POSTGRES: &[(i64, &str, &str)] = &[
    (1, "service", include_str!("migrations/postgres/0001_service.sql")),
    (2, "fairness", include_str!("migrations/postgres/0002_fairness.sql")),
    (3, "audit", include_str!("migrations/postgres/0003_audit.sql")),
    (4, "verdict", include_str!("migrations/postgres/0004_verdict.sql")),
    (5, "encryption", include_str!("migrations/postgres/0005_encryption.sql")),
    (6, "audit_anchor", include_str!("migrations/postgres/0006_audit_anchor.sql")),
    (7, "tickets", include_str!("migrations/postgres/0007_tickets.sql")),
    (8, "studies", include_str!("migrations/postgres/0008_studies.sql")),
    (9, "clock", include_str!("migrations/postgres/0009_clock.sql")),
    (10, "waits", include_str!("migrations/postgres/0010_waits.sql")),
    (11, "workers", include_str!("migrations/postgres/0011_workers.sql")),
];

/// Applies the migrations that a database does not have.
pub(super) fn migrator(migrations: &[(i64, &'static str, &'static str)]) -> Migrator {
    let migration = |&(version, description, text): &(i64, &'static str, &'static str)| {
        Migration::new(version, description.into(), MigrationType::Simple, text.into_sql_str(), false)
    };
    Migrator::with_migrations(migrations.iter().map(migration).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use std::path::Path;

    #[test]
    fn every_migration_file_is_listed_with_the_version_and_description_of_its_name() {
        for (folder, listed) in [("sqlite", SQLITE), ("postgres", POSTGRES)] {
            let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/store/sql/migrations").join(folder);
            let name = |entry: std::io::Result<std::fs::DirEntry>| entry.unwrap().file_name().into_string().unwrap();
            let found: BTreeSet<String> = std::fs::read_dir(folder).unwrap().map(name).collect();
            let expected: BTreeSet<String> =
                listed.iter().map(|(version, description, _)| format!("{version:04}_{description}.sql")).collect();
            assert_eq!(found, expected);
        }
    }
}
