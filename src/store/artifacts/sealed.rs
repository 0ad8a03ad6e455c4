//! Blobs that are encrypted before they reach a folder or an S3-compatible store.
//!
//! A stored blob consists of [`MAGIC`], chunks of [`CHUNK`] bytes, each with a tag of [`TAG`] bytes, and a footer: the
//! blob's own key, encrypted with a key-encryption key for the blob's address and size. Chunks are encrypted with
//! AES-256-GCM. The nonce contains the number of the chunk and whether it is the last (the STREAM construction of
//! Hoang, Reyhanitabar, Rogaway and Vizár, CRYPTO 2015), so chunks can neither be exchanged nor cut off, and reading a
//! range decrypts only the chunks that it touches. Unencrypted blobs, stored before encryption was set up, are read as
//! they are and always compared with their hashes.

use super::pieces::in_pieces;
use super::stored_blobs::StoredBlobs;
use crate::jobs::{ArtifactKey, ArtifactStore, ArtifactWriter, BlobStream, JobError, Tenant};
use crate::store::keyring::{Keyring, OVERHEAD, content_cipher, random_key, sealed_with};
use async_trait::async_trait;
use bytes::{Bytes, BytesMut};
use futures_util::TryStreamExt as _;
use ring::aead::{Aad, LessSafeKey, Nonce};
use std::ops::Range;
use std::sync::Arc;

/// First bytes of an encrypted blob.
const MAGIC: &[u8; 16] = b"homolog sealed 1";
/// Content of a chunk, bytes.
const CHUNK: u64 = 64 << 10;
/// Length of the tag of a chunk, bytes.
const TAG: u64 = 16;
/// Length of the footer, bytes.
pub(crate) const FOOTER: u64 = (32 + OVERHEAD) as u64;
/// Memory of a reader of a blob, bytes.
const PIECE: u64 = 8 * CHUNK;

/// What a rotation does with a blob.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::store) enum Resealed {
    /// Nothing: the blob is already encrypted with the current key.
    Not,
    /// The blob's key was encrypted with the current key.
    Rewrapped,
    /// The blob was encrypted for the first time.
    Encrypted,
}

/// A store that holds blobs encrypted.
#[derive(Clone)]
pub struct SealedArtifacts {
    inner: Arc<dyn StoredBlobs>,
    keyring: Arc<Keyring>,
}

fn altered(what: &'static str) -> JobError {
    JobError::Corrupt { what, source: None }
}

/// Number of chunks of a blob of `n_bytes`. An empty blob has one chunk, which proves that it is empty.
fn n_chunks(n_bytes: u64) -> u64 {
    n_bytes.div_ceil(CHUNK).max(1)
}

/// Size of an encrypted blob with `n_bytes` of content; `None` if it is not representable.
pub(crate) fn sealed_size(n_bytes: u64) -> Option<u64> {
    n_bytes.checked_add(n_chunks(n_bytes).checked_mul(TAG)?)?.checked_add(MAGIC.len() as u64 + FOOTER)
}

/// Whether a stored blob is encrypted, by its first bytes.
pub(crate) fn is_sealed_blob(first: &[u8]) -> bool {
    first.starts_with(MAGIC)
}

/// Offset of an encrypted chunk.
fn offset(chunk: u64) -> u64 {
    MAGIC.len() as u64 + chunk * (CHUNK + TAG)
}

fn nonce(chunk: u64, is_last: bool) -> Nonce {
    let mut nonce = [0; 12];
    nonce[..8].copy_from_slice(&chunk.to_be_bytes());
    nonce[11] = u8::from(is_last);
    // Each key encrypts one blob, and each chunk has a number.
    Nonce::assume_unique_for_key(nonce)
}

/// The associated data of a blob's footer.
fn owner(key: &ArtifactKey, n_bytes: u64) -> Vec<u8> {
    format!("blob\n{}\n{}\n{n_bytes}", key.tenant.name(), key.path()).into_bytes()
}

fn decrypted(cipher: &LessSafeKey, stored: &[u8], first: u64, last_of_blob: u64) -> Result<Vec<u8>, JobError> {
    let changed = || altered("an encrypted blob that was changed");
    let mut content = Vec::with_capacity(stored.len());
    for (index, chunk) in (first..).zip(stored.chunks((CHUNK + TAG) as usize)) {
        let mut chunk = chunk.to_vec();
        let opened = cipher.open_in_place(nonce(index, index == last_of_blob), Aad::empty(), &mut chunk);
        content.extend_from_slice(opened.map_err(|_| changed())?);
    }
    Ok(content)
}

impl SealedArtifacts {
    /// The blobs of `inner`, encrypted with keys of `keyring`.
    pub fn new(inner: Arc<dyn StoredBlobs>, keyring: Arc<Keyring>) -> Self {
        SealedArtifacts { inner, keyring }
    }

    async fn stored_range(&self, key: &ArtifactKey, range: Range<u64>) -> Result<Bytes, JobError> {
        let pieces: Vec<Bytes> = self.inner.open(key, range.end, Some(range)).await?.try_collect().await?;
        match <[Bytes; 1]>::try_from(pieces) {
            Ok([piece]) => Ok(piece),
            Err(pieces) => Ok(pieces.concat().into()),
        }
    }

    /// The footer of a blob; `None` if it is not encrypted.
    async fn footer(&self, key: &ArtifactKey, n_bytes: u64) -> Result<Option<Bytes>, JobError> {
        let magic = MAGIC.len() as u64;
        // The blob is shorter than the magic.
        let first = match n_bytes < magic {
            true => self.inner.stored(key).await?,
            false => self.stored_range(key, 0..magic).await?,
        };
        if !is_sealed_blob(&first) {
            return Ok(None);
        }
        let size = sealed_size(n_bytes).ok_or_else(|| altered("the size of a blob"))?;
        self.stored_range(key, size - FOOTER..size).await.map(Some)
    }

    /// The key in the footer of a blob.
    fn content_key(&self, key: &ArtifactKey, n_bytes: u64, footer: &[u8]) -> Result<Vec<u8>, JobError> {
        let opened = self.keyring.open(&owner(key, n_bytes), footer);
        opened
            .map_err(|fault| JobError::Corrupt { what: "the key of an encrypted blob", source: Some(Box::new(fault)) })
    }

    fn cipher(&self, key: &ArtifactKey, n_bytes: u64, footer: &[u8]) -> Result<LessSafeKey, JobError> {
        content_cipher(&self.content_key(key, n_bytes, footer)?).ok_or_else(|| altered("the key of an encrypted blob"))
    }

    /// The outcome that [`SealedArtifacts::reseal`] would have.
    pub(in crate::store) async fn is_current(&self, key: &ArtifactKey, n_bytes: u64) -> Result<Resealed, JobError> {
        Ok(match self.footer(key, n_bytes).await? {
            None => Resealed::Encrypted,
            Some(footer) if sealed_with(&footer) == self.keyring.current() => Resealed::Not,
            Some(_) => Resealed::Rewrapped,
        })
    }

    /// Encrypts the key of a blob with the current key, or the whole blob if it is not encrypted yet. The new blob is
    /// written beside the old one and replaces it when complete.
    pub(in crate::store) async fn reseal(&self, key: &ArtifactKey, n_bytes: u64) -> Result<Resealed, JobError> {
        let done = self.is_current(key, n_bytes).await?;
        match (done, self.footer(key, n_bytes).await?) {
            (Resealed::Rewrapped, Some(footer)) => {
                let content_key = self.content_key(key, n_bytes, &footer)?;
                let footer = self.sealed_key(key, n_bytes, &content_key)?;
                let size = sealed_size(n_bytes).ok_or_else(|| altered("the size of a blob"))?;
                let mut writer = self.inner.begin(&key.tenant).await?;
                let mut content = self.inner.open(key, size, Some(0..size - FOOTER)).await?;
                while let Some(piece) = content.try_next().await? {
                    writer.write(piece).await?;
                }
                writer.write(footer).await?;
                writer.commit(key).await?;
            }
            (Resealed::Encrypted, None) => {
                let mut writer = self.begin(&key.tenant).await?;
                // Read whole, so that it is compared with its hash.
                let mut content = self.inner.open(key, n_bytes, None).await?;
                while let Some(piece) = content.try_next().await? {
                    writer.write(piece).await?;
                }
                writer.commit(key).await?;
            }
            _ => {}
        }
        Ok(done)
    }

    /// The footer of a blob with this content key.
    fn sealed_key(&self, key: &ArtifactKey, n_bytes: u64, content_key: &[u8]) -> Result<Bytes, JobError> {
        let sealed = self.keyring.seal(&owner(key, n_bytes), content_key);
        sealed.map(Bytes::from).ok_or_else(|| altered("a key that cannot be encrypted"))
    }

    fn writer(&self, inner: Box<dyn ArtifactWriter>) -> Result<SealedWriter, JobError> {
        let (content_key, cipher) = random_key().ok_or_else(|| altered("random numbers"))?;
        let (store, waiting) = (self.clone(), BytesMut::new());
        Ok(SealedWriter { store, inner, content_key, cipher, waiting, chunk: 0, n_bytes: 0 })
    }
}

/// A blob that is encrypted as it arrives.
struct SealedWriter {
    store: SealedArtifacts,
    inner: Box<dyn ArtifactWriter>,
    content_key: [u8; 32],
    cipher: LessSafeKey,
    /// Content that is not encrypted yet: at most one chunk between calls, because the last chunk is marked as such.
    waiting: BytesMut,
    chunk: u64,
    n_bytes: u64,
}

impl SealedWriter {
    /// Encrypts the complete chunks except the last one; at the end, all.
    fn encrypted(&mut self, is_end: bool) -> Result<BytesMut, JobError> {
        let mut out = BytesMut::new();
        if self.chunk == 0 {
            out.extend_from_slice(MAGIC);
        }
        loop {
            let is_last = is_end && self.waiting.len() as u64 <= CHUNK;
            if !is_last && self.waiting.len() as u64 <= CHUNK {
                break;
            }
            let mut text = self.waiting.split_to(self.waiting.len().min(CHUNK as usize));
            let tag = self.cipher.seal_in_place_separate_tag(nonce(self.chunk, is_last), Aad::empty(), &mut text);
            out.extend_from_slice(&text);
            out.extend_from_slice(tag.map_err(|_| altered("a blob that cannot be encrypted"))?.as_ref());
            self.chunk += 1;
            if is_last {
                break;
            }
        }
        Ok(out)
    }
}

#[async_trait]
impl ArtifactWriter for SealedWriter {
    async fn write(&mut self, part: Bytes) -> Result<(), JobError> {
        self.n_bytes += part.len() as u64;
        self.waiting.extend_from_slice(&part);
        if self.waiting.len() as u64 <= CHUNK {
            return Ok(());
        }
        let out = self.encrypted(false)?;
        self.inner.write(out.freeze()).await
    }

    async fn commit(mut self: Box<Self>, key: &ArtifactKey) -> Result<(), JobError> {
        let mut out = self.encrypted(true)?;
        out.extend_from_slice(&self.store.sealed_key(key, self.n_bytes, &self.content_key)?);
        self.inner.write(out.freeze()).await?;
        self.inner.commit(key).await
    }
}

/// Collects the output of a [`SealedWriter`].
#[derive(Default)]
struct Collected(Arc<parking_lot::Mutex<BytesMut>>);

#[async_trait]
impl ArtifactWriter for Collected {
    async fn write(&mut self, part: Bytes) -> Result<(), JobError> {
        self.0.lock().extend_from_slice(&part);
        Ok(())
    }

    async fn commit(self: Box<Self>, _: &ArtifactKey) -> Result<(), JobError> {
        Ok(())
    }
}

#[async_trait]
impl ArtifactStore for SealedArtifacts {
    async fn ping(&self) -> Result<(), JobError> {
        self.inner.ping().await
    }

    async fn put(&self, key: &ArtifactKey, bytes: Bytes) -> Result<(), JobError> {
        let collected = Collected::default();
        let content = Arc::clone(&collected.0);
        let mut writer = Box::new(self.writer(Box::new(collected))?);
        writer.write(bytes).await?;
        writer.commit(key).await?;
        let sealed = std::mem::take(&mut *content.lock()).freeze();
        self.inner.put(key, sealed).await
    }

    async fn begin(&self, tenant: &Tenant) -> Result<Box<dyn ArtifactWriter>, JobError> {
        Ok(Box::new(self.writer(self.inner.begin(tenant).await?)?))
    }

    async fn get(&self, key: &ArtifactKey) -> Result<Bytes, JobError> {
        let stored = self.inner.stored(key).await?;
        let content = if is_sealed_blob(&stored) {
            let short = || altered("an encrypted blob that is shorter than it was");
            let chunks = (stored.len() as u64).checked_sub(MAGIC.len() as u64 + FOOTER).ok_or_else(short)?;
            let n_bytes = chunks.checked_sub(chunks.div_ceil(CHUNK + TAG).max(1) * TAG).ok_or_else(short)?;
            let (chunks, footer) = stored[MAGIC.len()..].split_at(chunks as usize);
            let cipher = self.cipher(key, n_bytes, footer)?;
            decrypted(&cipher, chunks, 0, n_chunks(n_bytes) - 1)?.into()
        } else {
            stored
        };
        if blake3::hash(&content).to_hex().as_str() != key.hash() {
            return Err(altered("a blob whose content is not its name"));
        }
        Ok(content)
    }

    async fn open(&self, key: &ArtifactKey, n_bytes: u64, range: Option<Range<u64>>) -> Result<BlobStream, JobError> {
        let Some(footer) = self.footer(key, n_bytes).await? else {
            if range.is_some() {
                // A range cannot be verified by itself, and an encrypted blob whose first bytes were changed looks like
                // an unencrypted one.
                let mut whole = self.inner.open(key, n_bytes, None).await?;
                while whole.try_next().await?.is_some() {}
            }
            return self.inner.open(key, n_bytes, range).await;
        };
        let cipher = Arc::new(self.cipher(key, n_bytes, &footer)?);
        let (store, of_blob) = (self.clone(), key.clone());
        in_pieces(key, n_bytes, range, PIECE, move |range| {
            let (store, key, cipher) = (store.clone(), of_blob.clone(), Arc::clone(&cipher));
            async move {
                let last_of_blob = n_chunks(n_bytes) - 1;
                let (first, last) = (range.start / CHUNK, (range.end - 1) / CHUNK);
                let end =
                    if last == last_of_blob { offset(last) + n_bytes - last * CHUNK + TAG } else { offset(last + 1) };
                let stored = store.stored_range(&key, offset(first)..end).await?;
                let content = Bytes::from(decrypted(&cipher, &stored, first, last_of_blob)?);
                let begin = (range.start - first * CHUNK) as usize;
                let wanted = begin..begin + (range.end - range.start) as usize;
                if content.len() < wanted.end {
                    return Err(altered("an encrypted blob that is shorter than it was"));
                }
                Ok(content.slice(wanted))
            }
        })
        .await
    }

    async fn remove(&self, key: &ArtifactKey) -> Result<(), JobError> {
        self.inner.remove(key).await
    }

    async fn sweep(&self) -> Result<u32, JobError> {
        self.inner.sweep().await
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::store::artifacts::FolderArtifacts;
    use std::fs;
    use std::path::PathBuf;

    const OLD: &str = "0000000000000000000000000000000000000000000000000000000000000001";
    const NEW: &str = "0000000000000000000000000000000000000000000000000000000000000002";

    struct Fixture {
        folder: tempfile::TempDir,
        plain: FolderArtifacts,
        tenant: Tenant,
    }

    impl Fixture {
        fn open() -> Self {
            let folder = tempfile::tempdir().unwrap();
            let plain = FolderArtifacts::open(folder.path()).unwrap();
            Fixture { folder, plain, tenant: Tenant::default() }
        }

        fn with(&self, keys: &[&str]) -> SealedArtifacts {
            let keyring = Keyring::parse(&keys.join("\n")).unwrap();
            SealedArtifacts::new(Arc::new(self.plain.clone()), Arc::new(keyring))
        }

        fn file(&self, key: &ArtifactKey) -> PathBuf {
            self.folder.path().join("blobs").join(key.tenant.name()).join(key.path())
        }
    }

    /// Bytes without a period.
    fn content(n: usize) -> Vec<u8> {
        (0..n as u64).map(|i| (i.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 56) as u8).collect()
    }

    async fn read(
        store: &SealedArtifacts,
        key: &ArtifactKey,
        n: usize,
        range: Option<Range<u64>>,
    ) -> Result<Vec<u8>, JobError> {
        Ok(store.open(key, n as u64, range).await?.try_collect::<Vec<Bytes>>().await?.concat())
    }

    #[tokio::test]
    async fn content_of_any_size_is_read_whole_and_in_ranges() {
        let f = Fixture::open();
        let store = f.with(&[NEW]);
        let chunk = CHUNK as usize;
        for n in [0, 1, 15, 16, 17, chunk - 1, chunk, chunk + 1, 2 * chunk, 9 * chunk + 5, 20 * chunk] {
            let bytes = content(n);
            let key = ArtifactKey::of(&f.tenant, &bytes);
            if n % 2 == 0 {
                store.put(&key, bytes.clone().into()).await.unwrap();
            } else {
                let mut writer = store.begin(&f.tenant).await.unwrap();
                for part in bytes.chunks(50_000) {
                    writer.write(Bytes::copy_from_slice(part)).await.unwrap();
                }
                writer.commit(&key).await.unwrap();
            }
            let stored = fs::read(f.file(&key)).unwrap();
            assert_eq!(stored.len() as u64, sealed_size(n as u64).unwrap());
            assert!(n < 32 || !stored.windows(32).any(|window| window == &bytes[..32]), "{n}");
            assert_eq!(store.get(&key).await.unwrap(), bytes, "{n}");
            assert_eq!(read(&store, &key, n, None).await.unwrap(), bytes, "{n}");
            for (start, end) in [(0, 1), (n / 2, n), (n.saturating_sub(1), n), (chunk - 2, chunk + 2), (n, n)] {
                if start <= end && end <= n {
                    let range = Some(start as u64..end as u64);
                    assert_eq!(read(&store, &key, n, range).await.unwrap(), bytes[start..end], "{n}: {start}..{end}");
                }
            }
        }
    }

    #[tokio::test]
    async fn a_changed_byte_is_refused_whole_and_in_the_range_that_has_it() {
        let f = Fixture::open();
        let store = f.with(&[NEW]);
        let n = 3 * CHUNK as usize + 100;
        let bytes = content(n);
        let key = ArtifactKey::of(&f.tenant, &bytes);
        store.put(&key, bytes.into()).await.unwrap();
        let stored = fs::read(f.file(&key)).unwrap();
        let chunk = (CHUNK + TAG) as usize;
        for at in
            [0, 15, 16, 5_000, 16 + chunk - 1, 16 + chunk, 16 + 3 * chunk + 50, stored.len() - 68, stored.len() - 1]
        {
            let mut changed = stored.clone();
            changed[at] ^= 1;
            fs::write(f.file(&key), &changed).unwrap();
            assert!(store.get(&key).await.is_err(), "byte {at}");
            assert!(read(&store, &key, n, None).await.is_err(), "byte {at}");
            let range = match at.saturating_sub(16) / chunk {
                // A fault in the magic or in the footer makes every range unreadable.
                _ if !(16..stored.len() - 68).contains(&at) => 70_000..70_001,
                index => index as u64 * CHUNK..index as u64 * CHUNK + 1,
            };
            assert!(read(&store, &key, n, Some(range)).await.is_err(), "byte {at}");
        }
        // The blob is cut off, its chunks are exchanged, or it is another blob.
        fs::write(f.file(&key), &stored[..stored.len() - chunk]).unwrap();
        assert!(store.get(&key).await.is_err() && read(&store, &key, n, Some(0..1)).await.is_err());
        let mut exchanged = stored.clone();
        exchanged[16..16 + 2 * chunk].rotate_left(chunk);
        fs::write(f.file(&key), &exchanged).unwrap();
        assert!(read(&store, &key, n, Some(0..1)).await.is_err());
        let other = ArtifactKey::of(&Tenant::new("other").unwrap(), b"0");
        fs::create_dir_all(f.file(&other).parent().unwrap()).unwrap();
        fs::write(f.file(&other), &stored).unwrap();
        assert!(read(&store, &other, n, Some(0..1)).await.is_err());
    }

    #[tokio::test]
    async fn old_keys_still_read_and_rotation_leaves_the_current_one_alone() {
        let f = Fixture::open();
        let n = 2 * CHUNK as usize + 7;
        let bytes = content(n);
        let (before, sealed) = (ArtifactKey::of(&f.tenant, &bytes), ArtifactKey::of(&f.tenant, b"sealed"));
        f.plain.put(&before, bytes.clone().into()).await.unwrap();
        f.with(&[OLD]).put(&sealed, Bytes::from_static(b"sealed")).await.unwrap();
        let both = f.with(&[NEW, OLD]);
        assert_eq!(read(&both, &before, n, Some(5..9)).await.unwrap(), bytes[5..9], "stored before");
        assert_eq!(both.get(&sealed).await.unwrap(), "sealed");
        assert!(f.with(&[NEW]).get(&sealed).await.is_err());
        assert_eq!(both.reseal(&before, n as u64).await.unwrap(), Resealed::Encrypted);
        assert_eq!(both.reseal(&sealed, 6).await.unwrap(), Resealed::Rewrapped);
        assert_eq!(both.reseal(&sealed, 6).await.unwrap(), Resealed::Not);
        let new = f.with(&[NEW]);
        assert_eq!(new.get(&sealed).await.unwrap(), "sealed");
        assert_eq!(read(&new, &before, n, None).await.unwrap(), bytes);
        assert!(f.with(&[OLD]).get(&sealed).await.is_err());
    }
}
