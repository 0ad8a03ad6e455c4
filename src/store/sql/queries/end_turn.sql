-- end_turn
UPDATE webhooks SET next_at = {now} + $3, busy_until = 0, wait_ms = $3, failures = $2 WHERE id = $1
