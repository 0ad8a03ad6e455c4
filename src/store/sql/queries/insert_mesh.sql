-- insert_mesh
INSERT INTO meshes (tenant, hash, path, n_bytes, name_hint, created_at)
VALUES ($1, $2, $3, $4, $5, {now})
ON CONFLICT (tenant, hash) DO NOTHING
