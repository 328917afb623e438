"""Applies a patch that CONTRIBUTING.md names to a copy of the tree, and expects the new row everywhere.

walkthrough.py SOURCE BUILD PATCH NAME: PATCH is one of tests/house/added, NAME what it adds. What stands below the
patch in its block is run. Only what is new or changed is compiled, with the build's own commands, and linked with the
build's libraries.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile


# Family and algorithm of the study in which what is added has to show; a format is nothing that a study shows.
STUDIES = {"matching": ("perfect-matching", "matching"), "triangle-strip": ("triangle-strip", "diamond"), "num_segments": ("cycle", "grid")}


def commands(page, patch):
    """What is run once the patch is applied."""
    return re.search(rf"^```sh\ngit apply {re.escape(patch)}\n(.*?)^```", page, re.S | re.M)[1]


def copy_of(source, tree):
    listed = subprocess.run(["git", "ls-files", "*.h", "*.cpp"], cwd=source, capture_output=True, text=True)
    for name in listed.stdout.split():
        target = tree / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if (source / name).exists():
            target.write_bytes((source / name).read_bytes())


def units_of(source, build):
    """The unit that each source is compiled in, itself or one that includes it beside others, and the command."""
    units = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        unit = pathlib.Path(entry["file"])
        together = re.findall(r'#include "(\S+)"', unit.read_text()) if "Unity" in unit.parts else [str(unit)]
        for file in together:
            if file.startswith(f"{source}/"):
                units[str(pathlib.Path(file).relative_to(source))] = (unit, entry["command"])
    return units


def compile_units(touched, source, tree, build):
    """The objects of the units with a changed or new source; a new one is compiled as its neighbours are; quickly."""
    units = units_of(source, build)
    wanted = {}
    for name in touched:
        unit, command = units.get(name) or (source / name, next(c for n, (_, c) in units.items() if n.startswith(name.split("/")[0] + "/")))
        wanted[unit] = command
    objects = []
    for number, (unit, command) in enumerate(wanted.items()):
        copied = tree / f"unit_{number}.cpp"
        inside = unit.read_text() if "Unity" in unit.parts else f'#include "{unit}"\n'
        copied.write_text(inside.replace(f'"{source}/', f'"{tree}/'))
        command = re.sub(r" -o \S+ -c \S+", f" -O0 -o {copied}.o -c {copied}", command)
        subprocess.run(command.replace(f"-I{source}/include", f"-I{tree}/include"), shell=True, check=True, cwd=build)
        objects.append(f"{copied}.o")
    return objects


def link(objects, tree, build):
    link_line = subprocess.run(["ninja", "-t", "commands", "apps/ar3d"], cwd=build, capture_output=True, text=True,
                               check=True).stdout.splitlines()[-1]
    mine = link_line.replace(" apps/CMakeFiles", f" {' '.join(objects)} apps/CMakeFiles", 1)
    subprocess.run(mine.replace("-o apps/ar3d ", f"-o {tree}/ar3d "), shell=True, check=True, cwd=build)


def expect_everywhere(name, tree, listed):
    import h5py
    assert name in listed, f"list does not show {name}:\n{listed}"
    table = h5py.File(tree / "results.h5")["runs"]
    runs = table[:]
    if name in runs.dtype.names:
        assert table.attrs[name + ".unit"] and table.attrs[name + ".meaning"], "not described in the HDF5 file"
        assert (runs[name] > 0).any(), "never measured"
    columns = [c for c in runs.dtype.names if runs.dtype[c].kind == "S"]
    assert name in runs.dtype.names or any(name.encode() in runs[c] for c in columns), "not in the HDF5 file"
    assert name in (tree / "report.html").read_text(), "not in the report"
    assert any(name in p.read_text() for p in tree.glob("**/*.csv")), "not in the CSV files"


def main():
    source, build = (pathlib.Path(p).resolve() for p in sys.argv[1:3])
    patch, name = f"tests/house/added/{sys.argv[3]}.patch", sys.argv[4]
    with tempfile.TemporaryDirectory(prefix="ar3d-walk-") as scratch:
        tree = pathlib.Path(scratch)
        copy_of(source, tree)
        (tree / "include").mkdir()
        (tree / "include" / "ar3d").symlink_to(tree)
        subprocess.run(["git", "apply", source / patch], cwd=tree, check=True)
        touched = re.findall(r"^\+\+\+ b/(\S+\.cpp)$", (source / patch).read_text(), re.M)
        shell = [commands((source / "CONTRIBUTING.md").read_text(), patch)]
        link(compile_units(touched, source, tree, build), tree, build)
        if name in STUDIES:
            family, algorithm = STUDIES[name]
            (tree / "study.toml").write_text(f"study = 'walk'\n[[sweep]]\nfamilies = '{family}'\nsizes = [4, 10]\nalgorithms = '{algorithm}'\n")
            shell.append("./ar3d study run study.toml -q -o results.h5\n./ar3d check results.h5\n"
                         "./ar3d report results.h5 -o report.html --csv report.csv --rows rows.csv")
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", "\n".join(shell)], cwd=tree, capture_output=True,
                              text=True)
        assert done.returncode == 0, done.stdout + done.stderr
        if name in STUDIES:
            expect_everywhere(name, tree, done.stdout)


main()
