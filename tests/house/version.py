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
newest = re.search(r"^## (\S+)", (source / "CHANGELOG.md").read_text(), re.M)[1]
assert newest == version, f"CHANGELOG.md begins with {newest}, not {version}"
# What git archive makes names its commit.
unpacked = subprocess.run("git archive HEAD bench/build_info.cmake | tar -xO", shell=True, cwd=source, capture_output=True, text=True, check=True).stdout
commit = subprocess.run(["git", "rev-parse", "HEAD"], cwd=source, capture_output=True, text=True, check=True).stdout.strip()
assert f'set(released "{commit}")' in unpacked, "an archive without its commit"
