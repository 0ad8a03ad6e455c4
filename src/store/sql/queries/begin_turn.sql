-- begin_turn
UPDATE webhooks SET next_at = {now} + $2, busy_until = {now} + $2, wait_ms = $2, served_at = {now} WHERE id = $1
