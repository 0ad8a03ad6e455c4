-- batch_counts
SELECT state, COUNT(*) AS n FROM jobs WHERE batch_id = $1 GROUP BY state
