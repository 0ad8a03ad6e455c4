"""What a file holds, by each of the other programs and by homolog: area and volume of a surface, or the voxels of each label.

A measure is a dict: {"area", "volume"} in mm² and mm³ (volume only of closed surfaces), or {"dims", "voxel_mm3", "counts"}.
"""
import concurrent.futures
import json
import multiprocessing
import os
import subprocess
import sys
import warnings

SECONDS = 60
SURFACES = {
    "gii": ["nibabel"],
    "freesurfer": ["nibabel"],
    "ply": ["trimesh", "vtk"],
    "stl": ["trimesh", "vtk"],
    "obj": ["trimesh", "vtk"],
    "off": ["trimesh", "meshio"],
    "vtk": ["vtk"],
    "vtp": ["vtk"],
}
VOLUMES = {
    "nii": ["nibabel", "simpleitk"],
    "mgz": ["nibabel"],
    "nrrd": ["pynrrd", "simpleitk"],
    "mha": ["simpleitk"],
    "dcm": ["highdicom"],
}


def readers(kind):
    return SURFACES.get(kind) or VOLUMES[kind]


def surface(points, faces):
    """Area and, if every edge has two faces, volume; faces are lists of corners, split into fans."""
    import numpy

    points = numpy.asarray(points, dtype=float).reshape(-1, 3)
    fans = [(f[0], f[k], f[k + 1]) for f in faces for k in range(1, len(f) - 1)] if not isinstance(faces, numpy.ndarray) else faces
    triangles = numpy.asarray(fans, dtype=numpy.int64).reshape(-1, 3)
    if len(triangles) == 0:
        raise ValueError("no faces")
    if triangles.min() < 0 or triangles.max() >= len(points):
        raise ValueError("a face refers to no vertex")
    used = numpy.unique(triangles)
    if not numpy.isfinite(points[used]).all():
        raise ValueError("a coordinate is not finite")
    a, b, c = (points[triangles[:, k]] for k in range(3))
    area = float(numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1).sum() / 2)
    # By position, since formats without shared vertices repeat them.
    _, place = numpy.unique(points, axis=0, return_inverse=True)
    corners = place.reshape(-1)[triangles]
    edges = numpy.sort(numpy.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]), axis=1)
    edges = edges[edges[:, 0] != edges[:, 1]]
    _, uses = numpy.unique(edges, axis=0, return_counts=True)
    closed = bool((uses % 2 == 0).all())
    middle = points[used].mean(axis=0)
    volume = abs(float((numpy.cross(a - middle, b - middle) * (c - middle)).sum() / 6)) if closed else None
    return {"area": area, "volume": volume}


def labels(array, affine):
    import numpy

    array = numpy.asarray(array)
    while array.ndim > 3 and 1 in array.shape[3:]:
        array = array.squeeze(axis=3 + array.shape[3:].index(1))
    if array.ndim != 3:
        raise ValueError("not three dimensions")
    if not numpy.isfinite(array).all() or (numpy.abs(array - numpy.round(array)) > 1e-3).any() or array.min() < 0:
        raise ValueError("not labels")
    values, counts = numpy.unique(numpy.round(array).astype(numpy.int64), return_counts=True)
    counts = {str(v): int(n) for v, n in zip(values, counts) if v != 0}
    return {
        "dims": [int(n) for n in array.shape],
        "voxel_mm3": abs(float(numpy.linalg.det(numpy.asarray(affine, dtype=float)[:3, :3]))),
        "counts": counts,
    }


def with_nibabel(path, kind):
    import nibabel
    import numpy

    if kind == "freesurfer":
        points, faces = nibabel.freesurfer.read_geometry(path)
        return surface(points, faces)
    file = nibabel.load(path)
    if kind == "gii":
        points = file.agg_data("pointset")
        faces = file.agg_data("triangle")
        return surface(points, numpy.asarray(faces))
    return labels(file.dataobj, file.affine)


def with_trimesh(path, kind):
    import trimesh

    mesh = trimesh.load(path, file_type=kind, process=False, force="mesh")
    return surface(mesh.vertices, mesh.faces)


def with_meshio(path, kind):
    import meshio

    mesh = meshio.read(path, file_format=kind)
    return surface(mesh.points, [list(face) for block in mesh.cells if block.type in ("triangle", "quad", "polygon") for face in block.data])


def with_vtk(path, kind):
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    names = {"ply": "vtkPLYReader", "stl": "vtkSTLReader", "obj": "vtkOBJReader", "vtk": "vtkPolyDataReader", "vtp": "vtkXMLPolyDataReader"}
    vtk.vtkObject.GlobalWarningDisplayOff()
    reader = getattr(vtk, names[kind])()
    failed = []
    reader.AddObserver("ErrorEvent", lambda *_: failed.append(1))
    reader.SetFileName(path)
    reader.Update()
    mesh = reader.GetOutput()
    if failed or mesh is None or mesh.GetNumberOfPoints() == 0:
        raise ValueError("no points")
    triangulate = vtk.vtkTriangleFilter()
    triangulate.PassLinesOff()
    triangulate.PassVertsOff()
    # Polygons as fans, as everybody else splits them; strips as VTK does.
    faces = []
    polys = mesh.GetPolys()
    ids = vtk.vtkIdList()
    polys.InitTraversal()
    while polys.GetNextCell(ids):
        faces.append([ids.GetId(k) for k in range(ids.GetNumberOfIds())])
    strips = mesh.GetStrips()
    strips.InitTraversal()
    while strips.GetNextCell(ids):
        strip = [ids.GetId(k) for k in range(ids.GetNumberOfIds())]
        for k in range(len(strip) - 2):
            t = strip[k : k + 3]
            if len(set(t)) == 3:
                faces.append(t if k % 2 == 0 else [t[1], t[0], t[2]])
    return surface(vtk_to_numpy(mesh.GetPoints().GetData()), faces)


def with_simpleitk(path, kind):
    import numpy
    import SimpleITK

    SimpleITK.ProcessObject.SetGlobalWarningDisplay(False)
    image = SimpleITK.ReadImage(path)
    array = SimpleITK.GetArrayFromImage(image).T
    if image.GetDimension() != 3:
        raise ValueError("not three dimensions")
    spacing = numpy.diag(image.GetSpacing())
    return labels(array, numpy.reshape(image.GetDirection(), (3, 3)) @ spacing)


def with_pynrrd(path, kind):
    import nrrd
    import numpy

    array, header = nrrd.read(path)
    directions = header.get("space directions")
    if directions is None:
        directions = numpy.diag(header.get("spacings", [1.0] * array.ndim))
    directions = numpy.array([d if d is not None else [numpy.nan] * 3 for d in directions], dtype=float)
    spatial = [k for k in range(array.ndim) if numpy.isfinite(directions[k]).all()]
    others = tuple(k for k in range(array.ndim) if k not in spatial)
    if any(array.shape[k] != 1 for k in others):
        raise ValueError("several layers")
    return labels(array.squeeze(axis=others), directions[spatial])


def with_highdicom(path, kind):
    import highdicom
    import numpy
    import pydicom

    segmentation = highdicom.seg.Segmentation.from_dataset(pydicom.dcmread(path, force=True))
    counts, slices = {}, None
    for number in segmentation.segment_numbers:
        volume = segmentation.get_volume(segment_numbers=[number], combine_segments=False, allow_missing_positions=True)
        slices = volume
        n = int((numpy.asarray(volume.array)[..., 0] > 0).sum())
        if n:
            counts[str(number)] = n
    size = slices.spatial_shape
    return {"dims": [size[2], size[1], size[0]], "voxel_mm3": abs(float(numpy.linalg.det(slices.affine[:3, :3]))), "counts": counts}


def with_program(name, path, kind):
    """Runs in a process of its own: what a library prints, and how it ends, is nobody else's concern."""
    warnings.simplefilter("ignore")
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
    os.dup2(null, 2)
    try:
        return globals()[f"with_{name}"](path, kind), None
    except BaseException as error:  # noqa: BLE001: whatever a reader raises is a refusal
        return None, f"{type(error).__name__}: {error}"[:200]


class Peers:
    """The other programs, in a process that is started again where a file has ended it."""

    def __init__(self):
        self.pool = None

    def measure(self, name, path, kind):
        if self.pool is None:
            context = multiprocessing.get_context("spawn")
            self.pool = concurrent.futures.ProcessPoolExecutor(max_workers=1, mp_context=context)
        try:
            return self.pool.submit(with_program, name, str(path), kind).result(timeout=SECONDS)
        except (concurrent.futures.TimeoutError, concurrent.futures.process.BrokenProcessPool) as error:
            for process in list((self.pool._processes or {}).values()):
                process.kill()
            self.pool.shutdown(wait=False, cancel_futures=True)
            self.pool = None
            return None, f"the process ended: {type(error).__name__}"


def ours(binary, path):
    """What `homolog inspect` says, and why not."""
    try:
        done = subprocess.run([binary, "inspect", "--json", str(path)], capture_output=True, text=True, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return None, f"no answer within {SECONDS} s", []
    if done.returncode != 0:
        return None, done.stderr.strip().split(": ", 2)[-1], []
    report = json.loads(done.stdout)
    notes = report.get("notes", []) + [warning["detail"] for warning in report.get("warnings", [])]
    if report["kind"] == "label_volume":
        volume = report["volume"]
        voxel = 1.0
        for size in volume["spacing_mm"]:
            voxel *= size
        counts = {str(label["label"]): label["n_voxels"] for label in volume["labels"]}
        return {"dims": volume["dims"], "voxel_mm3": voxel, "counts": counts}, None, notes
    topology = report.get("topology")
    if topology is None:
        return None, report["refusal"]["detail"], notes
    if not report["suitable"]:
        notes = notes + ["refused for a match: " + report["refusal"]["detail"]]
    # Corners that coincide are joined before the volume is taken.
    closed = report.get("repaired_topology") or topology
    volume = closed.get("volume_mm3")
    return {"area": topology["area_mm2"], "volume": None if volume is None else abs(volume)}, None, notes


def same(a, b, tolerance=1e-4):
    """Whether two measures agree."""
    if a is None or b is None or ("area" in a) != ("area" in b):
        return False
    near = lambda x, y: abs(x - y) <= tolerance * max(abs(x), abs(y), 1e-12)
    if "area" in a:
        volumes = a["volume"] is None or b["volume"] is None or near(a["volume"], b["volume"])
        return near(a["area"], b["area"]) and volumes
    listed = list(a["counts"].items())[:1000] == list(b["counts"].items())[:1000] or dict(list(sorted(a["counts"].items()))[:1000]) == dict(list(sorted(b["counts"].items()))[:1000])
    return a["dims"] == b["dims"] and near(a["voxel_mm3"], b["voxel_mm3"]) and listed
