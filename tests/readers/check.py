"""Opens what homolog wrote with the programs that its users have, and compares counts and values.

Usage: check.py FOLDER. The folder has files named PART.FORMAT, with "-" for "/" in the part, as the test that calls this
wrote them. Every file must be known here; what a part holds is compared with the JSON of that part.
"""

import io
import json
import sys
from pathlib import Path

import meshio
import nibabel
import numpy as np
import pyarrow.feather
import pyarrow.parquet
import SimpleITK
import trimesh
import vtk
from vtk.util.numpy_support import vtk_to_numpy

REASONS = ["none", "residual", "neighborhood", "both", "no_counterpart"]
SINGLE = 2e-6  # relative error of single precision, with room


def triangulated(faces):
    """Quads as two triangles, in no particular order of faces."""
    faces = np.asarray(faces)
    if faces.shape[1] == 3:
        return faces
    return np.concatenate([faces[:, [0, 1, 2]], faces[:, [0, 2, 3]]])


def face_sets(faces):
    return {frozenset(map(int, face)) for face in faces}


class Surface:
    """What a reader found: points, faces (of one size), and arrays by name."""

    def __init__(self, points, faces, arrays):
        self.points, self.faces, self.arrays = np.asarray(points, float), np.asarray(faces), arrays


def of_vtk(reader, path):
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(path.name))
    reader.SetFileName(str(path))
    reader.Update()
    assert not errors, f"VTK reports an error for {errors}"
    data = reader.GetOutput()
    polygons = data.GetPolys()
    corners = vtk_to_numpy(polygons.GetConnectivityArray())
    faces = corners.reshape(polygons.GetNumberOfCells(), -1)
    values = data.GetPointData()
    arrays = {values.GetArrayName(k): vtk_to_numpy(values.GetArray(k)) for k in range(values.GetNumberOfArrays())}
    return Surface(vtk_to_numpy(data.GetPoints().GetData()), faces, arrays)


def of_meshio(path, file_format=None):
    mesh = meshio.read(path, file_format)
    (block,) = [block for block in mesh.cells if block.type in ("triangle", "quad")]
    return Surface(mesh.points, block.data, mesh.point_data)


def of_gifti(path):
    image = nibabel.load(path)
    points, faces = image.agg_data(("pointset", "triangle"))
    arrays = {}
    for array in image.darrays:
        if array.meta.get("Name") and array.intent not in (1008, 1009):
            arrays[array.meta["Name"]] = array.data
    return Surface(points, faces, arrays)


def of_trimesh(path):
    mesh = trimesh.load(path, process=False, force="mesh")
    return Surface(mesh.vertices, mesh.faces, {})


def of_glb(path):
    """The surfaces of a scene by name, with colors, in mm and RAS."""
    scene = trimesh.load(path, process=False, force="scene")
    found = {}
    for node in scene.graph.nodes_geometry:
        transform, name = scene.graph[node]
        mesh = scene.geometry[name]
        # Meters, y up.
        x, y, z = (mesh.vertices @ transform[:3, :3].T + transform[:3, 3]).T * 1000
        surface = Surface(np.stack([x, -z, y], axis=1), mesh.faces, {})
        # Beside a material, trimesh keeps colors as an attribute.
        colors = getattr(mesh.visual, "vertex_attributes", {}).get("color")
        surface.colors = None if colors is None else np.asarray(colors)[:, :3].astype(float)
        found[node] = surface
    return found


def readings(path):
    """The file as each program reads it: name of the program, surface."""
    kind = path.name.split(".", 1)[1]
    if kind == "ply":
        yield "trimesh", of_trimesh(path)
        yield "meshio", of_meshio(path)
        yield "VTK", of_vtk(vtk.vtkPLYReader(), path)
    elif kind == "vtk":
        yield "VTK", of_vtk(vtk.vtkPolyDataReader(), path)
    elif kind == "vtp":
        yield "VTK", of_vtk(vtk.vtkXMLPolyDataReader(), path)
    elif kind in ("gifti", "surf.gii"):
        gifti = path.with_name(path.name.replace(".gifti", ".surf.gii"))
        gifti.write_bytes(path.read_bytes())
        yield "nibabel", of_gifti(gifti)
    elif kind == "stl":
        yield "trimesh", of_trimesh(path)
        yield "VTK", of_vtk(vtk.vtkSTLReader(), path)
    elif kind == "glb":
        for name, surface in of_glb(path).items():
            if name not in ("target", "source") or path.name.startswith("surfaces"):
                yield "trimesh", surface
    else:
        raise AssertionError(f"{path.name}: no reader for this surface")


def same_surface(path, expected):
    """All programs read the points and the faces of `expected`; returns the arrays that they read."""
    arrays = {}
    for program, found in readings(path):
        where = f"{path.name} in {program}"
        if path.suffix == ".stl":
            # A format without shared vertices.
            assert len(found.faces) == len(triangulated(expected.faces)), where
            box = [expected.points.min(0), expected.points.max(0)]
            assert np.allclose([found.points.min(0), found.points.max(0)], box, rtol=SINGLE, atol=1e-4), where
            continue
        scale = np.abs(expected.points).max()
        assert found.points.shape == expected.points.shape, where
        assert np.allclose(found.points, expected.points, rtol=0, atol=SINGLE * scale), where
        faces = expected.faces
        if found.faces.shape[1] == 3:
            faces = triangulated(faces)
            found.faces = triangulated(found.faces)
        assert len(found.faces) == len(faces), where
        if found.faces.shape[1] == 3 and expected.faces.shape[1] == 4:
            # A quad may be split along either diagonal.
            whole = [set(map(int, face)) for face in expected.faces]
            around = {}
            for k, face in enumerate(whole):
                for vertex in face:
                    around.setdefault(vertex, set()).add(k)
            for face in found.faces:
                assert set.intersection(*[around[int(v)] for v in face]), where
        else:
            assert face_sets(found.faces) == face_sets(faces), where
        # What a program skips is not wrong, as long as another keeps it.
        arrays.update({name: np.asarray(values) for name, values in found.arrays.items()})
    return arrays


def same_values(where, found, expected, single=False):
    """The columns of a table, or the arrays of a surface, have the values of `expected`."""
    missing = set(expected) - set(found)
    assert not missing, f"{where}: no {missing}"
    for name, values in expected.items():
        values, other = np.asarray(values, float), np.asarray(found[name], float).reshape(np.shape(values))
        tolerance = SINGLE if single else 1e-12
        assert np.allclose(other, values, rtol=tolerance, atol=tolerance), f"{where}: {name}"


def flat(columns):
    """Columns of numbers: reasons as their codes, triples as three columns."""
    found = {}
    for name, values in columns.items():
        if name == "inverse":
            continue
        if name == "outlier" and len(values) and isinstance(values[0], str):
            values = [REASONS.index(word) for word in values]
        values = np.asarray(values)
        if values.ndim == 2:
            found.update({f"{name}_{k}": values[:, k] for k in range(3)})
        else:
            found[name] = values
    return found


def of_csv(path):
    lines = path.read_text().splitlines()
    words = [line.split(",") for line in lines[1:]]
    numbers = {"true": 1, "false": 0, **{word: k for k, word in enumerate(REASONS)}}
    return {
        name: np.array([float(numbers.get(row[k], row[k])) for row in words])
        for k, name in enumerate(lines[0].split(","))
    }


def of_structured(array):
    return flat({name: array[name] for name in array.dtype.names})


def of_table(path):
    kind = path.name.split(".", 1)[1]
    if kind == "csv":
        return of_csv(path)
    if kind == "npy":
        return of_structured(np.load(path))
    if kind == "npz":
        with np.load(path) as arrays:
            return flat({name: arrays[name] for name in arrays.files})
    if kind == "arrow":
        table = pyarrow.feather.read_table(path)
        return {name: table[name].to_numpy() for name in table.column_names}
    if kind == "parquet":
        table = pyarrow.parquet.read_table(path)
        assert table.num_rows == pyarrow.parquet.read_metadata(path).num_rows
        return {name: table[name].to_numpy() for name in table.column_names}
    return None


def check_colors(path, columns, surface):
    """Both surfaces are there, and vertices have nearly the color of their target vertices."""
    found = of_glb(path)
    moved, fixed = ("target", "source") if "inverse" in path.name else ("source", "target")
    assert set(found) == {"source", "target"}, f"{path.name}: {set(found)}"
    assert found[moved].points.shape == surface.points.shape, path.name
    at, target = columns["source"], columns["target"]
    difference = np.abs(found[moved].colors[at] - found[fixed].colors[target]).max(1)
    paired = columns["outlier"] != REASONS.index("no_counterpart")
    assert np.median(difference[paired]) < 25, f"{path.name}: {np.median(difference[paired])}"


def check_correspondences(folder, part, surface):
    columns = flat(json.loads((folder / f"{part}.json").read_text()))
    n = len(columns["source"])
    at = columns["source"]
    for path in sorted(folder.glob(f"{part}.*")):
        if path.suffix == ".json":
            continue
        table = of_table(path)
        if table is not None:
            assert len(table["source"]) == n, path.name
            same_values(path.name, table, columns)
            continue
        if path.suffix == ".glb":
            check_colors(path, columns, surface)
            continue
        arrays = same_surface(path, surface)
        names = ["target", "confidence", "inlier", "spread_mm", "outlier"]
        names += [f"{name}_{k}" for name in ("triangle", "barycentric") for k in range(3)]
        named = {name: columns[name] for name in names}
        same_values(path.name, {name: values[at] for name, values in arrays.items()}, named, "gii" in path.name or "gifti" in path.name)


def check_warped(folder, part, connectivity):
    """Every form of a bent surface: the points of its PLY, the faces of the surface that was bent, the values of its CSV."""
    columns = of_csv(folder / f"{part}.csv")
    del columns["vertex"]
    points = of_trimesh(folder / f"{part}.ply").points
    expected = Surface(points, connectivity.faces, {})
    assert not np.allclose(points, connectivity.points), "it is bent"
    for path in sorted(folder.glob(f"{part}.*")):
        if path.suffix == ".csv":
            continue
        if path.suffix == ".json":
            same_values(path.name, json.loads(path.read_text()), columns)
            continue
        table = of_table(path)
        if table is not None:
            same_values(path.name, table, columns)
            continue
        arrays = same_surface(path, expected)
        if path.suffix not in (".stl", ".glb"):
            same_values(path.name, arrays, columns, "gii" in path.name or "gifti" in path.name)


def check_transform(folder, source, aligned):
    matrix = np.array(json.loads((folder / "transform.json").read_text())["matrix"])
    assert np.allclose(source.points @ matrix[:3, :3].T + matrix[:3, 3], aligned.points, atol=1e-9)
    assert np.array_equal(np.loadtxt(folder / "transform.text"), matrix)
    lines = (folder / "transform.lta").read_text().splitlines()
    begin = lines.index("1 4 4") + 1
    assert np.allclose(np.loadtxt(io.StringIO("\n".join(lines[begin : begin + 4]))), matrix, rtol=1e-12)
    assert lines[0].split() [:3] == ["type", "=", "1"], "RAS to RAS"
    # ITK maps points of the target to the source, both in LPS.
    read = SimpleITK.ReadTransform(str(folder / "transform.tfm"))
    flip = np.array([-1.0, -1.0, 1.0])
    for before, after in zip(source.points[::50], aligned.points[::50]):
        assert np.allclose(np.array(read.TransformPoint((after * flip).tolist())) * flip, before, atol=1e-6)


def as_from_the_service(folder):
    """The files of the command line under the names of the service, with the parts of its result document."""
    for which in ("source", "target"):
        (folder / f"{which}.ply").rename(folder / f"surfaces-{which}.ply")
    result = json.loads((folder / "result.json").read_text())
    (folder / "correspondences.json").write_text(json.dumps(result["correspondences"]))
    if "inverse" in result["correspondences"]:
        (folder / "correspondences-inverse.json").write_text(json.dumps(result["correspondences"]["inverse"]))
    matrix = np.array(result["transform"]["matrix"])
    source, aligned = (of_meshio(folder / f"{name}.ply").points for name in ("surfaces-source", "aligned"))
    assert np.allclose(source @ matrix[:3, :3].T + matrix[:3, 3], aligned, atol=1e-9)


def main(folder):
    from_service = (folder / "transform.json").exists()
    if not from_service:
        as_from_the_service(folder)
    surfaces = {}
    for part in ("surfaces-source", "surfaces-target", "aligned"):
        # trimesh splits quads; meshio keeps them.
        surfaces[part] = of_meshio(folder / f"{part}.ply")
        for path in sorted(folder.glob(f"{part}.*")):
            same_surface(path, surfaces[part])
    if from_service:
        check_transform(folder, surfaces["surfaces-source"], surfaces["aligned"])
    check_correspondences(folder, "correspondences", surfaces["surfaces-source"])
    check_warped(folder, "warped", surfaces["surfaces-source"])
    if (folder / "correspondences-inverse.json").exists():
        check_correspondences(folder, "correspondences-inverse", surfaces["surfaces-target"])
    if (folder / "warped-inverse.csv").exists():
        check_warped(folder, "warped-inverse", surfaces["surfaces-target"])
    n_files = sum(1 for path in folder.iterdir() if path.name.count(".") >= 1)
    print(f"{n_files} files read as written")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
