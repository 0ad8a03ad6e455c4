//! Descriptions of operations in the OpenAPI document, from their parts: parameters, headers of answers, problems.

use super::operations::Operation;
use super::parts::Part;
use super::problem::PROBLEM_JSON;
use axum::http::Method;
use utoipa::openapi::header::Header;
use utoipa::openapi::path::{Operation as Described, Parameter, ParameterBuilder, ParameterIn};
use utoipa::openapi::schema::{KnownFormat, Object, ObjectBuilder, SchemaFormat, SchemaType, Type};
use utoipa::openapi::{Content, OpenApi, Ref, RefOr, Required, Response};
use utoipa::{PartialSchema, openapi::Schema};

/// Media types of surfaces.
const SURFACES: [&str; 6] =
    ["model/ply", "model/vtk", "application/vnd.vtk.vtp", "application/gifti+xml", "model/stl", "model/gltf-binary"];

impl Operation {
    /// The description of the operation in the document.
    pub(super) fn described<'a>(&self, document: &'a mut OpenApi) -> Option<&'a mut Described> {
        let item = document.paths.paths.get_mut(self.path)?;
        let described = match self.method {
            Method::POST => &mut item.post,
            Method::PUT => &mut item.put,
            Method::PATCH => &mut item.patch,
            Method::DELETE => &mut item.delete,
            _ => &mut item.get,
        };
        described.as_mut()
    }

    /// Completes the description of the operation in the document.
    pub(super) fn describe(&self, document: &mut OpenApi) {
        let Some(described) = self.described(document) else { return };
        described.operation_id = Some(self.name.to_owned());
        described.tags = Some(vec![self.tag.to_owned()]);
        let (noun, name, description) = self.resource.words();
        if self.path.contains(&format!("{{{name}}}")) {
            let named = described.parameters.get_or_insert_default();
            if !has(named, name) {
                named.insert(0, parameter(ParameterIn::Path, name, description, text()).into());
            }
            if !self.parts.iter().any(|part| matches!(part, Part::Says(404, _))) {
                problem(described, 404, &format!("No such {noun}"));
            }
        }
        // Their own problems first: the texts of parts are the general ones.
        for part in self.parts {
            if let Part::Says(status, when) = part {
                problem(described, *status, when);
            }
        }
        self.parts.iter().for_each(|part| part.describe(described, noun));
    }
}

impl Part {
    fn describe(self, to: &mut Described, noun: &str) {
        match self {
            Part::Query => problem(to, 400, "Invalid query parameters"),
            Part::Pages(entries) => {
                Part::Query.describe(to, noun);
                query(to, "page_size", &format!("Maximum number of {entries}; 50 if absent"), number(1, 500));
                query(to, "page_token", "`next_page_token` of the previous page", text());
            }
            Part::Watch => {
                Part::Query.describe(to, noun);
                Part::Polls.describe(to, noun);
                query(to, "wait", "Longest time to wait for a change, s; 0 if absent", number(0, 30));
                let same = format!("The {noun} has not changed since the version that `If-None-Match` names");
                let about = format!("The ETag of an earlier answer: 304 if the {noun} has not changed since");
                known(to, ["Weak; pass it as `If-None-Match`", &about, &same]);
            }
            Part::Polls => problem(to, 429, "Too many event streams and long polls are open"),
            Part::Follow => problem(to, 429, "Too many streams are open"),
            Part::Etag => {
                let same = "Not modified since the version that `If-None-Match` names";
                known(to, ["Pass it as `If-None-Match`", "ETag of an earlier answer", same]);
            }
            Part::OfResult => {
                problem(to, 409, &format!("The {noun} is not finished, or finished without a result"));
                problem(to, 410, "The result was deleted at the end of its retention time");
            }
            Part::Formats => {
                Part::Query.describe(to, noun);
                header(to, "200", "ETag", "Of this representation", text());
                header(to, "200", "Vary", "`accept`", text());
                problem(to, 406, "`Accept` allows none of the formats; `available` lists them");
                Part::Etag.describe(to, noun);
            }
            Part::Surface => {
                let about = "`ply`, `vtk`, `vtp`, `gifti`, `stl` or `glb`; takes precedence over `Accept`; PLY if neither is given";
                query(to, "format", about, text());
                header(to, "200", "Content-Disposition", "Suggested file name", text());
                let Some(RefOr::T(answer)) = to.responses.responses.get_mut("200") else { return };
                for media_type in SURFACES {
                    answer.content.insert(media_type.to_owned(), Content::new(Some(String::schema())).into());
                }
            }
            Part::Uids => {
                for (name, about) in [
                    (
                        "study_uid",
                        "UID of the study, used where neither input is a DICOM object; its patient is left empty",
                    ),
                    ("source_frame_uid", "UID of the frame of reference of the source, used where it states none"),
                    ("target_frame_uid", "UID of the frame of reference of the target, used where it states none"),
                ] {
                    let uid = ObjectBuilder::new().schema_type(Type::String).max_length(Some(64)).build();
                    query(to, name, &format!("`dicom`: {about}"), uid);
                }
            }
            Part::Json => {
                problem(to, 400, "The body is malformed");
                problem(to, 415, "Not JSON");
                problem(to, 422, "Invalid fields");
            }
            Part::Files => problem(to, 400, "The body is malformed"),
            Part::Form => problem(to, 415, "Neither multipart nor JSON, or an unknown file format"),
            Part::Idempotent => {
                let about = "1 to 128 visible ASCII characters";
                add(to, parameter(ParameterIn::Header, "Idempotency-Key", about, maybe_text()));
                problem(to, 409, "A request with the same Idempotency-Key is in progress");
            }
            Part::Accepted => {
                header(to, "202", "Location", &format!("The {noun}"), text());
                let seconds = ObjectBuilder::new()
                    .schema_type(Type::Integer)
                    .format(Some(SchemaFormat::KnownFormat(KnownFormat::Int32)))
                    .minimum(Some(0));
                header(to, "202", "Retry-After", "Suggested delay before the next request, s", seconds.build());
            }
            Part::Queue => problem(to, 429, "The queue is full"),
            Part::Slow => problem(to, 408, "The body took too long to arrive"),
            Part::Busy => problem(to, 503, "Too many uploads at once, or a dependency does not respond"),
            Part::Full => problem(to, 507, "Out of storage space"),
            Part::Download | Part::Says(..) => {}
        }
    }
}

/// A header `ETag` and `If-None-Match`: what the header, the parameter and a 304 say.
fn known(to: &mut Described, [etag, sent, same]: [&str; 3]) {
    header(to, "200", "ETag", etag, text());
    add(to, parameter(ParameterIn::Header, "If-None-Match", sent, maybe_text()));
    to.responses.responses.entry("304".to_owned()).or_insert_with(|| Response::new(same).into());
}

fn text() -> Object {
    Object::with_type(Type::String)
}

fn maybe_text() -> Object {
    Object::with_type(SchemaType::from_iter([Type::String, Type::Null]))
}

fn number(least: u32, most: u32) -> Object {
    let format = Some(SchemaFormat::KnownFormat(KnownFormat::Int32));
    ObjectBuilder::new().schema_type(Type::Integer).format(format).minimum(Some(least)).maximum(Some(most)).build()
}

fn parameter(place: ParameterIn, name: &str, about: &str, schema: Object) -> Parameter {
    let required = if place == ParameterIn::Path { Required::True } else { Required::False };
    ParameterBuilder::new()
        .name(name)
        .parameter_in(place)
        .required(required)
        .description(Some(about))
        .schema(Some(schema))
        .build()
}

fn query(to: &mut Described, name: &str, about: &str, schema: Object) {
    add(to, parameter(ParameterIn::Query, name, about, schema));
}

/// Adds a parameter, unless the handler describes it.
pub(super) fn add(to: &mut Described, parameter: Parameter) {
    let described = to.parameters.get_or_insert_default();
    if !has(described, &parameter.name) {
        described.push(parameter.into());
    }
}

fn has(described: &[RefOr<Parameter>], name: &str) -> bool {
    described.iter().any(|one| matches!(one, RefOr::T(one) if one.name == name))
}

/// Adds a header to the answer with this status, if there is one, unless the handler describes it.
fn header(to: &mut Described, status: &str, name: &str, about: &str, schema: Object) {
    let Some(RefOr::T(answer)) = to.responses.responses.get_mut(status) else { return };
    let described = || {
        let mut header = Header::new(Schema::from(schema));
        header.description = Some(about.to_owned());
        header
    };
    answer.headers.entry(name.to_owned()).or_insert_with(|| described().into());
}

/// Adds a problem, unless one with this status is described.
pub(super) fn problem(to: &mut Described, status: u16, when: &str) {
    let response = || {
        let content = Content::new(Some(Ref::from_schema_name("ProblemDocument")));
        Response::builder().description(when).content(PROBLEM_JSON, content).build().into()
    };
    to.responses.responses.entry(status.to_string()).or_insert_with(response);
}
