-- insert_batch
INSERT INTO batches (id, tenant, n_jobs, labels, external_ref, created_at) VALUES ($1, $2, $3, $4, $5, {now})
