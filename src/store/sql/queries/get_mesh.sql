-- get_mesh
SELECT * FROM meshes WHERE tenant = $1 AND hash = $2
