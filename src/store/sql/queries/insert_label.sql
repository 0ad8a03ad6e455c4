-- insert_label
INSERT INTO job_labels (job_id, tenant, name, value, created_at)
SELECT id, tenant, $2, $3, created_at FROM jobs WHERE id = $1
