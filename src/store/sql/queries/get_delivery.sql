-- get_delivery
SELECT * FROM webhook_deliveries WHERE id = $1
