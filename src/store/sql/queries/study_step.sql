-- study_step
SELECT state, error FROM jobs WHERE id = $1
