//! The one provider of cryptography for TLS, for whichever client asks first.

/// Makes TLS clients possible. May be called any number of times.
pub fn prepare() {
    // An error only says that it is there already.
    let _ = rustls::crypto::ring::default_provider().install_default();
}
