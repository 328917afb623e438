"""refutations.py UNSATISFIABLE COUNT: random formulas with proofs that a small solver writes, broken in COUNT ways. The program must say
what a plain checker says, which propagates by looking at all clauses again, and never call a formula unsatisfiable that has a model."""
import itertools
import os
import random
import subprocess
import sys
import tempfile

program, count = sys.argv[1], int(sys.argv[2])
VARIABLES = 8
draw = random.Random(1)
failed = []


def propagated(clauses, false_ones):
    """The literals that are false when no clause is left with one literal that is not; None if a clause is left with none."""
    false_ones = set(false_ones)
    while True:
        rest = [[l for l in clause if l not in false_ones] for clause in clauses]
        if [] in rest:
            return None
        new = {-c[0] for c in rest if len(set(c)) == 1} - false_ones
        if not new:
            return false_ones
        false_ones |= new


def refutation(clauses, decided=()):
    """Lemmas and deletions of a search that tries both values of each variable; None with a model."""
    false_ones = propagated(clauses, decided)
    if false_ones is None:
        return [("", tuple(decided))]
    free = [v for v in range(1, VARIABLES + 1) if not {v, -v} & false_ones]
    if not free:
        return None
    steps = []
    for literal in (free[0], -free[0]):
        below = refutation(clauses, (*decided, literal))
        if below is None:
            return None
        steps += below
    return [*steps, ("", tuple(decided)), *(("d ", (*decided, l)) for l in (free[0], -free[0]))]


def verdict(clauses, steps):
    """What a proof is worth, by the definition. Units that follow from all clauses stay when a clause goes."""
    known, fixed = [list(c) for c in clauses], set()
    for kind, literals in [("", None), *steps]:
        if literals is not None and kind:
            same = [c for c in known if set(c) == set(literals)]
            if same and len(set(literals)) > 1:
                known.remove(same[0])
        elif literals is not None and not any(-l in literals for l in literals):
            if propagated(known, fixed | set(literals)) is not None:
                return "REFUSED"
            known.append(list(literals))
        now = propagated(known, fixed)
        if now is None:
            return "UNSATISFIABLE"
        fixed = now
    return "REFUSED"


def has_model(clauses):
    return any(all(any((l > 0) == values[abs(l) - 1] for l in c) for c in clauses) for values in itertools.product((True, False), repeat=VARIABLES))


def dimacs(clauses):
    return f"p cnf {VARIABLES} {len(clauses)}\n" + "".join(" ".join(map(str, [*c, 0])) + "\n" for c in clauses)


def text(steps):
    return "".join(kind + " ".join(map(str, [*literals, 0])) + "\n" for kind, literals in steps).encode()


def binary(steps):
    def number(n):
        return bytes([n]) if n < 128 else bytes([n & 127 | 128]) + number(n >> 7)
    return b"".join((b"d" if kind else b"a") + b"".join(number(2 * abs(l) + (l < 0)) for l in literals) + b"\0" for kind, literals in steps)


def broken(clauses, steps):
    """A proof with a step less, a literal less, another literal, steps exchanged, none of its end; or another formula."""
    clauses, steps = list(clauses), list(steps)
    i, way = draw.randrange(len(steps)), draw.randrange(7)
    kind, literals = steps[i]
    if way == 0:
        del steps[i]
    elif way == 1 and literals:
        steps[i] = kind, literals[1:]
    elif way == 2 and literals:
        steps[i] = kind, (-literals[0], *literals[1:])
    elif way == 3:
        j = draw.randrange(len(steps))
        steps[i], steps[j] = steps[j], steps[i]
    elif way == 4:
        del steps[i:]
    elif way == 5:
        del clauses[draw.randrange(len(clauses))]
    elif way == 6:
        steps.insert(0, ("d ", clauses[draw.randrange(len(clauses))]))
    return clauses, steps


def judge(named):
    done = subprocess.run([program, *named], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


os.chdir(tempfile.mkdtemp())
cases, said = [], {"UNSATISFIABLE": 0, "REFUSED": 0}
while len(cases) < count:
    formula = [tuple(draw.choice((v, -v)) for v in draw.sample(range(1, VARIABLES + 1), draw.choice((2, 3, 3)))) for _ in range(40)]
    proof = refutation(formula)
    if proof is not None:
        cases.append((formula, proof))
        for _ in range(24):
            case = formula, proof
            for _ in range(draw.randrange(1, 9)):
                case = broken(*case) if case[1] else case
            cases.append(case)
for number, (formula, proof) in enumerate(cases):
    with open(f"{number}.cnf", "w") as file:
        file.write("c a comment\n" * (number % 2) + dimacs(formula))
    with open(f"{number}.drat", "wb") as file:
        file.write((text, binary)[number % 3 == 0](proof))
code, out = judge([f"{number}.cnf" for number in range(len(cases))])
for line, (number, (formula, proof)) in zip(out.splitlines(), enumerate(cases)):
    found, right = line.split()[1], verdict(formula, proof)
    said[found] += 1
    if found != right or line.split(":")[0] != f"{number}.cnf" or found == "UNSATISFIABLE" and has_model(formula):
        failed.append(f"{line}, not {right}: {formula} {proof}")
if code != 4 or min(said.values()) < count // 9 or sum(said.values()) != len(cases):
    failed.append(f"exit code {code}, {said}")

# Files that do not say one thing, and calls that are none.
GOOD, PROOF = "p cnf 1 2\n1 0\n-1 0\n", b"0\n"
for what, formula, proof, wanted in (
        ("both right", GOOD, PROOF, 0), ("a clause less than it says", "p cnf 1 3\n1 0\n-1 0\n", PROOF, 2), ("no head", "1 0\n-1 0\n", PROOF, 2),
        ("a blank too many", "p cnf 1 2\n1  0\n-1 0\n", PROOF, 2), ("no end", "p cnf 1 2\n1 0\n-1", PROOF, 2), ("no number", "p cnf 1 2\n1 0\nx 0\n", PROOF, 2),
        ("a comment inside", "p cnf 1 2\n1 0\nc\n-1 0\n", PROOF, 2), ("a large number", "p cnf 1 2\n1 0\n-9999999999 0\n", PROOF, 2),
        ("an empty file", "", PROOF, 2), ("an empty clause", "p cnf 1 1\n0\n", b"", 0), ("no clause", "p cnf 1 0\n", PROOF, 4),
        ("a lemma without its end", "p cnf 2 2\n1 2 0\n-1 0\n", b"2", 2), ("a word in the proof", "p cnf 2 2\n1 2 0\n-1 0\n", b"x 0\n", 2),
        ("half a step", "p cnf 2 2\n1 2 0\n-1 0\n", b"a\4\0a", 2), ("another step", "p cnf 2 2\n1 2 0\n-1 0\n", b"b\0", 2), ("no proof", GOOD, None, 2)):
    with open("one.cnf", "w") as file:
        file.write(formula)
    if proof is None:
        os.remove("one.drat")
    else:
        with open("one.drat", "wb") as file:
            file.write(proof)
    code, out = judge(["one.cnf"])
    if code != wanted:
        failed.append(f"{what}: exit code {code}, not {wanted}: {out}")
for named in ([], ["one.drat"], ["--what", "one.cnf"], ["none.cnf"]):
    code, out = judge(named)
    if code != 2:
        failed.append(f"{named}: exit code {code}: {out}")
print("\n".join(failed[:9]) or f"{len(cases)} proofs: {said}")
raise SystemExit(1 if failed else 0)
