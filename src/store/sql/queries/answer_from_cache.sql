-- answer_from_cache
UPDATE jobs
SET state = 'succeeded', cached = TRUE, finished_at = {now}, expires_at = {now} + $2
WHERE id = $1
