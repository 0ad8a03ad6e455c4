//! One text for each query, and the parts of it that differ between SQLite and PostgreSQL.
//!
//! Each query is written once, in `queries/`, with placeholders: `{now}` is the database's clock in ms at the beginning
//! of the statement (constant during the statement, so that an index can be used for comparisons with it),
//! `{for_update}` locks the selected rows until the transaction ends, `{skip_locked}` also skips rows that another
//! transaction has locked. SQLite needs neither lock, because it runs write transactions one at a time.

use std::sync::LazyLock;

/// Which database.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Dialect {
    Sqlite,
    Postgres,
}

/// A query in both dialects.
pub(super) struct Sql {
    sqlite: String,
    postgres: String,
}

impl Sql {
    /// Replaces the placeholders in a query's text.
    pub(super) fn new(text: &str) -> Self {
        let filled = |now, for_update, skip_locked| {
            text.replace("{now}", now).replace("{for_update}", for_update).replace("{skip_locked}", skip_locked)
        };
        Sql {
            sqlite: filled("CAST(unixepoch('subsec') * 1000 AS INTEGER)", "", ""),
            postgres: filled(
                "CAST(EXTRACT(EPOCH FROM statement_timestamp()) * 1000 AS BIGINT)",
                "FOR UPDATE",
                "FOR UPDATE SKIP LOCKED",
            ),
        }
    }

    /// The text for a database.
    pub(super) fn text(&self, dialect: Dialect) -> &str {
        match dialect {
            Dialect::Sqlite => &self.sqlite,
            Dialect::Postgres => &self.postgres,
        }
    }
}

/// A query that is created when it is first used.
pub(super) type LazySql = LazyLock<Sql>;

/// The query in `queries/` of this name.
macro_rules! sql {
    ($name:literal) => {{
        static QUERY: $crate::store::sql::dialect::LazySql = $crate::store::sql::dialect::LazySql::new(|| {
            $crate::store::sql::dialect::Sql::new(include_str!(concat!("queries/", $name, ".sql")))
        });
        &*QUERY
    }};
}
pub(super) use sql;

/// The text of a query, with the optional lines whose names are in `wanted` and without the others, and with numbered
/// parameters.
///
/// An optional line ends in `-- when NAME`. Parameters are written `:name` and replaced by `$1`, `$2`, … in the order
/// of their first use; their names are returned in that order.
pub(super) fn with_options(text: &str, wanted: &[&str]) -> (String, Vec<String>) {
    let mut kept = String::new();
    let mut names: Vec<String> = Vec::new();
    for line in text.lines() {
        let (line, option) = line.split_once("-- when ").map_or((line, None), |(l, o)| (l, Some(o.trim())));
        if option.is_some_and(|option| !wanted.contains(&option)) || line.trim_start().starts_with("--") {
            continue;
        }
        let mut rest = line;
        while let Some(at) = rest.find(':') {
            let length = rest[at + 1..].bytes().take_while(|b| b.is_ascii_lowercase() || *b == b'_').count();
            let name = &rest[at + 1..at + 1 + length];
            let number = names.iter().position(|n| n == name).unwrap_or_else(|| {
                names.push(name.to_owned());
                names.len() - 1
            });
            kept.push_str(&rest[..at]);
            kept.push_str(&format!("${}", number + 1));
            rest = &rest[at + 1 + length..];
        }
        kept.push_str(rest);
        kept.push('\n');
    }
    (kept, names)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn optional_lines_and_parameters() {
        let text =
            "-- name\nSELECT a\nWHERE t = :tenant\nAND b = :b -- when b\nAND c = :c OR d = :c -- when c\nLIMIT :size";
        let (all, names) = with_options(text, &["c"]);
        assert_eq!(all, "SELECT a\nWHERE t = $1\nAND c = $2 OR d = $2 \nLIMIT $3\n");
        assert_eq!(names, ["tenant", "c", "size"]);
    }
}
