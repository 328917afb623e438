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

    A plan is advice that nobody needs to trust. [Cut]: a point is on one side of the plane
    h . x = c, and of two segments through it both reach that side. [Part]: the segments along
    which h . x does not change, and the others, are looked at by themselves and against each other. *)

Inductive plan :=
| Together
| Cut (h : point) (c : Z) (low high : plan)
| Part (h : point) (p q r o : plan).

Fixpoint sift {A} (f : A -> bool) (l r : list A) : list A :=
  match l with [] => r | a :: m => sift f m (if f a then a :: r else r) end.

(** The segments that reach below and those that reach above the plane. *)
Fixpoint divide (h : point) (c : Z) (l low high : list segment) : list segment * list segment :=
  match l with
  | [] => (low, high)
  | s :: r =>
      let x := dot h (snd (fst s)) in let y := dot h (snd (snd s)) in
      divide h c r (if (x <=? c) || (y <=? c) then s :: low else low)
        (if (c <=? x) || (c <=? y) then s :: high else high)
  end.

Definition level (h : point) (s : segment) : bool :=
  dot h (snd (fst s)) =? dot h (snd (snd s)).
Definition sloping (h : point) (s : segment) : bool := negb (level h s).

Fixpoint all_pairs {A} (f : A -> A -> bool) (l : list A) : bool :=
  match l with [] => true | a :: r => forallb (f a) r && all_pairs f r end.

(** One of l with one of m. *)
Fixpoint across_ok (f : segment -> segment -> bool) (p : plan) (l m : list segment) : bool :=
  match p with
  | Together => forallb (fun s => forallb (f s) m) l
  | Cut h c low high =>
      let (l1, l2) := divide h c l [] [] in let (m1, m2) := divide h c m [] [] in
      across_ok f low l1 m1 && across_ok f high l2 m2
  | Part h p q r o =>
      let l1 := sift (level h) l [] in let l2 := sift (sloping h) l [] in
      let m1 := sift (level h) m [] in let m2 := sift (sloping h) m [] in
      across_ok f p l1 m1 && across_ok f q l1 m2 && across_ok f r l2 m1 && across_ok f o l2 m2
  end.

(** Two of l. *)
Fixpoint pairs_ok (f : segment -> segment -> bool) (p : plan) (l : list segment) : bool :=
  match p with
  | Together => all_pairs f l
  | Cut h c low high =>
      let (l1, l2) := divide h c l [] [] in pairs_ok f low l1 && pairs_ok f high l2
  | Part h p q _ o =>
      let l1 := sift (level h) l [] in let l2 := sift (sloping h) l [] in
      pairs_ok f p l1 && across_ok f q l1 l2 && pairs_ok f o l2
  end.

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

Definition check (p : plan) (d : drawing) (g : graph) (k : promise) : bool :=
  sane k && same_metric_ok d k && graph_ok d g
  && forallb (fun f => N.leb (count 0 (bends f)) (most_bends k)) (edges d)
  && plane_ok k d && box_ok k d g
  && match gather (fill 0 (vertices d) (PositiveMap.empty point)) 0 (edges d) [] with
     | None => false
     | Some l =>
         forallb (fun s => negb (same_point (snd (fst s)) (snd (snd s))) && direction_ok k s) l
         && pairs_ok (pair_ok (lengths k) k) p (dots 0 (vertices d) l)
     end.
