//! The HTTP API: routes, problems, wire types and the OpenAPI document.
//!
//! Reading order: [`operations`] (the table of all operations; `parts`, what they have in common), [`state`] (of all
//! handlers), `call` (a request whose sender is authorized), [`routes`] (the handlers, one file for each resource), `handlers`
//! (all of them), [`mod@router`] (layers), [`openapi`] (the document, with `service_description`, `operation_description` and
//! `examples`), [`upload`] (bodies under limits; `shares` among clients, `pace` and `rate` of each), `strict_json`, [`wire`] and
//! `study_wire` (JSON forms; `options`, the members that submissions share), `accept` and `representation` (content
//! negotiation), `content` (streams and ranges), `fields` (lists with selected members), `conditional` and `long_poll` (ETags
//! and `?wait=`), [`problem`] (errors), [`context`] (spans, metrics, `request_id`), `audit` (recorded requests), `auth` (keys,
//! under an `auth_mode`), `tokens` (of OpenID Connect) and `ticketed` (tickets), [`hosts`] and `host_check` (host validation),
//! `cors` (pages of other origins) and `allowed_methods` (`OPTIONS`), [`server`] (connections), `page` (the dashboard);
//! `fuzzed` holds the entry points of fuzzing.
//!
//! Invariant: every error answer is `application/problem+json`; a 5xx answer hides its cause and carries the request
//! id. This module knows neither the stores nor how a match is computed.

mod accept;
mod allowed_methods;
mod audit;
mod auth;
mod auth_mode;
mod call;
mod compression;
mod conditional;
mod content;
mod context;
mod cors;
mod examples;
mod fields;
#[cfg(any(test, fuzzing))]
pub mod fuzzed;
mod handlers;
mod head;
mod host_check;
mod hosts;
mod input_wire;
mod json_fault;
mod links;
mod long_poll;
mod openapi;
mod operation_description;
mod operations;
mod options;
mod pace;
mod page;
mod parts;
mod preferences;
mod problem;
mod problem_table;
mod query;
mod rate;
mod representation;
mod request_id;
mod router;
mod routes;
mod server;
mod service_description;
mod shares;
mod state;
mod strict_json;
mod study_score_wire;
mod study_wire;
mod submission;
mod ticketed;
mod token_signatures;
mod tokens;
mod upload;
mod wire;

pub use auth_mode::AuthMode;
pub use cors::CorsOrigins;
pub use hosts::AllowedHosts;
pub use openapi::openapi_json;
pub use operations::{OPERATIONS, Operation};
pub use pace::LeastRate;
pub use problem_table::problems_markdown;
pub use router::{probe_router, router};
pub use server::{ConnectionLimits, Served, serve};
pub use state::{HttpLimits, HttpState};
pub(crate) use strict_json::MAX_LIST;
pub use tokens::{KeySetSource, TokenSettings, Tokens};
