#!/usr/bin/env python3
"""Draws connected cubic graphs without bridges with two bends per edge and 120 degrees along face diagonals, as
docs/two-bend-120.md proves it: Lemmas F.10 to F.13.

    nauty-geng -C -d3 -D3 10 > ten.g6
    bridgeless.py AR3D < ten.g6 > drawings.jsonl
    ar3d verify drawings.jsonl --graphs ten.g6 --bends 2 --cosine -1/2 --exactly

reads graph6 lines of at most 62 vertices. AR3D is the program, which draws one 3-connected part of each graph. Cost: that
of trying all pairs of edges and all paths; graphs are small.
"""
import itertools
import json
import subprocess
import sys
from dataclasses import dataclass
from fractions import Fraction

from face_lengths import read_graph6


def component(start, edges):
    near = {}
    for u, v in edges:
        near.setdefault(u, []).append(v)
        near.setdefault(v, []).append(u)
    found, open_ = set(), [start]
    while open_:
        v = open_.pop()
        if v not in found:
            found.add(v)
            open_ += near.get(v, [])
    return found


def within(vertices, edges):
    return [edge for edge in edges if vertices >= set(edge)]


def is_connected(vertices, edges):
    return not vertices or component(min(vertices), within(vertices, edges)) == vertices


def without(edges, *left_out):
    return [edge for edge in edges if edge not in left_out]


@dataclass
class Fork:
    """A U (up) or a D; the stem of a block's bottom x and of its top y is None until the block stands in a graph."""
    up: bool
    stem: int
    prongs: tuple


@dataclass
class Block:
    """Orders of a part with a free stem below x and one above y: heights lists vertices, a and b classes, as tuples."""
    heights: list
    a: list
    b: list
    forks: dict

    def check(self, edges):
        """Conditions 1 to 3, each fork with its neighbours."""
        height = {v: i for i, v in enumerate(self.heights)}
        a, b = ({v: i for i, of in enumerate(order) for v in of} for order in (self.a, self.b))
        for v, fork in self.forks.items():
            near = [edge[edge[0] == v] for edge in edges if v in edge]
            values = a if fork.up else b
            low, high = sorted(values[p] for p in fork.prongs)
            assert sorted(near) == sorted([*fork.prongs, *([] if fork.stem is None else [fork.stem])])
            assert all((height[p] > height[v]) == fork.up for p in fork.prongs) and low < values[v] < high
            if fork.stem is not None:
                is_class = self.forks[fork.stem].up != fork.up
                assert (height[fork.stem] < height[v]) == fork.up
                assert (a[v] < a[fork.stem]) == (b[v] < b[fork.stem])
                assert is_class == (a[v] == a[fork.stem]) == (b[v] == b[fork.stem])
        assert len(self.a) == len(self.b) and all(len(of) < 3 for of in self.a)


def index_of(order, v):
    return next(i for i, of in enumerate(order) if v in of)


def in_place_of(order, v, inner, joined):
    """The order with `inner` where the class of v was; its vertices join those that `joined` names."""
    i = index_of(order, v)
    return order[:i] + [of + tuple(w for w in order[i] if joined.get(w) in of) for of in inner] + order[i + 1:]


def insert(outer, u, v, inner, x, y):
    """Lemma F.11: the inner block, from x to y, in the edge from u up to v.

    Proof. Of the outer vertices only u sees x, and only v sees y. If u is a U and v a D, x is on v's side of u in a, and
    in b in the same direction; y is on u's side of v in b, and in a in the same direction. In the other cases all see u
    and v where these were, since the block's classes stand together. A class is made by one stem, and those of x and y
    are free, so no class gets three vertices."""
    forks = outer.forks | inner.forks
    for w, old, new in ((u, v, x), (v, u, y), (x, None, u), (y, None, v)):
        stem, prongs = forks[w].stem, forks[w].prongs
        forks[w] = Fork(forks[w].up, new if stem == old else stem, tuple(new if p == old else p for p in prongs))
    orders = []
    turns = (index_of(outer.a, u) < index_of(outer.a, v)) != (index_of(outer.b, u) < index_of(outer.b, v))
    for order, block, is_b in ((outer.a, inner.a, False), (outer.b, inner.b, True)):
        of_u, of_v = index_of(order, u), index_of(order, v)
        if forks[u].up and not forks[v].up:  # between both, or beyond v in a and beyond u in b
            after, is_right = (of_v, of_v > of_u) if turns and not is_b else (of_u, (of_v > of_u) != (turns and is_b))
            at = after + 1 if is_right else after
            orders.append(order[:at] + block + order[at:])
        else:
            joined = ({} if forks[u].up else {u: x}) | ({v: y} if forks[v].up else {})
            orders.append(in_place_of(order, v if forks[v].up else u, block, joined))
    at = outer.heights.index(u) + 1
    return Block(outer.heights[:at] + inner.heights + outer.heights[at:], *orders, forks)


def in_series(lower, upper, u, v):
    """Lemma F.11 for a bridge: the top u of one block is joined to the bottom v of another one."""
    forks = lower.forks | upper.forks
    forks[u].stem, forks[v].stem = v, u
    orders = (in_place_of(order, u, block, {u: v}) for order, block in ((lower.a, upper.a), (lower.b, upper.b)))
    return Block(lower.heights + upper.heights, *orders, forks)


def parts_of(vertices, edges, x, y):
    """The largest parts without x and y that two edges cut off: the part, and these edges, outer end first."""
    parts = []
    for pair in itertools.combinations(edges, 2):
        part = vertices - component(x, [(x, y), *without(edges, *pair)])
        if part and is_connected(part, edges):
            ends = [(v, u) if u in part else (u, v) for u, v in pair]
            if all(u not in part and v in part for u, v in ends):
                parts.append((part, ends))
    return [one for one in parts if not any(one[0] < other[0] for other in parts)]


def block_of(vertices, edges, x, y):
    """Lemma F.12: a block of a part whose edges to others start in x and y, which no bridge cuts if these are joined.

    Proof. A bridge of the part lies between x and y. With an edge between its ends each side is cubic and has no bridge,
    so it is a block by induction; they are joined as in Lemma F.11 from a D up to a U. Else each largest part without x
    and y that two edges cut off becomes an edge. Such parts are disjoint and not joined: else at most two edges would
    leave the union of two, which would be a larger part. No two edges cut what is left, with an edge xy: with xy the
    other one would be a bridge, without it they would cut off a larger part. So it is 3-connected (Lemma F.10), or x and
    y with three edges. Of these one stands for a part, since the graph is simple. With its block C the heights x, C, y,
    a = C, x, y and b = C, y, x keep the conditions. The other parts are inserted by Lemma F.11."""
    for u, v in edges:
        rest = without(edges, (u, v))
        lower = component(x, rest)
        if lower != vertices:
            u, v = (u, v) if u in lower else (v, u)
            upper = vertices - lower
            return in_series(block_of(lower, within(lower, edges), x, u), block_of(upper, within(upper, edges), v, y), u, v)
    parts = parts_of(vertices, edges, x, y)
    left = vertices.difference(*(part for part, _ in parts))
    inner = {}
    for part, ((u, first), (v, last)) in parts:
        inner.setdefault((u, v), []).append((part, first, last))
    if len(left) == 2:  # a digon: x and y are joined twice, at least once through a part
        (u, v), ((part, first, last), *_) = next(iter(inner.items()))
        inner[u, v].pop(0)
        first, last = (first, last) if u == x else (last, first)
        block = block_of(part, within(part, edges), first, last)
        block.forks[first].stem, block.forks[last].stem = x, y
        block.forks |= {x: Fork(True, None, (first, y)), y: Fork(False, None, (last, x))}
        block = Block([x, *block.heights, y], [*block.a, (x,), (y,)], [*block.b, (y,), (x,)], block.forks)
    else:
        block = simple_block(left, within(left, edges) + [ends for ends in inner for _ in inner[ends]], x, y)
    for (u, v), of_edge in inner.items():
        for part, first, last in of_edge:
            is_up = block.heights.index(u) < block.heights.index(v)
            lower, upper, bottom, top = (u, v, first, last) if is_up else (v, u, last, first)
            block = insert(block, lower, upper, block_of(part, within(part, edges), bottom, top), bottom, top)
    return block


def tutte_path(near, path, y):
    """A path to y, no edge between others of its vertices than neighbours, whose removal leaves the others connected."""
    if path[-1] == y:
        rest = set(near) - set(path)
        return path if len(path) > 2 and is_connected(rest, [(u, v) for u in rest for v in near[u]]) else None
    for v in near[path[-1]]:
        if v not in path and not any(w in path[:-1] for w in near[v] if (v, w) != (y, path[0])):
            if found := tutte_path(near, [*path, v], y):
                return found
    return None


def st_numbering(near, bottom, top):
    """Tarjan's of 1986, by a depth-first search from the bottom, which goes to the top first."""
    order, low, parent = [], {}, {}

    def search(v):
        order.append(v)
        low[v] = v
        for w in [top] * (v == bottom) + near[v]:
            if w not in low:
                parent[w] = v
                search(w)
            low[v] = min(low[v], low[w] if parent.get(w) == v else w, key=order.index)

    search(bottom)
    found, goes_before = [bottom, top], {bottom: True}
    for v in order[2:]:
        before = goes_before[low[v]]
        found.insert(found.index(parent[v]) + (not before), v)
        goes_before[parent[v]] = not before
    return found


def simple_block(vertices, edges, x, y):
    """Lemma F.10: the part is 3-connected with an edge between x and y. A path is numbered first, then the others.

    Proof. By Tutte (1963) there is a path x, p_1, ..., p_k, y, k > 0, that induces no other edge and whose removal leaves
    a connected part H, not empty. Its vertices but y are numbered first, then H and y, by an st-numbering in which they
    are one vertex. There is one: without the path, or without y, the rest is connected, as H is; and a vertex of H that
    cut others off from the path and y would cut the graph. So all p_i are U, and y's other neighbour h is a D and the
    last one of H.

    In Lemmas F.4 and F.5 y takes the place of T, and x that of S; both own lists. Chains go on as there until they come
    to x or y: else two edges would cut the graph. And z(x) = y, w(y) = x, since the way along the path and one through H
    share x and y only. It remains that x and y agree. Let y be forwards, with p_k as its first lower neighbour. In y's
    list the item of h, which holds all of H, is to the right of y. So p_k, ..., p_1, x are inserted in turn, each between
    the one before, at first y, and this item: x is forwards. In x's list the item of p_1 is the first one, for others
    come between two items or to the right of x. It holds p_k. And h is in another one: x's neighbour in H is h or below
    it, so a way down from h through that neighbour avoids p_1. So y is forwards."""
    near = {v: [edge[edge[0] == v] for edge in edges if v in edge] for v in vertices}
    path = tutte_path(near, [x], y)[:-1]
    rest = {v: [x if w in path else w for w in near[v]] for v in vertices - set(path)}
    rest[x] = [v for v in rest for w in near[v] if w in path]
    heights = path + st_numbering(rest, x, y)[1:]
    forks = {}
    for i, v in enumerate(heights):
        below = [w for w in near[v] if w in heights[:i]]
        above = [w for w in near[v] if w not in below]
        up = len(below) < 2
        forks[v] = Fork(up, next(iter(below if up else above), None), tuple(above if up else below))
    in_a, in_b = NestedLists(heights[::-1], forks, True), NestedLists(heights, forks, False)
    forwards = {y: True}

    def is_forwards(v):
        if v not in forwards:
            lists = in_a if forks[v].up else in_b
            forwards[v] = is_forwards(lists.owner[v]) != lists.reversed[v]
        return forwards[v]

    assert all(is_forwards(v) is not None for v in heights)
    assert in_b.owner[y] == x and forwards[x] != in_b.reversed[y], "the chain of x and y agrees with itself"
    return Block(heights, list(in_a.sequence(y, forwards)), list(in_b.sequence(x, forwards)), forks)


class NestedLists:
    """Lemma F.4, by plain lists. In a (U split, D follow) from the top, in b (D split, U follow) from the bottom."""

    def __init__(self, sweep, forks, for_a):
        self.forks, self.for_a = forks, for_a
        root = sweep[0]
        self.lists, self.owner, self.reversed = {root: [("own", root)]}, {}, {}
        path = {root: [(root, ("own", root))]}  # the lists that hold a vertex, outermost first, and its item in each
        for v in sweep[1:]:
            stem = forks[v].stem
            if forks[v].up == for_a:
                p, q = (path[w] for w in forks[v].prongs)
                level = next(i for i in itertools.count() if p[i] != q[i])
                owner = self.owner[v] = p[level][0]
                one, other = (self.lists[owner].index(w[level][1]) for w in (p, q))
                self.reversed[v] = other < one
                self.lists[owner].insert(min(one, other) + 1, v)
                path[v] = p[:level] + [(owner, v)]
                continue
            outer = path[stem]
            if forks[stem].up != for_a:
                self.lists[stem].insert(self.lists[stem].index(("own", stem)) + (forks[stem].prongs[1] == v), v)
                outer = outer[:-1] + [(stem, v)]
            self.lists[v] = [("own", v)]
            path[v] = outer + [(v, ("own", v))]

    def class_of(self, v):
        stem = self.forks[v].stem
        return (v,) if stem is None or self.forks[stem].up == self.forks[v].up else (v, stem)

    def sequence(self, owner, forwards):
        for item in self.lists[owner] if forwards[owner] else self.lists[owner][::-1]:
            if item == ("own", owner):
                yield self.class_of(owner)
            elif self.forks[item].up == self.for_a and len(self.class_of(item)) == 1:
                yield (item,)
            else:  # of a class the follower owns the list
                yield from self.sequence(self.class_of(item)[-1] if self.forks[item].up == self.for_a else item, forwards)


# Points have four coordinates with sum 0; directions are pairs of letters, here 0 to 3.
DIRECTIONS = tuple(itertools.permutations(range(4), 2))


def plus(p, vectors, lengths):
    return tuple(c + sum(k * ((i == d[0]) - (i == d[1])) for d, k in zip(vectors, lengths)) for i, c in enumerate(p))


def minus(p, q):
    return tuple(c - d for c, d in zip(p, q))


def lengths_of(word, total):
    """Positive integers that make the word of independent directions lead along the vector; None if there are none."""
    rows = [[Fraction((i == d[0]) - (i == d[1])) for d in word] + [Fraction(total[i])] for i in range(4)]
    for c in range(len(word)):
        pivot = next((r for r in range(c, 4) if rows[r][c]), None)
        if pivot is None:
            return None
        rows[c], rows[pivot] = rows[pivot], rows[c]
        rows[c] = [value / rows[c][c] for value in rows[c]]
        rows = [row if r == c else [s - row[c] * t for s, t in zip(row, rows[c])] for r, row in enumerate(rows)]
    found = [row[-1] for row in rows]
    is_good = not any(found[len(word):]) and all(k > 0 and k.denominator == 1 for k in found[:len(word)])
    return [int(k) for k in found[:len(word)]] if is_good else None


def bends_between(p, first, last, q):
    """Lemma F.1: the bends of an edge with these directions at its ends, at most two; None if there is no word."""
    is_right = lambda d, e: (d[0] == e[0]) != (d[1] == e[1])
    middles = [m for m in DIRECTIONS if is_right(first, m) and is_right(m, last)]
    if first == last and (k := lengths_of([first], minus(q, p))):
        return []
    if is_right(first, last) and (k := lengths_of([first, last], minus(q, p))):
        return [plus(p, [first], k)]
    for m in middles:
        if first == last and (k := lengths_of([first, m], minus(q, p))) and k[0] > 1:
            return [plus(p, [first], [1]), plus(p, [first, m], [1, k[1]])]
        if k := lengths_of([first, m, last], minus(q, p)):
            return [plus(p, [first], k), plus(p, [first, m], k)]
        if first != last and (k := lengths_of([first, last], minus(minus(q, p), plus((0,) * 4, [m], [1])))):
            return [plus(p, [first], k), plus(p, [first, m], [k[0], 1])]
    return None


def places(block, edges):
    """Step F.5 for a block: points of its vertices, and bends by edge, from the lower end up."""
    a, b = ({v: i for i, of in enumerate(order) for v in of} for order in (block.a, block.b))
    t, at, stars, bends = 0, {}, {}, {}
    for v in block.heights:
        fork = block.forks[v]
        slab = 2 + sum(abs(a[v] - a[w]) + abs(b[v] - b[w]) for edge in edges if v in edge for w in edge)
        at[v] = (t + slab - a[v] - b[v], a[v], b[v], -t - slab)
        t += 2 * slab
        less, more = sorted(fork.prongs, key=(a if fork.up else b).get)
        stars[v] = {fork.stem: (3, 0), less: (0, 1), more: (1, 3)} if fork.up else {fork.stem: (0, 3), less: (3, 2), more: (2, 0)}
    for u, v in edges:
        u, v = (u, v) if at[u][3] > at[v][3] else (v, u)
        bends[u, v] = bends_between(at[u], stars[u][v], stars[v][u][::-1], at[v])
    return at, bends


def grid(p):
    return [p[0] + p[1], p[0] + p[2], p[0] + p[3]]


def scaled(p, scale):
    """The four coordinates of a point of a drawing, times an even scale."""
    first = scale * sum(p) // 2
    return (first, *(scale * c - first for c in p))


def leaf(vertices, edges):
    """The smallest part that two edges cut off, and these edges, inner end first: with an edge instead it is 3-connected."""
    parts = []
    for pair in itertools.combinations(edges, 2):
        part = component(pair[0][0], without(edges, *pair))
        for one in (part, vertices - part) if part != vertices else ():
            if is_connected(one, edges):
                parts.append((one, [(u, v) if u in one else (v, u) for u, v in pair]))
    return min(parts, key=lambda one: len(one[0]), default=None)


def drawn_by(ar3d, graph6):
    command = [ar3d, "draw", "-", "-q", "--algorithm", "two-bend-120"]
    return subprocess.run(command, input=graph6 + "\n", stdout=subprocess.PIPE, text=True, check=True).stdout


def drawing_of_leaf(ar3d, names, edges):
    index = {v: i for i, v in enumerate(names)}
    adjacent = {frozenset((index[u], index[v])) for u, v in edges}
    bits = [frozenset((u, v)) in adjacent for v in range(len(names)) for u in range(v)]
    bits += [False] * (-len(bits) % 6)
    codes = [len(names), *(sum(bit << (5 - k) for k, bit in enumerate(bits[i:i + 6])) for i in range(0, len(bits), 6))]
    drawing = json.loads(drawn_by(ar3d, "".join(chr(63 + code) for code in codes)))
    bends = {(names[u], names[v]): points[0] if points else [] for u, v, *points in drawing["edges"]}
    return dict(zip(names, drawing["vertices"])), bends


def draw(ar3d, n, edges):
    """Lemma F.13: the block of all but one 3-connected part stands in the middle of a segment of that part's drawing.

    Proof. Components are drawn one by one, the 3-connected ones by the first theorem, and stand side by side. In another
    one let R be a smallest part that two edges cut off, from p and q. If R had the edge pq, R without p and q would be a
    smaller part; so would be a side of two edges that cut R+pq. So R+pq is simple and 3-connected, and drawn in O(n^2).
    So is the block, by Steps F.5 and F.6. Lemma F.2 holds for it: the stem of x, along 41, is below all slabs, and that
    of y, along 14, above. R's drawing is scaled by a constant times the block's extents: points are integral and
    directions finitely many, so the block has room in the middle of a segment of pq, the second one of three. Letters are
    renamed so that 14 is its direction ij. The lines into x and out of y differ in the coordinates k and l. The length of
    a segment beside this one moves the line in k alone or in l alone.

    - If one side moves it in k and the other one in l, each makes up for one difference.
    - If both move it in k, a further bend beside ij makes up for that of l. It does so in one direction only. With a and b
      both reversed conditions 1 to 3 still hold, and the differences change their signs.
    - If there is a segment on one side only, it and such a bend do. If there is none, one edge moves the line in k, the
      other one in l, by the words ij, m, ij, in any direction.

    New lines stay within a constant times the block's extents of the line of pq, and leave p and q in its directions, so
    they meet no other edge of R. Further bends are outside of the block's heights."""
    part, ((p, x), (q, y)) = leaf(set(range(n)), edges)
    rest = set(range(n)) - part
    at_part, bends_of_part = drawing_of_leaf(ar3d, sorted(part), within(part, edges) + [(p, q)])
    block = block_of(rest, within(rest, edges), x, y)
    block.check(within(rest, edges))
    for turned in (block, Block(block.heights, block.a[::-1], block.b[::-1], block.forks)):
        at, bends = places(turned, within(rest, edges))
        points = [*at.values(), *itertools.chain(*bends.values())]
        scale = 32 * (2 + max(max(c) - min(c) for c in zip(*points)))
        of_part = {v: scaled(c, scale) for v, c in at_part.items()}
        line = [scaled(c, scale) for c in bends_of_part.get((p, q)) or reversed(bends_of_part.get((q, p), ()))]
        line = [of_part[p], *line, of_part[q]]
        steps = [minus(t, s) for s, t in zip(line, line[1:])]
        ways = [(step.index(max(step)), step.index(min(step))) for step in steps]
        along = 1 if len(ways) == 3 else max(range(len(ways)), key=lambda i: max(steps[i]))
        i, j = ways[along]
        middle = [(c + d) // 2 for c, d in zip(line[along], line[along + 1])]
        for k, l in itertools.permutations({0, 1, 2, 3} - {i, j}):
            letters = sorted(range(4), key=(i, k, l, j).__getitem__)  # the block's letter for each of the part's
            here = lambda c: tuple(c[letter] for letter in letters)
            apart = minus(here(at[y]), here(at[x]))
            for in_k, in_l in itertools.product((0, -apart[k]), (0, -apart[l])):
                goal = list(middle)
                goal[k], goal[l], goal[i] = goal[k] + in_k, goal[l] + in_l, goal[i] - in_k - in_l
                moved = lambda c: minus(here(c), minus(here(at[x]), goal))
                below = bends_between(line[0], ways[0], (i, j), moved(at[x]))
                above = bends_between(moved(at[y]), (i, j), ways[-1], line[-1])
                if below is None or above is None:
                    continue
                vertices = of_part | {v: moved(c) for v, c in at.items()}
                lines = {ends: [scaled(c, scale) for c in of] for ends, of in bends_of_part.items() if set(ends) != {p, q}}
                lines |= {ends: [moved(c) for c in of] for ends, of in bends.items()} | {(p, x): below, (y, q): above}
                return {"n": n, "algorithm": "two-bend-120", "gram": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "gram_denominator": 1,
                        "vertices": [grid(vertices[v]) for v in range(n)],
                        "edges": [[*ends, [grid(c) for c in of]] for ends, of in lines.items()]}
    raise AssertionError("Lemma F.13")


def main(ar3d):
    for line in sys.stdin:
        n, edges = read_graph6(line)
        whole = set(range(n))
        if 2 * len(edges) != 3 * n or not is_connected(whole, edges) or not all(is_connected(whole, without(edges, e)) for e in edges):
            raise SystemExit(f"not a connected cubic graph without bridges: {line.strip()!r}")
        is_cut = leaf(whole, edges) is not None
        print(json.dumps(draw(ar3d, n, edges)) if is_cut else drawn_by(ar3d, line.strip()).strip(), flush=True)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
