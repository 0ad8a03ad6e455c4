-- unreferenced_candidates
SELECT tenant, hash
FROM blob_candidates AS candidate
WHERE
    NOT EXISTS (SELECT 1 FROM job_artifacts AS a WHERE a.tenant = candidate.tenant AND a.hash = candidate.hash)
    AND NOT EXISTS (SELECT 1 FROM blob_holds AS h WHERE h.tenant = candidate.tenant AND h.hash = candidate.hash)
LIMIT ?1
