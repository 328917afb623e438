"""theorems.py PROOF: everything is proved again with Coq and looked at by its second checker; nothing is taken for granted but the axioms
of Coq's real numbers, and the committed OCaml is what is extracted. Proofs that cheat are refused."""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

AXIOMS = {"ClassicalDedekindReals.sig_not_dec", "ClassicalDedekindReals.sig_forall_dec", "FunctionalExtensionality.functional_extensionality_dep"}
source = pathlib.Path(sys.argv[1])
scratch = pathlib.Path(tempfile.mkdtemp())


def prove(folder):
    """Exit code, what is printed, and the folder of the compiled proofs."""
    output = pathlib.Path(tempfile.mkdtemp(dir=scratch)) / "ar3d_proved"
    done = subprocess.run([folder / "build.sh", "--prove", output], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr, output.with_name("ar3d_proved.build")


code, said, built = prove(source)
if code:
    raise SystemExit(f"exit code {code}\n{said}")
theorems = said.split("Axioms:\n")[1:]
wanted = (source / "Assumptions.v").read_text().count("Print Assumptions") - 1
if len(theorems) != wanted or wanted < 6 or "Closed under the global context" not in said:
    raise SystemExit(f"{len(theorems)} lists of axioms, {wanted} wanted:\n{said}")
for theorem in theorems:
    lines = [line for line in theorem.splitlines() if not line.startswith((" ", "Closed"))]
    if {line.split(" :")[0] for line in lines} != AXIOMS:
        raise SystemExit(f"other assumptions: {lines}")
print(f"{wanted} theorems rest on {len(AXIOMS)} axioms, one on none")

# coqchk, the checker of compiled proofs: its summary.
files = [word for file in sorted(built.glob("*.vo")) for word in ("-norec", f"Drawing.{file.stem}")]
done = subprocess.run(["coqchk", "-silent", "-o", "-Q", ".", "Drawing", *files], cwd=built, stdout=subprocess.PIPE,
                      stderr=subprocess.STDOUT, text=True)
unsafe = re.findall(r"^\* (.*): <none>$", done.stdout, re.M)
if done.returncode or len(files) < 20 or len(unsafe) != 3 or re.search(r"^ +Drawing\.", done.stdout, re.M):
    raise SystemExit(f"coqchk: exit code {done.returncode}\n{done.stdout}")
print(f"coqchk: {len(files) // 2} files; none: {', '.join(unsafe)}")

# Cheats, and what build.sh has to say of each; the second one as if its text had not been looked at.
PARADOX = """From Coq Require Import Hurkens.
Unset Universe Checking.
Definition everything : False := TypeNeqSmallType.paradox Type eq_refl.
Set Universe Checking.
"""
CHEATS = [("a paradox", PARADOX, "|", "something is taken for granted"),
          ("a paradox unseen", PARADOX, "|Unset|", "an assumption that is none of the three axioms"),
          ("a variable of no section", "Variable everything : False.\n", "|", "an assumption that is none of the three axioms")]
for what, cheat, blind, refusal in CHEATS:
    folder = pathlib.Path(tempfile.mkdtemp(dir=scratch)) / "proof"
    shutil.copytree(source, folder)
    scope = "Local Open Scope R_scope.\n"
    before, _ = (folder / "OneBend.v").read_text().rsplit("Proof.\n", 1)
    if before.count(scope) != 1:
        raise SystemExit("OneBend.v does not open the scope of the reals once")
    (folder / "OneBend.v").write_text(before.replace(scope, scope + cheat) + "Proof.\n  destruct everything.\nQed.\n")
    guard = (folder / "build.sh").read_text()
    if blind not in guard:
        raise SystemExit(f"build.sh does not look for {blind}")
    (folder / "build.sh").write_text(guard.replace(blind, "|"))
    code, said, _ = prove(folder)
    if code != 1 or refusal not in said:
        raise SystemExit(f"{what}: exit code {code}\n{said}")
    print(f"{what}: {refusal}")
shutil.rmtree(scratch)
