//! `homolog match SOURCE TARGET`: a match without the service.

use super::companions::with_numbers;
use super::error::CliError;
use super::files::{OutputFolder, check_writable, read_input};
use super::interrupt::Interrupt;
use super::match_args::MatchArgs;
use super::match_many;
use super::output::{note, print, print_json};
use super::pair::{Pair, write_page};
use super::summary::summary;
use homolog_run::SurfaceCache;
use std::path::Path;

/// Runs the command.
///
/// # Errors
/// [`CliError`].
pub(super) fn run(args: &MatchArgs) -> Result<(), CliError> {
    let [target] = args.targets.as_slice() else { return match_many::run(args) };
    let limits = args.limits.limits();
    let parameters = with_numbers(&args.parameters.resolve()?, [&args.source, target]);
    let source = read_input(&args.source, &limits)?;
    let target_bytes = read_input(target, &limits)?;
    // Created before the computation, so that an unwritable folder is reported at once.
    let folder = args.out.as_deref().map(OutputFolder::create).transpose()?;
    if let Some(page) = &args.html {
        let folder = page.parent().filter(|folder| !folder.as_os_str().is_empty());
        check_writable(folder.unwrap_or(Path::new(".")))?;
    }
    let pair = Pair { source: (&args.source, &source), target: (target, &target_bytes) };
    let (output, trace) = pair.matched(&SurfaceCache::none(), (&parameters, &limits), &Interrupt::listen(), None)?;
    if let Some(folder) = &folder {
        pair.write(folder, &output, &trace, &args.uids())?;
    }
    if let Some(page) = &args.html {
        write_page(page, &output, &trace)?;
    }
    if args.json {
        return print_json(&output.document);
    }
    print(&summary(&output.document))?;
    if let Some(folder) = &folder {
        note(&format!("written to {}", folder.path().display()));
    }
    Ok(())
}
