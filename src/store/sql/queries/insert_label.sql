-- insert_label
INSERT INTO job_labels (job_id, tenant, name, value) VALUES ($1, $2, $3, $4)
