//! Messages in terms of the command line: dotted names of parameters, and the required form of a value.

use homolog_contract::parameters::ParameterError;

/// Messages of libraries about a value, and their meanings.
const MEANINGS: [(&str, &str); 10] = [
    ("invalid digit found in string", "a whole number of at least 0 is needed here"),
    ("cannot parse integer from empty string", "a whole number of at least 0 is needed here"),
    ("number too large to fit in target type", "the number is too large"),
    ("invalid float literal", "a number is needed here"),
    ("cannot parse float from empty string", "a number is needed here"),
    ("provided string was not `true` or `false`", "true or false is needed here"),
    ("is not in 1..18446744073709551615", "must be at least 1"),
    ("is not in 1..=18446744073709551615", "must be at least 1"),
    ("is not in 1..=4294967295", "must be at least 1"),
    ("is not in 1..4294967296", "must be at least 1"),
];

/// A message of a library, rewritten with these meanings.
pub(super) fn plain(message: &str) -> String {
    MEANINGS.iter().fold(message.to_owned(), |said, (theirs, ours)| said.replace(theirs, ours))
}

/// What sentences call a parameter of a request, and the option of the command line that sets it.
const OPTIONS: [(&str, &str); 8] = [
    ("(method: balanced)", "(--method balanced)"),
    ("with the method balanced", "with --method balanced"),
    (
        "Look at both surfaces in corresponding colors;",
        "Look at both surfaces in corresponding colors (--html PAGE.html);",
    ),
    ("(input.labels)", "(--label NUMBER or NAME)"),
    ("input.labels chooses", "--label chooses"),
    ("(input.repair)", "(--repair)"),
    ("(parameter landmarks)", "(--set 'landmarks=[...]')"),
    ("without input.smoothing_mm", "without --set input.smoothing_mm"),
];

/// A sentence of a verdict or a warning, with command-line options in place of request parameters.
pub(super) fn on_command_line(sentence: &str) -> String {
    OPTIONS.iter().fold(sentence.to_owned(), |said, (theirs, ours)| said.replace(theirs, ours))
}

/// One line for each fault, with the dotted name of its parameter, as `--set` takes it.
pub(super) fn describe(faults: &[ParameterError]) -> String {
    let lines: Vec<_> = faults.iter().map(|fault| format!("{}: {}", dotted(&fault.pointer), fault.detail)).collect();
    lines.join("\n")
}

/// `energy.alpha` for the JSON pointer `/energy/alpha`.
fn dotted(pointer: &str) -> String {
    if pointer.is_empty() {
        return "parameters".to_owned();
    }
    let names: Vec<_> = pointer.split('/').skip(1).map(|name| name.replace("~1", "/").replace("~0", "~")).collect();
    names.join(".")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pointers_become_the_names_that_set_takes() {
        for (pointer, name) in [
            ("/energy/alpha", "energy.alpha"),
            ("/features/0/weight", "features.0.weight"),
            ("/a~1b~0", "a/b~"),
            ("", "parameters"),
        ] {
            assert_eq!(dotted(pointer), name);
        }
    }

    #[test]
    fn what_libraries_say_is_said_plainly() {
        let message = "error: invalid value 'x' for '--seed <N>': invalid digit found in string";
        assert!(plain(message).ends_with("'--seed <N>': a whole number of at least 0 is needed here"));
        assert_eq!(plain("anything else"), "anything else");
    }
}
