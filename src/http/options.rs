//! The options that submissions of jobs, batches and studies share.

use super::strict_json::{Parameters, SentTags};
use jiff::Timestamp;

/// The members of a submission besides its inputs, as sent.
#[derive(Debug, Default)]
pub(crate) struct SentOptions {
    pub(crate) parameters: Option<Parameters>,
    pub(crate) tags: SentTags,
    pub(crate) labels: SentTags,
    pub(crate) external_ref: Option<String>,
    pub(crate) priority: Option<i32>,
    pub(crate) deadline_at: Option<Timestamp>,
    pub(crate) max_run_s: Option<u64>,
    pub(crate) use_cache: Option<bool>,
}

/// Defines the document of a submission: its own members, and the shared ones with these descriptions. `take_options` takes the
/// shared ones out. They are members of each document, because a flattened one could not refuse unknown members.
macro_rules! submission_document {
    ($(#[$about:meta])* struct $name:ident { $($own:tt)* } options {
        parameters: $parameters:tt, tags: $tags:tt, external_ref: $external_ref:tt, priority: $priority:tt,
        max_run_s: $max_run_s:tt $(, deadline_at: $deadline_at:tt, use_cache: $use_cache:tt)?
    }) => {
        $(#[$about])*
        #[derive(Debug, Clone, serde::Deserialize, serde::Serialize, utoipa::ToSchema)]
        #[serde(deny_unknown_fields)]
        pub(crate) struct $name {
            $($own)*
            #[doc = $parameters]
            #[serde(default, skip_serializing_if = "Option::is_none")]
            #[schema(value_type = crate::jobs::documents::PartialParameters, required = false)]
            pub(crate) parameters: Option<crate::http::strict_json::Parameters>,
            #[doc = $tags]
            #[serde(default, skip_serializing_if = "crate::http::strict_json::SentTags::is_empty")]
            #[schema(value_type = std::collections::BTreeMap<String, String>, required = false)]
            pub(crate) tags: crate::http::strict_json::SentTags,
            /// The former name of `tags`, accepted until 0.3.
            #[serde(default, skip_serializing_if = "crate::http::strict_json::SentTags::is_empty")]
            #[schema(value_type = std::collections::BTreeMap<String, String>, required = false, deprecated)]
            pub(crate) labels: crate::http::strict_json::SentTags,
            #[doc = $external_ref]
            #[serde(default, skip_serializing_if = "Option::is_none")]
            #[schema(max_length = 200)]
            pub(crate) external_ref: Option<String>,
            #[doc = $priority]
            #[serde(default, skip_serializing_if = "Option::is_none")]
            #[schema(minimum = -100, maximum = 100)]
            pub(crate) priority: Option<i32>,
            #[doc = $max_run_s]
            #[serde(default, skip_serializing_if = "Option::is_none")]
            #[schema(minimum = 1)]
            pub(crate) max_run_s: Option<u64>,
            $(
            #[doc = $deadline_at]
            #[serde(default, skip_serializing_if = "Option::is_none")]
            #[schema(value_type = Option<String>, format = DateTime)]
            pub(crate) deadline_at: Option<jiff::Timestamp>,
            #[doc = $use_cache]
            #[serde(default, skip_serializing_if = "Option::is_none")]
            pub(crate) use_cache: Option<bool>,
            )?
        }

        impl $name {
            /// Takes the shared members out.
            pub(crate) fn take_options(&mut self) -> crate::http::options::SentOptions {
                #[allow(unused_mut, reason = "not every submission has all options")]
                let mut options = crate::http::options::SentOptions {
                    parameters: self.parameters.take(),
                    tags: std::mem::take(&mut self.tags),
                    labels: std::mem::take(&mut self.labels),
                    external_ref: self.external_ref.take(),
                    priority: self.priority,
                    deadline_at: None,
                    max_run_s: self.max_run_s,
                    use_cache: None,
                };
                $(
                const _: [&str; 2] = [$deadline_at, $use_cache];
                (options.deadline_at, options.use_cache) = (self.deadline_at, self.use_cache);
                )?
                options
            }
        }
    };
}

pub(crate) use submission_document;
