-- retry_delivery
UPDATE webhook_deliveries
SET next_at = {now} + $2, wait_ms = $2, status = $3, error = $4
WHERE id = $1 AND state = 'pending'
