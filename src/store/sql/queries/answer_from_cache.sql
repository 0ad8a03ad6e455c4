-- answer_from_cache
UPDATE jobs
SET
    state = 'succeeded',
    cached = TRUE,
    finished_at = {now},
    expires_at = {now} + $2,
    verdict = (SELECT first.verdict FROM jobs AS first WHERE first.id = $3)
WHERE id = $1
