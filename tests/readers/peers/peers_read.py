"""Reads the same files with homolog and with other programs, and reports the differences.

Two sets of files: what VTK, SimpleITK, nibabel, pynrrd, trimesh and highdicom write, with mutations of it; and the test data of
packages of PyPI. Writes docs/formats-read.md, and fails if a difference is not one of those that decisions.json explains.

    python peers_read.py BINARY --cache FOLDER [--rounds N] [--out docs/formats-read.md] [--only mutations|collections]
"""
import argparse
import collections
import gzip
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import measure
import mutate

HERE = pathlib.Path(__file__).parent
DECISIONS = json.loads((HERE / "decisions.json").read_text())
PACKAGES = json.loads((HERE / "packages.json").read_text())
MAX_BYTES = 30_000_000


def decided(where, entry):
    """The decision about an entry: all the fields that it states must match."""
    for decision in DECISIONS[where]:
        if all(re.fullmatch(pattern, str(entry.get(field, ""))) for field, pattern in decision["if"].items()):
            return decision["because"]
    return None


def compare_mutants(binary, rounds, peers, folder):
    """For each writer and mutation: how homolog and the other programs read the file."""
    entries = []
    for writer, kind, path in mutate.originals(folder):
        data = path.read_bytes()
        truth, refused, _ = measure.ours(binary, path)
        unmutated = {name: peers.measure(name, path, kind)[0] for name in measure.readers(kind)}
        for name, found in unmutated.items():
            if found is not None and not measure.same(truth, found):
                entries.append({"format": kind, "writer": writer, "mutation": "none", "ours": refused or "read", "peers": {name: found}, "class": "original"})
        for mutation, mutated in mutate.mutants(data, kind, rounds, path.name):
            place = folder / f"mutant.{kind}" if kind != "freesurfer" else folder / "lh.mutant"
            place.write_bytes(mutated)
            mine, why, notes = measure.ours(binary, place)
            state = "refused" if mine is None else "right" if measure.same(mine, truth) else "other"
            said = bool(notes)
            theirs = {}
            for name in measure.readers(kind):
                found, _ = peers.measure(name, place, kind)
                theirs[name] = (
                    "refused" if found is None else "right" if measure.same(found, truth) else "as we" if measure.same(found, mine) else "other"
                )
            entries.append(
                {"format": kind, "writer": writer, "mutation": mutation, "ours": state, "said": said, "why": why, "peers": theirs, "bytes": len(mutated), "size": len(data)}
            )
    return entries


def classify(entry):
    """How homolog differs from the other programs, or `None`."""
    ours, theirs = entry["ours"], list(entry["peers"].values())
    if entry.get("class"):
        return entry["class"]
    if ours == "refused" and "right" in theirs:
        return "other programs read, homolog refuses"
    if ours == "right" and set(theirs) == {"refused"}:
        return "homolog reads, other programs refuse"
    if ours == "other" and "right" in theirs:
        return "other programs read the original, homolog something else"
    if ours == "other" and "as we" not in theirs:
        return "homolog reads something that no other program reads"
    return None


def mutation_section(entries):
    lines, undecided = [], []
    table = collections.defaultdict(lambda: collections.Counter())
    for entry in entries:
        if entry["mutation"] == "none":
            undecided.append(entry)
            continue
        table[entry["format"]]["files"] += 1
        table[entry["format"]][entry["ours"]] += 1
        if any(state == "other" for state in entry["peers"].values()) and entry["ours"] != "other":
            table[entry["format"]]["misread"] += 1
    lines += [
        "| format | files | read as the original | read differently, like other programs or with a note | refused | refused or read as the original, but misread by another program |",
        "|---|---|---|---|---|---|",
    ]
    for kind, counts in sorted(table.items()):
        lines.append(f"| {kind} | {counts['files']} | {counts['right']} | {counts['other']} | {counts['refused']} | {counts['misread']} |")
    differences = collections.defaultdict(list)
    for entry in entries:
        kind = classify(entry)
        if kind and entry["mutation"] != "none":
            entry["class"] = kind
            reason = decided("mutations", entry)
            differences[(kind, entry["format"], entry["mutation"], reason)].append(entry)
            if reason is None:
                undecided.append(entry)
    lines += ["", "Differences between homolog and the other programs:", "", "| difference | format | mutation | files | decision |", "|---|---|---|---|---|"]
    for (kind, form, mutation, reason), found in sorted(differences.items(), key=lambda item: tuple(map(str, item[0]))):
        lines.append(f"| {kind} | {form} | {mutation} | {len(found)} | {reason or '**undecided**'} |")
    return lines, undecided


KINDS = {
    ".gii": "gii", ".gii.gz": "gii", ".ply": "ply", ".stl": "stl", ".obj": "obj", ".off": "off", ".vtk": "vtk", ".vtp": "vtp",
    ".nii": "nii", ".nii.gz": "nii", ".mgz": "mgz", ".mgh": "mgz", ".nrrd": "nrrd", ".nhdr": "nrrd", ".mha": "mha", ".dcm": "dcm",
    ".pial": "freesurfer", ".white": "freesurfer", ".inflated": "freesurfer",
}


def kind_of(name):
    return next((kind for ending, kind in sorted(KINDS.items(), key=lambda item: -len(item[0])) if name.lower().endswith(ending)), None)


def collect(cache):
    """The files of the packages that have a format of ours, by package."""
    cache.mkdir(parents=True, exist_ok=True)
    for package in PACKAGES:
        folder = cache / package["name"]
        if (folder / "done").exists():
            continue
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        how = ["--no-binary", ":all:"] if package["source"] else ["--only-binary", ":all:"]
        command = [sys.executable, "-m", "pip", "--disable-pip-version-check", "download", "--quiet", "--no-deps", *how, "--dest", str(folder), f"{package['name']}=={package['version']}"]
        if subprocess.run(command).returncode != 0:
            print(f"{package['name']} cannot be had", file=sys.stderr)
            continue
        for archive in list(folder.iterdir()):
            unpack(archive, folder / "files")
            archive.unlink()
        (folder / "done").write_text("")
    found = []
    for package in PACKAGES:
        files = cache / package["name"] / "files"
        if files.exists():
            found += [(package["name"], path.relative_to(files), path) for path in sorted(files.rglob("*")) if path.is_file()]
    return found


def unpack(archive, folder):
    def wanted(name, size):
        return kind_of(name) and 0 < size < MAX_BYTES and not pathlib.PurePosixPath(name).is_absolute() and ".." not in name

    def write(name, data):
        place = folder / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(data)

    if archive.suffix == ".whl":
        with zipfile.ZipFile(archive) as packed:
            for info in packed.infolist():
                if wanted(info.filename, info.file_size):
                    write(info.filename, packed.read(info))
    else:
        with tarfile.open(archive) as packed:
            for info in packed:
                if info.isfile() and wanted(info.name, info.size):
                    write(info.name, packed.extractfile(info).read())


def number(value):
    return "" if value is None else f"{value:.6g}"


def shown(found):
    if found is None:
        return "refused"
    if "area" in found:
        return f"{number(found['area'])} mm², {number(found['volume']) or 'open'}{' mm³' if found['volume'] is not None else ''}"
    n = sum(found["counts"].values())
    return f"{'×'.join(map(str, found['dims']))}, {len(found['counts'])} labels, {number(n * found['voxel_mm3'])} mm³"


def compare_collections(binary, peers, cache, limit):
    rows, undecided = [], []
    per_package = collections.Counter()
    for package, name, path in collect(cache):
        kind = kind_of(path.name)
        # The whole of a large package would hide the others.
        if per_package[package] >= limit:
            continue
        per_package[package] += 1
        mine, why, notes = measure.ours(binary, path)
        plain = path
        packed = path.name.endswith(".gz") and kind not in ("nii",)
        if packed:
            plain = pathlib.Path(tempfile.mkdtemp()) / path.name[:-3]
            plain.write_bytes(gzip.decompress(path.read_bytes()))
        theirs = {reader: peers.measure(reader, plain, kind)[0] for reader in measure.readers(kind)}
        equal = [reader for reader, found in theirs.items() if measure.same(mine, found)]
        read = [reader for reader, found in theirs.items() if found is not None]
        differs = [reader for reader in read if reader not in equal]
        state = "equal" if equal and not differs else "refused by all" if mine is None and not read else "differs"
        entry = {"package": package, "file": str(name), "format": kind, "state": state, "ours": "refused" if mine is None else "read", "why": why or "", "read": " ".join(read), "equal": " ".join(equal), "notes": " ".join(notes)}
        reason = "" if state == "equal" else decided("collections", entry)
        if reason is None:
            if state == "refused by all":
                reason = why
            else:
                undecided.append(entry)
        others = "; ".join(f"{reader}: {'equal' if reader in equal else shown(found)}" for reader, found in theirs.items())
        rows.append((package, name, mine, others, state, reason))
    lines = ["| package | file | homolog | others | |", "|---|---|---|---|---|"]
    for package, name, mine, others, state, reason in rows:
        short = str(name).split("/", 1)[-1]
        lines.append(f"| {package} | `{short}` | {shown(mine)} | {others} | {'equal' if state == 'equal' else state + ': ' + (reason or '**undecided**').replace('|', '/')} |")
    counts = collections.Counter(state for *_, state, _ in rows)
    head = f"{len(rows)} files: {counts['equal']} equal, {counts['refused by all']} refused by all, {counts['differs']} different for the reason given."
    return [head, "", *lines], undecided


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("binary")
    parser.add_argument("--cache", type=pathlib.Path, required=True)
    parser.add_argument("--rounds", type=int, default=6)
    parser.add_argument("--limit", type=int, default=45, help="files of one package")
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--only", choices=["mutations", "collections"])
    arguments = parser.parse_args()
    peers = measure.Peers()
    version = subprocess.run([arguments.binary, "--version"], capture_output=True, text=True).stdout.strip()
    lines = [
        "# Files read by homolog and by other programs",
        "",
        f"Made by `make peers-read` with {version}; versions of the other programs are in `tests/readers/requirements.txt`.",
        "`tests/readers/peers/decisions.json` has the decision on each difference, and [formats.md](formats.md) explains them.",
        "",
    ]
    undecided = []
    if arguments.only != "collections":
        with tempfile.TemporaryDirectory() as folder:
            entries = compare_mutants(arguments.binary, arguments.rounds, peers, pathlib.Path(folder))
        section, open_cases = mutation_section(entries)
        lines += ["## Mutations", "", f"One surface and one label volume, written by these programs and each mutated at random with fixed seeds, {arguments.rounds} rounds.", "", *section, ""]
        undecided += open_cases
    if arguments.only != "mutations":
        section, open_cases = compare_collections(arguments.binary, peers, arguments.cache, arguments.limit)
        lines += ["## Public test data", "", "Surfaces: area and enclosed volume. Label volumes: size, labels with their number of voxels, volume of a voxel. Equal means within 10⁻⁴.", "", *section, ""]
        undecided += open_cases
    text = "\n".join(lines)
    if arguments.out:
        arguments.out.write_text(text)
    else:
        print(text)
    for entry in undecided:
        print(json.dumps(entry), file=sys.stderr)
    print(f"{len(undecided)} differences are not decided", file=sys.stderr)
    sys.exit(1 if undecided else 0)


if __name__ == "__main__":
    main()
