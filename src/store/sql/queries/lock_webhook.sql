-- lock_webhook
SELECT url, secret, is_enabled, failures FROM webhooks WHERE id = $1 AND next_at <= {now} {skip_locked}
