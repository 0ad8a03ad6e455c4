//! The migrations of both databases.

use sqlx::SqlSafeStr as _;
use sqlx::migrate::{Migration, MigrationType, Migrator};

/// Migrations in order: version, description, text. Listed by hand because sqlx's macro, which reads the folder at compile
/// time, would build both database drivers a second time for the host.
pub(super) const SQLITE: &[(i64, &str, &str)] = &[(1, "service", include_str!("migrations/sqlite/0001_service.sql"))];
/// Migrations of PostgreSQL, in the form of [`SQLITE`].
pub(super) const POSTGRES: &[(i64, &str, &str)] =
    &[(1, "service", include_str!("migrations/postgres/0001_service.sql"))];

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
