-- mesh_is_used
SELECT
    EXISTS (SELECT 1 FROM job_artifacts WHERE tenant = $1 AND path = $2)
    OR EXISTS (SELECT 1 FROM study_blobs WHERE tenant = $1 AND path = $2)
