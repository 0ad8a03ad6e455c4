-- jobs_to_purge
SELECT id
FROM jobs
WHERE finished_at IS NOT NULL AND finished_at <= {now} - $1
ORDER BY finished_at
LIMIT $2
