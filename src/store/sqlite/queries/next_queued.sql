-- next_queued
SELECT id
FROM jobs
WHERE state = 'queued' AND scheduled_at <= CAST(unixepoch('subsec') * 1000 AS INTEGER)
ORDER BY priority DESC, created_at, id
LIMIT 1
