-- forget_referenced_candidates
DELETE FROM blob_candidates
WHERE EXISTS (
    SELECT 1 FROM job_artifacts AS a WHERE a.tenant = blob_candidates.tenant AND a.hash = blob_candidates.hash
)
