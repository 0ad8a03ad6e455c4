//! The addresses to which webhooks may be sent: public ones, unless the operator allows private ones.
//!
//! A user who can register a URL must not be able to make a service inside a hospital send requests to its neighbors. So
//! every address to which a host name resolves is checked, at every delivery, and redirects are not followed.

use std::net::{IpAddr, Ipv4Addr, Ipv6Addr};
use url::{Host, Url};

const MAX_URL_BYTES: usize = 2_000;

/// Checks a URL without resolving its host name: form, scheme, and a literal address.
///
/// # Errors
/// The fault of the URL, or the form that is needed.
pub fn check_url(text: &str, allow_private: bool) -> Result<Url, &'static str> {
    if text.len() > MAX_URL_BYTES {
        return Err("at most 2000 bytes");
    }
    if text.chars().any(|c| c.is_control() || c.is_whitespace()) {
        return Err("no white space and no control characters");
    }
    let url = Url::parse(text).map_err(|_| "an absolute URL is needed here, as https://example.org/hook")?;
    if !matches!(url.scheme(), "https" | "http") {
        return Err("https (or http) is needed here");
    }
    if !url.username().is_empty() || url.password().is_some() {
        return Err("no user name and no password in the URL: deliveries are signed");
    }
    let is_allowed = match url.host() {
        None => return Err("a host is needed here"),
        Some(Host::Ipv4(address)) => is_public(address.into()),
        Some(Host::Ipv6(address)) => is_public(address.into()),
        Some(Host::Domain(name)) => {
            let name = name.trim_end_matches('.').to_ascii_lowercase();
            name != "localhost" && !name.ends_with(".localhost")
        }
    };
    if is_allowed || allow_private { Ok(url) } else { Err(NOT_PUBLIC) }
}

/// Why an address is refused, and who can allow it.
pub const NOT_PUBLIC: &str = "a public address is needed here; for receivers on a private network the operator starts the service \
                              with --allow-private-webhooks (HOMOLOG_ALLOW_PRIVATE_WEBHOOKS=true)";

/// Whether an address belongs to the public internet.
pub fn is_public(address: IpAddr) -> bool {
    match address {
        IpAddr::V4(address) => is_public_v4(address),
        IpAddr::V6(address) => is_public_v6(address),
    }
}

/// After the IANA registry of special-purpose addresses.
fn is_public_v4(address: Ipv4Addr) -> bool {
    let [a, b, c, _] = address.octets();
    let special = address.is_private()
        || address.is_loopback()
        || address.is_link_local()
        || address.is_documentation()
        || address.is_multicast()
        || a == 0
        || a >= 240
        || (a == 100 && (64..128).contains(&b))
        || (a == 192 && b == 0 && c == 0)
        || (a == 198 && (b == 18 || b == 19));
    !special
}

fn is_public_v6(address: Ipv6Addr) -> bool {
    let segments = address.segments();
    let embedded = |high: u16, low: u16| {
        let ([a, b], [c, d]) = (high.to_be_bytes(), low.to_be_bytes());
        is_public_v4(Ipv4Addr::new(a, b, c, d))
    };
    match segments {
        [0, 0, 0, 0, 0, 0xffff, high, low] | [0x64, 0xff9b, 0, 0, 0, 0, high, low] => embedded(high, low),
        [0x2002, high, low, ..] => embedded(high, low),
        // Global unicast is 2000::/3; of it 2001:db8::/32 is for documentation and 2001::/23 for protocols.
        [first, second, ..] => {
            (0x2000..0x4000).contains(&first) && !(first == 0x2001 && (second == 0xdb8 || second < 0x200))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn private_addresses_are_recognized_in_every_notation() {
        for address in [
            "127.0.0.1",
            "10.1.2.3",
            "172.16.0.1",
            "192.168.1.1",
            "169.254.169.254",
            "100.64.0.1",
            "0.0.0.0",
            "224.0.0.1",
            "255.255.255.255",
            "198.18.0.1",
            "::1",
            "::",
            "fe80::1",
            "fc00::1",
            "fd12::1",
            "ff02::1",
            "::ffff:127.0.0.1",
            "::ffff:10.0.0.1",
            "64:ff9b::7f00:1",
            "2002:7f00:1::",
            "2001:db8::1",
            "2001::1",
        ] {
            assert!(!is_public(address.parse().unwrap()), "{address}");
        }
        for address in ["8.8.8.8", "93.184.216.34", "2606:4700:4700::1111", "::ffff:8.8.8.8"] {
            assert!(is_public(address.parse().unwrap()), "{address}");
        }
    }

    #[test]
    fn urls_are_checked() {
        for wrong in [
            "",
            "example.org",
            "ftp://example.org",
            "file:///etc/passwd",
            "https://user:pw@example.org/",
            "https://",
            "https://example.org/\0",
            "https://exam\tple.org/",
            " https://example.org/",
            "http://127.0.0.1/",
            "http://0x7f000001/",
            "http://2130706433/",
            "http://[::1]:80/",
            "http://localhost/",
            "http://a.localhost./",
        ] {
            assert!(check_url(wrong, false).is_err(), "{wrong}");
        }
        assert!(check_url("https://example.org/hook?x=1", false).is_ok());
        assert!(check_url("http://127.0.0.1:9/", true).is_ok());
    }
}
