-- Short-lived permissions to read one resource, by the hash of the ticket.
CREATE TABLE tickets (
    hash       TEXT COLLATE "C" PRIMARY KEY,
    tenant     TEXT COLLATE "C" NOT NULL,
    key_id     TEXT COLLATE "C",
    path       TEXT COLLATE "C" NOT NULL,
    expires_at BIGINT NOT NULL
);
CREATE INDEX tickets_of_tenant ON tickets (tenant, expires_at);
CREATE INDEX tickets_by_time ON tickets (expires_at);
