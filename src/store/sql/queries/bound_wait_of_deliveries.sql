-- bound_wait_of_deliveries
UPDATE webhook_deliveries SET next_at = {now} + wait_ms WHERE state = 'pending' AND next_at > {now} + wait_ms
