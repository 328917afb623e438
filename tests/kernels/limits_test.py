"""The benchmarks of docs/performance.md and the table that is made of them: every one is measured, save where a peer is missing,
and goals are judged at their own sizes only."""
import collections
import json
import pathlib
import re

from program import AR3D, SOURCE, Program, main, run, write

KERNELS = pathlib.Path(AR3D).parents[1] / "bench" / "kernels"
LIMITS = f"{KERNELS}/ar3d_limits"
TABLE = f"/usr/bin/python3 {SOURCE}/bench/kernels/limits/table.py "
# Algorithms, each with the family that it is measured on.
DRAWN = {"diamond": "random-4-regular", "compact": "random-4-regular", "grid": "random-cubic", "two-bend": "random-cubic",
         "compact-120": "random-cubic", "two-bend-109": "random-4-regular"}
# Parts of rows that need another program, a library or a right that a machine may lack.
MAY_BE_UNMEASURED = ("nauty-genrang", "crossings/cgal", "memory/")


def lines_of(table):
    """The cells of the table's lines, without its head."""
    return [line[2:].split("|")[:-1] for line in table.splitlines() if line.startswith("| `")]


def number(cell):
    return float(re.match(r" [\d.e+-]+", cell)[0])


def made_up(times, **more):
    """A report of benchmarks with these names and times, in seconds."""
    return json.dumps({
        "context": {"num_cpus": 2, "mhz_per_cpu": 1, "date": "2026-01-02", "load_avg": [0.5]},
        "benchmarks": [{"run_name": name, "run_type": "iteration", "cpu_time": seconds, "real_time": 1, "time_unit": "s", **more}
                       for name, seconds in times]})


class Limits(Program):

    def report(self, program, pattern):
        """The table of the benchmarks that the pattern finds, run once."""
        self.expect(f"{program} --benchmark_repetitions=1 --benchmark_filter='{pattern}' --benchmark_out=report.json")
        return self.expect(TABLE + "report.json").out

    def test_every_row_is_measured_and_none_is_judged_at_small_sizes(self):
        table = self.report(LIMITS, "/(n:1000|mib:1|rows:20)/")
        self.assertIn("load average before", table)
        rows = collections.Counter()
        for cells in lines_of(table):
            self.assertEqual(len(cells), 6, cells)
            name, _, measured, _, met, remark = cells
            rows[name] += 1
            self.assertNotIn("missed", remark, cells)
            if any(part in name for part in MAY_BE_UNMEASURED) and measured.startswith(" –"):
                self.assertEqual(met, " – ", cells)
                self.assertTrue(remark.startswith(" not measured, missing"), cells)
                continue
            self.assertGreater(number(measured), 0, cells)
            self.assertEqual(met, "  ", cells)
        names = [f"draw/{algorithm}/{family}/effort:1/n:1000" for algorithm, family in DRAWN.items()]
        names += [f"{stage}/{algorithm}/n:1000" for stage in ("certify", "measure", "closest", "memory/certify") for algorithm in DRAWN]
        names += ["machine/chain/mib:1", "bisect/random-cubic/n:1000", "draw/boost_search/random-cubic/n:1000", "draw/diamond/random-4-regular/effort:0/n:1000",
                  "threads/draw/diamond/effort:0/threads:2/n:1000", "at_once/draw/diamond/effort:0/n:1000/threads:2",
                  "threads/certify/diamond/threads:2/n:1000", "memory/draw/diamond/n:1000", "memory/draw_and_measure/diamond/n:1000",
                  "memory/whole/diamond/n:1000", "read/graphml/ours/n:1000", "crossings/cgal/n:1000", "generate/nauty-genrang/3/n:1000",
                  "generate/igraph/4/n:1000", "generate/igraph_k_regular_game/4/n:1000", "threads/generate/3/threads:2/n:1000",
                  "study/rows/workers:2/rows:20"]
        self.assertEqual([name for name in names if not rows[f"`{name}` "]], [])

    def test_every_algorithm_is_drawn_at_large_sizes(self):
        names = run(f"{LIMITS} --benchmark_list_tests").out
        self.assertHas(names, [f"draw/{algorithm}/{family}/effort:1/n:{n}/" for algorithm, family in DRAWN.items() for n in (100000, 1000000)])
        self.assertNotIn("n:10000000", names, "large graphs are asked for")
        self.assertNotIn("n:1000/", names)

    def test_a_goal_is_judged_at_its_size(self):
        lines = lines_of(self.report(LIMITS, "^study/.*rows:2000/"))
        self.assertEqual(len(lines), 1)
        _, _, measured, _, met, remark = lines[0]
        self.assertIn(met, (" yes ", " no "))
        if number(measured) < 1.94:  # rounded
            self.assertEqual(met, " no ")
            self.assertIn("missed: ", remark, "with the reason")
        if number(measured) > 1.96:
            self.assertEqual(met, " yes ")

    def test_ratios_are_those_of_medians_and_the_last_file_counts(self):
        draw = "draw/diamond/random-4-regular/effort:1/n:1000000/iterations:1"
        search = "draw/search/random-4-regular/n:1000000/iterations:1"
        write("slow.json", made_up([(draw, 2), (draw, 99), (draw, 3), (search, 1), (search, 1)]))
        write("good.json", made_up([(draw, 2), (search, 1)]))
        self.assertHas(run(TABLE + "slow.json").out, ["| 3× | ≤ 2 | no |", "missed: some 14 random accesses"])
        both = self.expect(TABLE + "slow.json good.json", out="| 2× | ≤ 2 | yes |")
        self.assertNotIn("3×", both.out)
        write("alone.json", made_up([(draw, 2)]))
        self.assertEqual(lines_of(run(TABLE + "alone.json").out), [], "its yardstick was not asked for")

    def test_what_failed_and_what_is_missing_are_told_apart(self):
        for message, code, told in (("missing: a peer", 0, "not measured, "), ("not valid", 1, "failed: ")):
            write("e.json", made_up([("read/graphml/ours/n:300000", 1)], error_occurred=True, error_message=message))
            self.expect(TABLE + "e.json", code, told + message)
        for text in ("", "{}", "[1]", '{"context": {}, "benchmarks": [{}]}'):
            write("bad.json", text)
            self.refused(TABLE + "bad.json", "bad.json: not a report of Google Benchmark")

    def test_families_have_nanoseconds_and_ratios_for_every_size(self):
        """Every family that an algorithm draws has a line with a ratio for every size."""
        table = self.report(f"{KERNELS}/ar3d_kernels --benchmark_min_time=0",
                            "^(draw/(grid|diamond)|search)/(cycle|random-4-regular|random-cubic)/(1000|10000)/")
        rows = {name: cells for name, *cells in lines_of(table)}
        for name, cells in rows.items():
            self.assertEqual(len(cells), 2, name)
            self.assertRegex(cells[0], "1000: [1-9][0-9]*, [0-9.]+; 10000: [1-9][0-9]*, [0-9.]+", name)
            self.assertEqual(cells[1], " – ", "no growth from one size")
        self.assertIn("`grid/random-cubic` ", rows)
        self.assertIn("`diamond/random-4-regular` ", rows)
        self.assertNotIn("`grid/random-4-regular` ", rows, "its degree is too large")

    def test_bad_arguments_are_errors(self):
        self.expect(f"{LIMITS} --colour", 2)
        self.expect(TABLE, 2)


class PrecisionTables(Program):
    """The tables of docs/precision.md: their commands run, and say what the page says of them."""
    PRECISION = f"{KERNELS}/ar3d_precision "

    def test_all_takes_a_picture_and_the_whole_report_is_one_command(self):
        """The commands of docs/precision.md; the tables of `all` take minutes and are not made here."""
        self.expect(self.PRECISION + "--help", out="--picture")
        write("s.toml", 'study = "few"\n[[sweep]]\nfamilies = "cycle"\nsizes = 5\nalgorithms = "grid"\n')
        write("tables", '#!/bin/sh\necho "$@"\ntouch "$3"\n')
        command = f"chmod +x tables && AR3D={AR3D} AR3D_PRECISION=$PWD/tables {SOURCE}/tools/precision-report $PWD/report s.toml"
        self.assertRegex(self.expect(command).out, "tables.md and signs.svg in .*report: [0-9]+ s")
        folder = pathlib.Path.cwd() / "report"
        self.assertEqual((folder / "tables.md").read_text(), f"all --picture {folder}/signs.svg\n")
        for name in ("precision.h5", "precision.html", "signs.svg"):
            self.assertTrue((folder / name).exists(), name)
        self.expect(command, 2)  # the folder exists

    def test_widths_follow_from_the_bounds(self):
        self.expect(self.PRECISION + "widths", out=["| `diamond` | 4095 |", "| 268435455 |"])  # 8 n <= 2^15 - 1

    def test_predicates_are_right_where_the_range_check_proves_them(self):
        """Nothing is wrong that it proves. Doubles hold 53 bits."""
        table = self.expect(self.PRECISION + "predicates").out
        self.assertRegex(table, r"`two-bend` \| 100 \| angle as drawn \| 49 \| [^|]* \| 0 ")
        self.assertRegex(table, r"`two-bend` \| 100000 \| angle, one unit off \| 130 \| [^|]* \| [1-9][^|]*%")

    def test_far_from_the_origin_misses_grow_as_predicted(self):
        self.expect(self.PRECISION + "shift", out="| double | 1e-06 | 2^26 to 2^27 | 2^27 |")

    def test_nests_miss_from_the_depth_that_the_condition_predicts(self):
        """Seen onsets lie in the predicted band, or a level or two beside it."""
        self.expect(self.PRECISION + "nests --depth 12",
                    out=["| hexagons in K4 | float | 0.01 |", "| heptagons in C5 | double | broken |  | > 12 |",
                         "| hexagons in the cube | float | 0.01 |", "| heptagons, then as many hexagons, in C5 | float | 0.01 |"])

    def test_maps_of_wrong_signs(self):
        table = self.expect(self.PRECISION + "signs --picture signs.svg", out="| double | as drawn, steps of 1 | 0 (< ").out
        self.assertRegex(table, r"\| float \| as drawn, steps of 1 \| [0-9.e-]+ % ")
        self.assertIn("fill='#000'", pathlib.Path("signs.svg").read_text())
        self.expect(self.PRECISION + "signs --picture signs.svg", 2)


if __name__ == "__main__":
    main()
