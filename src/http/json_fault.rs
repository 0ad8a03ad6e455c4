//! What is wrong with a member of a JSON body, said by field and shape: the words of serde name types of Rust.

use super::problem::FieldError;

/// Longest detail, characters: a message may repeat the names of members that a client sent.
const MAX_DETAIL: usize = 400;
/// Longest pointer in an answer.
pub(super) const MAX_POINTER: usize = 256;

/// The fault at a place, from the message of serde.
pub(super) fn json_fault(pointer: String, message: &str) -> FieldError {
    let message = message.rsplit_once(" at line ").map_or(message, |(message, _)| message);
    let (member, code, detail) = said(message);
    let pointer = match member {
        // The place of a member that serde names ends with it, or with the object that it is in.
        Some(member) => {
            let member = format!("/{}", member.replace('~', "~0").replace('/', "~1"));
            if pointer.ends_with(&member) { pointer } else { pointer + &member }
        }
        None => pointer,
    };
    FieldError::new(
        pointer.chars().take(MAX_POINTER).collect::<String>(),
        code,
        detail.chars().take(MAX_DETAIL).collect::<String>(),
    )
}

/// The member that a message names, the code of the fault, and what is allowed.
fn said(message: &str) -> (Option<&str>, &'static str, String) {
    if let Some(rest) = message.strip_prefix("missing field ") {
        let name = quoted(rest);
        return (name, "missing", format!("is required{}", name.and_then(shape_of).unwrap_or_default()));
    }
    if let Some(rest) = message.strip_prefix("unknown field ") {
        let name = quoted(rest);
        let known = names_after(rest, ", expected ");
        let known = if known.is_empty() { String::new() } else { format!("; known members are {}", known.join(", ")) };
        return (name, "unknown_field", format!("is not known here{known}"));
    }
    if let Some(rest) = message.strip_prefix("duplicate field ") {
        return (quoted(rest), "repeated", "must be given once".to_owned());
    }
    if let Some(rest) = message.strip_prefix("unknown variant ") {
        return (
            None,
            "out_of_range",
            format!("must be {}", names_after(rest, ", expected ").join(", ")).replace(", ", " or "),
        );
    }
    if message.starts_with("data did not match any variant of untagged enum CovariateValue") {
        return (None, "wrong_form", "must be a number, a string or null".to_owned());
    }
    if let Some(rest) = message.strip_prefix("invalid type: ")
        && let Some((sent, expected)) = rest.rsplit_once(", expected ")
    {
        return (None, "wrong_form", format!("must be {}, not {}", expected_shape(expected), sent_shape(sent)));
    }
    if let Some(rest) = message.strip_prefix("invalid value: ").or_else(|| message.strip_prefix("invalid length "))
        && let Some((_, expected)) = rest.rsplit_once(", expected ")
    {
        return (None, "out_of_range", format!("must be {}", expected_shape(expected)));
    }
    (None, "wrong_form", message.to_owned())
}

/// The first name in backquotes.
fn quoted(text: &str) -> Option<&str> {
    text.split('`').nth(1)
}

/// The names in backquotes after a word.
fn names_after<'a>(text: &'a str, word: &str) -> Vec<&'a str> {
    let list = text.split_once(word).map_or("", |(_, list)| list);
    list.split('`').skip(1).step_by(2).collect()
}

/// How an input is written; other members say it by their own names.
fn shape_of(member: &str) -> Option<String> {
    ["source", "target", "input"].contains(&member).then(|| format!(": {INPUT_SHAPE}"))
}

/// What an input must be.
pub(super) const INPUT_SHAPE: &str =
    "an object with mesh_id, the id of an upload, or content_base64, or upload, the name of a file of the form";

/// The shape that a type of Rust has in JSON.
fn expected_shape(expected: &str) -> &str {
    match expected {
        "i8" | "i16" | "i32" | "i64" | "isize" => "an integer",
        "u8" | "u16" | "u32" | "u64" | "usize" => "an integer of at least 0",
        "f32" | "f64" => "a number",
        "a boolean" => "true or false",
        "a sequence" => "a list",
        "a map" => "a JSON object",
        _ if expected.starts_with("struct ") => "a JSON object",
        _ if expected.starts_with("enum ") || expected == "variant identifier" => "a string",
        _ => expected,
    }
}

/// The shape of what was sent, without its value.
fn sent_shape(sent: &str) -> &'static str {
    match sent.split(' ').next().unwrap_or("") {
        "null" | "unit" => "null",
        "boolean" => "true or false",
        "integer" | "floating" => "a number",
        "string" | "character" => "a string",
        "sequence" => "a list",
        "map" => "an object",
        _ => "a value of this kind",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_name_the_field_and_its_shape() {
        for (pointer, message, expected) in [
            (
                "",
                "missing field `source` at line 1 column 2",
                ("/source", "missing", &*format!("is required: {INPUT_SHAPE}")),
            ),
            ("/pairs/1", "missing field `id`", ("/pairs/1/id", "missing", "is required")),
            (
                "/color",
                "unknown field `color`, expected one of `source`, `target` at line 1 column 9",
                ("/color", "unknown_field", "is not known here; known members are source, target"),
            ),
            ("/a", "unknown field `color`, there are no fields", ("/a/color", "unknown_field", "is not known here")),
            (
                "/priority",
                "invalid type: string \"high\", expected i32 at line 1 column 1",
                ("/priority", "wrong_form", "must be an integer, not a string"),
            ),
            (
                "/x",
                "invalid type: string \", expected f64\", expected i32",
                ("/x", "wrong_form", "must be an integer, not a string"),
            ),
            (
                "/max_run_s",
                "invalid value: integer `-1`, expected u64",
                ("/max_run_s", "out_of_range", "must be an integer of at least 0"),
            ),
            (
                "/tags",
                "invalid type: sequence, expected a JSON object of strings",
                ("/tags", "wrong_form", "must be a JSON object of strings, not a list"),
            ),
            (
                "/role",
                "unknown variant `x`, expected `model` or `score`",
                ("/role", "out_of_range", "must be model or score"),
            ),
            ("/priority", "duplicate field `priority`", ("/priority", "repeated", "must be given once")),
            ("/tags", "a tag is given twice at line 3 column 1", ("/tags", "wrong_form", "a tag is given twice")),
        ] {
            let FieldError { pointer, code, detail } = json_fault(pointer.to_owned(), message);
            assert_eq!((&*pointer, &*code, &*detail), expected, "{message}");
        }
    }
}
