-- end_delivery
UPDATE webhook_deliveries SET state = $2, status = $3, error = $4, ended_at = {now} WHERE id = $1 AND state = 'pending'
