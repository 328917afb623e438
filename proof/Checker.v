(** The checker: functions on integers only. Nothing is proved here. *)
From Coq Require Import ZArith NArith List Bool FMapPositive.
From Drawing Require Import Spec.
Import ListNotations.
Local Open Scope Z_scope.

(** ** Points and vectors of integers *)

Definition diff (a b : point) : point := Point (px b - px a) (py b - py a) (pz b - pz a).
Definition dot (u v : point) : Z := px u * px v + py u * py v + pz u * pz v.
Definition cross (u v : point) : point :=
  Point (py u * pz v - pz u * py v) (pz u * px v - px u * pz v) (px u * py v - py u * px v).
Definition zinner (G : gram) (u v : point) : Z :=
  xx G * (px u * px v) + yy G * (py u * py v) + zz G * (pz u * pz v)
  + xy G * (px u * py v + py u * px v) + xz G * (px u * pz v + pz u * px v)
  + yz G * (py u * pz v + pz u * py v).

(** ** Two segments *)

(** Both of a and b are smaller than both of c and d, or the other way round. *)
Definition apart (a b c d : Z) : bool :=
  if a <? c then (a <? d) && (b <? c) && (b <? d) else (c <? a) && (d <? a) && (c <? b) && (d <? b).

(** The plane through no point of either segment, at right angles to h, that has one on each side. *)
Definition separates (h a b c d : point) : bool := apart (dot h a) (dot h b) (dot h c) (dot h d).

Definition boxes_apart (a b c d : point) : bool :=
  apart (px a) (px b) (px c) (px d) || apart (py a) (py b) (py c) (py d)
  || apart (pz a) (pz b) (pz c) (pz d).

(** The segments ab and cd have no point in common. *)
Definition disjoint (a b c d : point) : bool :=
  boxes_apart a b c d
  || let u := diff a b in let v := diff c d in let n := cross u v in
     separates n a b c d
     || separates (cross n u) a b c d || separates (cross n v) a b c d
     || separates u a b c d || separates v a b c d
     || let w := diff a c in
        separates (cross u (cross w u)) a b c d || separates (cross v (cross w v)) a b c d.

(** ** Angles *)

Definition angle_ok (G : gram) (k : promise) (a b c : point) : bool :=
  let u := diff a b in let v := diff a c in
  let g := zinner G u v in
  let l := g * g * (q k * q k) in
  let r := minus_p k * minus_p k * (zinner G u u * zinner G v v) in
  (g <=? 0) && (if equal k then l =? r else r <=? l).

Definition metric_ok (G : gram) : bool :=
  let m := xx G * yy G - xy G * xy G in
  let l := xx G * zz G - xz G * xz G in
  let o := xx G * yz G - xy G * xz G in
  (0 <? xx G) && (0 <? m) && (0 <? m * l - o * o).

(** ** Corners *)

Definition same_point (a b : point) : bool := (px a =? px b) && (py a =? py b) && (pz a =? pz b).
Definition same_name (a b : name) : bool :=
  match a, b with
  | Vertex v, Vertex w => N.eqb v w
  | Bend e i, Bend f j => N.eqb e f && N.eqb i j
  | _, _ => false
  end.
Definition same (a b : corner) : bool := same_name (fst a) (fst b) && same_point (snd a) (snd b).

(** The segments, or vertices, with ends a, b and a, c: a vertex has both ends the same. *)
Definition fine (G : gram) (k : promise) (a b c : corner) : bool :=
  same a b || same a c || angle_ok G k (snd a) (snd b) (snd c).

Definition pair_ok (G : gram) (k : promise) (s t : segment) : bool :=
  let (a, b) := s in let (c, d) := t in
  boxes_apart (snd a) (snd b) (snd c) (snd d)
  || let ac := same a c in let ad := same a d in let bc := same b c in let bd := same b d in
     if ac || ad || bc || bd
     then (negb ac || fine G k a b d) && (negb ad || fine G k a b c)
          && (negb bc || fine G k b a d) && (negb bd || fine G k b a c)
     else disjoint (snd a) (snd b) (snd c) (snd d).

(** ** All pairs that can have a point in common, by halving space

    Of a segment from a to b a piece holds the points a + t (b - a) with from <= t <= till, counted
    in so many parts. A plan is advice that nobody needs to trust. [Cut]: a point is on one side of
    the plane h . x = c, and of two segments through it both have a piece on that side. [Part]: the
    segments along which h . x does not change, and the others, are looked at by themselves and
    against each other. *)

Definition parts : Z := 1048576.
Record piece := Piece { whole : segment; from : Z; till : Z }.

Inductive plan :=
| Together
| Cut (h : point) (c : Z) (low high : plan)
| Part (h : point) (p q r o : plan).

(** The plan, and how to divide two numbers: a quotient that is wrong costs time, too, never truth. *)
Record advice := Advice { cuts : plan; ratio : Z -> Z -> Z }.
Definition no_advice := Advice Together (fun _ _ => 0).

Fixpoint each {A B} (f : A -> B) (l : list A) (r : list B) : list B :=
  match l with [] => r | a :: m => each f m (f a :: r) end.
Fixpoint sift {A} (f : A -> bool) (l r : list A) : list A :=
  match l with [] => r | a :: m => sift f m (if f a then a :: r else r) end.

(** Adds what a piece has before m, and what it has behind m. *)
Definition before (m : Z) (s : piece) (l : list piece) : list piece :=
  if from s <=? m then Piece (whole s) (from s) (Z.min m (till s)) :: l else l.
Definition behind (m : Z) (s : piece) (l : list piece) : list piece :=
  if m <=? till s then Piece (whole s) (Z.max m (from s)) (till s) :: l else l.

(** What lies below and what lies above the plane. A segment that rises or falls by o, by n / parts
    of it until it is there, passes the plane between m and m + 1. *)
Fixpoint divide (ratio : Z -> Z -> Z) (h : point) (c : Z) (l low high : list piece) : list piece * list piece :=
  match l with
  | [] => (low, high)
  | s :: r =>
      let x := dot h (snd (fst (whole s))) - c in let y := dot h (snd (snd (whole s))) - c in
      if (x <? 0) && (y <? 0) then divide ratio h c r (s :: low) high
      else if (0 <? x) && (0 <? y) then divide ratio h c r low (s :: high)
      else
        let rises := x <? y in let o := if rises then y - x else x - y in
        let n := (if rises then 0 - x else x) * parts in
        let m := ratio n o in let e := n - m * o in
        if (0 <? o) && (0 <=? e) && (e <=? o)
        then if rises then divide ratio h c r (before (m + 1) s low) (behind m s high)
             else divide ratio h c r (behind m s low) (before (m + 1) s high)
        else divide ratio h c r (s :: low) (s :: high)
  end.

Definition level (h : point) (s : piece) : bool :=
  dot h (snd (fst (whole s))) =? dot h (snd (snd (whole s))).
Definition sloping (h : point) (s : piece) : bool := negb (level h s).

(** A segment with the box of a piece. *)
Record boxed := Boxed { inside : segment; x0 : Z; x1 : Z; y0 : Z; y1 : Z; z0 : Z; z1 : Z }.
Definition box_of (s : piece) : boxed :=
  let a := snd (fst (whole s)) in let b := snd (snd (whole s)) in
  let at_ (c : point -> Z) t := c a * parts + t * (c b - c a) in
  let x := at_ px (from s) in let x' := at_ px (till s) in
  let y := at_ py (from s) in let y' := at_ py (till s) in
  let z := at_ pz (from s) in let z' := at_ pz (till s) in
  Boxed (whole s) (Z.min x x') (Z.max x x') (Z.min y y') (Z.max y y') (Z.min z z') (Z.max z z').
Definition far (s t : boxed) : bool :=
  (x1 s <? x0 t) || (x1 t <? x0 s) || (y1 s <? y0 t) || (y1 t <? y0 s) || (z1 s <? z0 t) || (z1 t <? z0 s).
Definition near_ok (f : segment -> segment -> bool) (s t : boxed) : bool := far s t || f (inside s) (inside t).

Fixpoint all_pairs {A} (f : A -> A -> bool) (l : list A) : bool :=
  match l with [] => true | a :: r => forallb (f a) r && all_pairs f r end.

Section Pairs.
  Context (f : segment -> segment -> bool) (ratio : Z -> Z -> Z).

  (** One of l with one of m. *)
  Fixpoint across_ok (p : plan) (l m : list piece) : bool :=
    match p with
    | Together => let m := each box_of m [] in forallb (fun s => forallb (near_ok f (box_of s)) m) l
    | Cut h c low high =>
        let (l1, l2) := divide ratio h c l [] [] in let (m1, m2) := divide ratio h c m [] [] in
        across_ok low l1 m1 && across_ok high l2 m2
    | Part h p q r o =>
        let l1 := sift (level h) l [] in let l2 := sift (sloping h) l [] in
        let m1 := sift (level h) m [] in let m2 := sift (sloping h) m [] in
        across_ok p l1 m1 && across_ok q l1 m2 && across_ok r l2 m1 && across_ok o l2 m2
    end.

  (** Two of l. *)
  Fixpoint pairs_ok (p : plan) (l : list piece) : bool :=
    match p with
    | Together => all_pairs (near_ok f) (each box_of l [])
    | Cut h c low high =>
        let (l1, l2) := divide ratio h c l [] [] in pairs_ok low l1 && pairs_ok high l2
    | Part h p q _ o =>
        let l1 := sift (level h) l [] in let l2 := sift (sloping h) l [] in
        pairs_ok p l1 && across_ok q l1 l2 && pairs_ok o l2
    end.
End Pairs.

(** ** The segments, with the vertices' points from a table *)

Definition table := PositiveMap.t point.
Fixpoint fill (i : N) (l : list point) (t : table) : table :=
  match l with
  | [] => t
  | p :: r => fill (N.succ i) r (PositiveMap.add (N.succ_pos i) p t)
  end.
Definition look (t : table) (v : N) : option point := PositiveMap.find (N.succ_pos v) t.

Fixpoint walk (e i : N) (a : corner) (l : list point) (z : corner) (acc : list segment)
  : list segment :=
  match l with
  | [] => (a, z) :: acc
  | p :: r => let b := (Bend e i, p) in walk e (N.succ i) b r z ((a, b) :: acc)
  end.

Fixpoint gather (t : table) (e : N) (l : list edge) (acc : list segment)
  : option (list segment) :=
  match l with
  | [] => Some acc
  | f :: r =>
      match look t (tail f), look t (head f) with
      | Some a, Some b =>
          gather t (N.succ e) r
            (walk e 0 (Vertex (tail f), a) (bends f) (Vertex (head f), b) acc)
      | _, _ => None
      end
  end.

(** Vertices as segments from a point to itself. *)
Fixpoint dots (i : N) (l : list point) (acc : list segment) : list segment :=
  match l with
  | [] => acc
  | p :: r => let c := (Vertex i, p) in dots (N.succ i) r ((c, c) :: acc)
  end.

(** ** The graph *)

Fixpoint count {A} (i : N) (l : list A) : N :=
  match l with [] => i | _ :: r => count (N.succ i) r end.

(** Different for different pairs of numbers below n. *)
Definition pair_key (n : N) (e : N * N) : positive := N.succ_pos (n * fst e + snd e).

(** The set of what f makes of the list, if it makes nothing twice. *)
Fixpoint once {A} (f : A -> positive) (l : list A) (t : PositiveMap.t unit)
  : option (PositiveMap.t unit) :=
  match l with
  | [] => Some t
  | a :: r =>
      match PositiveMap.find (f a) t with
      | None => once f r (PositiveMap.add (f a) tt t)
      | Some _ => None
      end
  end.

Definition graph_ok (d : drawing) (g : graph) : bool :=
  let n := order g in
  let wanted e := pair_key n (turned e) in let drawn f := pair_key n (turned (ends f)) in
  N.eqb (count 0 (vertices d)) n
  && forallb (fun e => N.ltb (fst e) n && N.ltb (snd e) n && negb (N.eqb (fst e) (snd e))) (pairs g)
  && forallb (fun f => N.ltb (tail f) n && N.ltb (head f) n) (edges d)
  && N.eqb (count 0 (edges d)) (count 0 (pairs g))
  && match once wanted (pairs g) (PositiveMap.empty unit), once drawn (edges d) (PositiveMap.empty unit) with
     | Some t, Some _ => forallb (fun f => PositiveMap.mem (drawn f) t) (edges d)
     | _, _ => false
     end.

(** ** Directions, plane, box *)

Definition zero : point := Point 0 0 0.
Definition along_ok (a u : point) : bool :=
  negb (same_point a zero) && same_point (cross a u) zero.
Definition direction_ok (k : promise) (s : segment) : bool :=
  match directions k with
  | [] => true
  | l => let u := diff (snd (fst s)) (snd (snd s)) in existsb (fun a => along_ok a u) l
  end.

Definition plane_ok (k : promise) (d : drawing) : bool :=
  negb (in_plane k) || forallb (fun p => pz p =? 0) (vertices d).

Definition at_most_ok (b : bound) (n : N) (e : Z) : bool :=
  let l := den b * (e - constant b) in
  (l <=? 0) || (l * l <=? num b * num b * Z.of_N n ^ Z.of_N (half b)).

Definition fold_points {A} (f : A -> point -> A) (d : drawing) (a : A) : A :=
  fold_left (fun a e => fold_left f (bends e) a) (edges d) (fold_left f (vertices d) a).

(** The largest c less the least one, for c = px, py or pz. *)
Definition spread (c : point -> Z) (d : drawing) (p : point) : Z :=
  fold_points (fun m o => Z.max m (c o)) d (c p) - fold_points (fun m o => Z.min m (c o)) d (c p).

Definition box_ok (k : promise) (d : drawing) (g : graph) : bool :=
  match size k, vertices d with
  | Some b, p :: _ =>
      at_most_ok (in_x b) (order g) (spread px d p) && at_most_ok (in_y b) (order g) (spread py d p)
      && at_most_ok (in_z b) (order g) (spread pz d p)
  | _, _ => true
  end.

(** ** The promise *)

Definition bound_ok (b : bound) : bool := (0 <? den b) && (0 <=? num b).
Definition sane (k : promise) : bool :=
  (0 <? q k) && (0 <=? minus_p k) && (minus_p k <=? q k) && metric_ok (lengths k)
  && match size k with
     | None => true
     | Some b => bound_ok (in_x b) && bound_ok (in_y b) && bound_ok (in_z b)
     end.

Definition same_metric_ok (d : drawing) (k : promise) : bool :=
  (0 <? over d) && (0 <? lengths_over k)
  && forallb (fun place : gram -> Z =>
       place (metric d) * lengths_over k =? place (lengths k) * over d) [xx; yy; zz; xy; xz; yz].

(** ** All of it *)

Definition check (p : advice) (d : drawing) (g : graph) (k : promise) : bool :=
  sane k && same_metric_ok d k && graph_ok d g
  && forallb (fun f => N.leb (count 0 (bends f)) (most_bends k)) (edges d)
  && plane_ok k d && box_ok k d g
  && match gather (fill 0 (vertices d) (PositiveMap.empty point)) 0 (edges d) [] with
     | None => false
     | Some l =>
         forallb (fun s => negb (same_point (snd (fst s)) (snd (snd s))) && direction_ok k s) l
         && pairs_ok (pair_ok (lengths k) k) (ratio p) (cuts p)
              (each (fun s => Piece s 0 parts) (dots 0 (vertices d) l) [])
     end.
