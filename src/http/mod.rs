//! How the outside asks: routes, problems, wire types and the OpenAPI document.
//!
//! Reading order: [`mod@router`] (layers and routes), [`routes`] (a file a resource), [`upload`] (multipart under limits),
//! [`wire`] (JSON forms), `accept` and `representation` (which format is answered), [`problem`] (every error there is), [`context`] (request ids, spans, the last resort),
//! [`hosts`] (who may ask), [`server`] (connections).
//!
//! Invariant: every error answer is `application/problem+json`; an answer of 5xx hides its cause and carries the
//! request id. Nothing here knows a store or how a match is computed.

pub mod auth;
pub mod context;
pub mod hosts;
pub mod openapi;
pub mod problem;
pub mod problem_table;
pub mod query;
pub mod router;
pub mod routes;
pub mod server;
pub mod submission;
pub mod upload;
pub mod wire;

mod accept;
mod conditional;
mod examples;
mod long_poll;
mod preferences;
mod representation;

pub use auth::AuthMode;
pub use hosts::AllowedHosts;
pub use router::{HttpLimits, HttpState, probe_router, router};
pub use server::{ConnectionLimits, serve};
