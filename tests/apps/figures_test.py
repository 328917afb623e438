"""Pictures of `ar3d figures`, looked at as a reader would: the axes are large, texts do not cover each other, something is drawn."""
import itertools
import json
import math
import shutil
import sys
import unittest

from program import SOURCE, Program

sys.path.insert(0, str(SOURCE / "python" / "ar3d"))
import figures  # pylint: disable=wrong-import-position
import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # pylint: disable=wrong-import-position

STUDY = """study = "pictures"
seed = 1
accept_unproved = true
[[sweep]]
families = "all"
sizes = SIZES
algorithms = "diamond"
[[sweep]]
families = ["random-cubic", "ladder"]
sizes = SIZES
algorithms = ["diamond", "two-bend", "grid", "compact"]
timed_repetitions = 1
strong = { threads = [1, 2] }
weak = { threads = [1, 2] }
[[sweep]]
families = ["random-cubic", "prism"]
sizes = SIZES
algorithms = { algorithm = "two-bend-paper", type = [0, 1] }
[[sweep]]
graphs = [{ file = "small.g6" }]
algorithms = ["diamond", "two-bend", "grid", "compact"]
"""
GROWING = ("side", "x", "y", "z", "volume", "time", "bends", "share", "precision")
ALL = GROWING + ("trade", "profile", "scaling")


def copies(tables, count):
    """Returns the tables with as many settings as asked for, by repeating the settings one after the other under other names."""
    old_settings, old_curves = len(tables["settings"]), len(tables["bounds"])
    times = -(-count // old_settings)
    made = {}
    for name, rows in tables.items():
        of_setting = rows and "setting" in rows[0] and name != "settings"
        of_curve = rows and "curve" in rows[0]
        made[name] = list(rows)
        for copy in range(1, times) if of_setting or of_curve or name in ("settings", "bounds", "scaling") else ():
            for row in rows:
                row = dict(row)
                if name == "settings":
                    row["setting"] = f"{row['setting']}, copy {copy}"
                if of_setting and isinstance(row["setting"], int):
                    row["setting"] += copy * old_settings
                if of_curve:
                    row["curve"] += copy * old_curves
                if name == "scaling":
                    row["algorithm"] += f", copy {copy}"
                made[name].append(row)
    return made


class FiguresAsSeen(Program):
    """Every quantity, for one n and several, for one line and thirty."""

    def tables_of(self, name, sizes):
        with open("small.g6", "w", encoding="ascii") as file:
            file.write("".join(line + "\n" for line in ("C~", "EFz_", "E{Sw", "Dhc", "G~?GW[", "Cr", "C]", "CF", "Bw", "Bg", "Ch", "DQc", "D?{", "DLo", "DUW", "ECYW", "EEh_", "EQjO", "E?Bw", "EhEG", "EhCG")))
        with open(f"{name}.toml", "w", encoding="ascii") as file:
            file.write(STUDY.replace("SIZES", sizes))
        self.expect(f"ar3d study run {name}.toml -o {name}.h5 -q && ar3d report {name}.h5 --json {name}.json")
        return figures.load(f"{name}.json")

    def look_at(self, tables, quantity, **chosen):
        pyplot.close("all")
        figure = figures.page_of(pyplot, [quantity], 84 / 25.4, lambda axes, name: figures.draw(axes, tables, name, **chosen))
        said = (quantity, chosen.get("families"), len(tables["settings"]))
        renderer = figure.canvas.get_renderer()
        figure.draw(renderer)
        axes, whole = figure.axes[0], figure.bbox
        inner = axes.get_window_extent(renderer)
        self.assertGreaterEqual(inner.width * inner.height, 0.5 * whole.width * whole.height, said)
        legend = axes.get_legend()
        ticks = [tick.label1 for axis, (low, high) in ((axes.xaxis, sorted(axes.get_xlim())), (axes.yaxis, sorted(axes.get_ylim())))
                 for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks()) if low <= tick.get_loc() <= high]
        texts = [text for text in [axes.xaxis.label, axes.yaxis.label, axes.title, *legend.get_texts(), *ticks] if text.get_visible() and text.get_text()]
        shown = [(text.get_text(), text.get_window_extent(renderer)) for text in texts]
        for text, box in shown:
            self.assertTrue(box.x0 >= -1 and box.y0 >= -1 and box.x1 <= whole.x1 + 1 and box.y1 <= whole.y1 + 1, (said, text))
        for (one, a), (other, b) in itertools.combinations(shown, 2):
            across, up = min(a.x1, b.x1) - max(a.x0, b.x0), min(a.y1, b.y1) - max(a.y0, b.y0)
            self.assertFalse(across > 1 and up > 1, (said, one, other))
        for text in legend.get_texts():
            box = text.get_window_extent(renderer)
            self.assertFalse(min(box.x1, inner.x1) - max(box.x0, inner.x0) > 1 and min(box.y1, inner.y1) - max(box.y0, inner.y0) > 1, (said, text.get_text()))
            self.assertTrue(whole.x0 <= box.x0 and box.x1 <= whole.x1 and whole.y0 <= box.y0, (said, text.get_text()))
        inside = 0
        for line in axes.lines:
            points = [(x, y) for x, y in axes.transData.transform([(x, y) for x, y in zip(line.get_xdata(), line.get_ydata())]).tolist()] if len(line.get_xdata()) else []
            seen = [(x, y) for x, y in points if math.isfinite(x) and math.isfinite(y) and inner.x0 - 1 <= x <= inner.x1 + 1 and inner.y0 - 1 <= y <= inner.y1 + 1]
            inside += len(seen) if line.get_marker() not in ("", "None", None) or len(seen) > 1 else 0
        self.assertGreater(inside, 0, said)
        return figure

    def look_at_all(self, counts, sizes, few):
        all_tables = [self.tables_of(f"study{i}", text) for i, text in enumerate(sizes)]
        for tables in all_tables:
            for quantity in ALL:
                self.look_at(tables, quantity)
        for count in (count for count in counts if count > 2):
            many = copies(all_tables[0], count)
            for quantity in ALL:
                self.look_at(many, quantity)
        names = list(dict.fromkeys(curve["family"] for curve in all_tables[0]["bounds"] if curve["algorithm"] == "diamond" and not curve["is_collection"]))
        names.remove("edgeless")
        self.assertGreaterEqual(len(names), 30)
        for count, tables, quantity in itertools.product(counts, all_tables, few):
            self.look_at(tables, quantity, algorithms=["diamond"], families=names[:count])

    def test_every_quantity_is_legible(self):
        self.look_at_all((1, 30), ["[12, 40, 120]"], ("volume",))
        tables = self.tables_of("single", "40")
        for quantity in ALL:
            self.look_at(tables, quantity)
        for quantity in ("side", "time", "precision"):
            self.look_at(tables, quantity, families=["random-cubic"])

    def test_a_figure_shows_what_the_tables_say(self):
        tables = self.tables_of("one", "{ from = 12, to = 1200, per_decade = 4 }")
        axes = self.look_at(tables, "x", algorithms=["diamond"], families=["ladder"], over=1.0).axes[0]
        lines = {line.get_label(): line for line in axes.lines}
        curve = next(index for index, row in enumerate(tables["bounds"]) if (row["algorithm"], row["family"]) == ("diamond", "ladder"))
        rows = sorted((row for row in tables["curves"] if row["curve"] == curve and row["quantity"] == "x extent"), key=lambda row: row["n"])
        drawn = next(line for label, line in lines.items() if label.startswith("ladder"))
        for y, row in zip(drawn.get_ydata(), rows, strict=True):
            self.assertAlmostEqual(y, row["median"] * row["divisor"] / row["n"], delta=1e-4 * y)
        bound = next(line for label, line in lines.items() if "16/3 n" in label)
        for y in bound.get_ydata():
            self.assertAlmostEqual(y, 16 / 3, delta=1e-3)
        self.assertEqual(bound.get_linestyle(), "--")
        law = next(row for row in tables["growth"] if row["curve"] == curve and row["quantity"] == "x extent")
        self.assertIn(f"{law['exponent']:.2f}", drawn.get_label())
        axes = self.look_at(tables, "bends", algorithms=["diamond"], families=["ladder"]).axes[0]
        self.assertEqual(set(axes.lines[0].get_ydata()), {3})
        self.assertEqual([(line.get_linestyle(), set(line.get_ydata())) for line in axes.lines if line.get_label() == "theorem's bound"], [("--", {3})])
        axes = self.look_at(tables, "trade", algorithms=["diamond", "grid"], families=["ladder"]).axes[0]
        seen = next((line.get_xdata()[0], line.get_ydata()[0]) for line in axes.lines if line.get_label() == "diamond")
        last = {row["quantity"]: row["median"] * row["divisor"] for row in tables["curves"] if row["curve"] == curve and row["n"] == 1200}
        self.assertEqual(seen, (last["drawing time"], last["volume"]))
        axes = self.look_at(tables, "precision").axes[0]
        self.assertIn("grid: 0, exact integers", [text.get_text() for text in axes.get_legend().get_texts()])
        looks = [tuple(map(str, look.values())) for look in itertools.islice(figures.styles(), 30)]
        self.assertEqual(len({look[1:] for look in looks}), 30, "marks and dashes alone tell 30 lines apart")

    def test_what_a_study_does_not_have_is_refused(self):
        with open("one.toml", "w", encoding="ascii") as file:
            file.write('study = "one"\nseed = 1\n[[sweep]]\nfamilies = ["edgeless", "ladder"]\nsizes = 12\nalgorithms = "diamond"\n')
        self.expect("ar3d study run one.toml -o one.h5 -q")
        for quantity in ("time", "trade", "profile", "precision", "scaling"):
            self.refused(f"ar3d figures one.h5 -o f --quantity {quantity}", f"--quantity {quantity}")
        self.refused("ar3d figures one.h5 -o f --quantity bends --families edgeless", "no drawings with edges")
        self.refused("ar3d figures one.h5 -o f --quantity trade --over 2", "--over")
        self.refused("ar3d figures one.h5 -o f --over x", "'x' is not an exponent")
        self.assertFalse(shutil.os.path.exists("f/bends.pdf"))
        self.expect("ar3d figures one.h5 -o f --quantity bends,share --format png")


class FiguresAsSeenLong(FiguresAsSeen):
    """More numbers of lines, sizes and quantities."""

    def test_every_quantity_is_legible(self):
        self.look_at_all((1, 2, 8, 30), ["[12, 40, 120]", "40", "{ from = 12, to = 12000, per_decade = 3 }"], GROWING[:5] + ("bends", "share"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
