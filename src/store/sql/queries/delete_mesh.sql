-- delete_mesh
DELETE FROM meshes WHERE tenant = $1 AND hash = $2
