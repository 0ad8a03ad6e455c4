-- undelivered_changes
SELECT seq, tenant, job_id, batch_id, state, at FROM changes WHERE seq > $1 ORDER BY seq LIMIT $2
