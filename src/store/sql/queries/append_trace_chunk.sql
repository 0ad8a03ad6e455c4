-- append_trace_chunk
INSERT INTO trace_chunks (job_id, first_seq, last_seq, lease_epoch, points) VALUES ($1, $2, $3, $4, $5)
