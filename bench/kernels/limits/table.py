#!/usr/bin/env python3
"""Makes results/reference/limits.md: limits/table.py FILE.json... > results/reference/limits.md

The files are what `ar3d_limits --benchmark_out=FILE.json` writes and, for the table of families, `ar3d_kernels`.
A stage is compared with its yardstick in the same file; of several files the last one counts.
Exit code 1: a benchmark failed; 2: a file is no report.
"""
import itertools
import json
import math
import re
import statistics
import sys
import types

SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}
PASSES = "some 14 random accesses per vertex, four of them of the walks over all edges"
ALONE = "the row `at_once` says what two works gain that share only the machine"
# Full name of a benchmark, goal, reason if it is missed. A goal is for one size.
GOALS = [
    (r"draw/diamond/.*/n:1000000", "≤", 2, PASSES),
    (r"draw/diamond/.*/n:10000000", "≤", 1.5, PASSES),
    (r"draw/grid/.*/n:1000000", "≤", 8, "Kempe chains, whose steps wait for one another, then the search and its copies"),
    (r"draw/two-bend/.*/n:1000000", "≤", 12, "two depth-first searches, whose steps wait for one another, and some twenty passes"),
    (r"draw/two-bend-120/.*/n:100000", "≤", 100, "the time is spread over all steps, which read in random order"),
    (r"draw/compact/.*effort:1/n:1000000", "≤", 15, "29 cells tried per vertex, and waiting for lines and ejected neighbours"),
    (r"certify/(?!two-bend-109)[\w-]+/n:10{6,7}", "≤", 3, "the drawing is fast, and every segment is computed, stored and compared"),
    (r"measure/(?!two-bend-109)[\w-]+/n:10{6,7}", "≤", 1, "the drawing is fast, and every length takes an inner product and a root"),
    (r"segment of certify/diamond/n:10{6,7}", "≤", 0.25, ""),
    (r"threads/draw/diamond/.*/n:10000000", "≥", 1.6, ALONE),
    (r"threads/certify/diamond/.*/n:1000000", "≥", 1.8, ALONE),
    (r"threads/generate/.*/n:1000000", "≥", 1.7, ALONE),
    (r"study/rows/.*/rows:2000", "≥", 1.95, ""),
    (r"memory/draw.*/n:10000000", "≤", 48, ""),
    (r"memory/whole/diamond/n:100000000", "≤", 257, ""),  # 24 GiB
    (r"memory/certify/(?!two-bend-109).*/n:1000000", "≤", 40, "24 or 32 bytes a segment in columns, and more while these are counted"),
    (r"read/graphml/ours/n:300000", "≥", 100, ""),
    (r"crossings/cgal/n:10000", "≥", 700, "ours is the whole certificate, two thirds of whose instructions count the meetings"),
    *[(f"generate/{peer}/n:1000000", "≥", goal, "the peer's time is chance, and the goal is from a run of few graphs")
      for peer, goal in (("nauty-genrang/3", 3.2), ("nauty-genrang/4", 31), ("igraph/3", 10), ("igraph/4", 16),
                         ("igraph_k_regular_game/3", 8), ("igraph_k_regular_game/4", 14))],
]


def read(path):
    """Context, and by name, without what Google Benchmark appends to it: seconds of the repetitions, counters, error."""
    found = {}
    try:
        with open(path, encoding="utf-8") as file:
            report = json.load(file)
        for run in report["benchmarks"]:
            name = re.sub(r"/(iterations:\d+|repeats:\d+|process_time|real_time|manual_time)(?=/|$)", "", run["run_name"])
            runs = found.setdefault(name, types.SimpleNamespace(seconds=[], counters=run, error=run.get("error_message", "")))
            if run["run_type"] == "iteration" and not runs.error:
                wall = re.search("/(real|manual)_time", run["run_name"]) and "/process_time" not in run["run_name"]
                runs.seconds.append(SECONDS[run["time_unit"]] * run["real_time" if wall else "cpu_time"])
                runs.counters = run
        return report["context"], found
    except (OSError, ValueError, KeyError, TypeError) as error:
        print(f"table.py: {path}: not a report of Google Benchmark: {error!r}", file=sys.stderr)
        raise SystemExit(2) from None


def median(runs):
    return statistics.median(runs.seconds)


def time(runs):
    per_vertex = f" ({1e9 * median(runs) / runs.counters['vertices']:.4g} ns a vertex)" if "vertices" in runs.counters else ""
    return f"{median(runs):.3g} s{per_vertex}"


def ratio(stage, yard, exponent=1, unit="×"):
    return (median(stage) / median(yard)) ** exponent, unit, f"{time(stage)}; beside it {time(yard)}"


def mean_of_peer(peer, ours):
    mean, own, count = statistics.mean(peer.seconds), statistics.mean(ours.seconds), len(peer.seconds)
    error = f" ± {statistics.stdev(peer.seconds) / math.sqrt(count):.2g} s" if count > 1 else ""
    return mean / own, "× ours", f"means of {count}: {mean:.3g} s{error}, ours {own:.3g} s"


# Name of a stage, the names of its yardstick (%s: groups of the stage's name), and the function of both that measures.
STAGES = [
    (r"machine/chains?/mib:\d+", "", lambda stage, _: (1e9 * median(stage) / stage.counters["reads"], " ns a read", "")),
    (r"machine/(?:read|copy)/mib:\d+|read/graphml/\w+/n:\d+", "", lambda stage, _: (stage.counters["bytes"] / median(stage) / 1e6, " MB/s", time(stage))),
    (r"memory/certify/.*", "", lambda stage, _: (stage.counters["bytes"] / stage.counters["segments"], " bytes a segment", "")),
    (r"memory/(?!certify).*", "", lambda stage, _: (stage.counters["bytes"] / stage.counters["vertices"], " bytes a vertex", "")),
    (r"draw/(?!search)[\w-]+/(random[\w-]+)(?:/effort:\d)?(/n:\d+)", "draw/search/%s%s", ratio),
    (r"bisect/.*", "", lambda stage, _: (1e3 * median(stage), " ms", f"at least {stage.counters['bisection']:.0f} edges")),
    (r"(?:certify|measure|closest)/([\w-]+)(/n:\d+)", r"draw/%s/[\w-]+/effort:1%s", ratio),
    (r"certify/[\w-]+/n:\d+", "", lambda stage, _: (1e6 * median(stage) / stage.counters["segments"], " µs a segment", f"{stage.counters['segments']:.0f} segments")),
    (r"(threads/.*/threads:|study/rows/workers:)2(/\w+:\d+)", "%s1%s", lambda stage, yard: ratio(stage, yard, -1, "× faster")),
    (r"at_once/(.*)(/n:\d+)/threads:2", "threads/%s/threads:1%s", lambda stage, yard: ratio(stage, yard, -1, "× faster")),
    (r"crossings/cgal(/n:\d+)", "crossings/ours%s", mean_of_peer),
    (r"generate/(?!ours)[\w-]+(/\d/n:\d+)", "generate/ours%s", mean_of_peer),
]


def line_of(name, yardstick, measure, found):
    """One line of the table, "" where the yardstick was not asked for."""
    beside = next((other for other in found if yardstick and re.fullmatch(yardstick, other)), "")
    if yardstick and not beside:
        return ""
    start = f"| `{name}` | {beside and f'`{beside}`'} |"
    error = found[name].error or (found[beside].error if beside else "")
    if error:
        return f"{start} – | | – | {'not measured, ' if error.startswith('missing') else 'failed: '}{error} |"
    value, unit, remark = measure(found[name], found.get(beside))
    label = "segment of " * ("µs" in unit) + name
    sign, goal, why = next((rest for pattern, *rest in GOALS if re.fullmatch(pattern, label)), ("", "", ""))
    met = sign and ("yes" if (value <= goal if sign == "≤" else value >= goal) else "no")
    remark += f"{'; ' * bool(remark)}missed: {why or 'reason not known'}" if met == "no" else ""
    return f"{start} {value:{'.0f' if value >= 100 else '.3g'}}{unit} | {sign} {goal} | {met} | {remark} |"


def lines_of_families(found):
    """Drawing beside the search by family and size, and how the ratio grows from 10^4 on."""
    rows = {}
    for name, stage in found.items():
        match = re.fullmatch(r"draw/([\w-]+/([\w-]+))/(\d+)", name)
        yard = match and found.get(f"search/{match[2]}/{match[3]}")
        if yard and stage.seconds and yard.seconds:
            rows.setdefault(match[1], {})[int(match[3])] = (1e9 * median(stage) / int(match[3]), median(stage) / median(yard))
    for name, cells in sorted(rows.items()):
        grown = [(math.log(n), math.log(times)) for n, (_, times) in cells.items() if n >= 5000]
        shown = "; ".join(f"{n}: {ns:.0f}, {times:.3g}" for n, (ns, times) in sorted(cells.items()))
        yield f"| `{name}` | {shown} | {f'{statistics.linear_regression(*zip(*grown)).slope:+.2f}' if len(grown) > 1 else '–'} |"


def main(paths):
    reports = [read(path) for path in paths]
    print("# The limits\n\nMade by `bench/kernels/limits/table.py`; [performance.md](../../docs/performance.md) says how. Where the load passes 1, ratios of CPU times scatter, and wall times say nothing. Every family: [limits-families.md](limits-families.md).\n")
    lines = {}
    for context, found in reports:
        loads = [run.counters["load"] for run in found.values() if "load" in run.counters]
        print(f"- {context.get('ar3d', 'unknown build')}, {context['num_cpus']} cores of {context['mhz_per_cpu']} MHz, {context['date'][:10]}; "
              f"medians of {max((len(run.seconds) for run in found.values()), default=0)}; load average before "
              f"{context['load_avg'][0]:.2f}{f', while it ran at most {max(loads):.2f}' if loads else ''}")
        for name, (kind, (pattern, yardstick, measure)) in itertools.product(found, enumerate(STAGES)):
            if match := re.fullmatch(pattern, name):
                line = line_of(name, yardstick % match.groups() if yardstick else "", measure, found)
                lines.update({(kind, re.sub(r"\d+", lambda n: n[0].zfill(9), name)): line} if line else {})
    print("\n| benchmark | beside | measured | goal | met | |\n|---|---|---|---|---|---|", *(lines[key] for key in sorted(lines)), sep="\n")
    if families := [line for _, found in reports for line in lines_of_families(found)]:
        print("\n## Families\n\nn: nanoseconds per vertex, ratio to the search. Growth: the ratio grows like n to that power, from 10^4 on.\n\n"
              "| row | | growth |\n|---|---|---|\n" + "\n".join(families))
    return any("| failed: " in line for line in lines.values())


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]) if sys.argv[1:] else print(__doc__, file=sys.stderr) or 2)
