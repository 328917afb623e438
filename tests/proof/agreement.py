"""agreement.py AR3D PROVED COUNT [SEED]: `ar3d verify` and ar3d_proved must say the same of COUNT drawings.

All algorithms; small graphs of all kinds and families; as drawn, damaged, two laid over each other. No promise is left out."""
import collections
import pathlib
import sys
import tempfile

import drawings

ar3d, proved, count = sys.argv[1], sys.argv[2], int(sys.argv[3])
seed = int(sys.argv[4]) if len(sys.argv) > 4 else 1


def say_cpp(folder, lines):
    """The kinds of violation of each drawing."""
    said = drawings.run(ar3d, "verify", str(folder / "d.jsonl"), "--graphs", str(folder / "g.g6"), "--threads", "1", codes=(0, 4))
    found = collections.defaultdict(set)
    for line in said.splitlines():
        parts = line.split(":")
        if len(parts) > 2 and parts[1].isdigit():
            found[int(parts[1])].add(parts[2].strip())
    bad = sum(1 for kinds in found.values() if kinds)
    if said.splitlines()[-1] != f"{lines - bad} certified, {bad} violated, 0 not drawn":
        raise SystemExit(f"ar3d verify did not judge every drawing: {said.splitlines()[-1]}")
    return [found[i] for i in range(1, lines + 1)]


def say_proved(folder, lines, promise):
    said = drawings.run(proved, str(folder / "d.jsonl"), "--graphs", str(folder / "g.g6"), *promise, codes=(0, 4)).splitlines()
    verdicts = [line.split()[1] for line in said[:-1]]
    if len(verdicts) != lines or not set(verdicts) <= {"GOOD", "REFUSED"}:
        raise SystemExit("ar3d_proved did not judge every drawing")
    return [v == "GOOD" for v in verdicts]


table, wrong, good = collections.Counter(), [], collections.Counter()
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    algorithms = [*drawings.DEGREE, *drawings.PIECES]
    for index, algorithm in enumerate(algorithms):
        share = count // len(algorithms) + (index < count % len(algorithms))
        if degree := drawings.DEGREE.get(algorithm):
            graphs = drawings.small_graphs(ar3d, degree, 7 if degree == 4 else 8, share // 8 + 1)
        else:
            graphs = drawings.pieces(ar3d, algorithm, min(60, share // 8))
        drawn = drawings.draw(ar3d, algorithm, graphs)
        cases = drawings.broken([d for d in drawn if d[0]["n"] <= 31], max(0, share - len(drawn)), seed + index)
        cases = [("drawn", *d) for d in drawn] + cases
        (folder / "d.jsonl").write_text("".join(drawings.text(d) + "\n" for _, d, _ in cases))
        (folder / "g.g6").write_text("".join(g + "\n" for _, _, g in cases))
        promise = drawings.run(ar3d, "list", "--promise", algorithm).split()
        kinds = say_cpp(folder, len(cases))
        for (kind, d, graph), violations, fine in zip(cases, kinds, say_proved(folder, len(cases), promise)):
            table[kind, "good" if fine else "refused"] += 1
            for violation in violations:
                good[violation] += 1
            if fine == bool(violations):
                wrong.append((algorithm, kind, fine, sorted(violations), graph, drawings.text(d)))
for row, times in sorted(table.items()):
    print(*row, times)
print("violations:", *(f"{k} {v}," for k, v in sorted(good.items())))
print(f"{sum(table.values())} drawings, {len(wrong)} verdicts differ")
for case in wrong[:5]:
    print("DIFFERS", *case)
needed = {"good", "refused"}
if wrong or sum(table.values()) != count or {verdict for _, verdict in table} != needed or len(good) < 8:
    raise SystemExit(1)
