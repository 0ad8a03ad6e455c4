//! The mode of authentication, which the operator sets.

/// Whether requests are authenticated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum AuthMode {
    /// No authentication: every client is the tenant `default` and has every scope.
    None,
    /// API keys are required, `Authorization: Bearer hml_…`, or tokens where a provider is set.
    Keys,
}
