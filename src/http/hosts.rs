//! The hosts that requests may name, against DNS rebinding.
//!
//! Without authentication, everybody who can connect may do everything, including a web page in a browser that can
//! connect, under a host name that resolves to the address of the service (DNS rebinding). The browser sends that name
//! in `Host` and the origin of the page in `Origin`. Both must therefore name this machine, or a name that the operator
//! allows.
//!
//! This applies to every address, because inside a container the service listens on all of them.

use super::cors::CorsOrigins;
use axum::http::uri::Authority;
use axum::http::{HeaderMap, Uri, header};
use std::net::IpAddr;

/// Host names that are allowed besides `localhost` and the loopback addresses.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct AllowedHosts {
    names: Vec<String>,
}

impl AllowedHosts {
    /// Allows these names, without port; case does not matter.
    pub fn new(names: impl IntoIterator<Item = String>) -> Self {
        AllowedHosts { names: names.into_iter().map(|name| canonical(&name)).collect() }
    }

    /// Whether `Host` names an allowed host. `Origin`, if present, must also name one, unless the operator lists it.
    pub(super) fn allow(&self, uri: &Uri, headers: &HeaderMap, origins: &CorsOrigins) -> bool {
        let mut hosts = headers.get_all(header::HOST).iter().peekable();
        // No current client omits the host.
        let names_a_host = uri.authority().is_some() || hosts.peek().is_some();
        let authority = |text: &str| text.parse::<Authority>().is_ok_and(|authority| self.has(&authority));
        names_a_host
            && uri.authority().is_none_or(|authority| self.has(authority))
            && hosts.all(|value| value.to_str().is_ok_and(authority))
            && (origins.allow(headers)
                || headers.get_all(header::ORIGIN).iter().all(|value| {
                    // `null`, the origin of sandboxed pages, has no host.
                    value.to_str().ok().and_then(|o| o.split_once("://")).is_some_and(|(_, host)| authority(host))
                }))
    }

    fn has(&self, authority: &Authority) -> bool {
        let name = canonical(authority.host());
        let address: Option<IpAddr> = name.parse().ok();
        name == "localhost" || address.is_some_and(|ip| ip.to_canonical().is_loopback()) || self.names.contains(&name)
    }
}

/// The name in lower case, without the brackets of an address and the final dot of a name.
fn canonical(name: &str) -> String {
    let name = name.trim();
    let bare = name.strip_prefix('[').and_then(|n| n.strip_suffix(']')).unwrap_or(name);
    bare.strip_suffix('.').unwrap_or(bare).to_ascii_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::http::HeaderValue;

    fn allows(uri: &str, host: &[&'static str], origin: Option<&'static str>) -> bool {
        let mut headers = HeaderMap::new();
        host.iter().for_each(|h| {
            headers.append(header::HOST, HeaderValue::from_static(h));
        });
        if let Some(origin) = origin {
            headers.insert(header::ORIGIN, HeaderValue::from_static(origin));
        }
        AllowedHosts::new(["Imaging.Example.".to_owned()]).allow(
            &uri.parse().unwrap(),
            &headers,
            &CorsOrigins::default(),
        )
    }

    #[test]
    fn names_of_this_machine_are_allowed_with_any_port() {
        for host in [
            "localhost",
            "LOCALHOST:8080",
            "localhost.",
            "127.0.0.1",
            "127.0.0.1:1",
            "127.8.9.10:80",
            "[::1]",
            "[::1]:8080",
            "[::ffff:127.0.0.1]:80",
            "imaging.example",
            "imaging.example:443",
        ] {
            assert!(allows("/v1/jobs", &[host], None), "{host}");
            let origin: &'static str = Box::leak(format!("http://{host}").into_boxed_str());
            assert!(allows("/v1/jobs", &["localhost"], Some(origin)), "{origin}");
        }
    }

    #[test]
    fn other_names_are_refused() {
        for host in [
            "evil.example",
            "evil.example:8080",
            "localhost.evil.example",
            "127.0.0.1.evil.example",
            "128.0.0.1",
            "0.0.0.0",
            "[::2]",
            "10.0.0.1",
            "",
            "localhost@evil.example",
            "x imaging.example",
            "notimaging.example",
        ] {
            assert!(!allows("/v1/jobs", &[host], None), "{host}");
            let origin: &'static str = Box::leak(format!("https://{host}").into_boxed_str());
            assert!(!allows("/v1/jobs", &["localhost"], Some(origin)), "{origin}");
        }
        assert!(!allows("/", &["localhost"], Some("null")));
        assert!(!allows("/", &["localhost", "evil.example"], None), "one of two");
        assert!(!allows("http://evil.example/", &["localhost"], None), "the absolute form goes before Host");
        assert!(!allows("/", &[], None));
    }
}
