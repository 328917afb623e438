"""Figures for papers from the tables that `ar3d report --json` writes, by matplotlib.

    ar3d figures RESULTS.h5 -o DIR --quantity side --width 84mm --format pdf,pgf
    python3 -m ar3d.figures TABLES.json -o DIR ...

`ar3d figures` runs this very file. To have something else, copy it, or call `draw` with axes of your own:

    tables = load("tables.json")
    draw(axes, tables, "volume", algorithms=["diamond"])
"""
import argparse
import contextlib
import json
import math
import os
import pathlib
import re
import statistics
import sys

QUANTITIES = {"side": "longest side", "x": "x extent", "y": "y extent", "z": "z extent", "volume": "volume", "time": "drawing time"}
OTHERS = ("trade", "profile", "precision", "scaling")
FORMATS = ("pdf", "svg", "pgf", "png")
MILLIMETRES = {"mm": 1.0, "cm": 10.0, "in": 25.4, "pt": 25.4 / 72.27}


class Refused(Exception):
    """Says in one line why a figure is not made."""


def load(path):
    """Returns the tables by name, each a list of rows, each a dictionary by column. Raises Refused."""
    try:
        with open(path, encoding="utf-8") as file:
            stored = json.load(file)["tables"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise Refused(f"{path}: no tables of ar3d report --json ({error})") from error
    return {name: [dict(zip([column["name"] for column in table["columns"]], row)) for row in table["rows"]] for name, table in stored.items()}


def chosen_settings(tables, algorithms):
    """Returns the places of the settings whose algorithm or name is asked for; of all if nothing is. Raises Refused."""
    known = {name for row in tables["settings"] for name in (row["setting"], row["algorithm"])}
    for name in algorithms or ():
        if name not in known:
            raise Refused(f"--algorithms {name}: the study has {', '.join(sorted(known))}")
    return [place for place, row in enumerate(tables["settings"]) if not algorithms or {row["setting"], row["algorithm"]} & set(algorithms)]


def family_of(curve):
    return {curve["family"], curve["label"], curve["name"]}


def check_families(tables, families):
    known = {curve["family"] for curve in tables["bounds"]}
    for name in families or ():
        if not any(name in family_of(curve) for curve in tables["bounds"]):
            raise Refused(f"--families {name}: the study has {', '.join(sorted(known))}")


def legend(axes):
    """Puts the names of the lines inside the axes, many of them beside."""
    many = len(axes.get_legend_handles_labels()[1]) > 6
    axes.legend(**({"loc": "upper left", "bbox_to_anchor": (1.02, 1)} if many else {}))


def draw_growth(axes, tables, quantity, settings, families):
    """Draws a quantity against n: of every setting the families' medians (line) from least to largest (band), or the families asked for."""
    name, count = QUANTITIES[quantity], 0
    order = {(row["setting"], row["quantity"]): row["order"] for row in tables["figures"]}
    for setting in settings:
        label = tables["settings"][setting]["setting"]
        if families:
            for place, curve in enumerate(tables["bounds"]):
                rows = [row for row in tables["curves"] if row["curve"] == place and row["quantity"] == name]
                if curve["setting"] != setting or not family_of(curve) & set(families) or not rows:
                    continue
                axes.plot([row["n"] for row in rows], [row["median"] * row["divisor"] for row in rows], marker=".", label=f"{label}, {curve['label']}")
                count += 1
            continue
        rows = [row for row in tables["bands"] if row["setting"] == setting and row["quantity"] == name]
        if not rows:
            continue
        scale = [row["n"] ** order[setting, name] for row in rows]
        n = [row["n"] for row in rows]
        line, = axes.plot(n, [row["median"] * s for row, s in zip(rows, scale)], marker=".", label=label)
        axes.fill_between(n, [row["least"] * s for row, s in zip(rows, scale)], [row["largest"] * s for row, s in zip(rows, scale)],
                          color=line.get_color(), alpha=0.15, linewidth=0)
        count += 1
    if not count:
        raise Refused(f"--quantity {quantity}: the study has no such values of these algorithms and families" +
                      (" (timed_repetitions in the sweep times drawings)" if quantity == "time" else ""))
    axes.set(xscale="log", yscale="log", xlabel="vertices $n$", ylabel={"time": "drawing time in s", "volume": "volume"}.get(quantity, name))
    legend(axes)


def draw_trade(axes, tables, settings):
    """Draws volume against drawing time at the largest n at which most settings have a time, with the Pareto front."""
    points = [row for row in tables["trade"] if row["time"] is not None and row["setting"] in settings and row["group"] == 0]
    if not points:
        raise Refused("--quantity trade: no two of these settings have times of a timing phase on common families")
    sizes = {}
    for row in points:
        sizes[row["n"]] = sizes.get(row["n"], 0) + 1
    n = max(sizes, key=lambda size: (sizes[size], size))
    shown = [row for row in points if row["n"] == n]
    front = sorted((row["time"], row["volume"]) for row in shown if row["front"])
    axes.step(*zip(*front), where="post", color="0.6", linestyle=":") if front else None
    for row in shown:
        axes.plot(row["time"], row["volume"], "o", label=tables["settings"][row["setting"]]["setting"])
    axes.set(xscale="log", yscale="log", xlabel="drawing time in s", ylabel=f"volume in {tables['groups'][0]['unit']}", title=f"$n$ = {n}")
    legend(axes)


def draw_lines(axes, rows, label, x, y):
    """Draws a line for each label."""
    lines = {}
    for row in rows:
        lines.setdefault(label(row), []).append((row[x], row[y]))
    for name, points in lines.items():
        axes.plot(*zip(*sorted(points)), label=name)


def draw_profile(axes, tables, settings):
    """Draws the share of a collection's graphs within a factor of the best volume, by setting."""
    rows = [row for row in tables["profile"] if row["measure"] == "volume" and row["setting"] in settings]
    if not rows:
        raise Refused("--quantity profile: the study has no collection of at least 20 graphs")
    draw_lines(axes, [row for row in rows if row["collection"] == rows[0]["collection"]], lambda row: tables["settings"][row["setting"]]["setting"], "factor", "share")
    axes.set(xscale="log", ylim=(0, 1), xlabel="factor of the best volume", ylabel="share of graphs", title=rows[0]["collection"])
    legend(axes)


def real_type(curve):
    """Returns the name of the real type that a curve's drawings are in; of any other setting its name."""
    options = re.sub(r"(^|;)level=.*$", "", curve["options"] or "")
    known = re.fullmatch("type=([0-4])", options) if curve["algorithm"] == "two-bend-paper" else None
    return ("float", "double", "binary80", "binary128", "237 bits")[int(known[1])] if known else curve["algorithm"] + (f" ({options})" if options else "")


def draw_precision(axes, tables, _settings):
    """Draws the largest miss of an angle against n, medians by real type, of the family with most drawings."""
    families, curves = {}, tables["bounds"]
    for row in tables["real_drawings"]:
        families.setdefault((curves[row["curve"]]["family"], curves[row["curve"]]["parameters"]), []).append(row)
    if not families:
        raise Refused("--quantity precision: the study has no drawings in real types")
    (family, parameters), drawings = max(sorted(families.items()), key=lambda item: len(item[1]))
    misses = {}
    for row in drawings:
        misses.setdefault((real_type(curves[row["curve"]]), row["n"]), []).append(float("inf") if row["miss"] is None else row["miss"])
    medians = [{"type": name, "n": n, "miss": math.sqrt(statistics.median_low(values) * statistics.median_high(values))} for (name, n), values in misses.items()]
    draw_lines(axes, [row for row in medians if row["miss"]], lambda row: row["type"], "n", "miss")
    title = f"{family} ({parameters})" if parameters else family
    axes.set(xscale="log", yscale="log", xlabel="vertices $n$", ylabel="largest miss in degrees", title=title)
    legend(axes)


def draw_scaling(axes, tables, settings):
    """Draws how many drawings threads or ranks make at a time."""
    names = {tables["settings"][setting]["setting"] for setting in settings}
    rows = [row for row in tables["scaling"] if row["algorithm"] in names]
    if not rows:
        raise Refused("--quantity scaling: the study has no batches of these algorithms")
    draw_lines(axes, rows, lambda row: f"{row['algorithm']}, {row['kind']}, {row['family']}, n = {row['n']}", "sharers", "at_a_time")
    most = max(row["sharers"] for row in rows)
    axes.plot([1, most], [1, most], "--", color="0.6", label="ideal")
    axes.set(xscale="log", yscale="log", xlabel=statistics.mode(row["shared_by"] for row in rows), ylabel="drawings at a time")
    legend(axes)


def draw(axes, tables, quantity, algorithms=None, families=None):
    """Draws one quantity into axes of matplotlib. Raises Refused if the study does not have it."""
    settings = chosen_settings(tables, algorithms)
    check_families(tables, families)
    if quantity in QUANTITIES:
        draw_growth(axes, tables, quantity, settings, families)
    else:
        {"trade": draw_trade, "profile": draw_profile, "precision": draw_precision, "scaling": draw_scaling}[quantity](axes, tables, settings)


def inches(text):
    found = re.fullmatch(r"([0-9]+(?:\.[0-9]+)?)(mm|cm|in|pt)", text)
    if not found or not 10 <= float(found[1]) * MILLIMETRES[found[2]] <= 1000:
        raise argparse.ArgumentTypeError(f"'{text}' is no width from 10mm to 1000mm (mm, cm, in or pt)")
    return float(found[1]) * MILLIMETRES[found[2]] / 25.4


def one_of(*names):
    def words(text):
        for word in text.split(","):
            if word not in names:
                raise argparse.ArgumentTypeError(f"'{word}' is none of {', '.join(names)}")
        return text.split(",")
    return words


def names_of(text):
    """Splits at commas outside of brackets."""
    return [name.strip() for name in re.split(r",(?![^(]*\))", text) if name.strip()]


def font_size(text):
    try:
        size = float(text)
    except ValueError:
        size = 0.0
    if not 1 <= size <= 100:
        raise argparse.ArgumentTypeError(f"'{text}' is no font size from 1 to 100")
    return size


def parser():
    made = argparse.ArgumentParser(prog="ar3d figures", description="Figures for papers from the tables of a study.")
    made.add_argument("tables", help="what `ar3d report --json` writes")
    made.add_argument("-o", "--output", default=".", help="the folder of the figures")
    made.add_argument("--quantity", type=one_of(*QUANTITIES, *OTHERS), default=["side"], help=", ".join((*QUANTITIES, *OTHERS)))
    made.add_argument("--algorithms", type=names_of, help="algorithms or settings; all if left out")
    made.add_argument("--families", type=names_of, help="a line for each of these families instead of a band for all")
    made.add_argument("--width", type=inches, default=inches("84mm"))
    made.add_argument("--font-size", type=font_size, default=8.0)
    made.add_argument("--format", type=one_of(*FORMATS), default=["pdf"])
    made.add_argument("--style", help="a style sheet of matplotlib's")
    made.add_argument("--grid", action="store_true", help="all quantities in one figure, QUANTITIES.FORMAT, two beside each other")
    made.add_argument("--force", action="store_true", help="replaces figures that exist")
    return made


def make_figures(arguments):
    """Writes DIR/QUANTITY.FORMAT, or with --grid one figure of all quantities; all or none. Raises Refused."""
    try:
        import matplotlib
        matplotlib.use("Agg")
        from matplotlib import pyplot
    except ImportError as error:
        raise Refused("figures need matplotlib: apt install python3-matplotlib") from error
    tables, folder = load(arguments.tables), pathlib.Path(arguments.output)
    pages = [arguments.quantity] if arguments.grid else [[quantity] for quantity in arguments.quantity]
    wanted = [(page, folder / ("-".join(page) + "." + ending)) for page in pages for ending in arguments.format]
    for _, path in wanted:
        if path.exists() and not arguments.force:
            raise Refused(f"{path} exists; --force replaces it")
    pyplot.rcParams.update({"font.size": arguments.font_size, "legend.fontsize": "x-small", "svg.hashsalt": "ar3d", "figure.constrained_layout.use": True, "pgf.texsystem": "pdflatex",
                            "lines.linewidth": 0.9, "lines.markersize": 2.5})
    if arguments.style:
        try:
            pyplot.style.use(arguments.style)
        except (OSError, ValueError) as error:
            raise Refused(f"--style {arguments.style}: {error}".replace("\n", " ")) from error
    made = []
    for page in pages:
        columns = min(2, len(page))
        rows = -(-len(page) // columns)
        figure, axes = pyplot.subplots(rows, columns, squeeze=False, figsize=(arguments.width, arguments.width / columns * 0.72 * rows))
        for place, quantity in enumerate(page):
            draw(axes.flat[place], tables, quantity, arguments.algorithms, arguments.families)
        for rest in axes.flat[len(page):]:
            rest.remove()
        made.append((page, figure))
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for page, figure in made:
            for path in (path for of, path in wanted if of == page):
                metadata = {"pdf": {"CreationDate": None}, "svg": {"Date": None}}.get(path.suffix[1:])
                half = path.with_name(f".{path.stem}.part{path.suffix}")
                figure.savefig(half, metadata=metadata, dpi=300)
                os.replace(half, path)
    except (FileNotFoundError, AttributeError) as error:
        raise Refused("pgf needs LaTeX: apt install texlive-latex-base texlive-pictures") from error
    except (OSError, RuntimeError) as error:
        raise Refused(f"cannot write figures into {folder}: {error}".splitlines()[0]) from error
    return [path for _, path in wanted]


def main(words=None):
    """Runs the command line. Returns 0, or 2 after one line that says what is wrong."""
    made = parser()
    made.error = lambda message: (_ for _ in ()).throw(Refused(message))
    try:
        for path in make_figures(made.parse_args(words)):
            print(f"figure   {path}", flush=True)
        return 0
    except Refused as error:
        message = error
    except OSError as error:  # of print
        message = f"cannot write to standard output: {error.strerror}"
        sys.stdout = None  # what it still holds is not tried again at the end
    with contextlib.suppress(OSError):
        print(f"ar3d: {message}", file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main())
