-- bound_wait_of_webhooks
UPDATE webhooks
SET next_at = {now} + wait_ms, busy_until = CASE WHEN busy_until > 0 THEN {now} + wait_ms ELSE 0 END
WHERE next_at > {now} + wait_ms
