-- trace_chunks_after
SELECT points FROM trace_chunks WHERE job_id = $1 AND last_seq > $2 ORDER BY first_seq LIMIT $3
