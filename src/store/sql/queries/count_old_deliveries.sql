-- count_old_deliveries
SELECT COUNT(*) FROM webhook_deliveries WHERE created_at <= {now} - $1
