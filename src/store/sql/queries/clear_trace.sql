-- clear_trace
DELETE FROM trace_chunks WHERE job_id = $1
