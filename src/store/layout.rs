//! Names of the files in a data directory.

/// The database, where it is SQLite.
pub(crate) const DATABASE_FILE: &str = "homolog.sqlite";
/// The key that seals secrets where no other is given. It may be there before a restore, and is kept apart from backups.
pub(crate) const SECRET_KEY_FILE: &str = "secret.key";
