-- stored_bytes
-- Jobs that share a blob, and the upload that it was, count once.
SELECT CAST(COALESCE(SUM(n_bytes), 0) AS BIGINT)
FROM (
    SELECT path, n_bytes FROM meshes WHERE tenant = $1
    UNION
    SELECT path, n_bytes FROM job_artifacts WHERE tenant = $1
    UNION
    SELECT path, n_bytes FROM study_blobs WHERE tenant = $1
) AS stored
