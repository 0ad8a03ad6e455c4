//! An S3 server in the test's process, on a temporary folder and a loopback port.

use hyper_util::rt::TokioIo;
use s3s::auth::SimpleAuth;
use s3s::config::{S3Config, StaticConfigProvider};
use s3s::service::S3ServiceBuilder;
use s3s_fs::FileSystem;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tempfile::TempDir;
use tokio::net::TcpListener;
use tokio::runtime::Runtime;

/// The only bucket.
pub(crate) const BUCKET: &str = "faults";
const KEY: &str = "test-key";
const SECRET: &str = "test-secret";

/// The server; it ends when this is dropped.
pub(crate) struct S3Server {
    port: u16,
    root: PathBuf,
    // A separate runtime, so that it answers while a test waits or blocks.
    runtime: Option<Runtime>,
    _folder: TempDir,
}

impl S3Server {
    pub(crate) fn start() -> Self {
        S3Server::start_under(&std::env::temp_dir())
    }

    /// A server that keeps its objects under `parent`, which may be a small disk.
    pub(crate) fn start_under(parent: &Path) -> Self {
        let folder = tempfile::tempdir_in(parent).unwrap();
        let root = folder.path().to_owned();
        fs::create_dir(root.join(BUCKET)).unwrap();
        let mut builder = S3ServiceBuilder::new(FileSystem::new(&root).unwrap());
        builder.set_auth(SimpleAuth::from_single(KEY, SECRET));
        // S3 refuses clients whose clocks are off by 15 minutes; some tests have such workers.
        let mut config = S3Config::default();
        config.presigned_url_max_skew_time_secs = 7_200;
        builder.set_config(Arc::new(StaticConfigProvider::new(Arc::new(config))));
        let service = builder.build();
        let runtime = tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build().unwrap();
        let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
        listener.set_nonblocking(true).unwrap();
        let port = listener.local_addr().unwrap().port();
        runtime.spawn(async move {
            let listener = TcpListener::from_std(listener).unwrap();
            while let Ok((stream, _)) = listener.accept().await {
                let service = service.clone();
                tokio::spawn(async move {
                    let connection = hyper_util::server::conn::auto::Builder::new(hyper_util::rt::TokioExecutor::new());
                    let _ = connection.http1_only().serve_connection(TokioIo::new(stream), service).await;
                });
            }
        });
        S3Server { port, root, runtime: Some(runtime), _folder: folder }
    }

    pub(crate) fn port(&self) -> u16 {
        self.port
    }

    /// Environment of a process that reaches the server through `port`.
    pub(crate) fn environment(port: u16) -> Vec<(&'static str, String)> {
        vec![
            ("HOMOLOG_ARTIFACTS_URL", format!("s3://{BUCKET}/blobs")),
            ("AWS_ENDPOINT_URL", format!("http://127.0.0.1:{port}")),
            ("AWS_ACCESS_KEY_ID", KEY.to_owned()),
            ("AWS_SECRET_ACCESS_KEY", SECRET.to_owned()),
            ("AWS_REGION", "us-east-1".to_owned()),
            ("AWS_ALLOW_HTTP", "true".to_owned()),
        ]
    }

    /// The folder of the bucket's objects.
    pub(crate) fn bucket(&self) -> PathBuf {
        self.root.join(BUCKET)
    }
}

impl Drop for S3Server {
    fn drop(&mut self) {
        if let Some(runtime) = self.runtime.take() {
            runtime.shutdown_background();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use object_store::aws::{AmazonS3Builder, S3ConditionalPut};
    use object_store::path::Path;
    use object_store::{ObjectStore, ObjectStoreExt, PutMode, PutOptions};

    #[tokio::test]
    async fn the_server_supports_what_the_blob_store_needs() {
        let _ = rustls::crypto::ring::default_provider().install_default();
        let server = S3Server::start();
        let store = AmazonS3Builder::new()
            .with_endpoint(format!("http://127.0.0.1:{}", server.port()))
            .with_allow_http(true)
            .with_bucket_name(BUCKET)
            .with_region("us-east-1")
            .with_access_key_id(KEY)
            .with_secret_access_key(SECRET)
            .with_conditional_put(S3ConditionalPut::ETagMatch)
            .build()
            .unwrap();
        let (one, two) = (Path::from("blobs/tenant/one"), Path::from("blobs/tenant/two"));
        store.put(&one, "first".into()).await.unwrap();
        assert_eq!(store.get(&one).await.unwrap().bytes().await.unwrap(), "first");
        assert_eq!(store.get_range(&one, 1..3).await.unwrap(), "ir");
        assert_eq!(store.head(&one).await.unwrap().size, 5);
        let only_new = PutOptions { mode: PutMode::Create, ..PutOptions::default() };
        let refused = store.put_opts(&one, "second".into(), only_new.clone()).await;
        assert!(matches!(refused, Err(object_store::Error::AlreadyExists { .. })), "{refused:?}");
        store.copy(&one, &two).await.unwrap();
        let mut parts = store.put_multipart(&one).await.unwrap();
        parts.put_part(vec![b'x'; 5 << 20].into()).await.unwrap();
        parts.put_part(vec![b'y'; 10].into()).await.unwrap();
        parts.complete().await.unwrap();
        assert_eq!(store.head(&one).await.unwrap().size, (5 << 20) + 10);
        let listed = store.list_with_delimiter(Some(&Path::from("blobs/tenant"))).await.unwrap();
        assert_eq!(listed.objects.len(), 2);
        store.delete(&one).await.unwrap();
        store.delete(&one).await.unwrap();
        assert!(matches!(store.get(&one).await, Err(object_store::Error::NotFound { .. })));
    }
}
