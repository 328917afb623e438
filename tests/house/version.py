"""The version stands in CMakeLists.txt; program, citation, metadata and change log repeat it.  version.py SOURCE PROGRAM"""
import json
import pathlib
import re
import subprocess
import sys

import yaml

source, program = pathlib.Path(sys.argv[1]), sys.argv[2]
version = re.search(r"project\(ar3d VERSION (\S+)", (source / "CMakeLists.txt").read_text())[1]
told = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
assert re.fullmatch(rf"ar3d {re.escape(version)} \(commit \w+(, modified)?, \w+ [\d.]+, \w+(, \w+)?\)\n", told), told
citation = yaml.safe_load((source / "CITATION.cff").read_text())
codemeta = json.loads((source / "codemeta.json").read_text())
assert citation["version"] == codemeta["version"] == version, (citation["version"], codemeta["version"], version)
assert citation["references"][0]["doi"] in codemeta["referencePublication"][0]["@id"]
headings = re.findall(r"^## (.*)", (source / "CHANGELOG.md").read_text(), re.M)
assert headings[0] == "Unreleased", f"CHANGELOG.md begins with {headings[0]}, not Unreleased"
assert re.fullmatch(rf"{re.escape(version)} \(\d{{4}}-\d\d-\d\d\)", headings[1]), f"CHANGELOG.md has {headings[1]}, not {version} with its date"
# What git archive makes names its commit.
unpacked = subprocess.run("git archive HEAD bench/build_info.cmake | tar -xO", shell=True, cwd=source, capture_output=True, text=True, check=True).stdout
commit = subprocess.run(["git", "rev-parse", "HEAD"], cwd=source, capture_output=True, text=True, check=True).stdout.strip()
assert f'set(released "{commit}")' in unpacked, "an archive without its commit"
# What a forge runs is what is run here: the workflow calls .ci/run in a container of the Dockerfile's system, as long as it may take.
workflow = yaml.safe_load((source / ".github/workflows/ci.yml").read_text())["jobs"]["ci"]
steps = (source / "Dockerfile").read_text().splitlines()
assert workflow["steps"][-1]["run"] == "bash .ci/run" and workflow["timeout-minutes"] == 90, workflow
assert len(steps) == 6 and steps[0] == f"FROM {workflow['container']}", steps
assert "./" + " ".join(json.loads(steps[-1].removeprefix("CMD "))) in (source / "README.md").read_text(), steps[-1]
assert json.loads((source / ".devcontainer/devcontainer.json").read_text())["image"] == workflow["container"]
# The folder that clangd reads is that of the preset which compiles every source by itself.
folder = yaml.safe_load((source / ".clangd").read_text())["CompileFlags"]["CompilationDatabase"]
editor = next(preset for preset in json.loads((source / "CMakePresets.json").read_text())["configurePresets"] if preset["name"] == "editor")
assert editor["binaryDir"] == "${sourceDir}/" + folder and editor["cacheVariables"] == {"AR3D_TOGETHER": "OFF"}, editor
