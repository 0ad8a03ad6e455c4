//! TLS: the one cryptography provider of the process, and the listener's certificates from files, which are read again
//! when they change.

use parking_lot::Mutex;
use rustls::pki_types::pem::PemObject as _;
use rustls::pki_types::{CertificateDer, PrivateKeyDer};
use rustls::server::WebPkiClientVerifier;
use rustls::{RootCertStore, ServerConfig};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// How often the files are read again.
const BETWEEN_READS: Duration = Duration::from_secs(2);

/// Installs the provider. Must be called before the first TLS client is created; may be called any number of times.
pub fn prepare() {
    // An error means that the provider is already installed.
    let _ = rustls::crypto::ring::default_provider().install_default();
}

/// The files of the listener's certificates, in PEM.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TlsFiles {
    /// The certificate of the service and intermediate certificates.
    pub certificates: PathBuf,
    /// The private key of the certificate.
    pub key: PathBuf,
    /// Authorities, one of which must have signed a client's certificate; `None`: clients need no certificate.
    pub client_authorities: Option<PathBuf>,
}

/// The contents of the files when they were last read.
struct Read {
    content: Vec<Vec<u8>>,
    config: Arc<ServerConfig>,
}

/// The TLS of a listener.
pub struct ServerTls {
    files: TlsFiles,
    current: Mutex<Read>,
}

impl ServerTls {
    /// Opens the certificates in these files.
    ///
    /// # Errors
    /// Which file cannot be used, and why.
    pub fn open(files: TlsFiles) -> Result<Arc<Self>, String> {
        let content = content(&files)?;
        let config = config(&files, &content)?;
        Ok(Arc::new(ServerTls { files, current: Mutex::new(Read { content, config }) }))
    }

    /// The configuration for the next connection.
    pub fn config(&self) -> Arc<ServerConfig> {
        Arc::clone(&self.current.lock().config)
    }

    /// Reads the files again. Returns whether they have changed; open connections keep their certificates.
    ///
    /// # Errors
    /// As for [`ServerTls::open`]; the earlier certificates then stay.
    pub fn reload(&self) -> Result<bool, String> {
        let content = content(&self.files)?;
        if content == self.current.lock().content {
            return Ok(false);
        }
        let config = config(&self.files, &content)?;
        *self.current.lock() = Read { content, config };
        Ok(true)
    }

    /// Reads the files again whenever they change, and at SIGHUP; never returns.
    pub async fn follow(self: Arc<Self>) {
        let (mut last_fault, mut occasion) = (None, Occasion::new());
        loop {
            occasion.next().await;
            let tls = Arc::clone(&self);
            let reloaded = tokio::task::spawn_blocking(move || tls.reload()).await;
            let fault = match reloaded {
                Ok(Ok(true)) => {
                    tracing::info!("new certificates are used for new connections");
                    None
                }
                Ok(Ok(false)) => None,
                Ok(Err(fault)) => Some(fault),
                Err(error) => Some(error.to_string()),
            };
            // Logged once for each fault: half-written files are read again soon.
            if let Some(error) = fault.as_ref().filter(|_| fault != last_fault) {
                tracing::warn!(error, "the certificates cannot be read again; the earlier ones are used");
            }
            last_fault = fault;
        }
    }
}

/// The next occasion to read the files: after some time, or at SIGHUP, including a signal that arrived during a read.
struct Occasion {
    #[cfg(unix)]
    hangup: Option<tokio::signal::unix::Signal>,
}

impl Occasion {
    fn new() -> Self {
        Occasion {
            #[cfg(unix)]
            hangup: tokio::signal::unix::signal(tokio::signal::unix::SignalKind::hangup()).ok(),
        }
    }

    async fn next(&mut self) {
        let hung_up = async {
            #[cfg(unix)]
            if let Some(hangup) = &mut self.hangup
                && hangup.recv().await.is_some()
            {
                return;
            }
            std::future::pending().await
        };
        let _ = tokio::time::timeout(BETWEEN_READS, hung_up).await;
    }
}

fn content(files: &TlsFiles) -> Result<Vec<Vec<u8>>, String> {
    let paths = [Some(&files.certificates), Some(&files.key), files.client_authorities.as_ref()];
    let read = |path: &PathBuf| std::fs::read(path).map_err(|error| format!("{}: {error}", path.display()));
    paths.into_iter().flatten().map(read).collect()
}

fn certificates(path: &Path, text: &[u8]) -> Result<Vec<CertificateDer<'static>>, String> {
    let found: Result<Vec<_>, _> = CertificateDer::pem_slice_iter(text).collect();
    match found {
        Ok(found) if !found.is_empty() => Ok(found),
        Ok(_) => Err(format!("{}: there is no certificate in PEM", path.display())),
        Err(error) => Err(format!("{}: {error}", path.display())),
    }
}

fn config(files: &TlsFiles, content: &[Vec<u8>]) -> Result<Arc<ServerConfig>, String> {
    let [chain, key, rest @ ..] = content else { return Err("files are missing".to_owned()) };
    let chain = certificates(&files.certificates, chain)?;
    let in_key = |error: &dyn std::fmt::Display| format!("{}: {error}", files.key.display());
    let key = PrivateKeyDer::from_pem_slice(key).map_err(|error| in_key(&error))?;
    let provider = Arc::new(rustls::crypto::ring::default_provider());
    let builder = ServerConfig::builder_with_provider(Arc::clone(&provider))
        .with_safe_default_protocol_versions()
        .map_err(|error| error.to_string())?;
    let builder = match (&files.client_authorities, rest) {
        (Some(path), [authorities]) => {
            let mut roots = RootCertStore::empty();
            for certificate in certificates(path, authorities)? {
                roots.add(certificate).map_err(|error| format!("{}: {error}", path.display()))?;
            }
            let verifier = WebPkiClientVerifier::builder_with_provider(Arc::new(roots), provider).build();
            builder.with_client_cert_verifier(verifier.map_err(|error| format!("{}: {error}", path.display()))?)
        }
        _ => builder.with_no_client_auth(),
    };
    let mut config = builder.with_single_cert(chain, key).map_err(|error| in_key(&error))?;
    config.alpn_protocols = vec![b"http/1.1".to_vec()];
    Ok(Arc::new(config))
}
