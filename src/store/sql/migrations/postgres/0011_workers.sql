-- Processes that run jobs, at work or idle, each with when it was last seen; one that is not seen for a minute has ended.
CREATE TABLE workers (
    name TEXT NOT NULL PRIMARY KEY,
    seen_at BIGINT NOT NULL
);
