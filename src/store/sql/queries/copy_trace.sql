-- copy_trace
INSERT INTO trace_chunks (job_id, first_seq, last_seq, lease_epoch, points)
SELECT $1, first_seq, last_seq, lease_epoch, points FROM trace_chunks WHERE job_id = $2
