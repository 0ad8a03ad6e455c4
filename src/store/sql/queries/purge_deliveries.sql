-- purge_deliveries
DELETE FROM webhook_deliveries WHERE created_at <= {now} - $1
