-- meshes_to_purge
SELECT tenant, hash
FROM meshes
WHERE
    created_at <= {now} - $1
    AND ($3 = '' OR tenant = $3) AND $4 NOT LIKE '%,' || tenant || ',%'
    AND NOT EXISTS (SELECT 1 FROM job_artifacts AS a WHERE a.tenant = meshes.tenant AND a.path = meshes.path)
    AND NOT EXISTS (SELECT 1 FROM study_blobs AS b WHERE b.tenant = meshes.tenant AND b.path = meshes.path)
LIMIT $2
