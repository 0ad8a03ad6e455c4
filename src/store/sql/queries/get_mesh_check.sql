-- get_mesh_check
SELECT outcome FROM mesh_checks WHERE tenant = $1 AND hash = $2 AND input_key = $3
