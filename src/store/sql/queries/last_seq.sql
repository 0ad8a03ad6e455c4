-- last_seq
SELECT COALESCE(MAX(last_seq), 0) FROM trace_chunks WHERE job_id = $1
