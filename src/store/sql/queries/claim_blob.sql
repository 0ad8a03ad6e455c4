-- claim_blob
INSERT INTO blobs (tenant, path) VALUES ($1, $2)
ON CONFLICT (tenant, path) DO UPDATE SET tenant = excluded.tenant
RETURNING removing_since
