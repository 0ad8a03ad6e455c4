-- hold_blob
INSERT INTO blob_holds (holder, tenant, hash, expires_at)
VALUES (?1, ?2, ?3, CAST(unixepoch('subsec') * 1000 AS INTEGER) + ?4)
ON CONFLICT DO UPDATE SET expires_at = excluded.expires_at
