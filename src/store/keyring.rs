//! The keys that encrypt the keys of blobs and the secrets in the database.
//!
//! A key-encryption key never encrypts content. Each blob has its own random key, which is stored with the blob,
//! encrypted with the current key-encryption key (AES-256-GCM, NIST SP 800-38D, by ring). Every given key decrypts.

use ring::aead::{AES_256_GCM, Aad, LessSafeKey, NONCE_LEN, Nonce, UnboundKey};
use ring::rand::{SecureRandom as _, SystemRandom};
use std::fmt;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Length of a key, bytes.
const KEY_BYTES: usize = 32;
/// Length of the id of a key, bytes.
const ID_BYTES: usize = 8;
/// Bytes that encryption with a key-encryption key adds: the key's id, a nonce and a tag.
pub(super) const OVERHEAD: usize = ID_BYTES + NONCE_LEN + 16;
/// How long the command that prints the keys may take.
const COMMAND_TIMEOUT: Duration = Duration::from_secs(30);

/// Public name of a key-encryption key: 16 hexadecimal digits that reveal nothing about the key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct KeyId([u8; ID_BYTES]);

impl fmt::Display for KeyId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

/// Why a ciphertext cannot be decrypted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub(super) enum OpenFault {
    /// Its key is not among the given ones.
    #[error("it is encrypted with the key {0}, which this process was not given")]
    UnknownKey(KeyId),
    /// It was changed, or belongs to another owner.
    #[error("it was changed, or belongs to something else")]
    Altered,
}

/// Key-encryption keys: the first key encrypts, all keys decrypt.
pub struct Keyring {
    keys: Vec<(KeyId, LessSafeKey)>,
    random: SystemRandom,
}

impl fmt::Debug for Keyring {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.keys.iter().map(|(id, _)| id)).finish()
    }
}

impl Keyring {
    /// Parses lines of 64 hexadecimal digits, the current key first; empty lines and lines that begin with `#` are
    /// skipped.
    ///
    /// # Errors
    /// The fault, without the keys.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut keys: Vec<(KeyId, LessSafeKey)> = Vec::new();
        for (index, line) in text.lines().enumerate().map(|(index, line)| (index, line.trim())) {
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            let key = blake3::Hash::from_hex(line)
                .map_err(|_| format!("line {} is no key: 64 hexadecimal digits are needed there", index + 1))?;
            let derived = blake3::derive_key("homolog 2026-11 id of a key-encryption key", key.as_bytes());
            let mut id = KeyId([0; ID_BYTES]);
            id.0.copy_from_slice(&derived[..ID_BYTES]);
            if keys.iter().all(|(known, _)| *known != id) {
                keys.push((id, cipher(key.as_bytes()).ok_or("a key cannot be used")?));
            }
        }
        if keys.is_empty() {
            return Err(
                "there is no key: 64 hexadecimal digits are needed, as `openssl rand -hex 32` prints them".to_owned()
            );
        }
        Ok(Keyring { keys, random: SystemRandom::new() })
    }

    /// The keys in a file.
    ///
    /// # Errors
    /// If it cannot be read, or as for [`Keyring::parse`].
    pub fn read(path: &Path) -> Result<Self, String> {
        let text = std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
        Keyring::parse(&text).map_err(|reason| format!("{}: {reason}", path.display()))
    }

    /// The keys that a shell command prints. Its standard error is the one of this process.
    ///
    /// # Errors
    /// If it fails or takes too long, or as for [`Keyring::parse`].
    pub fn from_command(command: &str) -> Result<Self, String> {
        let failed = |error: std::io::Error| format!("the command for the encryption keys: {error}");
        let mut shell = Command::new("/bin/sh");
        shell.arg("-c").arg(command).stdin(Stdio::null()).stdout(Stdio::piped());
        let mut child = shell.spawn().map_err(failed)?;
        let output = child.stdout.take();
        // Read on a separate thread, so that a command with long output does not block.
        let reader = std::thread::spawn(move || output.map(std::io::read_to_string).transpose());
        let began = Instant::now();
        let status = loop {
            match child.try_wait().map_err(failed)? {
                Some(status) => break status,
                None if began.elapsed() > COMMAND_TIMEOUT => {
                    let _ = child.kill();
                    let _ = child.wait();
                    return Err(format!(
                        "the command for the encryption keys took over {} s",
                        COMMAND_TIMEOUT.as_secs()
                    ));
                }
                None => std::thread::sleep(Duration::from_millis(10)),
            }
        };
        if !status.success() {
            return Err(format!("the command for the encryption keys failed: {status}"));
        }
        let text = reader.join().map_err(|_| "the answer of the command for the encryption keys is unreadable")?;
        Keyring::parse(&text.map_err(failed)?.unwrap_or_default())
            .map_err(|reason| format!("the answer of the command for the encryption keys: {reason}"))
    }

    /// The key that encrypts.
    pub fn current(&self) -> Option<KeyId> {
        self.keys.first().map(|(id, _)| *id)
    }

    /// Whether the key with this id is given.
    pub(crate) fn knows(&self, id: &str) -> bool {
        self.keys.iter().any(|(known, _)| known.to_string() == id)
    }

    /// Encrypts `text` with the current key for `owner`; decryption needs the same `owner`. `None` if the system
    /// provides no random numbers. The result is [`OVERHEAD`] bytes longer.
    pub(super) fn seal(&self, owner: &[u8], text: &[u8]) -> Option<Vec<u8>> {
        let (id, key) = self.keys.first()?;
        let mut nonce = [0; NONCE_LEN];
        self.random.fill(&mut nonce).ok()?;
        let mut sealed = text.to_vec();
        key.seal_in_place_append_tag(Nonce::assume_unique_for_key(nonce), Aad::from(owner), &mut sealed).ok()?;
        Some([&id.0[..], &nonce, &sealed].concat())
    }

    /// Decrypts a text that was encrypted for `owner`.
    pub(super) fn open(&self, owner: &[u8], sealed: &[u8]) -> Result<Vec<u8>, OpenFault> {
        let id = sealed_with(sealed).ok_or(OpenFault::Altered)?;
        let (_, key) = self.keys.iter().find(|(known, _)| *known == id).ok_or(OpenFault::UnknownKey(id))?;
        let (nonce, text) = sealed[ID_BYTES..].split_at_checked(NONCE_LEN).ok_or(OpenFault::Altered)?;
        let nonce = Nonce::try_assume_unique_for_key(nonce).map_err(|_| OpenFault::Altered)?;
        let mut text = text.to_vec();
        let n = key.open_in_place(nonce, Aad::from(owner), &mut text).map_err(|_| OpenFault::Altered)?.len();
        text.truncate(n);
        Ok(text)
    }
}

/// The id of the key with which a text was encrypted.
pub(super) fn sealed_with(sealed: &[u8]) -> Option<KeyId> {
    sealed.first_chunk().copied().map(KeyId)
}

fn cipher(key: &[u8; KEY_BYTES]) -> Option<LessSafeKey> {
    UnboundKey::new(&AES_256_GCM, key).ok().map(LessSafeKey::new)
}

/// A new random content key, and its cipher.
pub(super) fn random_key() -> Option<([u8; KEY_BYTES], LessSafeKey)> {
    let mut key = [0; KEY_BYTES];
    SystemRandom::new().fill(&mut key).ok()?;
    Some((key, cipher(&key)?))
}

/// The cipher of a stored content key.
pub(super) fn content_cipher(key: &[u8]) -> Option<LessSafeKey> {
    cipher(key.try_into().ok()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    const OLD: &str = "0000000000000000000000000000000000000000000000000000000000000001";
    const NEW: &str = "0000000000000000000000000000000000000000000000000000000000000002";

    #[test]
    fn the_first_key_encrypts_and_all_decrypt() {
        let old = Keyring::parse(&format!("# of 2026\n\n{OLD}\n")).unwrap();
        let both = Keyring::parse(&format!("{NEW}\n{OLD}\n{NEW}\n")).unwrap();
        assert_ne!(old.current(), both.current());
        let sealed = old.seal(b"owner", b"text").unwrap();
        assert_eq!(sealed.len(), 4 + OVERHEAD);
        assert_eq!(sealed_with(&sealed), old.current());
        assert_eq!(both.open(b"owner", &sealed).unwrap(), b"text");
        assert_eq!(both.open(b"other", &sealed), Err(OpenFault::Altered));
        let newer = both.seal(b"owner", b"text").unwrap();
        assert_eq!(old.open(b"owner", &newer), Err(OpenFault::UnknownKey(both.current().unwrap())));
        for at in ID_BYTES..sealed.len() {
            let mut changed = sealed.clone();
            changed[at] ^= 1;
            assert_eq!(both.open(b"owner", &changed), Err(OpenFault::Altered), "byte {at}");
        }
        assert!((0..sealed.len()).all(|n| both.open(b"owner", &sealed[..n]).is_err()));
        assert!(!format!("{both:?}").contains("0000000000"), "keys are never printed");
    }

    #[test]
    fn keys_come_from_files_and_commands_and_faults_are_named() {
        for (text, reason) in
            [("", "no key"), ("# none", "no key"), ("abc", "line 1"), (&format!("{OLD}\n12"), "line 2")]
        {
            assert!(Keyring::parse(text).unwrap_err().contains(reason), "{text}");
        }
        let printed = Keyring::from_command(&format!("printf '%s\\n' {NEW} {OLD}")).unwrap();
        assert_eq!(printed.current(), Keyring::parse(NEW).unwrap().current());
        assert!(Keyring::from_command("exit 3").unwrap_err().contains("failed"));
        assert!(Keyring::from_command("echo no key").unwrap_err().contains("line 1"));
    }
}
