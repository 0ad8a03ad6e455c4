-- heartbeat
UPDATE jobs
SET lease_expires_at = {now} + $3
WHERE id = $1 AND lease_epoch = $2 AND state = 'running'
RETURNING cancel_requested
