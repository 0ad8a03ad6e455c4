//! `?fields=`: lists with only the members that a client wants.

use super::problem::Problem;
use super::query::QueryString;
use axum::Json;
use axum::response::{IntoResponse, Response};
use serde::Serialize;
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::marker::PhantomData;
use utoipa::PartialSchema;

/// The members that the entries `E` of a list keep; `None` for all.
#[derive(Debug)]
pub(super) struct Fields<E> {
    kept: Option<BTreeSet<String>>,
    entries: PhantomData<fn() -> E>,
}

impl<E: PartialSchema> Fields<E> {
    /// `?fields=id,state` of a list. Members that its entries cannot have are faults.
    pub(super) fn of(query: &mut QueryString) -> Self {
        let kept = query.text("fields").map(|text| {
            let asked: BTreeSet<String> = text.split(',').map(|name| name.trim().to_owned()).collect();
            let schema = serde_json::to_value(E::schema()).unwrap_or(Value::Null);
            let known: BTreeSet<String> =
                schema["properties"].as_object().into_iter().flat_map(Map::keys).cloned().collect();
            if !asked.is_subset(&known) {
                let known: Vec<_> = known.into_iter().collect();
                let detail = format!("must be members of the entries of the list: {}", known.join(", "));
                query.fault("fields", "out_of_range", detail);
            }
            asked
        });
        Fields { kept, entries: PhantomData }
    }

    /// The answer with the page of a list: of the entries in its list `name`, these members only.
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
