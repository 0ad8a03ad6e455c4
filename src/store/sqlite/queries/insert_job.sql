-- insert_job
INSERT INTO jobs (
    id, tenant, state, method, method_version, parameters, source, target, priority, labels, external_ref,
    max_attempts, created_at, scheduled_at
)
VALUES (
    ?1, ?2, 'queued', ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11,
    CAST(unixepoch('subsec') * 1000 AS INTEGER), CAST(unixepoch('subsec') * 1000 AS INTEGER)
)
