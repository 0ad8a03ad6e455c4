-- hold_blob
INSERT INTO blob_holds (holder, tenant, path, expires_at)
VALUES ($1, $2, $3, {now} + $4)
ON CONFLICT (holder, tenant, path) DO UPDATE SET expires_at = excluded.expires_at
