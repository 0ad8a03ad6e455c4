-- list_changes
SELECT seq, job_id, batch_id, state, at
FROM changes
WHERE tenant = $1 AND seq > $2
ORDER BY seq
LIMIT $3
