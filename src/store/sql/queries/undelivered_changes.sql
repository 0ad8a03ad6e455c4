-- undelivered_changes
SELECT changes.seq, changes.number, changes.tenant, changes.job_id, changes.batch_id, changes.state, changes.at, jobs.traceparent
FROM changes
LEFT JOIN jobs ON jobs.id = changes.job_id
WHERE changes.seq > $1
ORDER BY changes.seq
LIMIT $2
