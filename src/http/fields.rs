//! `?fields=`: lists with only the members that a client wants.

use super::query::QueryString;
use super::wire::JobDocument;
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::sync::LazyLock;
use utoipa::PartialSchema;

/// The members of a job.
static OF_JOBS: LazyLock<BTreeSet<String>> = LazyLock::new(|| {
    let schema = serde_json::to_value(JobDocument::schema()).unwrap_or(Value::Null);
    schema["properties"].as_object().into_iter().flat_map(Map::keys).cloned().collect()
});

/// The members that entries of a list keep; `None` for all.
#[derive(Debug)]
pub(super) struct Fields(Option<BTreeSet<String>>);

impl Fields {
    /// `?fields=id,state` of a list of jobs. Unknown members are faults.
    pub(super) fn of_jobs(query: &mut QueryString) -> Self {
        let Some(text) = query.text("fields") else { return Fields(None) };
        let asked: BTreeSet<String> = text.split(',').map(|name| name.trim().to_owned()).collect();
        if !asked.is_subset(&OF_JOBS) {
            let known: Vec<&str> = OF_JOBS.iter().map(String::as_str).collect();
            query.fault("fields", "out_of_range", format!("must be members of a job: {}", known.join(", ")));
        }
        Fields(Some(asked))
    }

    /// The document with only these members in the entries of its list `name`.
    pub(super) fn of(&self, mut document: Value, name: &str) -> Value {
        let Fields(Some(kept)) = self else { return document };
        for entry in document.get_mut(name).and_then(Value::as_array_mut).into_iter().flatten() {
            if let Value::Object(members) = entry {
                members.retain(|member, _| kept.contains(member));
            }
        }
        document
    }
}
