-- webhook_position
SELECT value FROM counters WHERE name = 'webhooks'
