-- count_meshes_to_purge
SELECT COUNT(*)
FROM meshes
WHERE
    created_at <= {now} - $1
    AND ($2 = '' OR tenant = $2) AND $3 NOT LIKE '%,' || tenant || ',%'
    AND NOT EXISTS (SELECT 1 FROM job_artifacts AS a WHERE a.tenant = meshes.tenant AND a.path = meshes.path)
    AND NOT EXISTS (SELECT 1 FROM study_blobs AS b WHERE b.tenant = meshes.tenant AND b.path = meshes.path)
