//! JSON bodies, read into typed forms under limits.
//!
//! Nothing that a client sends becomes a tree of unknown size: a value of any form takes a hundred times the memory of its
//! text. What may have any form, the parameters of a match, has a limit of its own; lists and tags are read up to
//! the largest number that is accepted. A member that is given twice is refused, since readers differ in which one counts.

use super::json_fault::{MAX_POINTER, json_fault};
use super::problem::{FieldError, Problem};
use super::problem_table::ProblemKind;
use crate::jobs::metadata::{MetadataFault, Tags};
use serde::de::value::MapAccessDeserializer;
use serde::de::{DeserializeSeed, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::{Map, Number, Value};
use serde_path_to_error::Segment;
use std::cell::Cell;
use std::collections::BTreeMap;
use std::fmt;
use std::marker::PhantomData;

/// Longest list in a body: the largest value of the setting for jobs of a batch.
pub(crate) const MAX_LIST: usize = 100_000;
/// Bytes of text for which each value of the parameters counts at least, so that many small ones are bounded too.
const LEAST_VALUE: usize = 8;
/// Marks an error of serde: the parameters are too large.
const NO_ROOM: &str = "the parameters are too large";

thread_local! {
    /// Remaining bytes for parameters in the body that this thread is reading. Bodies are read without yielding.
    static ROOM: Cell<usize> = const { Cell::new(0) };
    /// Number of kept entries of a list; further ones are only counted, because one too many is enough to refuse the
    /// list.
    static KEPT: Cell<usize> = const { Cell::new(0) };
}

fn take_room<E: Error>(n: usize) -> Result<(), E> {
    let left = ROOM.get().checked_sub(n.max(LEAST_VALUE)).ok_or_else(|| E::custom(NO_ROOM))?;
    ROOM.set(left);
    Ok(())
}

/// Reads a JSON body, of which at most `max_parameters` bytes may be parameters. A list with more than `max_list`
/// entries is read as a list of `max_list` + 1.
///
/// # Errors
/// `malformed-json`; `too-large` for the parameters; `invalid-request` with the location of the first fault.
pub(super) fn parse<'a, T: Deserialize<'a>>(
    body: &'a [u8],
    max_parameters: usize,
    max_list: usize,
) -> Result<T, Problem> {
    // serde would also read a struct from an array, by the order of its fields.
    if body.iter().find(|b| !b.is_ascii_whitespace()).is_some_and(|&b| b == b'[') {
        let fault = FieldError::new("", "wrong_form", "must be a JSON object");
        return Err(Problem::new(ProblemKind::InvalidRequest).errors(&[fault]));
    }
    ROOM.set(max_parameters);
    KEPT.set(max_list.saturating_add(1));
    let mut reader = serde_json::Deserializer::from_slice(body);
    let read = serde_path_to_error::deserialize(&mut reader).map_err(|error| {
        let pointer = pointer(error.path());
        let inner = error.into_inner();
        if inner.is_syntax() || inner.is_eof() {
            return malformed(&inner);
        }
        let text = inner.to_string();
        if text.starts_with(NO_ROOM) {
            return parameters_too_large(max_parameters);
        }
        Problem::new(ProblemKind::InvalidRequest).errors(&[json_fault(pointer, &text)])
    })?;
    reader.end().map_err(|error| malformed(&error))?;
    Ok(read)
}

fn malformed(error: &serde_json::Error) -> Problem {
    let detail = format!("invalid JSON at line {}, column {}", error.line(), error.column());
    Problem::new(ProblemKind::MalformedJson).detail(detail)
}

fn parameters_too_large(limit: usize) -> Problem {
    Problem::new(ProblemKind::TooLarge)
        .detail(format!("parameters has more than {limit} bytes"))
        .member("limit_bytes", limit.into())
}

/// The JSON pointer of a path.
fn pointer(path: &serde_path_to_error::Path) -> String {
    let mut pointer = String::new();
    for segment in path.iter() {
        match segment {
            Segment::Seq { index } => pointer.push_str(&format!("/{index}")),
            Segment::Map { key } => pointer.push_str(&format!("/{}", key.replace('~', "~0").replace('/', "~1"))),
            Segment::Enum { .. } | Segment::Unknown => {}
        }
    }
    pointer.chars().take(MAX_POINTER).collect()
}

/// The parameters in a form field.
///
/// # Errors
/// The fault in the field.
pub(super) fn parse_parameters(text: &str, max_parameters: usize) -> Result<Parameters, FieldError> {
    ROOM.set(max_parameters);
    serde_json::from_str(text).map_err(|error| {
        let at = format!("line {}, column {}", error.line(), error.column());
        if error.is_data() {
            return json_fault("/parameters".to_owned(), &error.to_string());
        }
        FieldError::new("/parameters", "malformed_json", format!("invalid JSON at {at}"))
    })
}

/// The parameters of a match: JSON of any form, within the limit of the body that is being read.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(transparent)]
pub(crate) struct Parameters(pub(crate) Value);

impl<'de> Deserialize<'de> for Parameters {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        AnyValue.deserialize(deserializer).map(Parameters)
    }
}

/// Reads a value of any form, which uses up the limit; refuses repeated members.
#[derive(Clone, Copy)]
struct AnyValue;

impl<'de> DeserializeSeed<'de> for AnyValue {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for AnyValue {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a JSON value")
    }

    fn visit_bool<E: Error>(self, value: bool) -> Result<Value, E> {
        take_room(0).map(|()| value.into())
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Value, E> {
        take_room(0).map(|()| value.into())
    }

    fn visit_u64<E: Error>(self, value: u64) -> Result<Value, E> {
        take_room(0).map(|()| value.into())
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Value, E> {
        take_room(0).map(|()| Number::from_f64(value).map_or(Value::Null, Value::Number))
    }

    fn visit_str<E: Error>(self, value: &str) -> Result<Value, E> {
        take_room(value.len()).map(|()| value.into())
    }

    fn visit_unit<E: Error>(self) -> Result<Value, E> {
        take_room(0).map(|()| Value::Null)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Value, A::Error> {
        take_room(0)?;
        let mut values = Vec::new();
        while let Some(value) = list.next_element_seed(self)? {
            values.push(value);
        }
        Ok(values.into())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<Value, A::Error> {
        take_room(0)?;
        let mut members = Map::new();
        while let Some(name) = object.next_key::<String>()? {
            take_room(name.len())?;
            if members.contains_key(&name) {
                return Err(A::Error::custom("this member is given twice"));
            }
            let value = object.next_value_seed(self)?;
            members.insert(name, value);
        }
        Ok(Value::Object(members))
    }
}

/// Tags as sent, not checked yet. No more are kept than show that there are too many.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub(crate) struct SentTags(pub(crate) BTreeMap<String, String>);

impl SentTags {
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<'de> Deserialize<'de> for SentTags {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Reader;

        impl<'de> Visitor<'de> for Reader {
            type Value = SentTags;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a JSON object of strings")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<SentTags, A::Error> {
                let mut tags = BTreeMap::new();
                while tags.len() <= Tags::MAX {
                    let Some((name, value)) = object.next_entry()? else { return Ok(SentTags(tags)) };
                    if tags.insert(name, value).is_some() {
                        return Err(A::Error::custom("a tag is given twice"));
                    }
                }
                while object.next_entry::<IgnoredAny, IgnoredAny>()?.is_some() {}
                Ok(SentTags(tags))
            }
        }

        deserializer.deserialize_map(Reader)
    }
}

/// The former name of tags, accepted until 0.3.
pub(super) const FORMER_TAGS: &str = "labels";

/// The tags that were sent, as `tags` or under their former name.
///
/// # Errors
/// The member that has a fault, and what is allowed.
pub(super) fn tags_of(SentTags(tags): SentTags, SentTags(former): SentTags) -> Result<Tags, (&'static str, String)> {
    let said = |name| move |fault: MetadataFault| (name, fault.to_string());
    match (tags.is_empty(), former.is_empty()) {
        (_, true) => Tags::new(tags).map_err(said("tags")),
        (true, false) => Tags::new(former).map_err(said(FORMER_TAGS)),
        (false, false) => Err((FORMER_TAGS, "is the former name of tags; send tags only".to_owned())),
    }
}

/// Reads a form from a JSON object only.
pub(super) fn object<'de, D: Deserializer<'de>, T: Deserialize<'de>>(deserializer: D) -> Result<T, D::Error> {
    struct Reader<T>(PhantomData<T>);

    impl<'de, T: Deserialize<'de>> Visitor<'de> for Reader<T> {
        type Value = T;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("a JSON object")
        }

        fn visit_map<A: MapAccess<'de>>(self, object: A) -> Result<T, A::Error> {
            T::deserialize(MapAccessDeserializer::new(object))
        }
    }

    deserializer.deserialize_map(Reader(PhantomData))
}

/// Reads a list of objects, of at most [`MAX_LIST`].
pub(super) fn objects<'de, D: Deserializer<'de>, T: Deserialize<'de>>(deserializer: D) -> Result<Vec<T>, D::Error> {
    struct Reader<T>(PhantomData<T>);
    struct Entry<T>(T);

    impl<'de, T: Deserialize<'de>> Deserialize<'de> for Entry<T> {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            object(deserializer).map(Entry)
        }
    }

    impl<'de, T: Deserialize<'de>> Visitor<'de> for Reader<T> {
        type Value = Vec<T>;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            write!(f, "a list of at most {MAX_LIST} JSON objects")
        }

        fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vec<T>, A::Error> {
            let (mut entries, kept) = (Vec::new(), KEPT.get());
            while entries.len() < kept {
                let Some(Entry(entry)) = list.next_element()? else { return Ok(entries) };
                entries.push(entry);
            }
            let mut n = entries.len();
            while let Some(IgnoredAny) = list.next_element()? {
                n += 1;
                if n > MAX_LIST {
                    return Err(A::Error::invalid_length(n, &self));
                }
            }
            Ok(entries)
        }
    }

    deserializer.deserialize_seq(Reader(PhantomData))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn parameters(text: &str, room: usize) -> Result<Value, Problem> {
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Body {
            parameters: Parameters,
        }
        parse::<Body>(text.as_bytes(), room, 10).map(|body| body.parameters.0)
    }

    #[test]
    fn of_a_list_no_more_is_kept_than_shows_that_it_is_too_long() {
        #[derive(Deserialize)]
        struct Entry {}
        #[derive(Deserialize)]
        struct Body {
            #[serde(deserialize_with = "objects")]
            list: Vec<Entry>,
        }
        let read = |n: usize| {
            let text = json!({"list": vec![json!({}); n]}).to_string();
            parse::<Body>(text.as_bytes(), 0, 3).map(|body| body.list.len()).ok()
        };
        assert_eq!([0, 3, 4, 5, 50_000].map(read), [Some(0), Some(3), Some(4), Some(4), Some(4)]);
        assert_eq!(read(MAX_LIST + 1), None);
    }

    #[test]
    fn parameters_are_read_as_they_are_within_their_room() {
        let value = json!({"a": [1, -2, 2.5, true, null, "x"], "b": {"c": {}}});
        let text = json!({"parameters": value}).to_string();
        assert_eq!(parameters(&text, 1000).unwrap(), value);
        let refused = format!("{:?}", parameters(&text, 60).unwrap_err());
        assert!(refused.contains("TooLarge"), "{refused}");
    }

    #[test]
    fn members_given_twice_and_what_follows_the_body_are_refused() {
        for (text, part) in [
            (r#"{"parameters": {"a": 1, "a": 2}}"#, "given twice"),
            (r#"{"parameters": {}, "parameters": {}}"#, "must be given once"),
            (r#"{"parameters": {}} {}"#, "MalformedJson"),
            (r#"{"parameters": {}"#, "MalformedJson"),
            (r#"[{}]"#, "JSON object"),
            (r#""x""#, "InvalidRequest"),
            (r#"{"color": 1}"#, "color"),
        ] {
            let refused = format!("{:?}", parameters(text, 1000).unwrap_err());
            assert!(refused.contains(part), "{text}: {refused}");
        }
    }

    #[test]
    fn tags_are_kept_up_to_one_more_than_are_allowed() {
        let text = format!("{{{}}}", (0..1000).map(|i| format!("\"k{i}\": \"\"")).collect::<Vec<_>>().join(","));
        assert_eq!(serde_json::from_str::<SentTags>(&text).unwrap().0.len(), Tags::MAX + 1);
        assert!(serde_json::from_str::<SentTags>(r#"{"a": "1", "a": "2"}"#).is_err());
        assert!(serde_json::from_str::<SentTags>(r#"{"a": 1}"#).is_err());
    }
}
