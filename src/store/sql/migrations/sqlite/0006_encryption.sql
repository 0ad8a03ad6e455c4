-- The id of the key that encrypts blobs; no row if they are not encrypted.
CREATE TABLE encryption (
    one    INTEGER PRIMARY KEY CHECK (one = 1),
    key_id TEXT NOT NULL
) STRICT;
