-- find_cached
SELECT id
FROM jobs
WHERE tenant = $1 AND cache_key = $2 AND state = 'succeeded' AND purged_at IS NULL
ORDER BY created_at, id
LIMIT 1
