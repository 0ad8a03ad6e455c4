//! Blobs that are read piece by piece, as fast as their reader takes them.

use crate::jobs::{ArtifactKey, BlobStream, JobError};
use bytes::Bytes;
use futures_util::StreamExt as _;
use std::ops::Range;

/// The rest of a blob that is being read.
struct Rest<F> {
    read: F,
    left: Range<u64>,
    piece: u64,
    hasher: blake3::Hasher,
    /// The expected hash of the content, if the whole blob is read.
    hash: Option<String>,
}

impl<F, R> Rest<F>
where
    F: Fn(Range<u64>) -> R,
    R: Future<Output = Result<Bytes, JobError>>,
{
    /// The next piece; `None` after the last.
    async fn next(&mut self) -> Result<Option<Bytes>, JobError> {
        if self.left.is_empty() {
            return Ok(None);
        }
        let end = self.left.end.min(self.left.start.saturating_add(self.piece));
        let piece = (self.read)(self.left.start..end).await?;
        if piece.len() as u64 != end - self.left.start {
            return Err(JobError::Corrupt { what: "a blob that is shorter than it was", source: None });
        }
        self.left.start = end;
        if let Some(hash) = &self.hash {
            self.hasher.update(&piece);
            if self.left.is_empty() && self.hasher.finalize().to_hex().as_str() != hash {
                return Err(JobError::Corrupt { what: "a blob whose content is not its name", source: None });
            }
        }
        Ok(Some(piece))
    }
}

/// The blob under `key`, or a range of it, read by `read` in pieces of at most `piece` bytes. The first piece is read
/// at once, so that an unreadable blob is an error and not a stream that breaks off.
pub(super) async fn in_pieces<F, R>(
    key: &ArtifactKey,
    n_bytes: u64,
    range: Option<Range<u64>>,
    piece: u64,
    read: F,
) -> Result<BlobStream, JobError>
where
    F: Fn(Range<u64>) -> R + Send + 'static,
    R: Future<Output = Result<Bytes, JobError>> + Send,
{
    let hash = range.is_none().then(|| key.hash().to_owned());
    let left = range.unwrap_or(0..n_bytes);
    let mut rest = Rest { read, left, piece: piece.max(1), hasher: blake3::Hasher::new(), hash };
    let first = rest.next().await?;
    let others = futures_util::stream::unfold(Some(rest), |rest| async move {
        let mut rest = rest?;
        match rest.next().await {
            Ok(piece) => piece.map(|piece| (Ok(piece), Some(rest))),
            Err(error) => Some((Err(error), None)),
        }
    });
    Ok(futures_util::stream::iter(first.map(Ok)).chain(others).boxed())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::jobs::Tenant;
    use futures_util::TryStreamExt as _;

    async fn read(content: &'static [u8], key: &ArtifactKey, range: Option<Range<u64>>) -> Result<Vec<u8>, JobError> {
        let part = move |range: Range<u64>| Bytes::from(&content[range.start as usize..range.end as usize]);
        let read = move |range| std::future::ready(Ok(part(range)));
        let pieces: Vec<Bytes> = in_pieces(key, content.len() as u64, range, 3, read).await?.try_collect().await?;
        assert!(pieces.iter().all(|piece| piece.len() <= 3));
        Ok(pieces.concat())
    }

    #[tokio::test]
    async fn pieces_are_the_content_or_its_range() {
        let content = b"0123456789";
        let key = ArtifactKey::of(&Tenant::default(), content);
        assert_eq!(read(content, &key, None).await.unwrap(), content);
        assert_eq!(read(content, &key, Some(2..9)).await.unwrap(), b"2345678");
        assert_eq!(read(content, &key, Some(4..4)).await.unwrap(), b"");
        assert_eq!(read(b"", &ArtifactKey::of(&Tenant::default(), b""), None).await.unwrap(), b"");
    }

    #[tokio::test]
    async fn content_that_was_changed_is_never_read_to_its_end() {
        let key = ArtifactKey::of(&Tenant::default(), b"0123456789");
        assert!(matches!(read(b"0123456780", &key, None).await, Err(JobError::Corrupt { .. })));
        assert!(read(b"0123456780", &key, Some(0..3)).await.is_ok(), "a range cannot be verified");
    }
}
