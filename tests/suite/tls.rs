//! TLS of the listener: certificates from files, replaced while connections are open, and certificates of clients.

use super::jobs_support::TestService;
use crate::patience::PATIENCE;
use rcgen::{BasicConstraints, CertificateParams, CertifiedIssuer, IsCa, KeyPair};
use reqwest::{Certificate, Client, Identity};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use tokio::io::AsyncReadExt as _;

struct Authority(CertifiedIssuer<'static, KeyPair>);

impl Authority {
    fn new() -> Self {
        let mut params = CertificateParams::new(Vec::new()).unwrap();
        params.is_ca = IsCa::Ca(BasicConstraints::Unconstrained);
        Authority(CertifiedIssuer::self_signed(params, KeyPair::generate().unwrap()).unwrap())
    }

    /// A certificate for a name and its key, in PEM.
    fn sign(&self, name: &str) -> (String, String) {
        let key = KeyPair::generate().unwrap();
        let certificate = CertificateParams::new(vec![name.to_owned()]).unwrap().signed_by(&key, &self.0).unwrap();
        (certificate.pem(), key.serialize_pem())
    }

    fn root(&self) -> Certificate {
        Certificate::from_pem(self.0.pem().as_bytes()).unwrap()
    }

    /// A client that trusts this authority only.
    fn client(&self, identity: Option<(String, String)>) -> Client {
        homolog::tls::prepare();
        let builder = Client::builder().no_proxy().tls_certs_only([self.root()]).timeout(Duration::from_secs(10));
        match identity {
            None => builder.build().unwrap(),
            Some((certificate, key)) => {
                builder.identity(Identity::from_pem((certificate + &key).as_bytes()).unwrap()).build().unwrap()
            }
        }
    }
}

struct Files {
    folder: tempfile::TempDir,
}

impl Files {
    fn new() -> Self {
        Files { folder: tempfile::tempdir().unwrap() }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn put(&self, (certificate, key): (String, String)) {
        fs::write(self.path("key.pem"), key).unwrap();
        fs::write(self.path("cert.pem"), certificate).unwrap();
    }

    async fn start(&self, more: &[&str]) -> TestService {
        let text = |path: &Path| path.to_str().unwrap().to_owned();
        let (certificate, key) = (text(&self.path("cert.pem")), text(&self.path("key.pem")));
        let arguments = [&["--workers", "0", "--tls-cert", &certificate, "--tls-key", &key][..], more].concat();
        TestService::start(&arguments).await
    }
}

fn url(service: &TestService, path: &str) -> String {
    format!("{}{path}", service.base.replace("http://127.0.0.1", "https://localhost"))
}

#[tokio::test]
async fn certificates_are_replaced_without_dropping_connections() {
    let (files, first, second) = (Files::new(), Authority::new(), Authority::new());
    files.put(first.sign("localhost"));
    let service = files.start(&["--header-timeout-s", "2"]).await;
    let open = first.client(None);
    let job = service_job(&open, &service).await;
    let mut events = open.get(url(&service, &format!("/v1/jobs/{job}/events"))).send().await.unwrap();
    assert_eq!(events.status(), 200);
    assert!(events.chunk().await.unwrap().is_some());
    // Neither a client without TLS nor one with another authority is served.
    assert!(service.client.get(format!("{}/healthz", service.base)).send().await.is_err());
    assert!(second.client(None).get(url(&service, "/healthz")).send().await.is_err());

    // Half of a renewal, then invalid content: the earlier certificate stays in use.
    fs::write(files.path("cert.pem"), second.sign("localhost").0).unwrap();
    tokio::time::sleep(Duration::from_secs(3)).await;
    fs::write(files.path("cert.pem"), "no certificate").unwrap();
    tokio::time::sleep(Duration::from_secs(3)).await;
    assert_eq!(first.client(None).get(url(&service, "/healthz")).send().await.unwrap().status(), 200);
    files.put(second.sign("localhost"));
    let began = Instant::now();
    while second.client(None).get(url(&service, "/healthz")).send().await.is_err() {
        assert!(began.elapsed() < PATIENCE, "the new certificate is not used");
        tokio::time::sleep(Duration::from_millis(200)).await;
    }
    assert!(first.client(None).get(url(&service, "/healthz")).send().await.is_err());
    // The open stream continues to its end.
    let cancelled = second.client(None).post(url(&service, &format!("/v1/jobs/{job}/cancel"))).send().await.unwrap();
    assert!(cancelled.status().is_success());
    assert!(events.text().await.unwrap().contains("event: done"));

    // A client that begins no handshake is disconnected.
    let address = service.base.trim_start_matches("http://").to_owned();
    let mut silent = tokio::net::TcpStream::connect(address).await.unwrap();
    let closed = tokio::time::timeout(PATIENCE, silent.read(&mut [0; 16])).await;
    assert!(matches!(closed, Ok(Ok(0) | Err(_))), "a silent client holds its connection");
    service.end().await;
}

#[tokio::test]
async fn certificates_are_read_again_at_sighup() {
    let (files, mut authority) = (Files::new(), Authority::new());
    files.put(authority.sign("localhost"));
    let service = files.start(&[]).await;
    assert_eq!(authority.client(None).get(url(&service, "/healthz")).send().await.unwrap().status(), 200);
    let mut fastest = Duration::MAX;
    // Files are also checked every 2 s, so without the signal each round after the first would take that long.
    for round in 0..6 {
        authority = Authority::new();
        files.put(authority.sign("localhost"));
        let began = Instant::now();
        let process = std::process::id().to_string();
        assert!(std::process::Command::new("kill").args(["-HUP", &process]).status().unwrap().success());
        while authority.client(None).get(url(&service, "/healthz")).send().await.is_err() {
            assert!(began.elapsed() < PATIENCE, "the new certificate is not used");
            tokio::time::sleep(Duration::from_millis(20)).await;
        }
        if round > 0 {
            fastest = fastest.min(began.elapsed());
        }
    }
    assert!(fastest < Duration::from_secs(1), "each round takes half of the interval of the checks: {fastest:?}");
    service.end().await;
}

async fn service_job(client: &Client, service: &TestService) -> String {
    let form = super::jobs_support::form("a", "b", &serde_json::json!({}));
    let sent = client.post(url(service, "/v1/jobs")).multipart(form).send().await.unwrap();
    sent.json::<serde_json::Value>().await.unwrap()["id"].as_str().unwrap().to_owned()
}

#[tokio::test]
async fn clients_need_a_certificate_of_the_authority_if_one_is_given() {
    let (files, site, clients) = (Files::new(), Authority::new(), Authority::new());
    files.put(site.sign("localhost"));
    fs::write(files.path("clients.pem"), clients.0.pem()).unwrap();
    let authorities = files.path("clients.pem").to_str().unwrap().to_owned();
    let service = files.start(&["--tls-client-ca", &authorities, "--auth", "keys"]).await;
    let ask =
        async |client: Client| Ok::<_, reqwest::Error>(client.get(url(&service, "/v1/jobs")).send().await?.status());
    assert!(ask(site.client(None)).await.is_err(), "without a certificate");
    assert!(ask(site.client(Some(site.sign("worker")))).await.is_err(), "with one of another authority");
    let status = ask(site.client(Some(clients.sign("worker")))).await.unwrap();
    assert_eq!(status, 401, "a certificate replaces no API key");
    service.end().await;
}

#[test]
fn incomplete_or_wrong_certificates_are_refused_at_the_start() {
    let files = Files::new();
    let (authority, data) = (Authority::new(), files.path("data"));
    files.put(authority.sign("localhost"));
    let serve = |arguments: &[&str]| {
        let mut command = super::cli::homolog();
        command.args(["serve", "--listen", "127.0.0.1:0", "--data-dir"]).arg(&data).args(arguments);
        let done = command.output().unwrap();
        assert!(!done.status.success());
        String::from_utf8(done.stderr).unwrap()
    };
    let (cert, key) = (files.path("cert.pem"), files.path("key.pem"));
    let (cert, key) = (cert.to_str().unwrap(), key.to_str().unwrap());
    assert!(serve(&["--tls-cert", cert]).contains("needed together"));
    assert!(serve(&["--tls-client-ca", cert]).contains("needed together"));
    assert!(serve(&["--tls-cert", cert, "--tls-key", "/no/such/file"]).contains("/no/such/file"));
    assert!(serve(&["--tls-cert", key, "--tls-key", key]).contains("no certificate"));
    fs::write(files.path("key.pem"), authority.sign("localhost").1).unwrap();
    assert!(serve(&["--tls-cert", cert, "--tls-key", key]).contains("key.pem"), "a key of another certificate");
}
