//! The dashboard at `/`: a static page, built into the program, that shows answers of the API.
//!
//! The page is public, because it contains no data: users enter a key, with which the page calls the API. All its
//! addresses are relative, so that it works behind a proxy that serves it under another path.

use super::conditional::{etag_of, respond};
use super::problem::Problem;
use super::problem_table::ProblemKind;
use axum::extract::Path;
use axum::http::{HeaderMap, HeaderName, HeaderValue, header};
use axum::response::Response;

/// A file of the built page.
struct PageFile {
    name: &'static str,
    bytes: &'static [u8],
}

// FILES: the files that `make dashboard` has written to dashboard/dist, listed by build.rs.
include!(concat!(env!("OUT_DIR"), "/page_files.rs"));

/// Scripts and styles come only from files of the page; nothing is loaded from or sent to another origin. Pictures that
/// the page makes for saving are `blob:`.
const POLICY: HeaderValue = HeaderValue::from_static(
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self'; \
     base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
);

/// The name of a script, style or drawing contains the hash of its content, so the file never changes.
const FOREVER: HeaderValue = HeaderValue::from_static("public, max-age=31536000, immutable");
/// The assets that the page names change with the program.
const ASK_AGAIN: HeaderValue = HeaderValue::from_static("no-cache");

/// The page.
pub(super) async fn index(headers: HeaderMap) -> Result<Response, Problem> {
    file("index.html", &headers, ASK_AGAIN)
}

/// A file that the page loads.
pub(super) async fn asset(Path(name): Path<String>, headers: HeaderMap) -> Result<Response, Problem> {
    let is_named_by_content = [".js", ".css", ".svg"].iter().any(|ending| name.ends_with(ending));
    file(&name, &headers, if is_named_by_content { FOREVER } else { ASK_AGAIN })
}

/// A synthetic label volume to try the service with.
pub(super) async fn phantom(Path(name): Path<String>, headers: HeaderMap) -> Result<Response, Problem> {
    match name.as_str() {
        "source.nii.gz" | "target.nii.gz" => file(&format!("phantom-{name}"), &headers, ASK_AGAIN),
        _ => Err(Problem::new(ProblemKind::RouteNotFound)),
    }
}

fn file(name: &str, headers: &HeaderMap, caching: HeaderValue) -> Result<Response, Problem> {
    let found = FILES.iter().find(|file| file.name == name);
    let file = found.ok_or_else(|| Problem::new(ProblemKind::RouteNotFound))?;
    let content_type = match name.rsplit_once('.').map(|(_, ending)| ending) {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("svg") => "image/svg+xml",
        Some("txt") => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    };
    let mut response = respond(headers, &etag_of(file.bytes), content_type, file.bytes);
    let fixed: [(HeaderName, HeaderValue); 4] = [
        (header::CONTENT_SECURITY_POLICY, POLICY),
        (header::CACHE_CONTROL, caching),
        (header::X_CONTENT_TYPE_OPTIONS, HeaderValue::from_static("nosniff")),
        (header::REFERRER_POLICY, HeaderValue::from_static("no-referrer")),
    ];
    for (name, value) in fixed {
        response.headers_mut().insert(name, value);
    }
    Ok(response)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(name: &str) -> &'static str {
        let file = FILES.iter().find(|file| file.name == name);
        std::str::from_utf8(file.unwrap_or_else(|| panic!("no {name}: run make dashboard")).bytes).unwrap()
    }

    #[test]
    fn the_page_names_only_files_that_are_built_in_and_nothing_from_elsewhere() {
        let page = text("index.html");
        let addresses: Vec<&str> = ["src=\"", "href=\""]
            .iter()
            .flat_map(|start| page.split(start).skip(1).filter_map(|rest| rest.split('"').next()))
            .collect();
        assert!(addresses.len() >= 2, "{page}");
        for address in addresses.iter().filter(|address| !address.starts_with('#')) {
            let name = address.strip_prefix("assets/").unwrap_or_else(|| panic!("{address} is not relative"));
            assert!(FILES.iter().any(|file| file.name == name), "{name}");
        }
        assert!(!page.contains("<style") && !page.contains("style=") && !page.contains("onload"), "nothing inline");
        assert!(!page.contains("<script>"), "nothing inline");
    }

    #[tokio::test]
    async fn assets_are_kept_forever_and_the_page_is_asked_for_again() {
        let page = index(HeaderMap::new()).await.unwrap();
        assert_eq!(page.headers()[header::CACHE_CONTROL], "no-cache");
        let policy = page.headers()[header::CONTENT_SECURITY_POLICY].to_str().unwrap();
        assert!(!policy.contains("unsafe") && policy.contains("default-src 'none'"), "{policy}");
        let script = FILES.iter().find(|file| file.name.ends_with(".js")).unwrap();
        let got = asset(Path(script.name.to_owned()), HeaderMap::new()).await.unwrap();
        let caching: Vec<_> = got.headers().get_all(header::CACHE_CONTROL).iter().collect();
        assert_eq!(caching, [&FOREVER]);
        assert!(asset(Path("../Cargo.toml".to_owned()), HeaderMap::new()).await.is_err());
        let mut known = HeaderMap::new();
        known.insert(header::IF_NONE_MATCH, page.headers()[header::ETAG].clone());
        assert_eq!(index(known).await.unwrap().status(), 304);
    }
}
