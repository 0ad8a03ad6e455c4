"""One surface and one label volume in every format, as other programs write them, and their mutations.

A mutation is a function of bytes and a random generator; those that mean nothing by a format's grammar must leave the measure as
it is, and those that contradict the file must be refused or be seen through.
"""
import pathlib
import random
import re
import shutil

import numpy


def sphere():
    """A closed surface of 162 vertices, none of which is at a round number."""
    import trimesh

    ball = trimesh.creation.icosphere(subdivisions=2, radius=1.0)
    points = ball.vertices * [11.37, 7.91, 5.23] + [3.17, -2.61, 9.43]
    return numpy.asarray(points, dtype=numpy.float32), numpy.asarray(ball.faces)


def blob():
    """A volume of two labels, larger in each direction than in the next."""
    x, y, z = numpy.meshgrid(numpy.arange(17), numpy.arange(13), numpy.arange(11), indexing="ij")
    inside = ((x - 8) / 6.2) ** 2 + ((y - 6) / 4.6) ** 2 + ((z - 5) / 3.7) ** 2 < 1
    return (inside * (1 + (x > 8))).astype(numpy.uint8)


def originals(folder):
    """Name of the writer, kind, path: for each format what its programs write."""
    import nibabel
    import nrrd
    import SimpleITK
    import trimesh
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

    points, faces = sphere()
    made = []

    def add(writer, kind, name, write):
        path = folder / name
        write(str(path))
        made.append((writer, kind, path))

    mesh = trimesh.Trimesh(points, faces, process=False)
    for kind, options in [("ply", {"encoding": "ascii"}), ("ply", {"encoding": "binary"}), ("stl", {}), ("stl_ascii", {}), ("obj", {}), ("off", {})]:
        data = mesh.export(file_type=kind, **options)
        data = data.encode() if isinstance(data, str) else data
        kind = kind.split("_")[0]
        variant = options.get("encoding", "ascii" if data[:5] == b"solid" else "")
        add(f"trimesh {variant}".strip(), kind, f"trimesh_{variant}.{kind}", lambda path, data=data: open(path, "wb").write(data))

    poly = vtk.vtkPolyData()
    places = vtk.vtkPoints()
    places.SetData(numpy_to_vtk(points, deep=True))
    poly.SetPoints(places)
    cells = vtk.vtkCellArray()
    listed = numpy.column_stack([numpy.full(len(faces), 3), faces]).astype(numpy.int64).ravel()
    cells.SetCells(len(faces), numpy_to_vtkIdTypeArray(listed, deep=True))
    poly.SetPolys(cells)

    def by_vtk(name, set_up):
        def write(path):
            writer = getattr(vtk, name)()
            writer.SetInputData(poly)
            writer.SetFileName(path)
            set_up(writer)
            writer.Write()

        return write

    for mode in ["ASCII", "Binary"]:
        add(f"VTK {mode}", "ply", f"vtk_{mode}.ply", by_vtk("vtkPLYWriter", lambda w, m=mode: getattr(w, f"SetFileTypeTo{m}")()))
        add(f"VTK {mode}", "stl", f"vtk_{mode}.stl", by_vtk("vtkSTLWriter", lambda w, m=mode: getattr(w, f"SetFileTypeTo{m}")()))
        for version in [42, 51]:
            set_up = lambda w, m=mode, v=version: (getattr(w, f"SetFileTypeTo{m}")(), w.SetFileVersion(v))
            add(f"VTK {mode} {version / 10}", "vtk", f"vtk_{mode}_{version}.vtk", by_vtk("vtkPolyDataWriter", set_up))
    for mode in ["Ascii", "Binary", "Appended"]:
        add(f"VTK {mode}", "vtp", f"vtk_{mode}.vtp", by_vtk("vtkXMLPolyDataWriter", lambda w, m=mode: getattr(w, f"SetDataModeTo{m}")()))
    add("VTK", "obj", "vtk.obj", by_vtk("vtkOBJWriter", lambda w: None))

    for encoding in ["ASCII", "B64BIN", "B64GZ"]:
        def write(path, encoding=encoding):
            arrays = [
                nibabel.gifti.GiftiDataArray(points, "NIFTI_INTENT_POINTSET", "NIFTI_TYPE_FLOAT32", f"GIFTI_ENCODING_{encoding}"),
                nibabel.gifti.GiftiDataArray(faces.astype(numpy.int32), "NIFTI_INTENT_TRIANGLE", "NIFTI_TYPE_INT32", f"GIFTI_ENCODING_{encoding}"),
            ]
            nibabel.save(nibabel.gifti.GiftiImage(darrays=arrays), path)

        add(f"nibabel {encoding}", "gii", f"nibabel_{encoding}.gii", write)
    add("nibabel", "freesurfer", "lh.nibabel", lambda path: nibabel.freesurfer.write_geometry(path, points, faces, create_stamp="created by a test"))

    array = blob()
    affine = numpy.array([[-1.5, 0, 0, 20], [0, 1.2, 0, -15], [0, 0, 2.5, 7], [0, 0, 0, 1]])
    add("nibabel", "nii", "nibabel.nii", lambda path: nibabel.save(nibabel.Nifti1Image(array, affine), path))
    add("nibabel 2", "nii", "nibabel2.nii", lambda path: nibabel.save(nibabel.Nifti2Image(array.astype(numpy.int16), affine), path))
    add("nibabel", "mgz", "nibabel.mgz", lambda path: nibabel.save(nibabel.MGHImage(array.astype(numpy.int32), affine), path))
    image = SimpleITK.GetImageFromArray(array.T.copy())
    image.SetSpacing([1.5, 1.2, 2.5])
    image.SetOrigin([20.0, -15.0, 7.0])
    for kind, packed in [("mha", False), ("mha", True), ("nrrd", False), ("nrrd", True), ("nii", False)]:
        add(f"SimpleITK{' packed' if packed else ''}", kind, f"itk_{packed}.{kind}", lambda path, p=packed: SimpleITK.WriteImage(image, path, p))
    for encoding in ["raw", "gzip", "ascii"]:
        header = {"encoding": encoding, "space": "right-anterior-superior", "space directions": affine[:3, :3].T, "space origin": affine[:3, 3], "kinds": ["domain"] * 3}
        add(f"pynrrd {encoding}", "nrrd", f"pynrrd_{encoding}.nrrd", lambda path, h=header: nrrd.write(path, array, h))
    fixture = pathlib.Path(__file__).parents[2] / "fixtures/field/sparse.dcm"
    add("highdicom", "dcm", "highdicom.dcm", lambda path: shutil.copy(fixture, path))
    return made


def is_text(data):
    return not any(byte < 9 or 13 < byte < 32 for byte in data[:4000])


def head_end(kind, data):
    """Where the header of lines ends, for formats that have one before their data."""
    marks = {"ply": b"end_header\n", "nrrd": b"\n\n", "mha": b"ElementDataFile"}
    at = data.find(marks[kind]) if kind in marks else -1
    return None if at < 0 else at


def numbers(data, pattern, change):
    return re.sub(pattern, change, data)


# Mutations that mean nothing by any grammar of text, or that a grammar allows.
def bom(data, kind, rng):
    return b"\xef\xbb\xbf" + data


def blanks_before(data, kind, rng):
    return rng.choice([b" ", b"\n", b"\n\n  ", b"\t"]) + data


def crlf(data, kind, rng):
    return data.replace(b"\r\n", b"\n").replace(b"\n", b"\r\n") if is_text(data) else None


def cr(data, kind, rng):
    return data.replace(b"\r\n", b"\n").replace(b"\n", b"\r") if is_text(data) and kind in ("obj", "off", "stl", "ply") else None


def blank_lines(data, kind, rng):
    if not is_text(data) or kind in ("nrrd", "mha"):
        return None
    lines = data.split(b"\n")
    at = rng.randrange(len(lines) // 2, len(lines))
    return b"\n".join(lines[:at] + [b"", b"  "] + lines[at:])


def tabs(data, kind, rng):
    if not is_text(data) or kind in ("gii", "vtp"):
        return None
    lines = data.split(b"\n")
    return b"\n".join(lines[:12] + [line.replace(b" ", b"\t") for line in lines[12:]])


def blanks_at_ends(data, kind, rng):
    return b"\n".join(line + b"  " for line in data.split(b"\n")) if is_text(data) and kind not in ("gii", "vtp") else None


def no_last_line_end(data, kind, rng):
    return data.rstrip() if is_text(data) and data.endswith(b"\n") else None


def comment_lines(data, kind, rng):
    if kind not in ("obj", "off") or not is_text(data):
        return None
    lines = data.split(b"\n")
    at = rng.randrange(3, len(lines))
    return b"\n".join(lines[:at] + [b"# a comment"] + lines[at:])


def comments_after(data, kind, rng):
    if kind not in ("obj", "off") or not is_text(data):
        return None
    return b"\n".join(line + b" # a comment" if line[:2] in (b"v ", b"f ") or kind == "off" and k > 1 and line else line for k, line in enumerate(data.split(b"\n")))


def number_forms(data, kind, rng):
    if not is_text(data) or kind in ("gii", "vtp", "nii", "mgz", "mha"):
        return None
    form = rng.randrange(4)

    def change(match):
        text = match.group(0)
        if rng.random() > 0.2:
            return text
        value = float(text)
        return [f"{value:e}", f"+{text.decode().lstrip('+-')}" if value >= 0 else text.decode(), f"{value:.9f}0", text.decode().replace("0.", ".")][form].encode()

    lines = data.split(b"\n")
    begin = 1 if kind == "stl" else 9 if kind == "ply" else 5 if kind == "vtk" else 0
    lines[begin:] = [re.sub(rb"(?<![\w.])[-+]?\d+\.\d+(e[-+]?\d+)?(?![\w.])", change, line) for line in lines[begin:]]
    return b"\n".join(lines)


def unused_nan(data, kind, rng):
    if kind == "obj" and is_text(data):
        return data + b"\nv nan nan nan\n"
    if kind == "ply" and is_text(data):
        count = int(re.search(rb"element vertex (\d+)", data).group(1))
        data = data.replace(b"element vertex %d" % count, b"element vertex %d" % (count + 1))
        lines = data.split(b"\n")
        at = lines.index(b"end_header") + 1 + count
        width = len(lines[at - 1].split())
        return b"\n".join(lines[:at] + [b" ".join([b"nan"] * width)] + lines[at:])
    return None


def header_order(data, kind, rng):
    end = head_end(kind, data)
    if end is None or kind == "ply":
        return None
    lines = data[:end].rstrip(b"\n").split(b"\n")
    fixed = 1 if kind == "nrrd" else 0
    rest = lines[fixed:]
    rng.shuffle(rest)
    return b"\n".join(lines[:fixed] + rest) + (b"" if kind == "nrrd" else b"\n") + data[end:]


def empty_field(data, kind, rng):
    if kind == "nrrd":
        return data.replace(b"\n\n", b"\ncontent: \n\n", 1)
    if kind == "mha":
        return data.replace(b"NDims", b"Comment = \nNDims", 1)
    return None


def skip_bytes(data, kind, rng):
    if kind != "nrrd" or b"encoding: raw" not in data:
        return None
    junk = bytes(rng.randrange(256) for _ in range(rng.randrange(1, 50)))
    skip = rng.choice([-1, len(junk)])
    head, rest = data.split(b"\n\n", 1)
    return head + b"\nbyte skip: %d\n\n" % skip + junk + rest


def skip_lines(data, kind, rng):
    if kind != "nrrd":
        return None
    head, rest = data.split(b"\n\n", 1)
    return head + b"\nline skip: 2\n\nabc\ndef\n" + rest


def axis_of_one(data, kind, rng):
    if kind == "nrrd" and b"dimension: 3" in data and b"(" in data:
        data = data.replace(b"dimension: 3", b"dimension: 4", 1)
        data = re.sub(rb"sizes: ", b"sizes: 1 ", data, count=1)
        data = re.sub(rb"space directions: ", b"space directions: none ", data, count=1)
        return re.sub(rb"kinds: ", b"kinds: list ", data, count=1)
    return None


def stamp_lines(data, kind, rng):
    if kind != "freesurfer":
        return None
    n = rng.choice([1, 3, 4])
    at = data.index(b"\n")
    rest = data[at:].lstrip(b"\n")
    return data[:at] + b"\n" * n + rest


def encoding_names(data, kind, rng):
    if kind != "gii":
        return None
    for standard, constant in [(b"ASCII", b"GIFTI_ENCODING_ASCII"), (b"GZipBase64Binary", b"GIFTI_ENCODING_B64GZ"), (b"Base64Binary", b"GIFTI_ENCODING_B64BIN")]:
        if b'Encoding="%s"' % standard in data:
            return data.replace(b'Encoding="%s"' % standard, b'Encoding="%s"' % constant)
    return None


def preamble(data, kind, rng):
    return data[132:] if kind == "dcm" else None


def zeros_after(data, kind, rng):
    return data + bytes(rng.choice([1, 7, 512])) if kind not in ("mgz",) else None


def line_ends_after(data, kind, rng):
    return data + b"\n\n" if kind != "mgz" else None


# Mutations that contradict the file.
def text_after(data, kind, rng):
    return data + b"something else\n" if kind != "mgz" else None


def count_off(data, kind, rng):
    change = lambda n: max(0, rng.choice([n // 2, n - 1, n + 1, 2 * n, 0]))
    patterns = {
        "ply": rb"(element (?:vertex|face) )(\d+)",
        "vtk": rb"((?:POINTS|POLYGONS) )(\d+)",
        "vtp": rb"(NumberOf(?:Points|Polys)=\")(\d+)",
        "gii": rb"(Dim0=\")(\d+)",
        "nrrd": rb"(sizes: \d+ \d+ )(\d+)",
        "mha": rb"(DimSize = \d+ \d+ )(\d+)",
    }
    if kind in patterns:
        found = [m for m in re.finditer(patterns[kind], data) if m.group(2) != b"0"]
        if not found:
            return None
        match = rng.choice(found)
        new = change(int(match.group(2)))
        return None if new == int(match.group(2)) else data[: match.start(2)] + b"%d" % new + data[match.end(2) :]
    if kind == "stl" and not is_text(data):
        n = int.from_bytes(data[80:84], "little")
        new = change(n)
        return None if new == n else data[:80] + new.to_bytes(4, "little") + data[84:]
    if kind == "off":
        lines = data.split(b"\n")
        at = next(k for k, line in enumerate(lines) if re.match(rb"^\d+ \d+ ?\d*$", line.strip()))
        counts = lines[at].split()
        which = rng.randrange(2)
        counts[which] = b"%d" % change(int(counts[which]))
        lines[at] = b" ".join(counts)
        return b"\n".join(lines)
    if kind == "freesurfer":
        at = data.index(b"\n\n") + 2 + 4 * rng.randrange(2)
        n = int.from_bytes(data[at : at + 4], "big")
        return data[:at] + change(n).to_bytes(4, "big") + data[at + 4 :]
    if kind == "nii" and data[:4] == b"\x5c\x01\x00\x00":
        n = int.from_bytes(data[46:48], "little")
        new = max(1, change(n))
        return None if new == n else data[:46] + new.to_bytes(2, "little") + data[48:]
    return None


def cut(data, kind, rng):
    return data[: rng.randrange(len(data) // 3, len(data) - 1)]


def cut_line(data, kind, rng):
    if not is_text(data):
        return None
    lines = data.rstrip(b"\n").split(b"\n")
    return b"\n".join(lines[: rng.randrange(len(lines) // 2, len(lines) - 1)]) + b"\n"


def drop_header_line(data, kind, rng):
    end = head_end(kind, data)
    if end is None:
        return None
    lines = data[:end].split(b"\n")
    at = rng.randrange(1, len(lines) - 1)
    return b"\n".join(lines[:at] + lines[at + 1 :]) + data[end:]


def flip_bit(data, kind, rng):
    at = rng.randrange(min(len(data), 2000))
    return data[:at] + bytes([data[at] ^ 1 << rng.randrange(8)]) + data[at + 1 :]


def letters(data, kind, rng):
    """The case of keywords."""
    if not is_text(data) or kind in ("gii", "vtp", "obj"):
        return None
    lines = data.split(b"\n")
    at = rng.randrange(min(len(lines), 8))
    lines[at] = lines[at].swapcase()
    return b"\n".join(lines)


MEANINGLESS = [
    bom, blanks_before, crlf, cr, blank_lines, tabs, blanks_at_ends, no_last_line_end, comment_lines, comments_after, number_forms,
    unused_nan, header_order, empty_field, skip_bytes, skip_lines, axis_of_one, stamp_lines, encoding_names, preamble, zeros_after,
    line_ends_after,
]
CONTRADICTING = [text_after, count_off, cut, cut_line, drop_header_line, flip_bit, letters]


def mutants(data, kind, rounds, seed):
    """Name of the mutation, the mutated bytes: each that applies, those that draw at random `rounds` times."""
    for mutation in MEANINGLESS + CONTRADICTING:
        seen = set()
        for k in range(rounds):
            rng = random.Random(f"{seed} {mutation.__name__} {k}")
            mutated = mutation(data, kind, rng)
            if mutated is not None and mutated != data and mutated not in seen:
                seen.add(mutated)
                yield mutation.__name__, mutated
