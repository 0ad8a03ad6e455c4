//! Tokens of an OpenID Connect provider: accepted besides API keys, with a role and a tenant; refused for every fault.

use super::cli::homolog;
use super::jobs_support::{TestService, form, problem};
use base64::Engine as _;
use base64::prelude::BASE64_URL_SAFE_NO_PAD as BASE64;
use ring::rand::SystemRandom;
use ring::signature::{ECDSA_P256_SHA256_FIXED_SIGNING, EcdsaKeyPair, Ed25519KeyPair, KeyPair as _};
use serde_json::{Value, json};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Duration;

const ISSUER: &str = "https://idp.example.org/realms/hospital";

/// A key of the provider.
enum Key {
    Ed(Ed25519KeyPair),
    Ec(EcdsaKeyPair),
}

impl Key {
    fn ed() -> Self {
        let document = Ed25519KeyPair::generate_pkcs8(&SystemRandom::new()).unwrap();
        Key::Ed(Ed25519KeyPair::from_pkcs8(document.as_ref()).unwrap())
    }

    fn ec() -> Self {
        let random = SystemRandom::new();
        let document = EcdsaKeyPair::generate_pkcs8(&ECDSA_P256_SHA256_FIXED_SIGNING, &random).unwrap();
        Key::Ec(EcdsaKeyPair::from_pkcs8(&ECDSA_P256_SHA256_FIXED_SIGNING, document.as_ref(), &random).unwrap())
    }

    fn public(&self) -> &[u8] {
        match self {
            Key::Ed(key) => key.public_key().as_ref(),
            Key::Ec(key) => key.public_key().as_ref(),
        }
    }

    /// The entry of the key in the key set.
    fn jwk(&self, kid: &str) -> Value {
        let bytes = self.public();
        match self {
            Key::Ed(_) => {
                json!({"kty": "OKP", "crv": "Ed25519", "kid": kid, "use": "sig", "alg": "EdDSA", "x": BASE64.encode(bytes)})
            }
            Key::Ec(_) => json!({
                "kty": "EC", "crv": "P-256", "kid": kid, "use": "sig",
                "x": BASE64.encode(&bytes[1..33]), "y": BASE64.encode(&bytes[33..]),
            }),
        }
    }

    fn sign(&self, header: &Value, claims: &Value) -> String {
        let message = format!("{}.{}", BASE64.encode(header.to_string()), BASE64.encode(claims.to_string()));
        let signature = match self {
            Key::Ed(key) => key.sign(message.as_bytes()).as_ref().to_vec(),
            Key::Ec(key) => key.sign(&SystemRandom::new(), message.as_bytes()).unwrap().as_ref().to_vec(),
        };
        format!("{message}.{}", BASE64.encode(signature))
    }

    fn token(&self, kid: &str, claims: &Value) -> String {
        let alg = match self {
            Key::Ed(_) => "EdDSA",
            Key::Ec(_) => "ES256",
        };
        self.sign(&json!({"alg": alg, "typ": "JWT", "kid": kid}), claims)
    }
}

fn now() -> i64 {
    jiff::Timestamp::now().as_second()
}

/// The claims of a valid token, with changes: `null` removes one.
fn claims(changes: &Value) -> Value {
    let mut claims = json!({
        "iss": ISSUER, "aud": ["account", "homolog"], "sub": "248289761001", "exp": now() + 300,
        "iat": now(), "realm_access": {"roles": ["offline_access", "homolog-submitter"]}, "site": "clinic-a",
    });
    for (name, value) in changes.as_object().unwrap() {
        if value.is_null() {
            claims.as_object_mut().unwrap().remove(name);
        } else {
            claims[name] = value.clone();
        }
    }
    claims
}

const SETTINGS: [&str; 8] = [
    "--oidc-issuer",
    ISSUER,
    "--oidc-audience",
    "homolog",
    "--oidc-role-claim",
    "realm_access.roles",
    "--oidc-tenant-claim",
    "site",
];

async fn start(jwks: &str) -> TestService {
    TestService::start(&[&SETTINGS[..], &["--oidc-jwks", jwks, "--workers", "0"]].concat()).await
}

async fn get(service: &TestService, token: &str) -> reqwest::Response {
    service.client.get(format!("{}/v1/jobs", service.base)).bearer_auth(token).send().await.unwrap()
}

fn write(path: &Path, keys: &[Value]) {
    std::fs::write(path, json!({"keys": keys}).to_string()).unwrap();
}

#[tokio::test]
async fn tokens_are_accepted_beside_keys_with_their_role_and_tenant() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("jwks.json");
    let (ed, ec) = (Key::ed(), Key::ec());
    write(&file, &[ed.jwk("one"), ec.jwk("two"), json!({"kty": "future", "kid": "three"})]);
    let service = start(file.to_str().unwrap()).await;
    problem(service.get("/v1/jobs").await, 401, "unauthenticated").await;

    let submitter = ed.token("one", &claims(&json!({})));
    let url = format!("{}/v1/jobs", service.base);
    let sent =
        service.client.post(&url).bearer_auth(&submitter).multipart(form("a", "b", &json!({}))).send().await.unwrap();
    assert_eq!(sent.status(), 202);
    let job: Value = sent.json().await.unwrap();
    let path = format!("{url}/{}", job["id"].as_str().unwrap());
    let read = async |token: &str| service.client.get(&path).bearer_auth(token).send().await.unwrap();
    let reader = ec.token("two", &claims(&json!({"realm_access": {"roles": ["reader"]}, "sub": "other"})));
    assert_eq!(read(&reader).await.status(), 200, "another user of the tenant");
    let sent =
        service.client.post(&url).bearer_auth(&reader).multipart(form("a", "b", &json!({}))).send().await.unwrap();
    problem(sent, 403, "scope-missing").await;
    let stranger = ec.token("two", &claims(&json!({"site": "clinic-b"})));
    problem(read(&stranger).await, 404, "job-not-found").await;
    for no_role in
        [json!({"realm_access": {"roles": ["root"]}}), json!({"realm_access": null}), json!({"site": "Clinic A"})]
    {
        problem(get(&service, &ed.token("one", &claims(&no_role))).await, 403, "scope-missing").await;
    }

    // A key from the command line belongs to the same tenant.
    let mut command = homolog();
    command.args(["keys", "create", "--tenant", "clinic-a", "--data-dir"]).arg(service.folder.path());
    let done = tokio::task::spawn_blocking(move || command.output()).await.unwrap().unwrap();
    let key = String::from_utf8(done.stdout).unwrap();
    assert_eq!(read(key.trim()).await.status(), 200);

    // The audit log distinguishes users without naming them.
    let mut command = homolog();
    command.args(["audit", "export", "--data-dir"]).arg(service.folder.path());
    let done = tokio::task::spawn_blocking(move || command.output()).await.unwrap().unwrap();
    let log = String::from_utf8(done.stdout).unwrap();
    let submitted: Value =
        log.lines().map(|line| serde_json::from_str(line).unwrap()).find(|row: &Value| row["status"] == 202).unwrap();
    let id = submitted["key_id"].as_str().unwrap();
    assert!(id.starts_with("oidc:") && id.len() == 37 && submitted["tenant"] == "clinic-a", "{submitted}");
    assert!(!log.contains("248289761001"));
    service.end().await;
}

#[tokio::test]
async fn a_stream_ends_when_its_token_expires() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("jwks.json");
    let ed = Key::ed();
    write(&file, &[ed.jwk("one")]);
    let jwks = file.to_str().unwrap();
    let more = ["--oidc-jwks", jwks, "--workers", "0", "--access-interval-ms", "300"];
    let service = TestService::start(&[&SETTINGS[..], &more].concat()).await;
    let open = async |token: String| {
        let sent = service.client.get(format!("{}/v1/events", service.base)).bearer_auth(token).send().await.unwrap();
        assert_eq!(sent.status(), 200);
        sent
    };
    // Clocks may differ by 30 s.
    let mut expires = open(ed.token("one", &claims(&json!({"exp": now() - 26})))).await;
    let mut goes_on = open(ed.token("one", &claims(&json!({})))).await;
    let ends = async { while let Ok(Some(_)) = expires.chunk().await {} };
    tokio::time::timeout(Duration::from_secs(12), ends).await.expect("the stream goes on");
    let ends = async { while let Ok(Some(_)) = goes_on.chunk().await {} };
    assert!(tokio::time::timeout(Duration::from_secs(1), ends).await.is_err(), "with a valid token it goes on");
    service.end().await;
}

#[tokio::test]
async fn tokens_with_any_fault_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("jwks.json");
    let (ed, ec, other) = (Key::ed(), Key::ec(), Key::ed());
    let mut sealing = ed.jwk("sealing");
    sealing["use"] = json!("enc");
    let mut misnamed = ed.jwk("misnamed");
    misnamed["alg"] = json!("RS256");
    write(&file, &[ed.jwk("one"), ec.jwk("two"), sealing, misnamed]);
    let service = start(file.to_str().unwrap()).await;
    let fine = ed.token("one", &claims(&json!({})));
    assert_eq!(get(&service, &fine).await.status(), 200);
    for within in [json!({"exp": now() - 20}), json!({"nbf": now() + 20}), json!({"aud": "homolog"})] {
        assert_eq!(get(&service, &ed.token("one", &claims(&within))).await.status(), 200, "{within}");
    }

    let [header, payload, signature] = fine.split('.').collect::<Vec<_>>()[..] else { unreachable!() };
    let altered = BASE64.encode(claims(&json!({"site": "clinic-b"})).to_string());
    let header_with = |alg: &str| json!({"alg": alg, "kid": "one"});
    let unsigned = format!("{}.{payload}.", BASE64.encode(header_with("none").to_string()));
    // Signed with the public key as a shared secret.
    let by_public_key = {
        let message = format!("{}.{payload}", BASE64.encode(header_with("HS256").to_string()));
        let secret = ring::hmac::Key::new(ring::hmac::HMAC_SHA256, ed.public());
        format!("{message}.{}", BASE64.encode(ring::hmac::sign(&secret, message.as_bytes())))
    };
    let wrong = [
        ("expired", ed.token("one", &claims(&json!({"exp": now() - 60})))),
        ("not yet valid", ed.token("one", &claims(&json!({"nbf": now() + 60})))),
        ("no end", ed.token("one", &claims(&json!({"exp": null})))),
        ("an end that is no number", ed.token("one", &claims(&json!({"exp": "never"})))),
        ("a beginning that is no number", ed.token("one", &claims(&json!({"nbf": "later"})))),
        ("another issuer", ed.token("one", &claims(&json!({"iss": "https://idp.example.com"})))),
        ("no issuer", ed.token("one", &claims(&json!({"iss": null})))),
        ("another audience", ed.token("one", &claims(&json!({"aud": ["account"]})))),
        ("no audience", ed.token("one", &claims(&json!({"aud": null})))),
        ("no subject", ed.token("one", &claims(&json!({"sub": null})))),
        ("another key", other.token("one", &claims(&json!({})))),
        ("another key of the set", ed.sign(&json!({"alg": "EdDSA", "kid": "two"}), &claims(&json!({})))),
        ("another algorithm than its key", ec.sign(&header_with("ES256"), &claims(&json!({})))),
        ("a key that is not for signatures", ed.token("sealing", &claims(&json!({})))),
        ("a key for another algorithm", ed.token("misnamed", &claims(&json!({})))),
        ("an unknown key", ed.token("none", &claims(&json!({})))),
        ("no key named", ed.sign(&json!({"alg": "EdDSA"}), &claims(&json!({})))),
        (
            "an extension that must be understood",
            ed.sign(&json!({"alg": "EdDSA", "kid": "one", "crit": ["exp2"], "exp2": 1}), &claims(&json!({}))),
        ),
        ("unsigned", unsigned),
        ("signed with the public key", by_public_key),
        ("altered", format!("{header}.{altered}.{signature}")),
        ("cut", fine[..fine.len() - 4].to_owned()),
        ("no token", "a.b.c".to_owned()),
        ("long", format!("{header}.{}.{signature}", "A".repeat(7_000))),
    ];
    for (fault, token) in wrong {
        let refused = problem(get(&service, &token).await, 401, "unauthenticated").await;
        assert!(refused.get("detail").is_none(), "{fault}: {refused}");
    }
    assert_eq!(get(&service, &fine).await.status(), 200);
    service.end().await;
}

#[tokio::test]
async fn a_new_key_of_the_provider_is_fetched_and_unknown_keys_are_not_fetched_for_each_token() {
    let (old, new) = (Key::ed(), Key::ec());
    let set = Arc::new(std::sync::Mutex::new(json!({"keys": [old.jwk("old")]})));
    let n_fetched = Arc::new(AtomicU32::new(0));
    let provider = {
        let (set, n_fetched) = (Arc::clone(&set), Arc::clone(&n_fetched));
        axum::Router::new().route(
            "/jwks",
            axum::routing::get(move || async move {
                n_fetched.fetch_add(1, Ordering::SeqCst);
                set.lock().unwrap().to_string()
            }),
        )
    };
    let listener = tokio::net::TcpListener::bind("127.0.0.1:0").await.unwrap();
    let jwks = format!("http://{}/jwks", listener.local_addr().unwrap());
    let serving = tokio::spawn(async move { axum::serve(listener, provider).await });
    let service = start(&jwks).await;
    let tokens = [old.token("old", &claims(&json!({}))), new.token("new", &claims(&json!({})))];
    for _ in 0..20 {
        assert_eq!(get(&service, &tokens[0]).await.status(), 200);
        assert_eq!(get(&service, &tokens[1]).await.status(), 401);
    }
    assert_eq!(n_fetched.load(Ordering::SeqCst), 1);
    *set.lock().unwrap() = json!({"keys": [old.jwk("old"), new.jwk("new")]});
    tokio::time::sleep(Duration::from_millis(5_200)).await;
    assert_eq!(get(&service, &tokens[1]).await.status(), 200, "the new key");
    // The old key is withdrawn, and the provider becomes unreachable: known keys continue to work.
    serving.abort();
    let _ = serving.await;
    tokio::time::sleep(Duration::from_millis(5_200)).await;
    assert_eq!(get(&service, &new.token("third", &claims(&json!({})))).await.status(), 401);
    assert_eq!(get(&service, &tokens[1]).await.status(), 200);
    service.end().await;
}

#[tokio::test]
async fn a_provider_that_never_answered_is_reported_and_keys_work_without_it() {
    let listener = tokio::net::TcpListener::bind("127.0.0.1:0").await.unwrap();
    let jwks = format!("http://{}/jwks", listener.local_addr().unwrap());
    drop(listener);
    let service = start(&jwks).await;
    let refused = get(&service, &Key::ed().token("one", &claims(&json!({})))).await;
    assert!(refused.headers().contains_key("retry-after"));
    problem(refused, 503, "unavailable").await;
    problem(get(&service, "hml_x").await, 401, "unauthenticated").await;
    service.end().await;
}

#[test]
fn incomplete_settings_are_refused_at_the_start() {
    let folder = tempfile::tempdir().unwrap();
    let (set, data) = (folder.path().join("jwks.json"), folder.path().join("data"));
    write(&set, &[]);
    let set = set.to_str().unwrap();
    let all = ["--oidc-issuer", ISSUER, "--oidc-audience", "homolog", "--oidc-jwks"];
    for (arguments, said) in [
        (vec!["--oidc-issuer", ISSUER], "are needed together"),
        ([&all[..], &["/nonexistent.json"]].concat(), "/nonexistent.json"),
        ([&all[..], &["http://idp.example.org/jwks"]].concat(), "https://"),
        ([&all[..], &[set, "--auth", "none"]].concat(), "--auth none"),
    ] {
        let mut command = homolog();
        command.args(["serve", "--listen", "127.0.0.1:0", "--data-dir"]).arg(&data).args(&arguments);
        let done = command.output().unwrap();
        let stderr = String::from_utf8(done.stderr).unwrap();
        assert!(done.status.code() == Some(1) && stderr.contains(said), "{arguments:?}: {stderr}");
    }
}
