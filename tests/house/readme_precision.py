# What docs/precision.md says of results/reference/0.2.0-precision.h5, composed from its rows.
# Usage: readme_precision.py SOURCE_DIR
import pathlib
import sys

import h5py
import numpy as np

source = pathlib.Path(sys.argv[1])
all_runs = h5py.File(source / "results/reference/0.2.0-precision.h5")["runs"][:]
is_usual = (all_runs["certificate"] == b"") | (all_runs["certificate"] == b"measured")
runs = all_runs[is_usual & (all_runs["requested_n"] == 1024) & (all_runs["instance_index"] < 5)]


def median(column, algorithm, options):
    """Of five random graphs with 1024 vertices; times in microseconds per vertex."""
    is_cubic = algorithm in ("grid", "two-bend", "two-bend-paper", "compact-120")
    family = b"random-cubic" if is_cubic else b"random-4-regular"
    rows = runs[(runs["algorithm"] == algorithm.encode()) & (runs["family"] == family)
                & np.char.startswith(runs["options"], options.encode())]
    assert len(rows) >= 5, (algorithm, options, len(rows))
    return float(np.median(rows[column] / rows["n"] * 1e6 if column.endswith("_s") else rows[column]))


def time(algorithm, effort=1):
    return median("cpu_s", algorithm, f"effort={effort}")


def proof(algorithm):
    return median("certify_s", algorithm, "effort=1")


def longer(algorithm, effort):
    return time(algorithm, effort) / time(algorithm)


def log2_volume(algorithm, effort):
    return median("log2_volume", algorithm, f"effort={effort}") - median("log2_volume", algorithm, "effort=1")


def saved(algorithm):
    return 100 * (1 - 2 ** log2_volume(algorithm, 2))


def paper(kind, column):
    return median(column, "two-bend-paper", f"type={kind}")


sentences = [
    f"- **`diamond`** draws exactly in {time('diamond'):.2f} µs and is proved in {proof('diamond'):.2g} µs. Effort 2 takes "
    f"{longer('diamond', 2):.0f} times as long for {saved('diamond'):.0f} % less volume. Effort 0, the proof's own construction, saves no time "
    f"and needs {2 ** log2_volume('diamond', 0):.2g} times the volume.",
    f"- **`grid`**: {time('grid'):.2g} µs, proved in {proof('grid'):.2g} µs. Effort 0, the proof's core alone, takes {longer('grid', 0):.2g} times as long "
    f"and {2 ** log2_volume('grid', 0):.0f} times the volume.",
    f"- **`two-bend`**: {time('two-bend'):.2g} µs, proved in {proof('two-bend'):.2g} µs. The same theorem in real arithmetic (`two-bend-paper`) takes "
    f"{paper(1, 'cpu_s'):.2g} µs in double and {paper(4, 'cpu_s'):.2g} in 237 bits. In double it is off by {paper(1, 'angle_miss') * 1e10:.1f}·10⁻¹⁰ degrees: "
    f"exactness is the faster choice.",
    f"- **`compact`**: {time('compact'):.2g} µs, proved in {proof('compact'):.2g} µs. Effort 2 takes {longer('compact', 2):.2g} times as long for "
    f"{saved('compact'):.0f} % less volume. Effort 0 takes {longer('compact', 0):.2g} of the time and 2^{log2_volume('compact', 0):.0f} times the volume.",
    f"- **`compact-120`**: {time('compact-120'):.2g} µs, proved in {proof('compact-120'):.2g} µs. Effort 2 takes {longer('compact-120', 2):.2g} times as long for "
    f"{saved('compact-120'):.0f} % less volume.",
    f"- **`two-bend-109`**: {time('two-bend-109'):.2g} µs, proved in {proof('two-bend-109'):.2g} µs: the proof is the dearest. At effort 0 the drawing is "
    f"scaled as in the proof: {longer('two-bend-109', 0):.2g} times slower, and 2^{log2_volume('two-bend-109', 0):.1f} times the volume.",
]
if "--print" in sys.argv:
    print("\n".join(sentences))
    sys.exit()
page = " ".join((source / "docs/precision.md").read_text().split())
missing = [s for s in sentences if s not in page]
measured = int((all_runs["certificate"] == b"measured").sum())
for text in (f"{len(all_runs):,} rows", f"in none of the {measured:,} is a segment of length zero or a crossing"):
    if text not in page:
        missing.append(text)
real = all_runs[all_runs["algorithm"] == b"two-bend-paper"]
assert not real["collapsed_segments"].any() and not real["crossings"].any()
print("\n".join("not said: " + s for s in missing) or "said as the rows have it")
sys.exit(bool(missing))
