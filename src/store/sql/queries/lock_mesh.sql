-- lock_mesh
SELECT 1 FROM meshes WHERE tenant = $1 AND hash = $2 {for_update}
