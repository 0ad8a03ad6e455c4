//! The provider of cryptography for all TLS clients of the process.

/// Installs the provider, before the first TLS client is created. May be called any number of times.
pub fn prepare() {
    // An error means that it is installed already.
    let _ = rustls::crypto::ring::default_provider().install_default();
}
