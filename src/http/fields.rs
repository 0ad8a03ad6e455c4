//! `?fields=`: lists and documents with only the members that a client requests.

use super::problem::Problem;
use super::query::QueryString;
use axum::Json;
use axum::response::{IntoResponse, Response};
use serde::Serialize;
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::marker::PhantomData;
use utoipa::PartialSchema;

/// Every member, those that are left out unless asked for included.
const EVERY: &str = "*";

/// The members that the entries `E` of a list, or a document `E`, keep; `None` for all.
#[derive(Debug)]
pub(super) struct Fields<E> {
    kept: Option<BTreeSet<String>>,
    /// Whether every member was asked for.
    every: bool,
    entries: PhantomData<fn() -> E>,
}

impl<E: PartialSchema> Fields<E> {
    /// Reads `?fields=id,state` of a list. Members that its entries cannot have are faults.
    pub(super) fn of(query: &mut QueryString) -> Self {
        let mut every = false;
        let kept = query.text("fields").and_then(|text| {
            let mut asked: BTreeSet<String> = text.split(',').map(|name| name.trim().to_owned()).collect();
            every = asked.remove(EVERY);
            let schema = serde_json::to_value(E::schema()).unwrap_or(Value::Null);
            let known: BTreeSet<String> =
                schema["properties"].as_object().into_iter().flat_map(Map::keys).cloned().collect();
            if !asked.is_subset(&known) {
                let known: Vec<_> = known.into_iter().collect();
                let detail = format!("must be * or members of what is answered: {}", known.join(", "));
                query.fault("fields", "out_of_range", detail);
            }
            (!every).then_some(asked)
        });
        Fields { kept, every, entries: PhantomData }
    }

    /// All members that are not left out by default.
    pub(super) fn all(_: &mut QueryString) -> Self {
        Fields { kept: None, every: false, entries: PhantomData }
    }

    /// Whether the member `name` is requested.
    pub(super) fn wants(&self, name: &str) -> bool {
        self.kept.as_ref().is_none_or(|kept| kept.contains(name))
    }

    /// Whether the member `name` was asked for by name, or with every other.
    pub(super) fn asks_for(&self, name: &str) -> bool {
        self.every || self.kept.as_ref().is_some_and(|kept| kept.contains(name))
    }

    /// A document, of these members only.
    ///
    /// # Errors
    /// A document that JSON cannot represent.
    pub(super) fn value(&self, document: &impl Serialize) -> Result<Value, Problem> {
        let mut document = serde_json::to_value(document).map_err(|e| Problem::internal(&e))?;
        if let (Value::Object(members), Some(kept)) = (&mut document, &self.kept) {
            members.retain(|member, _| kept.contains(member));
        }
        Ok(document)
    }

    /// The JSON of a document, of these members only.
    ///
    /// # Errors
    /// A document that JSON cannot represent.
    pub(super) fn json(&self, document: &impl Serialize) -> Result<Vec<u8>, Problem> {
        match &self.kept {
            None => serde_json::to_vec(document),
            Some(_) => serde_json::to_vec(&self.value(document)?),
        }
        .map_err(|e| Problem::internal(&e))
    }

    /// The answer with a page of a list; the entries in its list `name` have the requested members only.
    ///
    /// # Errors
    /// A page that JSON cannot represent.
    pub(super) fn answer(&self, page: &impl Serialize, name: &str) -> Result<Response, Problem> {
        let Some(kept) = &self.kept else { return Ok(Json(page).into_response()) };
        let mut document = serde_json::to_value(page).map_err(|e| Problem::internal(&e))?;
        for entry in document.get_mut(name).and_then(Value::as_array_mut).into_iter().flatten() {
            if let Value::Object(members) = entry {
                members.retain(|member, _| kept.contains(member));
            }
        }
        Ok(Json(document).into_response())
    }
}
