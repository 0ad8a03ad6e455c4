//! A client of the service: submits two files, waits for the end by long polls, and prints the verdict.
//!
//! Usage: `05_client http://127.0.0.1:8080 SOURCE TARGET [KEY]`.
#![allow(clippy::print_stdout, reason = "an example")]

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use serde_json::{Value, json};

type Failure = Box<dyn std::error::Error>;

struct Client {
    base: String,
    key: Option<String>,
    agent: ureq::Agent,
}

impl Client {
    fn call(&self, method: &str, path: &str, body: &Value) -> Result<Value, Failure> {
        let mut request = http::Request::builder().method(method).uri(format!("{}{path}", self.base));
        request = request.header("content-type", "application/json");
        if let Some(key) = &self.key {
            request = request.header("authorization", format!("Bearer {key}"));
        }
        let body = if body.is_null() { String::new() } else { body.to_string() };
        let mut answer = self.agent.run(request.body(body)?)?;
        let text = answer.body_mut().read_to_string()?;
        if !answer.status().is_success() {
            // A problem document: its type is stable, and each fault has the pointer of its field.
            return Err(format!("{method} {path}: {}: {text}", answer.status()).into());
        }
        Ok(serde_json::from_str(&text)?)
    }
}

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [base, source, target, key @ ..] = arguments.as_slice() else {
        return Err("usage: 05_client BASE SOURCE TARGET [KEY]".into());
    };
    let agent = ureq::Agent::config_builder().http_status_as_error(false).allow_non_standard_methods(true).build();
    let client = Client { base: base.clone(), key: key.first().cloned(), agent: agent.into() };
    let input = |path: &String| -> Result<Value, Failure> {
        Ok(json!({"content_base64": BASE64_STANDARD.encode(std::fs::read(path)?), "file_name": path}))
    };
    let submission = json!({"source": input(source)?, "target": input(target)?, "tags": {"example": "05"}});
    let mut job = client.call("POST", "/v1/jobs", &submission)?;
    let path = format!("/v1/jobs/{}", job["id"].as_str().ok_or("a job has an id")?);
    while ["queued", "running"].contains(&job["state"].as_str().unwrap_or_default()) {
        job = client.call("GET", &format!("{path}?wait=20"), &Value::Null)?;
    }
    println!("{}, reliable: {}, reasons: {}", job["state"], job["reliable"], job["unreliable_reasons"]);
    let result = client.call("GET", &format!("{path}/result?correspondences=false"), &Value::Null)?;
    println!("target from source: {}", result["transform"]["matrix"]);
    Ok(())
}
