-- seal_secret
UPDATE webhooks SET secret = $2 WHERE id = $1 AND secret = $3
