-- newest_change
SELECT COALESCE(MAX(number), 0) FROM changes WHERE tenant = $1
