//! Query strings: parameters that are unknown, repeated or out of range are refused, all in one problem.

use super::problem::{FieldError, Problem};
use super::problem_table::ProblemKind;
use super::ticketed::{TICKET, is_ticketed};
use axum::extract::{FromRequestParts, Query};
use axum::http::request::Parts;
use std::ops::RangeInclusive;
use std::str::FromStr;

/// Most faults that are listed in an answer.
const MAX_FAULTS: usize = 16;

/// The parameters of a query string, taken out one by one; [`QueryString::finish`] refuses the remaining ones.
#[derive(Debug)]
pub(crate) struct QueryString {
    pairs: Vec<(String, String)>,
    faults: Vec<FieldError>,
}

impl<S: Send + Sync> FromRequestParts<S> for QueryString {
    type Rejection = Problem;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, Problem> {
        let is_ticketed = is_ticketed(&parts.extensions);
        match Query::<Vec<(String, String)>>::from_request_parts(parts, state).await {
            Ok(Query(pairs)) => {
                let mut query = QueryString { pairs, faults: Vec::new() };
                if is_ticketed {
                    // Authentication has already read the ticket.
                    query.pairs.retain(|(name, _)| name != TICKET);
                }
                // No stored text contains a NUL, and not every database accepts one in a query.
                if query.pairs.iter().any(|(name, value)| name.contains('\0') || value.contains('\0')) {
                    query.pairs.retain(|(name, value)| !name.contains('\0') && !value.contains('\0'));
                    query.faults.push(FieldError::new("/query", "out_of_range", "must not contain NUL characters"));
                }
                Ok(query)
            }
            Err(rejection) => Err(Problem::new(ProblemKind::InvalidQuery).detail(rejection.body_text())),
        }
    }
}

impl QueryString {
    /// All values of a parameter that may be repeated.
    pub(crate) fn all(&mut self, name: &str) -> Vec<String> {
        let (taken, kept) = std::mem::take(&mut self.pairs).into_iter().partition(|(n, _)| n == name);
        self.pairs = kept;
        let taken: Vec<(String, String)> = taken;
        taken.into_iter().map(|(_, value)| value).collect()
    }

    /// The value of a parameter that may be given once.
    pub(crate) fn text(&mut self, name: &str) -> Option<String> {
        let mut values = self.all(name);
        if values.len() > 1 {
            self.fault(name, "repeated", "must be given once");
        }
        values.pop()
    }

    /// A number within `range`.
    pub(crate) fn number<T>(&mut self, name: &str, range: RangeInclusive<T>) -> Option<T>
    where
        T: FromStr + PartialOrd + std::fmt::Display,
    {
        let text = self.text(name)?;
        match text.parse::<T>() {
            Ok(value) if range.contains(&value) => Some(value),
            _ => {
                let detail = format!("must be a number from {} to {}", range.start(), range.end());
                self.fault(name, "out_of_range", detail);
                None
            }
        }
    }

    /// One of several words.
    pub(crate) fn word<T: Copy>(&mut self, name: &str, words: &[(&str, T)]) -> Option<T> {
        let text = self.text(name)?;
        let found = words.iter().find(|(word, _)| *word == text).map(|(_, value)| *value);
        if found.is_none() {
            let known: Vec<_> = words.iter().map(|(word, _)| *word).collect();
            self.fault(name, "out_of_range", format!("must be one of {}", known.join(", ")));
        }
        found
    }

    /// Notes a fault.
    pub(crate) fn fault(&mut self, name: &str, code: &str, detail: impl Into<String>) {
        if self.faults.len() >= MAX_FAULTS {
            return;
        }
        self.faults.push(FieldError::new(format!("/query/{name}"), code, detail));
    }

    /// # Errors
    /// `invalid-query` with all faults, unknown parameters included.
    pub(crate) fn finish(&mut self) -> Result<(), Problem> {
        for (name, _) in std::mem::take(&mut self.pairs) {
            // The name comes from the client; it is truncated so that the answer stays small.
            let name: String = name.chars().take(64).collect();
            self.fault(&name, "unknown", "unknown parameter");
        }
        if self.faults.is_empty() {
            return Ok(());
        }
        Err(Problem::new(ProblemKind::InvalidQuery).errors(&self.faults))
    }
}
