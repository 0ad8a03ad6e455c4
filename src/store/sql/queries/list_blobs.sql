-- list_blobs
SELECT tenant, path, n_bytes
FROM (
    SELECT tenant, path, n_bytes
    FROM (
        SELECT DISTINCT tenant, path, n_bytes
        FROM job_artifacts
        WHERE (tenant, path) > ($1, $2)
        ORDER BY tenant, path
        LIMIT $3
    ) AS of_jobs
    UNION
    SELECT tenant, path, n_bytes
    FROM (
        SELECT tenant, path, n_bytes FROM meshes WHERE (tenant, path) > ($1, $2) ORDER BY tenant, path LIMIT $3
    ) AS of_uploads
    UNION
    SELECT tenant, path, n_bytes
    FROM (
        SELECT DISTINCT tenant, path, n_bytes
        FROM study_blobs
        WHERE (tenant, path) > ($1, $2)
        ORDER BY tenant, path
        LIMIT $3
    ) AS of_studies
) AS of_all
ORDER BY tenant, path
LIMIT $3
