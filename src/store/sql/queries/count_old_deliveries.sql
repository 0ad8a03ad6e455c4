-- count_old_deliveries
SELECT COUNT(*) FROM webhook_deliveries WHERE created_at <= {now} - $1 AND ($2 = '' OR tenant = $2) AND $3 NOT LIKE '%,' || tenant || ',%'
