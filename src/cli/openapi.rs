//! `homolog openapi`: the contract of the service as an OpenAPI document.

use super::error::CliError;
use super::output::print;
use super::seams::openapi_json;

/// Prints the document.
///
/// # Errors
/// [`CliError`].
pub fn run() -> Result<(), CliError> {
    print(openapi_json()?.trim_end())
}
