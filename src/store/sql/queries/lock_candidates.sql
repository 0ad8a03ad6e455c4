-- lock_candidates
SELECT tenant, path
FROM blobs
WHERE is_candidate AND (removing_since IS NULL OR removing_since < {now} - $2)
ORDER BY tenant, path
LIMIT $1
{skip_locked}
