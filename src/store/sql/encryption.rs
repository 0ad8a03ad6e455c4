//! The id of the key that encrypts the blobs of this service, so that no process starts without the key and stores
//! blobs unencrypted; and the mark that identifies the blob store of this service.

use super::argument::bind;
use super::dialect::sql;
use super::{SqlStore, StoredBlob};
use crate::jobs::JobError;

impl SqlStore {
    /// The id of the key that encrypts blobs; `None` if they are not encrypted.
    ///
    /// # Errors
    /// [`JobError::Unavailable`].
    pub(crate) async fn encryption_key(&self) -> Result<Option<String>, JobError> {
        self.database.reader().await?.value(sql!("encryption_key"), bind![]).await
    }

    /// Records the id of the key that encrypts blobs from now on.
    ///
    /// # Errors
    /// [`JobError::Unavailable`].
    pub(crate) async fn set_encryption_key(&self, id: &str) -> Result<(), JobError> {
        let set =
            self.database.transaction(async |session| session.execute(sql!("set_encryption_key"), bind![id]).await);
        set.await.map(|_| ())
    }

    /// The mark that the blob store of this database holds; `None` before the first process has chosen one.
    ///
    /// # Errors
    /// [`JobError::Unavailable`].
    pub(crate) async fn blob_store_mark(&self) -> Result<Option<String>, JobError> {
        self.database.reader().await?.value(sql!("blob_store_mark"), bind![]).await
    }

    /// Sets the mark unless one is set. Returns whether it did.
    ///
    /// # Errors
    /// [`JobError::Unavailable`].
    pub(crate) async fn set_blob_store_mark(&self, mark: &str) -> Result<bool, JobError> {
        let set =
            self.database.transaction(async |session| session.execute(sql!("set_blob_store_mark"), bind![mark]).await);
        Ok(set.await? == 1)
    }

    /// Whether a job, an upload or a process refers to a blob.
    ///
    /// # Errors
    /// [`JobError::Unavailable`].
    pub(crate) async fn blob_is_needed(&self, blob: &StoredBlob) -> Result<bool, JobError> {
        let needed =
            self.database.reader().await?.value(sql!("blob_is_needed"), bind![&blob.tenant, &blob.path]).await?;
        Ok(needed == Some(true))
    }
}
