//! Blobs in an S3-compatible store: `<prefix>/blobs/<tenant>/…`, named as in a folder.
//!
//! The store acknowledges a write when it is durable. A blob that arrives in parts is written to `<prefix>/incoming/` by a
//! multipart upload and copied to its final name, inside the store, when its hash is known. An interrupted upload leaves
//! parts that only the store sees: give the bucket a lifecycle rule that aborts incomplete multipart uploads.

use super::NOT_THERE;
use super::pieces::in_pieces;
use super::stored_blobs::StoredBlobs;
use crate::jobs::{ArtifactKey, ArtifactStore, ArtifactWriter, BlobStream, JobError, Tenant};
use crate::store::space::Space;
use async_trait::async_trait;
use bytes::{Bytes, BytesMut};
use object_store::aws::{AmazonS3, AmazonS3Builder, AmazonS3ConfigKey};
use object_store::path::Path;
use object_store::{ClientOptions, MultipartUpload, ObjectStore, ObjectStoreExt, PutPayload, RetryConfig};
use std::ops::Range;
use std::str::FromStr;
use std::sync::Arc;
use std::time::Duration;

/// Time limit of a request; blobs are a few megabytes.
const REQUEST: Duration = Duration::from_secs(30);
/// Time limit for a connection.
const CONNECT: Duration = Duration::from_secs(5);
/// How long failing requests are retried; callers retry for longer where they need to.
const RETRY: Duration = Duration::from_secs(10);
/// Memory of a reader of a blob, bytes.
const PIECE: u64 = 1 << 20;
/// Size of the parts of a multipart upload; S3 requires at least 5 MiB.
const PART: usize = 8 << 20;
/// Age at which an object in `incoming/` is removed: no upload takes this long, so the process that wrote it has ended.
const STALE: Duration = Duration::from_secs(24 * 3600);

/// An S3-compatible store of blobs.
#[derive(Debug, Clone)]
pub struct S3Artifacts {
    client: Arc<AmazonS3>,
    prefix: Path,
    space: Arc<Space>,
}

impl S3Artifacts {
    /// The store at `s3://bucket/prefix`; credentials, region and endpoint come from the environment, as `AWS_*`.
    ///
    /// # Errors
    /// [`JobError::Unavailable`] if the address or the environment is invalid. Does not connect yet.
    pub fn open(url: &str) -> Result<Self, JobError> {
        S3Artifacts::open_with(
            url,
            std::env::vars_os().filter_map(|(name, value)| Some((name.into_string().ok()?, value.into_string().ok()?))),
        )
    }

    /// As [`S3Artifacts::open`], with the given variables instead of the environment.
    ///
    /// # Errors
    /// As for [`S3Artifacts::open`].
    pub fn open_with(url: &str, variables: impl IntoIterator<Item = (String, String)>) -> Result<Self, JobError> {
        crate::tls::prepare();
        let rest = url.strip_prefix("s3://").unwrap_or(url);
        let (bucket, prefix) = rest.split_once('/').unwrap_or((rest, ""));
        let retry = RetryConfig { max_retries: 4, retry_timeout: RETRY, ..RetryConfig::default() };
        let mut builder = AmazonS3Builder::new().with_bucket_name(bucket).with_retry(retry);
        let mut options = ClientOptions::new().with_timeout(REQUEST).with_connect_timeout(CONNECT);
        for (name, value) in variables {
            let name = name.to_ascii_lowercase();
            if name == "aws_allow_http" {
                options = options.with_allow_http(value == "true" || value == "1");
            } else if let (true, Ok(key)) = (name.starts_with("aws_"), AmazonS3ConfigKey::from_str(&name)) {
                builder = builder.with_config(key, value);
            }
        }
        let client = builder.with_client_options(options).build().map_err(domain_error)?;
        Ok(S3Artifacts { client: Arc::new(client), prefix: Path::from(prefix), space: Arc::default() })
    }

    fn path(&self, key: &ArtifactKey) -> Path {
        Path::from(format!("{}/blobs/{}/{}", self.prefix, key.tenant.name(), key.path()))
    }

    fn incoming(&self) -> Path {
        Path::from(format!("{}/incoming", self.prefix))
    }
}

fn domain_error(error: object_store::Error) -> JobError {
    match error {
        object_store::Error::NotFound { .. } => JobError::Corrupt { what: NOT_THERE, source: Some(Box::new(error)) },
        // The error codes of S3-compatible servers when a quota or a disk is full.
        other
            if ["InsufficientStorage", "XMinioStorageFull", "QuotaExceeded", "status: 507"]
                .iter()
                .any(|sign| format!("{other:?}").contains(sign)) =>
        {
            JobError::StorageFull
        }
        other => JobError::Unavailable(Box::new(other)),
    }
}

#[async_trait]
impl ArtifactStore for S3Artifacts {
    async fn ping(&self) -> Result<(), JobError> {
        match self.client.head(&Path::from(format!("{}/.homolog", self.prefix))).await {
            // A read would not show that the bucket's quota is used up.
            Ok(_) | Err(object_store::Error::NotFound { .. }) => self.space.check(),
            Err(error) => Err(domain_error(error)),
        }
    }

    async fn put(&self, key: &ArtifactKey, bytes: Bytes) -> Result<(), JobError> {
        let put = self.client.put(&self.path(key), PutPayload::from_bytes(bytes)).await;
        self.space.noted(put.map(|_| ()).map_err(domain_error))
    }

    async fn begin(&self, _: &Tenant) -> Result<Box<dyn ArtifactWriter>, JobError> {
        let incoming = Path::from(format!("{}/{}", self.incoming(), uuid::Uuid::new_v4()));
        Ok(Box::new(S3Writer { store: self.clone(), incoming, upload: None, buffer: BytesMut::new() }))
    }

    async fn get(&self, key: &ArtifactKey) -> Result<Bytes, JobError> {
        let bytes = self.stored(key).await?;
        if blake3::hash(&bytes).to_hex().as_str() != key.hash() {
            return Err(JobError::Corrupt { what: "a blob whose content is not its name", source: None });
        }
        Ok(bytes)
    }

    async fn open(&self, key: &ArtifactKey, n_bytes: u64, range: Option<Range<u64>>) -> Result<BlobStream, JobError> {
        // Each piece has its own request: requests have a time limit, which a slow reader of the whole blob would
        // exceed.
        let (client, path) = (Arc::clone(&self.client), self.path(key));
        in_pieces(key, n_bytes, range, PIECE, move |range| {
            let (client, path) = (Arc::clone(&client), path.clone());
            async move { client.get_range(&path, range).await.map_err(domain_error) }
        })
        .await
    }

    async fn remove(&self, key: &ArtifactKey) -> Result<(), JobError> {
        match self.client.delete(&self.path(key)).await {
            Ok(()) | Err(object_store::Error::NotFound { .. }) => Ok(()),
            Err(error) => Err(domain_error(error)),
        }
    }

    async fn sweep(&self) -> Result<u32, JobError> {
        let listed = self.client.list_with_delimiter(Some(&self.incoming())).await.map_err(domain_error)?;
        let mut removed = 0;
        for object in listed.objects {
            let age = std::time::SystemTime::from(object.last_modified).elapsed().unwrap_or_default();
            if age > STALE && self.client.delete(&object.location).await.is_ok() {
                removed += 1;
            }
        }
        Ok(removed)
    }
}

#[async_trait]
impl StoredBlobs for S3Artifacts {
    async fn stored(&self, key: &ArtifactKey) -> Result<Bytes, JobError> {
        async { self.client.get(&self.path(key)).await?.bytes().await }.await.map_err(domain_error)
    }
}

/// A blob that is uploaded in parts; a small blob stays in memory until its name is known.
struct S3Writer {
    store: S3Artifacts,
    incoming: Path,
    upload: Option<Box<dyn MultipartUpload>>,
    buffer: BytesMut,
}

impl S3Writer {
    async fn send_part(&mut self) -> Result<(), JobError> {
        let part = PutPayload::from_bytes(self.buffer.split().freeze());
        let upload = match &mut self.upload {
            Some(upload) => upload,
            None => {
                let begun = self.store.client.put_multipart(&self.incoming).await.map_err(domain_error)?;
                self.upload.insert(begun)
            }
        };
        self.store.space.noted(upload.put_part(part).await.map_err(domain_error))
    }
}

#[async_trait]
impl ArtifactWriter for S3Writer {
    async fn write(&mut self, part: Bytes) -> Result<(), JobError> {
        self.buffer.extend_from_slice(&part);
        if self.buffer.len() >= PART { self.send_part().await } else { Ok(()) }
    }

    async fn commit(mut self: Box<Self>, key: &ArtifactKey) -> Result<(), JobError> {
        if self.upload.is_none() {
            let bytes = self.buffer.split().freeze();
            return self.store.put(key, bytes).await;
        }
        if !self.buffer.is_empty() {
            self.send_part().await?;
        }
        if let Some(upload) = &mut self.upload {
            self.store.space.noted(upload.complete().await.map_err(domain_error))?;
        }
        self.upload = None;
        let copied = self.store.client.copy(&self.incoming, &self.store.path(key)).await.map_err(domain_error);
        let _ = self.store.client.delete(&self.incoming).await; // if this fails, the sweep removes the object
        self.store.space.noted(copied)
    }
}

impl Drop for S3Writer {
    fn drop(&mut self) {
        if let (Some(mut upload), Ok(runtime)) = (self.upload.take(), tokio::runtime::Handle::try_current()) {
            runtime.spawn(async move { upload.abort().await });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tokio::io::{AsyncReadExt as _, AsyncWriteExt as _};
    use tokio::net::TcpListener;

    /// A store whose quota is used up: it answers reads and refuses every write.
    async fn full_store() -> S3Artifacts {
        let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
        let endpoint = format!("http://{}", listener.local_addr().unwrap());
        tokio::spawn(async move {
            while let Ok((mut stream, _)) = listener.accept().await {
                tokio::spawn(async move {
                    let (mut text, mut part) = (Vec::new(), [0; 4096]);
                    while let Ok(n @ 1..) = stream.read(&mut part).await {
                        text.extend_from_slice(&part[..n]);
                        if text.windows(4).any(|w| w == b"\r\n\r\n") {
                            break;
                        }
                    }
                    let body = "<Error><Code>QuotaExceeded</Code><Message>full</Message></Error>";
                    let answer = if text.starts_with(b"PUT") {
                        format!(
                            "HTTP/1.1 403 Forbidden\r\ncontent-length: {}\r\nconnection: close\r\n\r\n{body}",
                            body.len()
                        )
                    } else {
                        "HTTP/1.1 404 Not Found\r\ncontent-length: 0\r\nconnection: close\r\n\r\n".to_owned()
                    };
                    let _ = stream.write_all(answer.as_bytes()).await;
                    // Reads the rest of the request, so that the answer is not lost.
                    while let Ok(1..) = stream.read(&mut part).await {}
                });
            }
        });
        let variables = [
            ("AWS_ENDPOINT_URL", endpoint.as_str()),
            ("AWS_ALLOW_HTTP", "true"),
            ("AWS_ACCESS_KEY_ID", "key"),
            ("AWS_SECRET_ACCESS_KEY", "secret"),
            ("AWS_REGION", "us-east-1"),
        ];
        let variables = variables.map(|(name, value)| (name.to_owned(), value.to_owned()));
        S3Artifacts::open_with("s3://bucket/prefix", variables).unwrap()
    }

    #[tokio::test]
    async fn a_full_bucket_is_not_ready_after_it_has_refused_a_blob() {
        let store = full_store().await;
        store.ping().await.unwrap();
        let blob = Bytes::from_static(b"mesh");
        let tenant = Tenant::new("default").unwrap();
        let put = store.put(&ArtifactKey::of(&tenant, &blob), blob).await;
        assert!(matches!(put, Err(JobError::StorageFull)), "{put:?}");
        assert!(matches!(store.ping().await, Err(JobError::StorageFull)));
    }
}
