-- lock_delivery
SELECT 1 FROM webhook_deliveries WHERE id = $1 AND state = 'pending' AND next_at <= {now} {skip_locked}
