-- list_changes
SELECT number AS seq, job_id, batch_id, state, at
FROM changes
WHERE tenant = $1 AND number > $2
ORDER BY number
LIMIT $3
