"""Figures for papers from the tables that `ar3d report --json` writes, by matplotlib.

    ar3d figures RESULTS.h5 -o DIR --quantity side --width 84mm --format pdf,pgf
    python3 -m ar3d.figures TABLES.json -o DIR ...

`ar3d figures` runs this very file. To have something else, copy it, or call `draw` with axes of your own:

    tables = load("tables.json")
    draw(axes, tables, "volume", algorithms=["diamond"])

Colours are those of Okabe and Ito (2008); every line has a mark and a dash pattern of its own too, so that prints in grey
can be read. The legend stands below the axes or beside them, where it leaves the axes at least 60 % of the picture.
"""
import argparse
import contextlib
import itertools
import json
import math
import os
import pathlib
import re
import statistics
import sys

# Quantities of the curves: the name in the tables, the label of the axis, and the axes of the theorem's bound in words.
QUANTITIES = {"side": ("longest side", "longest side in lattice units"), "x": ("x extent", "x extent in lattice units"),
              "y": ("y extent", "y extent in lattice units"), "z": ("z extent", "z extent in lattice units"),
              "volume": ("volume", "volume in lattice points"), "time": ("drawing time", "drawing time in s")}
OTHERS = ("bends", "share", "trade", "profile", "precision", "scaling")
FORMATS = ("pdf", "svg", "pgf", "png")
MILLIMETRES = {"mm": 1.0, "cm": 10.0, "in": 25.4, "pt": 25.4 / 72.27}
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000")
MARKS = "osD^v<>Pp*X"
DASHES = ("-", (0, (6, 1.5)), (0, (3, 1, 1, 1)), (0, (8, 1.5, 1, 1.5, 1, 1.5)), (0, (4, 2, 4, 1)))
AXES_SHARE = 0.6  # of the picture, at least
LONGEST_NAME = 44  # characters of a name in a legend


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
    """Returns the indices of the settings whose algorithm or name is asked for; of all if nothing is. Raises Refused."""
    known = {name for row in tables["settings"] for name in (row["setting"], row["algorithm"])}
    for name in algorithms or ():
        if name not in known:
            raise Refused(f"--algorithms {name}: the study has {', '.join(sorted(known))}")
    return [index for index, row in enumerate(tables["settings"]) if not algorithms or {row["setting"], row["algorithm"]} & set(algorithms)]


def names_of_curve(curve):
    return {curve["family"], curve["label"], curve["name"]}


def check_families(tables, families):
    known = {curve["family"] for curve in tables["bounds"]}
    for name in families or ():
        if not any(name in names_of_curve(curve) for curve in tables["bounds"]):
            raise Refused(f"--families {name}: the study has {', '.join(sorted(known))}")


def is_asked_for(curve, families):
    return not families or bool(names_of_curve(curve) & set(families))


def short(text, most=LONGEST_NAME):
    """Shortens a name at its end."""
    return text if len(text) <= most else text[:most - 1].rstrip(" ,(") + "…"


def parts_of(name):
    """Splits 'grid-paper (spread=1;gap=0)' into the algorithm and its options."""
    found = re.fullmatch(r"(.*?) \((.*)\)", name)
    return (found[1], re.split("[,;] ?", found[2])) if found else (name, [])


def setting_names(tables, settings):
    """Returns a name for each of the settings, by index; an option that has one value in all settings of its algorithm is left out."""
    split = {index: parts_of(tables["settings"][index]["setting"]) for index in settings}
    everywhere = {algorithm: set.intersection(*(set(options) for name, options in split.values() if name == algorithm)) for algorithm, _ in split.values()}
    names = {}
    for index, (algorithm, options) in split.items():
        own = [option for option in options if option not in everywhere[algorithm]]
        names[index] = algorithm + (f" ({', '.join(own)})" if own else "")
    return names


def styles():
    """Yields colour, mark and dashes of one line after the other: no two of the first 30 are alike in grey."""
    for i in itertools.count():
        yield {"color": COLOURS[i % len(COLOURS)], "marker": MARKS[i % len(MARKS)], "linestyle": DASHES[i // len(COLOURS) % len(DASHES)]}


def power(exponent, low, high):
    """Returns a growth for a legend: the exponent with its interval."""
    return f"$n^{{{exponent:.2f}}}$ [{low:.2f}, {high:.2f}]"


def line_of_fit(axes, points, exponent, style):
    """Draws the fitted power law through the middle of the points."""
    n = [x for x, _ in points]
    middle = statistics.fmean(math.log(y) - exponent * math.log(x) for x, y in points)
    axes.plot([n[0], n[-1]], [math.exp(middle) * x ** exponent for x in (n[0], n[-1])], color=style["color"], linestyle=":", linewidth=0.7, zorder=1)


def reduced(rows, value, scale, over):
    """Returns the points (n, value) of rows, multiplied by what the table divided them by, divided by n^over."""
    return sorted((row["n"], row[value] * scale(row) / row["n"] ** over) for row in rows if row[value] is not None and row["n"] > 0 and row[value] > 0)


def longest_axis(tables, setting):
    """Returns the axis on which the families of a setting reach the largest extent at their largest n."""
    order = {(row["setting"], row["quantity"]): row["order"] for row in tables["figures"]}
    ends = [(row["n"], row["largest"] * row["n"] ** order[setting, row["quantity"]], row["quantity"][0]) for row in tables["bands"]
            if row["setting"] == setting and row["quantity"] in ("x extent", "y extent", "z extent") and row["largest"]]
    largest = max((n for n, _, _ in ends), default=0)
    return max(((extent, axis) for n, extent, axis in ends if n == largest), default=(0, "x"))[1]


def bound_of(tables, setting, quantity, over):
    """Returns the points of the theorem's bound and its formula in words; of the longest side that of the axis which is the longest."""
    axis = longest_axis(tables, setting) if quantity == "side" else quantity
    name = QUANTITIES[axis][0]
    order = {(row["setting"], row["quantity"]): row["order"] for row in tables["figures"]}.get((setting, name), 0)
    words = [row["proved"] for row in tables["promises"] if row["setting"] == setting and row["axis"] == axis and row["proved"]]
    points = reduced([row for row in tables["bound_lines"] if row["setting"] == setting and row["quantity"] == name], "bound", lambda row: row["n"] ** order, over)
    return points, (f" of {axis}" if quantity == "side" else "") + (f", {words[0]}" if words else "")


def draw_bounds(axes, tables, quantity, setting, label, style, over, reach):
    """Draws the theorem's bound (dashed) and the bound from below (dash-dotted) of a setting over the sizes that it drew. Without a label they have
    none in the legend."""
    points, words = bound_of(tables, setting, quantity, over)
    points = [(n, y) for n, y in points if reach[0] <= n <= reach[1]]
    if points:
        axes.plot(*zip(*points), color=style["color"], linestyle="--", linewidth=0.8, label=label and short(f"{label}: theorem's bound{words}"))
    if quantity == "volume":
        order = {row["setting"]: row["order"] for row in tables["figures"] if row["quantity"] == "volume"}[setting]
        least = reduced([row for row in tables["volume_bands"] if row["setting"] == setting], "least", lambda row: row["n"] ** order, over)
        if least:
            axes.plot(*zip(*least), color=style["color"], linestyle="-.", linewidth=0.6, label=label and short(f"{label}: proved from below"))


def draw_growth(axes, tables, quantity, settings, families, over=0.0):
    """Draws a quantity against n: of every setting the families' medians (line) from least to largest (band), or the families asked for."""
    (name, label), look, count, fitted = QUANTITIES[quantity], styles(), 0, False
    names, few = setting_names(tables, settings), len(settings) <= 3
    order = {(row["setting"], row["quantity"]): row["order"] for row in tables["figures"]}
    most = LONGEST_NAME if sum(is_asked_for(curve, families) for curve in tables["bounds"]) <= 12 else LONGEST_NAME // 2
    laws = {(row["curve"], row["quantity"]): row for row in tables["growth"] if row["exponent"] is not None}
    for setting in settings:
        reach, style = None, None
        for index, curve in enumerate(tables["bounds"] if families else ()):
            points = reduced([row for row in tables["curves"] if row["curve"] == index and row["quantity"] == name], "median", lambda row: row["divisor"], over)
            if curve["setting"] != setting or not is_asked_for(curve, families) or not points:
                continue
            style, law, words = next(look), laws.get((index, name)), curve["label"] if len(settings) == 1 else f"{names[setting]}, {curve['label']}"
            words = short(words, most)
            if law and law["low"] is not None and len(points) > 1:
                line_of_fit(axes, points, law["exponent"] - over, style)
                fitted = True
                words += ": " + power(law["exponent"], law["low"], law["high"])
            axes.plot(*zip(*points), label=words, **style)
            reach = (min(points[0][0], reach[0]), max(points[-1][0], reach[1])) if reach else (points[0][0], points[-1][0])
        if not families:
            rows = [row for row in tables["bands"] if row["setting"] == setting and row["quantity"] == name]
            points = reduced(rows, "median", lambda row: row["n"] ** order[setting, name], over)
            if points:
                style, reach = next(look), (points[0][0], points[-1][0])
                draw_band(axes, tables, quantity, setting, rows, points, names[setting], style, order[setting, name], over, few)
        if reach and quantity != "time":
            draw_bounds(axes, tables, quantity, setting, names[setting] if few else None, style, over, reach)
        count += reach is not None
    if fitted:
        axes.plot([], [], color="0.4", linestyle=":", linewidth=0.8, label="fitted power law")
    if not count:
        raise Refused(f"--quantity {quantity}: the study has no such values of these algorithms and families" +
                      (" (timed_repetitions in the sweep times drawings)" if quantity == "time" else ""))
    if not few:
        for dashes, words in (("--", "theorem's bound"), ("-.", "proved from below"))[:{"time": 0, "volume": 2}.get(quantity, 1)]:
            axes.plot([], [], color="0.4", linestyle=dashes, linewidth=0.8, label=f"{words}, in the colour of its algorithm")
    axes.set(xscale="log", yscale="log", xlabel="vertices $n$", ylabel=label + (f" / $n^{{{over:g}}}$" if over not in (0, 1) else " / $n$" if over else ""))


def draw_band(axes, tables, quantity, setting, rows, points, label, style, order, over, shaded):
    """Draws the medians of a setting's families; with few settings the band from the least to the largest family, too."""
    found = [row for row in tables["exponents"] if row["setting"] == setting and row["quantity"] == QUANTITIES[quantity][0] and row["least"] is not None]
    words = short(label) + (f": $n^{{{found[0]['least']:.2f}}}$ to $n^{{{found[0]['largest']:.2f}}}$ [{found[0]['low']:.2f}, {found[0]['high']:.2f}]" if found else "")
    axes.plot(*zip(*points), label=words, **style)
    if shaded:
        ends = [dict(reduced(rows, end, lambda row: row["n"] ** order, over)) for end in ("least", "largest")]
        n = sorted(ends[0].keys() & ends[1].keys())
        families = max(row["families"] for row in rows)
        axes.fill_between(n, [ends[0][x] for x in n], [ends[1][x] for x in n], color=style["color"], alpha=0.15, linewidth=0,
                          label=short(f"{label}: least to largest of {families} families") if families > 1 else None)


def middle_by_bin(rows, value, chosen):
    """Returns for thirds of a decade of n the middle n and what `chosen` takes of the rows' values."""
    bins = {}
    for row in rows:
        bins.setdefault(round(3 * math.log10(row["n"])), []).append(row)
    return [(math.exp(statistics.fmean(math.log(row["n"]) for row in bins[key])), chosen([row[value] for row in bins[key]])) for key in sorted(bins)]


def draw_bends(axes, tables, settings, families):
    """Draws bends per edge against n: of every setting the median of its families over thirds of a decade of n, or each family by its n."""
    names, look, few = setting_names(tables, settings), styles(), len(settings) <= 3
    for setting in settings:
        rows = [row for row in tables["bends_by_n"] if row["setting"] == setting and row["n"] > 0 and is_asked_for(tables["bounds"][row["curve"]], families)]
        if not families and rows:
            style = next(look)
            axes.plot(*zip(*middle_by_bin(rows, "median", statistics.median)), label=short(names[setting]), **style)
            if few:
                ends = [middle_by_bin(rows, end, chosen) for end, chosen in (("least", min), ("largest", max))]
                axes.fill_between([n for n, _ in ends[0]], [y for _, y in ends[0]], [y for _, y in ends[1]], color=style["color"], alpha=0.15, linewidth=0,
                                  label=short(f"{names[setting]}: least to largest graph"))
            continue
        for curve in sorted({row["curve"] for row in rows}):
            label = tables["bounds"][curve]["label"] if len(settings) == 1 else f"{names[setting]}, {tables['bounds'][curve]['label']}"
            axes.plot(*zip(*sorted((row["n"], row["median"]) for row in rows if row["curve"] == curve)), label=short(label), **next(look))
    promised = {}
    for setting in settings:
        promised.setdefault(tables["settings"][setting].get("promised_bends"), []).append(names[setting])
    if not axes.lines:
        raise Refused("--quantity bends: the study has no drawings with edges of these algorithms and families")
    for dashes, bends in zip(itertools.cycle(("--", "-.", ":")), sorted(bends for bends in promised if bends is not None)):
        axes.axhline(bends, color="0.4", linestyle=dashes, linewidth=0.8, label=short("theorem's bound" + (f" of {', '.join(promised[bends])}" if len(promised) > 1 else "")))
    axes.set(xscale="log", ylim=(0, None), xlabel="vertices $n$", ylabel="bends per edge")


def draw_share(axes, tables, settings, families):
    """Draws the share of the theorem's box, on the axis nearest to its bound, against n: the largest of a setting's families, or each family."""
    names, look, count = setting_names(tables, settings), styles(), 0
    for setting in settings:
        lines = {}
        for row in tables["shares"]:
            curve = tables["bounds"][row["curve"]]
            if row["setting"] == setting and row["share"] is not None and is_asked_for(curve, families):
                line = lines.setdefault(curve["label"] if families else "", {})
                line[row["last_n"]] = max(row["share"], line.get(row["last_n"], 0))
        for family, line in lines.items():
            label = names[setting] + (f", {family}" if family else "")
            axes.plot(*zip(*sorted((n, 100 * share) for n, share in line.items() if n > 0)), label=short(label), **next(look))
            count += 1
    if not count:
        raise Refused("--quantity share: the study has no drawings with a theorem's box of these algorithms and families")
    axes.axhline(100, color="0.4", linestyle="--", linewidth=0.8, label="theorem's bound")
    axes.set(xscale="log", yscale="log", xlabel="vertices $n$", ylabel="share of the bound in %")


def trade_points(tables, settings, families):
    """Returns medians of volume and time over families by setting and n: those that all settings drew, or of the families asked for those at that n."""
    if not families:
        return [row for row in tables["trade"] if row["time"] is not None and row["setting"] in settings and row["group"] == 0]
    drawn, points = {}, []
    for row in tables["curves"]:
        curve = tables["bounds"][row["curve"]]
        if row["quantity"] in ("volume", "drawing time") and curve["setting"] in settings and is_asked_for(curve, families):
            values = drawn.setdefault(row["n"], {}).setdefault(curve["setting"], {}).setdefault(curve["label"], {})
            values["time" if row["quantity"] == "drawing time" else "volume"] = row["median"] * row["divisor"]
    for n, of_n in drawn.items():
        timed = {setting: {label: values for label, values in of.items() if len(values) == 2} for setting, of in of_n.items()}
        timed = {setting: of for setting, of in timed.items() if of}
        common = set.intersection(*map(set, timed.values())) if len(timed) > 1 else ()
        points += [{"setting": setting, "n": n} | {key: statistics.median(of[label][key] for label in common) for key in ("volume", "time")}
                   for setting, of in timed.items() if common]
    return points


def draw_trade(axes, tables, settings, families):
    """Draws volume against drawing time at the largest n at which most settings have a time, with the Pareto front."""
    points, units = trade_points(tables, settings, families), {row["unit"] for row in tables["figures"] if row["setting"] in settings and row["quantity"] == "volume"}
    if families and len(units) > 1:
        raise Refused(f"--families: --quantity trade compares volumes, which these settings have in {' and '.join(sorted(units))}")
    if not points:
        raise Refused("--quantity trade: no two of these settings have times of a timing phase on common families")
    sizes = {}
    for row in points:
        sizes[row["n"]] = sizes.get(row["n"], 0) + 1
    n, names, look = max(sizes, key=lambda size: (sizes[size], size)), setting_names(tables, settings), styles()
    shown = [row for row in points if row["n"] == n]
    front = sorted({(a["time"], a["volume"]) for a in shown
                    if not any(b["time"] <= a["time"] and b["volume"] <= a["volume"] and (b["time"], b["volume"]) != (a["time"], a["volume"]) for b in shown)})
    if len(front) > 1:
        axes.step(*zip(*front), where="post", color="0.4", linestyle=":", label="Pareto front")
    for row in shown:
        axes.plot(row["time"], row["volume"], label=short(names[row["setting"]]), **{**next(look), "linestyle": "none", "markersize": 4})
    axes.set(xscale="log", yscale="log", xlabel=f"drawing time in s, $n$ = {n:,}", ylabel=f"volume in {units.pop() if families else tables['groups'][0]['unit']}")


def draw_lines(axes, rows, label, x, y):
    """Draws a line for each label."""
    lines, look = {}, styles()
    for row in rows:
        lines.setdefault(label(row), []).append((row[x], row[y]))
    for name, points in lines.items():
        axes.plot(*zip(*sorted(points)), label=short(name), **next(look))


def draw_profile(axes, tables, settings, families):
    """Draws the share of a collection's graphs within a factor of the best volume, by setting."""
    rows = [row for row in tables["profile"] if row["measure"] == "volume" and row["setting"] in settings]
    if families:
        rows = [row for row in rows if row["collection"] in families]
    if not rows:
        raise Refused("--quantity profile: the study has no collection of at least 20 graphs" + (" of these names" if families else ""))
    names = setting_names(tables, settings)
    draw_lines(axes, [row for row in rows if row["collection"] == rows[0]["collection"]], lambda row: names[row["setting"]], "factor", "share")
    for line in axes.lines:
        line.set_marker("")
    axes.set(xscale="log", ylim=(0, 1), xlabel="factor of the best volume", ylabel=short(f"share of the graphs of {rows[0]['collection']}"))


def real_type(curve):
    """Returns the name of the real type that a curve's drawings are in; of any other setting its name."""
    options = re.sub(r"(^|;)level=.*$", "", curve["options"] or "")
    known = re.fullmatch("type=([0-4])", options) if curve["algorithm"] == "two-bend-paper" else None
    return ("float", "double", "binary80", "binary128", "237 bits")[int(known[1])] if known else curve["algorithm"] + (f" ({options})" if options else "")


def draw_precision(axes, tables, settings, families):
    """Draws the largest miss of an angle against n, medians by real type and family; settings in exact integers are named with a miss of 0."""
    curves, misses = tables["bounds"], {}
    for row in tables["real_drawings"]:
        curve = curves[row["curve"]]
        if curve["setting"] in settings and is_asked_for(curve, families) and row["n"] > 0:
            misses.setdefault((real_type(curve), curve["label"], row["n"]), []).append(float("inf") if row["miss"] is None else row["miss"])
    if not misses:
        raise Refused("--quantity precision: the study has no drawings in real types of these algorithms and families")
    several, in_real_types = len({family for _, family, _ in misses}) > 1, {curves[row["curve"]]["setting"] for row in tables["real_drawings"]}
    rows = [{"name": f"{kind}, {family}" if several else kind, "n": n, "miss": math.sqrt(statistics.median_low(values) * statistics.median_high(values))}
            for (kind, family, n), values in misses.items()]
    draw_lines(axes, [row for row in rows if row["miss"] and math.isfinite(row["miss"])], lambda row: row["name"], "n", "miss")
    for setting, name in setting_names(tables, settings).items():
        if setting not in in_real_types and tables["settings"][setting]["ok"]:
            axes.plot([], [], " ", label=short(f"{name}: 0, exact integers"))
    axes.set(xscale="log", yscale="log", xlabel="vertices $n$", ylabel="largest miss in degrees")


def draw_scaling(axes, tables, settings, families):
    """Draws how many drawings threads or ranks make at a time; of more than twelve batches those of the largest n."""
    from matplotlib import ticker
    names = {tables["settings"][setting]["setting"]: name for setting, name in setting_names(tables, settings).items()}
    rows = [row for row in tables["scaling"] if row["algorithm"] in names and (not families or row["family"] in families)]
    if not rows:
        raise Refused("--quantity scaling: the study has no batches of these algorithms and families")
    shown = {(row["algorithm"], row["kind"], row["family"], row["n"]) for row in rows}
    if len(shown) > 12:
        largest = max(row["n"] for row in rows)
        rows = [row for row in rows if row["n"] == largest]
    draw_lines(axes, rows, lambda row: f"{names[row['algorithm']]}, {row['kind']}, {row['family']}, $n$ = {row['n']:,}", "sharers", "at_a_time")
    sizes = sorted({row["sharers"] for row in rows})
    axes.plot([1, sizes[-1]], [1, sizes[-1]], "--", color="0.4", label="ideal")
    axes.set(xscale="log", yscale="log", xlabel=statistics.mode(row["shared_by"] for row in rows), ylabel="drawings at a time")
    axes.xaxis.set_major_locator(ticker.FixedLocator(sizes))
    axes.xaxis.set_major_formatter(ticker.FormatStrFormatter("%d"))
    axes.xaxis.set_minor_locator(ticker.NullLocator())


def draw(axes, tables, quantity, algorithms=None, families=None, over=0.0):
    """Draws one quantity into axes of matplotlib, divided by n^over where it grows with n. Raises Refused if the study does not have it."""
    settings = chosen_settings(tables, algorithms)
    check_families(tables, families)
    if over and quantity not in QUANTITIES:
        raise Refused(f"--over: --quantity {quantity} is no quantity that grows with n")
    if quantity in QUANTITIES:
        draw_growth(axes, tables, quantity, settings, families, over)
    else:
        {"bends": draw_bends, "share": draw_share, "trade": draw_trade, "profile": draw_profile, "precision": draw_precision, "scaling": draw_scaling}[quantity](axes, tables, settings, families)
    if not any(math.isfinite(y) for line in axes.lines if line.get_marker() not in ("None", "", None) or quantity == "profile" for y in line.get_ydata()):
        raise Refused(f"--quantity {quantity}: the study has no finite value of these algorithms and families")
    tidy_ticks(axes)
    legend_of(axes)


def round_ticks(low, high):
    """Returns round numbers on a logarithmic axis, at least 0.28 of the axis apart."""
    for mantissas in ((1, 2, 5), range(1, 10), [1 + 0.1 * i for i in range(90)], [1 + 0.01 * i for i in range(900)]):
        chosen = []
        for tick in (m * 10.0 ** k for k in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1) for m in mantissas):
            if low <= tick <= high and (not chosen or math.log(tick / chosen[-1]) >= 0.28 * math.log(high / low)):
                chosen.append(tick)
        if len(chosen) > 1:
            break
    return chosen


def tidy_ticks(axes):
    """Labels decades only, or round numbers where an axis shows fewer than two decades."""
    from matplotlib import ticker
    for axis, name in ((axes.xaxis, axes.get_xscale()), (axes.yaxis, axes.get_yscale())):
        low, high = sorted(axis.get_view_interval())
        if name != "log" or isinstance(axis.get_major_locator(), ticker.FixedLocator):
            continue
        axis.set_minor_formatter(ticker.NullFormatter())
        if math.floor(math.log10(high)) - math.ceil(math.log10(low)) < 1:
            axis.set_major_locator(ticker.FixedLocator(round_ticks(low, high)))
            axis.set_major_formatter(ticker.FormatStrFormatter("%.4g"))
        else:
            axis.set_major_locator(ticker.LogLocator(numticks=6))


def legend_of(axes, columns=1, **where):
    """Puts the names of the lines into a legend."""
    handles, labels = axes.get_legend_handles_labels()
    return axes.legend(handles, labels, ncols=columns, frameon=False, borderaxespad=0, borderpad=0.2, labelspacing=0.25, handlelength=2.2, handletextpad=0.5,
                       columnspacing=1, fontsize="xx-small" if len(labels) > 12 else "x-small", **(where or {"loc": "best"}))


def lay_out(figure, axes, width, default_height):
    """Plans a panel that is `width` inches wide. Returns its margins, and its height, columns of the legend, size of the legend and width of the axes.

    The legend stands below in as many columns as fit, or beside the axes if that leaves them more room. A panel grows in height until the axes
    have AXES_SHARE of it."""
    renderer = figure.canvas.get_renderer()
    size = lambda box: (box.width / figure.dpi, box.height / figure.dpi)
    figure.set_size_inches(figure.get_size_inches()[0], 4 * default_height)  # the label of the y axis is shorter than the axis
    axes.set_position([0.2, 0.2, 0.6, 0.6])
    axes.get_legend().remove()
    box, inner = axes.get_tightbbox(renderer), axes.get_window_extent(renderer)
    margins = {"left": (inner.x0 - box.x0) / figure.dpi + 0.03, "right": (box.x1 - inner.x1) / figure.dpi + 0.03,
               "bottom": (inner.y0 - box.y0) / figure.dpi + 0.04, "top": (box.y1 - inner.y1) / figure.dpi + 0.04}
    choices = []
    for columns in (1, 2, 3, 4):
        legend_width, legend_height = size(legend_of(axes, columns, loc="upper left").get_window_extent(renderer))
        axes.get_legend().remove()
        if columns > 1 and legend_width > width - 0.04:
            break
        across, around = width - margins["left"] - margins["right"], margins["top"] + margins["bottom"] + legend_height + 0.08
        height = max(default_height, around + AXES_SHARE * width * around / max(0.05 * width, across - AXES_SHARE * width))
        choices.append((height, columns, legend_width, legend_height, across))
        if columns == 1 and legend_width < 0.3 * width and (across - legend_width - 0.08) * (default_height - margins["top"] - margins["bottom"]) >= AXES_SHARE * width * default_height:
            choices.append((default_height, 0, legend_width, legend_height, across - legend_width - 0.08))
    return margins, min(choices)


def place_panel(figure, axes, left, top, width, height, plan):
    """Sets the axes and the legend of a panel, whose upper left corner is (left, top) in inches, as `lay_out` planned it."""
    margins, (_, columns, _, legend_height, across) = plan
    full_width, full_height = figure.get_size_inches()
    below = margins["bottom"] + (legend_height + 0.08 if columns else 0)
    x, y = left + margins["left"], top - height + below
    axes.set_position([x / full_width, y / full_height, across / full_width, (height - below - margins["top"]) / full_height])
    if columns:
        legend_of(axes, columns, loc="lower left", bbox_to_anchor=(0.02 / full_width + left / full_width, (top - height + 0.03) / full_height), bbox_transform=figure.transFigure)
    else:
        legend_of(axes, 1, loc="upper left", bbox_to_anchor=((x + across + 0.08) / full_width, (top - margins["top"]) / full_height), bbox_transform=figure.transFigure)


def page_of(pyplot, quantities, width, drawn):
    """Returns a figure of the quantities, two beside each other; `drawn` draws one into axes."""
    columns = min(2, len(quantities))
    panel, rows = width / columns, [quantities[i:i + columns] for i in range(0, len(quantities), columns)]
    figure = pyplot.figure(figsize=(width, panel), dpi=300)  # as it is saved: sizes of texts are rounded to dots
    cells = [[figure.add_axes([0.1, 0.1, 0.8, 0.8], label=quantity) for quantity in row] for row in rows]
    plans = []
    for row, axes_of_row in zip(rows, cells):
        for quantity, axes in zip(row, axes_of_row):
            drawn(axes, quantity)
        plans.append([lay_out(figure, axes, panel, 0.72 * panel) for axes in axes_of_row])
    heights = [max(plan[0] for _, plan in row) for row in plans]
    figure.set_size_inches(width, sum(heights))
    top = sum(heights)
    for axes_of_row, row, height in zip(cells, plans, heights):
        for index, (axes, plan) in enumerate(zip(axes_of_row, row)):
            place_panel(figure, axes, index * panel, top, panel, height, plan)
        top -= height
    return figure


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


def exponent(text):
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not -10 <= number <= 10:
        raise argparse.ArgumentTypeError(f"'{text}' is not an exponent from -10 to 10")
    return number


def parser():
    made = argparse.ArgumentParser(prog="ar3d figures", description="Figures for papers from the tables of a study.")
    made.add_argument("tables", help="what `ar3d report --json` writes")
    made.add_argument("-o", "--output", default=".", help="the folder of the figures")
    made.add_argument("--quantity", type=one_of(*QUANTITIES, *OTHERS), default=["side"], help=", ".join((*QUANTITIES, *OTHERS)))
    made.add_argument("--over", type=exponent, default=0.0, metavar="A", help="divides quantities that grow with n by n^A")
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
    pyplot.rcParams.update({"font.size": arguments.font_size, "svg.hashsalt": "ar3d", "pgf.texsystem": "pdflatex",
                            "lines.linewidth": 0.9, "lines.markersize": 2.5})
    if arguments.style:
        try:
            pyplot.style.use(arguments.style)
        except (OSError, ValueError) as error:
            raise Refused(f"--style {arguments.style}: {error}".replace("\n", " ")) from error
    made = []
    for page in pages:
        made.append((page, page_of(pyplot, page, arguments.width,
                                   lambda axes, quantity: draw(axes, tables, quantity, arguments.algorithms, arguments.families, arguments.over))))
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
