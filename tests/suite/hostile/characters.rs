//! NUL characters and long texts in every field that a client can write: answered with 4xx on both databases, never
//! with 5xx.

use crate::faults::on_both;
use crate::faults::site::{Backend, Site};
use serde_json::json;

on_both!(nul_and_long_texts_are_faults_of_the_request);

async fn nul_and_long_texts_are_faults_of_the_request(backend: Backend) {
    let site = Site::open(backend);
    let node = site.serve(&["--workers", "0"]);
    let client = site.client(&node);
    let id = client.submit(json!({})).await;
    let long = "x".repeat(8_000);
    let openapi = client.json("/openapi.json").await;
    let mut paths = Vec::new();
    for (path, operations) in openapi["paths"].as_object().unwrap() {
        for (method, operation) in operations.as_object().unwrap() {
            for text in ["%00", "a%00b", &long, "%0a"] {
                if path.contains('{') {
                    let mut filled = path.clone();
                    while let (Some(from), Some(to)) = (filled.find('{'), filled.find('}')) {
                        filled.replace_range(from..=to, text);
                    }
                    paths.push((method.clone(), filled));
                }
                for parameter in operation["parameters"].as_array().into_iter().flatten() {
                    if parameter["in"] == "query" {
                        let name = parameter["name"].as_str().unwrap();
                        let filled = path.replace("{id}", &id).replace("{which}", "source");
                        paths.push((method.clone(), format!("{filled}?{name}={text}")));
                        paths.push((method.clone(), format!("{filled}?{name}=k:{text}&{text}=1")));
                    }
                }
            }
        }
    }
    assert!(paths.len() > 300, "only {}", paths.len());
    for (method, path) in paths {
        let method = reqwest::Method::from_bytes(method.to_uppercase().as_bytes()).unwrap();
        let answer =
            client.http.request(method.clone(), format!("{}{path}", node.base)).body("x").send().await.unwrap();
        let status = answer.status().as_u16();
        assert!(status < 500, "{method} {}: {status}", path.chars().take(120).collect::<String>());
    }
    for url in ["https://example.org/\0", "https://example.org/\n", &format!("https://example.org/{long}")] {
        let answer = client.http.post(format!("{}/v1/webhooks", node.base)).json(&json!({"url": url})).send().await;
        assert_eq!(answer.unwrap().status(), 422);
    }
    for name in ["a\0b.ply", &format!("{long}.ply")] {
        let part = reqwest::multipart::Part::bytes(b"mesh".to_vec()).file_name(name.to_owned());
        let form = reqwest::multipart::Form::new().part("file", part);
        let answer = client.http.post(format!("{}/v1/meshes", node.base)).multipart(form).send().await.unwrap();
        assert!(answer.status().as_u16() < 500, "{}", answer.status());
    }
}
