-- set_study_blob
INSERT INTO study_blobs (study_id, name, tenant, path, n_bytes)
VALUES ($1, $2, $3, $4, $5)
ON CONFLICT (study_id, name) DO UPDATE SET path = excluded.path, n_bytes = excluded.n_bytes
