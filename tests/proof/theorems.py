"""theorems.py PROOF: everything is proved again with Coq; nothing is taken for granted but the axioms of its real numbers, and the
committed OCaml is what is extracted."""
import pathlib
import re
import subprocess
import sys
import tempfile

AXIOMS = {"ClassicalDedekindReals.sig_not_dec", "ClassicalDedekindReals.sig_forall_dec", "FunctionalExtensionality.functional_extensionality_dep"}
folder = pathlib.Path(sys.argv[1])
for file in sorted(folder.glob("*.v")):
    if found := re.search(r"Admitted|admit|Axiom|Parameter|Conjecture|bypass_check|Unset Guard", file.read_text()):
        raise SystemExit(f"{file}: {found[0]}")
with tempfile.TemporaryDirectory() as name:
    done = subprocess.run([folder / "build.sh", "--prove", pathlib.Path(name) / "ar3d_proved"], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"exit code {done.returncode}\n{done.stdout}\n{done.stderr}")
theorems = done.stdout.split("Axioms:\n")[1:]
wanted = (folder / "Assumptions.v").read_text().count("Print Assumptions")
if len(theorems) != wanted or wanted < 3:
    raise SystemExit(f"{len(theorems)} lists of axioms, {wanted} wanted:\n{done.stdout}")
for theorem in theorems:
    names = set(re.findall(r"^([\w.]+)\s*:|^([\w.]+)$", theorem, re.M))
    names = {a or b for a, b in names}
    if names != AXIOMS:
        raise SystemExit(f"other axioms: {names ^ AXIOMS}")
print(f"{wanted} theorems rest on {len(AXIOMS)} axioms")
