-- active_studies
SELECT id, tenant FROM studies WHERE state IN ('queued', 'matching', 'modelling') ORDER BY created_at, id LIMIT $1
