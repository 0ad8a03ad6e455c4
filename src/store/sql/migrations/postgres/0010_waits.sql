-- How long what is stored in `next_at` waits, so that a clock that is set back makes no wait longer. What waits already may wait as
-- long as anything of its kind.
ALTER TABLE webhook_deliveries ADD COLUMN wait_ms BIGINT NOT NULL DEFAULT 43200000;
ALTER TABLE webhooks ADD COLUMN wait_ms BIGINT NOT NULL DEFAULT 3600000;
