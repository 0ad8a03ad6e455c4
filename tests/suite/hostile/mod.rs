//! Malicious clients with ordinary rights: limits on what one client may take from the service and from other clients.
//!
//! A file for each kind: [`memory`] (bodies and downloads), [`slow`] (uploads and downloads that stall), [`hosts`] (web pages),
//! [`metadata`] (tags and references), [`characters`] (NUL and long texts), [`receivers`] (webhooks), [`turns`] (queues), [`shares`] (requests, stored bytes and running jobs of a tenant),
//! [`streams`] (event streams and probes), [`studies`] (definitions of studies, and probes beside them), [`presence`] (requests whose process died), [`traces`] (what stays of patients), [`manners`] (small promises of the contract), [`mutations`] (requests with random damage).

mod characters;
mod hosts;
mod manners;
mod memory;
mod metadata;
mod mutations;
mod presence;
mod receivers;
mod shares;
mod slow;
mod streams;
mod studies;
mod traces;
mod turns;
