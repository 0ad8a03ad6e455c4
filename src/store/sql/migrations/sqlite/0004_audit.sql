-- The audit log: who did what, when, from where, with which outcome. Ids only. `hash` covers the row and the hash before it.
CREATE TABLE audit (
    position INTEGER PRIMARY KEY,
    at       INTEGER NOT NULL,
    tenant   TEXT,
    key_id   TEXT,
    action   TEXT NOT NULL,
    resource TEXT,
    address  TEXT,
    status   INTEGER,
    hash     TEXT NOT NULL
) STRICT;

-- Its last row, so that a missing end is noticed.
CREATE TABLE audit_head (
    one      INTEGER PRIMARY KEY CHECK (one = 1),
    position INTEGER NOT NULL,
    hash     TEXT NOT NULL
) STRICT;
INSERT INTO audit_head (one, position, hash)
VALUES (1, 0, '0000000000000000000000000000000000000000000000000000000000000000');

CREATE TRIGGER audit_keeps_rows BEFORE DELETE ON audit
BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;
CREATE TRIGGER audit_keeps_content BEFORE UPDATE ON audit
BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;
CREATE TRIGGER audit_grows BEFORE UPDATE ON audit_head WHEN NEW.position < OLD.position
BEGIN SELECT RAISE(ABORT, 'the audit log is append-only'); END;
