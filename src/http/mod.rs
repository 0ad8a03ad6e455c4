//! The HTTP API: routes, problems, wire types and the OpenAPI document.
//!
//! Reading order: [`mod@router`] (layers and routes), [`routes`] (one file for each resource), [`upload`] (bodies under
//! limits; `shares` among clients, `pace` and `rate` of each), `strict_json`, [`wire`] and `study_wire` (JSON forms),
//! `accept` and `representation` (content negotiation), `content` (streams and ranges), `fields` (lists with selected
//! members), `conditional` and `long_poll` (ETags and `?wait=`), [`problem`] (errors), [`context`] (request ids, spans,
//! metrics), `audit` (recorded requests), `auth` (keys), `tokens` (of OpenID Connect) and `ticketed` (tickets),
//! [`hosts`] (host validation) and `cors` (pages of other origins), [`server`] (connections), `page` (the dashboard);
//! `fuzzed` holds the entry points of fuzzing.
//!
//! Invariant: every error answer is `application/problem+json`; a 5xx answer hides its cause and carries the request
//! id. This module knows neither the stores nor how a match is computed.

mod accept;
mod audit;
mod auth;
mod compression;
mod conditional;
mod content;
mod context;
mod cors;
mod examples;
mod fields;
#[cfg(any(test, fuzzing))]
pub mod fuzzed;
mod head;
mod hosts;
mod input_wire;
mod json_fault;
mod long_poll;
mod openapi;
mod pace;
mod page;
mod preferences;
mod problem;
mod problem_table;
mod query;
mod rate;
mod representation;
mod router;
mod routes;
mod server;
mod shares;
mod strict_json;
mod study_score_wire;
mod study_wire;
mod submission;
mod ticketed;
mod token_signatures;
mod tokens;
mod upload;
mod wire;

pub use auth::AuthMode;
pub use cors::CorsOrigins;
pub use hosts::AllowedHosts;
pub use openapi::openapi_json;
pub use pace::LeastRate;
pub use problem_table::problems_markdown;
pub use router::{HttpLimits, HttpState, probe_router, router};
pub use server::{ConnectionLimits, Served, serve};
pub(crate) use strict_json::MAX_LIST;
pub use tokens::{KeySetSource, TokenSettings, Tokens};
