-- claim_delivery
UPDATE webhook_deliveries SET attempts = attempts + 1, next_at = {now} + $2, wait_ms = $2 WHERE id = $1
