-- The audit log: who did what, when, from where, with which outcome. Ids only. `hash` covers the row and the hash before it.
CREATE TABLE audit (
    position BIGINT PRIMARY KEY,
    at       BIGINT NOT NULL,
    tenant   TEXT,
    key_id   TEXT,
    action   TEXT NOT NULL,
    resource TEXT,
    address  TEXT,
    status   BIGINT,
    hash     TEXT NOT NULL
);

-- Its last row, so that a missing end is noticed.
CREATE TABLE audit_head (
    one      BIGINT PRIMARY KEY CHECK (one = 1),
    position BIGINT NOT NULL,
    hash     TEXT NOT NULL
);
INSERT INTO audit_head (one, position, hash)
VALUES (1, 0, '0000000000000000000000000000000000000000000000000000000000000000');

CREATE FUNCTION refuse_audit_change() RETURNS trigger LANGUAGE plpgsql AS
$$ BEGIN RAISE EXCEPTION 'the audit log is append-only'; END $$;
CREATE TRIGGER audit_keeps_rows BEFORE UPDATE OR DELETE ON audit
FOR EACH ROW EXECUTE FUNCTION refuse_audit_change();
CREATE TRIGGER audit_keeps_all BEFORE TRUNCATE ON audit
FOR EACH STATEMENT EXECUTE FUNCTION refuse_audit_change();
CREATE TRIGGER audit_grows BEFORE UPDATE ON audit_head
FOR EACH ROW WHEN (NEW.position < OLD.position) EXECUTE FUNCTION refuse_audit_change();
