-- save_mesh_check
INSERT INTO mesh_checks (tenant, hash, input_key, outcome) VALUES ($1, $2, $3, $4)
ON CONFLICT (tenant, hash, input_key) DO UPDATE SET outcome = excluded.outcome
