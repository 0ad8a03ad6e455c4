-- Short-lived permissions to read one resource, by the hash of the ticket.
CREATE TABLE tickets (
    hash       TEXT PRIMARY KEY,
    tenant     TEXT NOT NULL,
    key_id     TEXT,
    path       TEXT NOT NULL,
    expires_at INTEGER NOT NULL
) STRICT;
CREATE INDEX tickets_of_tenant ON tickets (tenant, expires_at);
CREATE INDEX tickets_by_time ON tickets (expires_at);
