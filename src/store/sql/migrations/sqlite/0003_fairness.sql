-- Turns of tenants, numbers by tenant, webhooks that do not wait for each other, and keys that lapse with their process.

-- Each claim of a job takes a turn: tenants that wait are served in the order of `due`, and a turn adds to it the less the
-- greater the tenant's weight. `started` is where the tenant's last turn began; the greatest of all is the present.
CREATE TABLE turns (
    tenant  TEXT PRIMARY KEY,
    started INTEGER NOT NULL,
    due     INTEGER NOT NULL
) STRICT, WITHOUT ROWID;

DROP INDEX jobs_queue_of_tenant;
CREATE INDEX jobs_queue_of_tenant ON jobs (tenant, priority DESC, created_at, id) WHERE state = 'queued';

-- `seq` counts the changes of all tenants, `number` those of one, which its clients see.
ALTER TABLE changes ADD COLUMN number INTEGER;
UPDATE changes SET number = seq;
CREATE INDEX changes_by_number ON changes (tenant, number);
CREATE INDEX changes_without_number ON changes (id) WHERE number IS NULL;
-- Where the numbers of each tenant go on: clients hold positions from before.
INSERT INTO counters (name, value) SELECT 'changes before', value FROM counters WHERE name = 'changes';

-- No attempt before `next_at`: another process is at it until `busy_until`, or the receiver has failed `failures` times.
ALTER TABLE webhooks ADD COLUMN next_at INTEGER NOT NULL DEFAULT 0;
ALTER TABLE webhooks ADD COLUMN busy_until INTEGER NOT NULL DEFAULT 0;
ALTER TABLE webhooks ADD COLUMN served_at INTEGER NOT NULL DEFAULT 0;
ALTER TABLE webhooks ADD COLUMN failures INTEGER NOT NULL DEFAULT 0;

ALTER TABLE webhook_deliveries ADD COLUMN traceparent TEXT;
CREATE INDEX webhook_deliveries_waiting ON webhook_deliveries (webhook_id, next_at) WHERE state = 'pending';

-- Batches were once taken without the limits of single jobs; a list of such rows takes all memory. No value within the limits
-- is changed.
UPDATE jobs SET external_ref = substr(external_ref, 1, 50) WHERE length(external_ref) > 200;
UPDATE jobs SET labels = '{}' WHERE length(labels) > 200000;
UPDATE batches SET external_ref = substr(external_ref, 1, 50) WHERE length(external_ref) > 200;
UPDATE batches SET labels = '{}' WHERE length(labels) > 200000;
DELETE FROM job_labels WHERE length(name) > 256 OR length(value) > 256;
