//! A small HTTP client for the service: JSON answers and multipart submissions.

use crate::cli::error::CliError;
use serde_json::Value;
use std::time::Duration;

/// A client of one service.
pub(in crate::cli) struct ServiceClient {
    base: String,
    agent: ureq::Agent,
}

/// Status and body of an answer.
pub(in crate::cli) struct Answer {
    /// HTTP status.
    pub(in crate::cli) status: u16,
    /// The whole body.
    pub(in crate::cli) body: Vec<u8>,
}

/// Largest answer, bytes; enough for the correspondences of the largest surfaces.
const MAX_BODY: u64 = 512 << 20;

impl ServiceClient {
    /// `base` is scheme and authority, such as `http://127.0.0.1:8080`; `timeout` applies to every request.
    pub(in crate::cli) fn new(base: &str, timeout: Duration) -> Self {
        let config = ureq::Agent::config_builder()
            .timeout_global(Some(timeout))
            .http_status_as_error(false)
            // The service is local or named explicitly, so a proxy from the environment does not apply to it.
            .proxy(None)
            .build();
        ServiceClient { base: base.trim_end_matches('/').to_owned(), agent: config.into() }
    }

    /// `GET path`.
    ///
    /// # Errors
    /// [`CliError::Failed`] if there is no answer.
    pub(in crate::cli) fn get(&self, path: &str) -> Result<Answer, CliError> {
        self.read("GET", path, self.agent.get(self.url(path)).call())
    }

    /// `GET path`, which must answer 200 with JSON.
    ///
    /// # Errors
    /// [`CliError::Failed`] for anything else.
    pub(in crate::cli) fn get_json(&self, path: &str) -> Result<Value, CliError> {
        let answer = self.get(path)?;
        if answer.status != 200 {
            return Err(CliError::Failed(format!("GET {path} answered {}: {}", answer.status, answer.problem())));
        }
        answer.json()
    }

    /// `POST path` with a multipart form.
    ///
    /// # Errors
    /// [`CliError::Failed`] if there is no answer.
    pub(in crate::cli) fn post_form(&self, path: &str, parts: &[FormPart<'_>]) -> Result<Answer, CliError> {
        let (content_type, body) = multipart(parts);
        let sent = self.agent.post(self.url(path)).header("content-type", &content_type).send(&body[..]);
        self.read("POST", path, sent)
    }

    fn url(&self, path: &str) -> String {
        // Links may be absolute.
        if path.starts_with("http://") { path.to_owned() } else { format!("{}{path}", self.base) }
    }

    fn read(
        &self,
        verb: &str,
        path: &str,
        sent: Result<http::Response<ureq::Body>, ureq::Error>,
    ) -> Result<Answer, CliError> {
        let unanswered = |e: ureq::Error| CliError::Failed(format!("{verb} {}: {e}", self.url(path)));
        let mut response = sent.map_err(unanswered)?;
        let status = response.status().as_u16();
        let body = response.body_mut().with_config().limit(MAX_BODY).read_to_vec().map_err(unanswered)?;
        Ok(Answer { status, body })
    }
}

impl Answer {
    /// The body as JSON.
    ///
    /// # Errors
    /// [`CliError::Failed`] if it is not.
    pub(in crate::cli) fn json(&self) -> Result<Value, CliError> {
        serde_json::from_slice(&self.body)
            .map_err(|e| CliError::Failed(format!("the answer of the service is not JSON: {e}")))
    }

    /// The text of a problem document.
    pub(in crate::cli) fn problem(&self) -> String {
        let Ok(problem) = self.json() else { return String::from_utf8_lossy(&self.body).into_owned() };
        let text = |value: &Value, key: &str| value.get(key).and_then(Value::as_str).unwrap_or_default().to_owned();
        let mut lines = vec![text(&problem, "title"), text(&problem, "detail")];
        for fault in problem.get("errors").and_then(Value::as_array).into_iter().flatten() {
            lines.push(format!("{}: {}", text(fault, "pointer"), text(fault, "detail")));
        }
        lines.retain(|line| !line.is_empty());
        lines.dedup();
        lines.join("\n")
    }
}

/// One part of a form.
pub(in crate::cli) struct FormPart<'a> {
    /// Name of the field.
    pub(in crate::cli) name: &'a str,
    /// Name of the file, for files.
    pub(in crate::cli) file_name: Option<&'a str>,
    /// Media type.
    pub(in crate::cli) content_type: &'a str,
    /// Content.
    pub(in crate::cli) bytes: &'a [u8],
}

/// RFC 7578: the content type with its boundary, and the body.
fn multipart(parts: &[FormPart<'_>]) -> (String, Vec<u8>) {
    // 122 random bits: no file contains them by chance.
    let boundary = format!("homolog-{}", uuid::Uuid::new_v4().simple());
    let mut body = Vec::with_capacity(parts.iter().map(|p| p.bytes.len() + 256).sum());
    for part in parts {
        body.extend_from_slice(
            format!("--{boundary}\r\ncontent-disposition: form-data; name=\"{}\"", part.name).as_bytes(),
        );
        if let Some(name) = part.file_name {
            // As in browsers, characters that would end the quoted string are percent-encoded.
            let name = name.replace('"', "%22").replace('\r', "%0D").replace('\n', "%0A");
            body.extend_from_slice(format!("; filename=\"{name}\"").as_bytes());
        }
        body.extend_from_slice(format!("\r\ncontent-type: {}\r\n\r\n", part.content_type).as_bytes());
        body.extend_from_slice(part.bytes);
        body.extend_from_slice(b"\r\n");
    }
    body.extend_from_slice(format!("--{boundary}--\r\n").as_bytes());
    (format!("multipart/form-data; boundary={boundary}"), body)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_form_has_its_parts_between_boundaries() {
        let part = FormPart { name: "source", file_name: Some("a\"b.ply"), content_type: "text/plain", bytes: b"xyz" };
        let (content_type, body) = multipart(&[part]);
        let boundary = content_type.split_once("boundary=").unwrap().1;
        let expected = format!(
            "--{boundary}\r\ncontent-disposition: form-data; name=\"source\"; filename=\"a%22b.ply\"\r\n\
             content-type: text/plain\r\n\r\nxyz\r\n--{boundary}--\r\n"
        );
        assert_eq!(String::from_utf8(body).unwrap(), expected);
    }

    #[test]
    fn the_text_of_a_problem_has_a_line_for_each_fault() {
        let body = br#"{"title": "bad", "detail": "two faults", "errors": [{"pointer": "/seed", "detail": "no"}]}"#;
        assert_eq!(Answer { status: 422, body: body.to_vec() }.problem(), "bad\ntwo faults\n/seed: no");
        assert_eq!(Answer { status: 500, body: b"oops".to_vec() }.problem(), "oops");
    }
}
