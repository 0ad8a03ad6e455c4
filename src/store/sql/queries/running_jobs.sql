-- running_jobs
SELECT COUNT(*)
FROM (SELECT 1 FROM jobs WHERE state = 'running' AND tenant = $1 LIMIT $2) AS running
