-- queue_length
SELECT COUNT(*)
FROM (SELECT 1 FROM jobs WHERE state = 'queued' AND tenant = $1 LIMIT $2) AS waiting
