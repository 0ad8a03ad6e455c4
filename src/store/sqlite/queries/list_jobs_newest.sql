-- list_jobs_newest
SELECT *
FROM job_records
WHERE
    tenant = ?1
    AND (?2 = '[]' OR state IN (SELECT value FROM json_each(?2)))
    AND (?3 IS NULL OR method = ?3)
    AND (?4 IS NULL OR external_ref = ?4)
    AND (?5 IS NULL OR (created_at, id) < (?5, ?6))
ORDER BY created_at DESC, id DESC
LIMIT ?7
