-- study_blobs
SELECT name, path, n_bytes FROM study_blobs WHERE study_id = $1 AND tenant = $2 ORDER BY name
