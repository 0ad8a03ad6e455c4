-- lock_turns
INSERT INTO turns (tenant, started, due) VALUES ($1, 0, 0)
ON CONFLICT (tenant) DO UPDATE SET tenant = excluded.tenant
