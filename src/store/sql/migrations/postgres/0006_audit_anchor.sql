-- Where the audit log begins: the position and hash of the last row that was pruned. Rows up to it may be removed.
CREATE TABLE audit_anchor (
    one      BIGINT PRIMARY KEY CHECK (one = 1),
    position BIGINT NOT NULL,
    hash     TEXT NOT NULL
);
INSERT INTO audit_anchor (one, position, hash)
VALUES (1, 0, '0000000000000000000000000000000000000000000000000000000000000000');

CREATE FUNCTION refuse_audit_removal() RETURNS trigger LANGUAGE plpgsql AS
$$ BEGIN
    IF OLD.position > (SELECT position FROM audit_anchor) THEN
        RAISE EXCEPTION 'the audit log is append-only';
    END IF;
    RETURN OLD;
END $$;
DROP TRIGGER audit_keeps_rows ON audit;
CREATE TRIGGER audit_keeps_rows BEFORE DELETE ON audit
FOR EACH ROW EXECUTE FUNCTION refuse_audit_removal();
CREATE TRIGGER audit_keeps_content BEFORE UPDATE ON audit
FOR EACH ROW EXECUTE FUNCTION refuse_audit_change();
CREATE TRIGGER audit_anchor_advances BEFORE UPDATE ON audit_anchor
FOR EACH ROW WHEN (NEW.position < OLD.position) EXECUTE FUNCTION refuse_audit_change();
CREATE TRIGGER audit_anchor_stays BEFORE DELETE ON audit_anchor
FOR EACH ROW EXECUTE FUNCTION refuse_audit_change();
