//! Secrets at rest: sealed with a key that is not in the database, so that a copy of the database alone reveals none.
//!
//! Authenticated encryption: AES-256 in Galois/counter mode with a random nonce (NIST SP 800-38D), by ring. The
//! identity of the secret's owner is authenticated too, so that a secret cannot be moved to another record.

use super::keyring::{Keyring, sealed_with};
use super::private_files;
use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use ring::aead::{AES_256_GCM, Aad, LessSafeKey, NONCE_LEN, Nonce, UnboundKey};
use ring::rand::{SecureRandom as _, SystemRandom};
use std::fmt;
use std::io::{self, Write as _};
use std::path::Path;
use std::sync::Arc;

/// Prefix of a secret sealed with the key of secrets. Unsealed secrets have no prefix.
const SEALED: &str = "sealed:1:";
/// Prefix of a secret sealed with a key of the keyring.
const BY_KEYRING: &str = "sealed:2:";
/// Length of a key, bytes.
const KEY_BYTES: usize = 32;

/// Seals secrets and opens them again.
pub struct Seal {
    key: Option<LessSafeKey>,
    keyring: Option<Arc<Keyring>>,
    random: SystemRandom,
}

impl fmt::Debug for Seal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Seal")
    }
}

fn invalid(what: &'static str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, what)
}

impl Seal {
    /// Reads the key from this file: 64 hexadecimal digits.
    ///
    /// # Errors
    /// If the file cannot be read, or holds no key.
    pub fn read(path: &Path) -> io::Result<Self> {
        let text = std::fs::read_to_string(path)?;
        let key = blake3::Hash::from_hex(text.trim()).map_err(|_| invalid("64 hexadecimal digits are needed in it"))?;
        Seal::new(key.as_bytes())
    }

    /// As [`Seal::read`], but creates a missing file with a random key.
    ///
    /// # Errors
    /// If the file can neither be read nor created.
    pub fn read_or_create(path: &Path) -> io::Result<Self> {
        if !path.exists() {
            let mut key = [0; KEY_BYTES];
            SystemRandom::new().fill(&mut key).map_err(|_| io::Error::other("no random numbers"))?;
            // Written under a temporary name: another process must neither read half of it nor replace it.
            let draft = path.with_extension(uuid::Uuid::new_v4().to_string());
            let mut file = private_files::create_new(&draft)?;
            writeln!(file, "{}", blake3::Hash::from_bytes(key).to_hex())?;
            file.sync_all()?;
            let linked = std::fs::hard_link(&draft, path);
            std::fs::remove_file(&draft)?;
            match linked {
                Err(error) if error.kind() != io::ErrorKind::AlreadyExists => return Err(error),
                _ => {}
            }
        }
        Seal::read(path)
    }

    fn new(key: &[u8; KEY_BYTES]) -> io::Result<Self> {
        let key = UnboundKey::new(&AES_256_GCM, key).map_err(|_| invalid("no key"))?;
        Ok(Seal { key: Some(LessSafeKey::new(key)), keyring: None, random: SystemRandom::new() })
    }

    /// Seals with the keys of a keyring; also opens secrets that were sealed with the key of `earlier`.
    #[must_use]
    pub fn with_keyring(keyring: Arc<Keyring>, earlier: Option<Seal>) -> Self {
        let key = earlier.and_then(|earlier| earlier.key);
        Seal { key, keyring: Some(keyring), random: SystemRandom::new() }
    }

    /// Whether a stored secret is sealed with the current key.
    pub(super) fn is_current(&self, stored: &str) -> bool {
        let Some(keyring) = &self.keyring else { return stored.starts_with(SEALED) };
        let sealed = stored.strip_prefix(BY_KEYRING).and_then(|text| BASE64_STANDARD.decode(text).ok());
        sealed.is_some_and(|sealed| sealed_with(&sealed) == keyring.current())
    }

    /// The sealed form of a secret of `owner`; `None` if the system provides no random numbers.
    pub(super) fn seal(&self, owner: &str, secret: &str) -> Option<String> {
        if let Some(keyring) = &self.keyring {
            let sealed = keyring.seal(&identity(owner), secret.as_bytes())?;
            return Some(format!("{BY_KEYRING}{}", BASE64_STANDARD.encode(sealed)));
        }
        let mut nonce = [0; NONCE_LEN];
        self.random.fill(&mut nonce).ok()?;
        let mut text = secret.as_bytes().to_vec();
        let aad = Aad::from(owner.as_bytes());
        self.key.as_ref()?.seal_in_place_append_tag(Nonce::assume_unique_for_key(nonce), aad, &mut text).ok()?;
        Some(format!("{SEALED}{}", BASE64_STANDARD.encode([&nonce[..], &text].concat())))
    }

    /// The secret of `owner` in its sealed form; `None` if it was sealed with another key or for another owner.
    fn open(&self, owner: &str, sealed: &str) -> Option<String> {
        if let Some(text) = sealed.strip_prefix(BY_KEYRING) {
            let sealed = BASE64_STANDARD.decode(text).ok()?;
            return String::from_utf8(self.keyring.as_ref()?.open(&identity(owner), &sealed).ok()?).ok();
        }
        let bytes = BASE64_STANDARD.decode(sealed.strip_prefix(SEALED)?).ok()?;
        let (nonce, text) = bytes.split_at_checked(NONCE_LEN)?;
        let nonce = Nonce::try_assume_unique_for_key(nonce).ok()?;
        let mut text = text.to_vec();
        let opened = self.key.as_ref()?.open_in_place(nonce, Aad::from(owner.as_bytes()), &mut text).ok()?;
        String::from_utf8(opened.to_vec()).ok()
    }
}

/// The identity to which a secret is bound under a key that also seals other things.
fn identity(owner: &str) -> Vec<u8> {
    format!("secret\n{owner}").into_bytes()
}

/// Whether a stored secret is sealed.
fn is_sealed(stored: &str) -> bool {
    stored.starts_with(SEALED) || stored.starts_with(BY_KEYRING)
}

/// The secret of `owner` in its stored form, sealed or not; `None` if it cannot be opened.
pub(super) fn opened(seal: Option<&Seal>, owner: &str, stored: &str) -> Option<String> {
    if is_sealed(stored) { seal?.open(owner, stored) } else { Some(stored.to_owned()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn secrets_are_opened_with_their_key_for_their_owner_only() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("seal.key");
        let seal = Seal::read_or_create(&path).unwrap();
        let sealed = seal.seal("webhook-1", "whsec_AAAA").unwrap();
        assert!(is_sealed(&sealed) && !sealed.contains("AAAA"));
        assert_ne!(sealed, seal.seal("webhook-1", "whsec_AAAA").unwrap(), "each with a nonce of its own");
        let again = Seal::read_or_create(&path).unwrap();
        assert_eq!(opened(Some(&again), "webhook-1", &sealed).as_deref(), Some("whsec_AAAA"));
        assert_eq!(opened(Some(&again), "webhook-2", &sealed), None);
        assert_eq!(opened(None, "webhook-1", &sealed), None);
        let other = Seal::read_or_create(&folder.path().join("other.key")).unwrap();
        assert_eq!(opened(Some(&other), "webhook-1", &sealed), None);
        assert_eq!(opened(None, "webhook-1", "whsec_AAAA").as_deref(), Some("whsec_AAAA"), "stored before");

        let [old, new] = ["1", "2"].map(|digit| digit.repeat(64));
        let ring = |keys: &[&str]| Arc::new(Keyring::parse(&keys.join("\n")).unwrap());
        let by_ring = Seal::with_keyring(ring(&[&new, &old]), Some(again));
        assert_eq!(opened(Some(&by_ring), "webhook-1", &sealed).as_deref(), Some("whsec_AAAA"), "sealed before");
        assert!(!by_ring.is_current(&sealed) && seal.is_current(&sealed));
        let by_old = Seal::with_keyring(ring(&[&old]), None).seal("webhook-1", "whsec_AAAA").unwrap();
        assert_eq!(opened(Some(&by_ring), "webhook-1", &by_old).as_deref(), Some("whsec_AAAA"));
        assert_eq!(opened(Some(&by_ring), "webhook-2", &by_old), None);
        assert!(!by_ring.is_current(&by_old));
        assert!(by_ring.is_current(&by_ring.seal("webhook-1", "whsec_AAAA").unwrap()));
        assert_eq!(opened(Some(&seal), "webhook-1", &by_old), None);
        std::fs::write(&path, "no key").unwrap();
        assert!(Seal::read(&path).is_err());
    }
}
