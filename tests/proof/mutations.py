"""mutations.py PROOF: the checker or the specification is changed in one place at a time, and the proofs have to fail each time."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

FILES = ["Spec", "Checker", "Geometry", "Edges", "Sound", "Complete", "Wrong"]
LATER = ["OneBend", "OneBendOnFaces", "OneBendNeeded"]
CHECKER = [
    ("<= for <", "(a <? d) && (b <? c)", "(a <=? d) && (b <=? c)"),
    ("a comparison left out", "(a <? d) && (b <? c) && (b <? d)", "(a <? d) && (b <? c)"),
    ("a separating vector left out", "|| separates u a b c d || separates v a b c d\n", "|| separates v a b c d\n"),
    ("the sign of the angle not asked", "(g <=? 0) && (if", "(if"),
    ("the angle turned", "else r <=? l", "else l <=? r"),
    ("the angle only without equality", "else r <=? l", "else r <? l"),
    ("the last minor left out", "(0 <? xx G) && (0 <? m) && (0 <? m * l - o * o)", "(0 <? xx G) && (0 <? m)"),
    ("names: number of the edge not compared", "N.eqb e f && N.eqb i j", "N.eqb i j"),
    ("a common corner of four left out", "&& (negb bd || fine G k b a c)", ""),
    ("cut: segments in the plane to one side only", "if (x <? 0) && (y <? 0)", "if (x <=? 0) && (y <=? 0)"),
    ("cut: too little before", "before (m + 1) s low", "before m s low"),
    ("cut: too little behind", "behind m s low", "behind (m + 1) s low"),
    ("cut: sides of a falling segment", "(behind m s low) (before (m + 1) s high)", "(before (m + 1) s low) (behind m s high)"),
    ("cut: no remainder asked of the quotient", "(0 <? o) && (0 <=? e) && (e <=? o)", "(0 <? o) && (0 <=? e)"),
    ("cut: a rise of nought", "(0 <? o) && (0 <=? e)", "(0 <=? e)"),
    ("piece: its other end forgotten", "(Z.min m (till s))", "(Z.min m (from s))"),
    ("pieces without the beginning", "Piece s 0 parts) (dots", "Piece s 1 parts) (dots"),
    ("boxes that touch are apart", "(x1 s <? x0 t)", "(x1 s <=? x0 t)"),
    ("boxes of whole segments' beginnings", "let y' := at_ py (till s)", "let y' := at_ py (from s)"),
    ("part: across left out", "pairs_ok p l1 && across_ok q l1 l2 && pairs_ok o l2", "pairs_ok p l1 && pairs_ok o l2"),
    ("the last segment of an edge left out", "| [] => (a, z) :: acc", "| [] => acc"),
    ("vertices not compared", "(dots 0 (vertices d) l) [])", "l [])"),
    ("zero length not asked", "negb (same_point (snd (fst s)) (snd (snd s))) && direction_ok k s", "direction_ok k s"),
    ("directions not asked", " && direction_ok k s", ""),
    ("any direction along nought", "negb (same_point a zero) && same_point (cross", "same_point (cross"),
    ("repeated edges not asked", "      | Some _ => None\n", "      | Some _ => once f r t\n"),
    ("as many edges not asked", "  && N.eqb (count 0 (edges d)) (count 0 (pairs g))\n", ""),
    ("loops not refused", " && negb (N.eqb (fst e) (snd e))", ""),
    ("one number for two pairs", "(n * fst e + snd e)", "(fst e + snd e)"),
    ("bends not counted", "forallb (fun f => N.leb (count 0 (bends f)) (most_bends k)) (edges d)", "true"),
    ("the size of bends not asked", "fold_left (fun a e => fold_left f (bends e) a) (edges d) (fold_left f (vertices d) a)", "fold_left f (vertices d) a"),
    ("the size along z not asked", "\n      && at_most_ok (in_z b) (order g) (spread pz d p)", ""),
    ("the square of the numerator", "num b * num b * Z.of_N", "num b * Z.of_N"),
    ("the plane not asked", "  && plane_ok k d && box_ok k d g", "  && box_ok k d g"),
    ("the metric not compared", "sane k && same_metric_ok d k", "sane k"),
    ("an entry of the metric not compared", "[xx; yy; zz; xy; xz; yz].", "[xx; yy; zz; xy; xz]."),
    ("q = 0 allowed", "(0 <? q k) && (0 <=? minus_p k)", "(0 <=? minus_p k)"),
]
SPEC = [
    ("a promise of q = 0", "(0 < q k /\\ 0 <= minus_p k <= q k)%Z", "(0 <= minus_p k <= q k)%Z"),
    ("any matrix", "0 < inner G u u.", "0 <= inner G u u."),
    ("any number of vertices", "N.of_nat (length (vertices d)) = order g;", "(N.of_nat (length (vertices d)) <= order g)%N;"),
    ("doubled edges", "edges_once : NoDup (map turned (pairs g));", "edges_once : NoDup (map snd (pairs g)) -> NoDup (map turned (pairs g));"),
    ("angles of two edges only", "s <> t ->\n    joins s a b", "s <> t -> a <> b -> fst a <> Vertex 0 ->\n    joins s a b"),
    ("vertices on edges", "  vertices_off_edges : forall v s,", "  vertices_off_edges : forall v s, v <> 0%N ->"),
    ("a box of x only", "at_most (in_y b) (order g) (py p - py p') /\\", "True /\\"),
    ("a plane for bends only", "In p (vertices d) -> pz p = 0%Z", "In p (flat_map bends (edges d)) -> pz p = 0%Z"),
    ("one entry of the metric", "In place [xx; yy; zz; xy; xz; yz]", "In place [xx]"),
    ("crossings of three", "s <> t ->\n    on s x -> on t x -> exists", "s <> t ->\n    on s x -> on t x -> x <> Vec 1 0 0 -> exists"),
]
ONE_BEND = [
    ("two bends", "Theorem K5_needs_two_bends d k : (most_bends k <= 1)%N", "Theorem K5_needs_two_bends d k : (most_bends k <= 2)%N"),
    ("smaller angles", "(q k <= 3 * minus_p k)%Z -> ~ Good", "(q k <= 4 * minus_p k)%Z -> ~ Good"),
    ("one edge less", "(2, 3); (2, 4); (3, 4)]%N.", "(2, 3); (2, 4)]%N."),
    ("two bends, with crossings", "(length (bends f) <= 1)%nat;", "(length (bends f) <= 2)%nat;"),
    ("smaller angles at vertices", "(at_ b) (at_ c) <= -1/3;", "(at_ b) (at_ c) <= -1/4;"),
    ("step 1: three of four", "t1 ** e + t2 ** e + t3 ** e + t4 ** e = 0", "t1 ** e + t2 ** e + t3 ** e = 0"),
    ("step 2: without the bend's angle", "-1 <= m -> cosine G b v w <= - m ->", "-1 <= m ->"),
    ("step 3: a pair left out", "\n  + edge_of_tetrahedron * len (vminus e2 e4) + edge", "\n  + edge"),
    ("step 4: triangles of 2.9", "chord c a b <= 3.", "chord c a b <= 29/10."),
    ("step 5: less", "10 * (1 + m) <= 30 / sqrt 6.\nProof.\n  intros APART", "10 * (1 + m) <= 29 / sqrt 6.\nProof.\n  intros APART"),
]
ON_FACES = [
    ("two bends", "Diagonal k -> (most_bends k <= 1)%N", "Diagonal k -> (most_bends k <= 2)%N"),
    ("three bends", "(length (bends f) <= 2)%nat;", "(length (bends f) <= 3)%nat;"),
    ("angles of 90 degrees", "(q k <= 2 * minus_p k)%Z }.", "(0 <= 2 * minus_p k)%Z }."),
    ("any directions", "directions k <> [] /\\ incl", "directions k <> [] -> incl"),
    ("directions of all kinds", "Point a b 0;", "Point a b 0; Point a 0 0;"),
    ("two neighbours", "/\\ adjacent g v b /\\ adjacent g v c.", "/\\ adjacent g v b."),
    ("no vertices", "faces_need_two_bends d g k : (0 < order g)%N", "faces_need_two_bends d g k : (0 <= order g)%N"),
    ("step 1: two of three", "-> dot s a = 1 \\/ dot s b = 1 \\/ dot s c = 1.", "-> dot s a = 1 \\/ dot s b = 1."),
    ("step 1: bends of 90 degrees", "1 <= dot a b -> dot s a = 1 ->", "0 <= dot a b -> dot s a = 1 ->"),
    ("step 2: any vertex", "forall w, (w < n)%N -> h w <= h v.", "forall w, (w < n)%N -> h w < h v."),
    ("step 3: never level", "height s b = height s c /\\ height s e", "height s b < height s c /\\ height s e"),
    ("step 4: not asked to be level", "dot s b = 0 -> dot t b = 0 -> s = t", "s = t"),
    ("seven edges", "length six = 6%nat", "length six = 7%nat"),
]
REFUTATION = [
    ("the opposite not taken", "add (opposite k) tt false_ones", "add k tt false_ones"),
    ("no hints needed", "  | [] => false\n  | h :: r =>", "  | [] => true\n  | h :: r =>"),
    ("two literals left", "if no_other false_ones l r then One l else Several", "One l"),
    ("another literal called the same", "if Pos.eqb k l then", "if Pos.eqb k k then"),
    ("a lemma that does not follow", "if propagates known (all_of (claim s)) (hints s)", "if propagates known (all_of (claim s)) (hints s) || (name s =? 9)%positive"),
    ("a proof without the empty clause", "  | [] => false\n  | s :: r =>", "  | [] => true\n  | s :: r =>"),
    ("any lemma as the end", "match claim s with [] => true | _ =>", "match claim s with [] => true | [_] => true | _ =>"),
    ("every literal a lemma's", "fold_left (fun s l => add l tt s) c Leaf", "fold_left (fun s l => add l tt (add (opposite l) tt s)) c Leaf"),
    ("one value for both signs", "xI v => negb (m v)", "xI v => m v"),
    ("unsatisfiable: by one model", "forall m, ~ is_model m f", "exists m, ~ is_model m f"),
]

source = pathlib.Path(sys.argv[1])
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)

    def prove(files):
        """Where a proof fails, or nothing."""
        for file in files:
            done = subprocess.run(["coqc", "-Q", ".", "Drawing", file + ".v"], cwd=folder, capture_output=True, text=True, timeout=300)
            if done.returncode:
                return f"{file}.v, line {done.stderr.split(', line ')[1].split(',')[0]}"
        return None

    for file in FILES + LATER + ["Refutation"]:
        shutil.copy(source / f"{file}.v", folder)
    if found := prove(FILES + LATER + ["Refutation"]):
        raise SystemExit(f"the proof fails without a mutation: {found}")
    survived = 0
    for file, changes, files in (("OneBend", ONE_BEND, LATER), ("OneBendOnFaces", ON_FACES, LATER[1:]), ("Checker", CHECKER, FILES[1:]), ("Spec", SPEC, FILES), ("Refutation", REFUTATION, ["Refutation"])):
        text = (source / f"{file}.v").read_text()
        for what, old, new in changes:
            if text.count(old) < 1:
                raise SystemExit(f"{what}: {file}.v has no {old}")
            (folder / f"{file}.v").write_text(text.replace(old, new, 1))
            where = prove(files)
            survived += where is None
            print(f"{file}: {what}: {'fails in ' + where if where else 'THE PROOF STILL PASSES'}", flush=True)
        shutil.copy(source / f"{file}.v", folder)
    print(f"{len(ONE_BEND) + len(ON_FACES) + len(REFUTATION) + len(CHECKER) + len(SPEC)} mutations, {survived} survived")
raise SystemExit(1 if survived else 0)
