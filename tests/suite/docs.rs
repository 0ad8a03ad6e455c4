//! The page at `/docs` and everything it loads come from the service itself.

use super::jobs_support::{TestService, problem};

/// Values of `src` and `href` in a page.
fn references(page: &str) -> Vec<String> {
    let begins = ["src=\"", "href=\""].into_iter().flat_map(|name| page.match_indices(name));
    begins.map(|(at, name)| page[at + name.len()..].split('"').next().unwrap().to_owned()).collect()
}

#[tokio::test]
async fn the_page_and_its_files_come_from_the_service() {
    let service = TestService::start(&["--workers", "0"]).await;
    let client = reqwest::Client::builder().redirect(reqwest::redirect::Policy::none()).build().unwrap();
    let redirect = client.get(format!("{}/docs", service.base)).send().await.unwrap();
    assert_eq!((redirect.status().as_u16(), &redirect.headers()["location"]), (308, &"/docs/".parse().unwrap()));
    let page = service.get("/docs").await;
    assert_eq!(page.headers()["content-type"], "text/html; charset=utf-8");
    let policy = page.headers()["content-security-policy"].to_str().unwrap().to_owned();
    assert!(policy.starts_with("default-src 'none'") && !policy.contains("http"), "{policy}");
    let page = page.text().await.unwrap();
    assert!(!page.contains("<script>"), "the policy allows no script within the page");
    let references = references(&page);
    assert!(references.len() >= 5, "{references:?}");
    for reference in references {
        assert!(!reference.contains("//") && !reference.starts_with("data:"), "{reference} leads elsewhere");
        let file = service.get(&format!("/docs/{reference}")).await;
        assert_eq!(file.status(), 200, "{reference}");
        let media_type = file.headers()["content-type"].to_str().unwrap().to_owned();
        let expected = [("css", "text/css"), ("js", "text/javascript"), ("png", "image/png")];
        let ending = reference.rsplit('.').next().unwrap();
        assert!(expected.iter().any(|(e, t)| *e == ending && media_type.starts_with(t)), "{reference}: {media_type}");
        assert!(!file.bytes().await.unwrap().is_empty());
    }
    let start = service.get("/docs/swagger-initializer.js").await.text().await.unwrap();
    assert!(start.contains("/openapi.json") && !start.contains("http:") && !start.contains("https:"), "{start}");
    let style = service.get("/docs/swagger-ui.css").await.text().await.unwrap();
    assert!(!style.contains("@import") && !style.contains("url(http") && !style.contains("url(//"));
    problem(service.get("/docs/nothing.js").await, 404, "route-not-found").await;
    problem(service.get("/docs/../Cargo.toml").await, 404, "route-not-found").await;
    problem(service.get("/docs/%2e%2e/Cargo.toml").await, 404, "route-not-found").await;
    service.end().await;
}
