-- list_jobs
-- Reads along an index that has the jobs in the order of the list: the index of the first label, or one on the jobs. In
-- SQLite, CROSS JOIN fixes the order of the tables.
SELECT job_records.*
FROM job_labels AS first_label CROSS JOIN job_records -- when by_label
FROM job_records -- when by_job
WHERE
    job_records.tenant = :tenant
    AND method <> 'study'
    AND first_label.tenant = :tenant AND first_label.name = :label_a AND first_label.value = :value_a -- when by_label
    AND job_records.id = first_label.job_id -- when by_label
    AND state = :state -- when state
    AND method = :method -- when method
    AND external_ref = :reference -- when reference
    AND batch_id = :batch -- when batch
    AND study_id = :study -- when study
    AND EXISTS (SELECT 1 FROM job_labels WHERE job_id = job_records.id AND name = :label_a AND value = :value_a) -- when label_a
    AND EXISTS (SELECT 1 FROM job_labels WHERE job_id = job_records.id AND name = :label_b AND value = :value_b) -- when label_b
    AND EXISTS (SELECT 1 FROM job_labels WHERE job_id = job_records.id AND name = :label_c AND value = :value_c) -- when label_c
    AND EXISTS (SELECT 1 FROM job_labels WHERE job_id = job_records.id AND name = :label_d AND value = :value_d) -- when label_d
    AND {created_at} >= :created_from -- when created_from
    AND {created_at} < :created_before -- when created_before
    AND ({created_at}, {id}) < (:after_time, :after_id) -- when after_newest
    AND ({created_at}, {id}) > (:after_time, :after_id) -- when after_oldest
ORDER BY {created_at} DESC, {id} DESC -- when newest
ORDER BY {created_at}, {id} -- when oldest
LIMIT :size
