(** What is promised of a drawing. This file says nothing of how it is decided:
    lengths and angles are real numbers, segments are sets of points of real space. *)
From Coq Require Import ZArith NArith List Permutation Reals.
Import ListNotations.

(** ** A drawing, as it is stored: integers only *)

Record point := Point { px : Z; py : Z; pz : Z }.
Record edge := Edge { tail : N; head : N; bends : list point }. (* bends from tail to head *)
Record gram := Gram { xx : Z; yy : Z; zz : Z; xy : Z; xz : Z; yz : Z }. (* symmetric *)
(** The squared length of a vector u is u^T [metric] u / [over]. *)
Record drawing := Drawing { vertices : list point; edges : list edge; metric : gram; over : Z }.

(** Vertices are 0, 1, ..., order - 1. *)
Record graph := Graph { order : N; pairs : list (N * N) }.

(** How long something may be for n vertices: num / den * n^(half / 2) + constant. *)
Record bound := Bound { num : Z; den : Z; half : N; constant : Z }.
Record box := Box { in_x : bound; in_y : bound; in_z : bound }.

(** At most [most_bends] bends per edge; cosines of angles at most - minus_p / q, or just that if
    [equal], in the metric [lengths] / [lengths_over]; every segment along one of the [directions],
    if there are any; all vertices at z = 0 if [in_plane]; the drawing within the [size], if any.
    It comes from who asks, not from the drawing. *)
Record promise := Promise {
  most_bends : N; minus_p : Z; q : Z; equal : bool; lengths : gram; lengths_over : Z;
  directions : list point; in_plane : bool; size : option box }.

(** ** Real space with the inner product of a metric *)

Record vec := Vec { vx : R; vy : R; vz : R }.
Definition real (p : point) : vec := Vec (IZR (px p)) (IZR (py p)) (IZR (pz p)).

Local Open Scope R_scope.

Definition inner (G : gram) (u v : vec) : R :=
  IZR (xx G) * (vx u * vx v) + IZR (yy G) * (vy u * vy v) + IZR (zz G) * (vz u * vz v)
  + IZR (xy G) * (vx u * vy v + vy u * vx v) + IZR (xz G) * (vx u * vz v + vz u * vx v)
  + IZR (yz G) * (vy u * vz v + vz u * vy v).

Definition positive_definite (G : gram) : Prop :=
  forall u, u <> Vec 0 0 0 -> 0 < inner G u u.

Definition towards (a b : vec) : vec := Vec (vx b - vx a) (vy b - vy a) (vz b - vz a).

(** The cosine of the angle at a between the rays to b and to c. *)
Definition cosine (G : gram) (a b c : vec) : R :=
  let u := towards a b in let v := towards a c in
  inner G u v / (sqrt (inner G u u) * sqrt (inner G v v)).

(** x is on the segment from a to b, its ends included. *)
Definition between (a b x : vec) : Prop :=
  exists t, 0 <= t <= 1 /\
    x = Vec (vx a + t * (vx b - vx a)) (vy a + t * (vy b - vy a)) (vz a + t * (vz b - vz a)).

(** u is a multiple of a. *)
Definition along (a : point) (u : vec) : Prop :=
  exists t, u = Vec (t * IZR (px a)) (t * IZR (py a)) (t * IZR (pz a)).

Definition at_most (b : bound) (n : N) (e : Z) : Prop :=
  IZR e <= IZR (num b) / IZR (den b) * sqrt (IZR (Z.of_N n)) ^ N.to_nat (half b) + IZR (constant b).

(** ** Corners and segments of a drawing *)

(** A corner is a vertex, or the i-th bend of the e-th edge, with its point. *)
Inductive name := Vertex (v : N) | Bend (e i : N).
Definition corner : Type := name * point.
Definition segment : Type := corner * corner.

Definition at_ (c : corner) : vec := real (snd c).
Definition is_end (c : corner) (s : segment) : Prop := c = fst s \/ c = snd s.
Definition joins (s : segment) (a b : corner) : Prop := s = (a, b) \/ s = (b, a).
Definition on (s : segment) (x : vec) : Prop := between (at_ (fst s)) (at_ (snd s)) x.

Fixpoint numbered {A} (i : N) (l : list A) : list (N * A) :=
  match l with [] => [] | a :: r => (i, a) :: numbered (N.succ i) r end.

Definition vertex (d : drawing) (v : N) : corner :=
  (Vertex v, nth (N.to_nat v) (vertices d) (Point 0 0 0)).

(** The corners of the e-th edge: its tail, its bends, its head. *)
Definition polyline (d : drawing) (e : N) (f : edge) : list corner :=
  vertex d (tail f)
  :: map (fun b => (Bend e (fst b), snd b)) (numbered 0 (bends f))
  ++ [vertex d (head f)].

(** Each corner with the next. *)
Definition steps (l : list corner) : list segment := combine l (List.tl l).

Definition segments (d : drawing) : list segment :=
  flat_map (fun f => steps (polyline d (fst f) (snd f))) (numbered 0 (edges d)).

(** ** The promise *)

Definition ends (f : edge) : N * N := (tail f, head f).
Definition turned (e : N * N) : N * N := (N.min (fst e) (snd e), N.max (fst e) (snd e)).

Definition angle_kept (G : gram) (k : promise) (a b c : vec) : Prop :=
  if equal k then cosine G a b c = - IZR (minus_p k) / IZR (q k)
  else cosine G a b c <= - IZR (minus_p k) / IZR (q k).

Definition points (d : drawing) : list point := vertices d ++ flat_map bends (edges d).

Definition sane_bound (b : bound) : Prop := (0 < den b /\ 0 <= num b)%Z.

Record Good (d : drawing) (g : graph) (k : promise) : Prop := {
  (* 0. The promise means something: angles of 90 to 180 degrees, a metric, bounds. *)
  cosine_means : (0 < q k /\ 0 <= minus_p k <= q k)%Z;
  metric_means : positive_definite (lengths k);
  size_means : forall b, size k = Some b ->
    sane_bound (in_x b) /\ sane_bound (in_y b) /\ sane_bound (in_z b);
  (* 1. It is a drawing of the graph, which is simple: its edges, each once, in any order. *)
  all_vertices : N.of_nat (length (vertices d)) = order g;
  edges_exist : forall u v, In (u, v) (pairs g) -> (u < order g /\ v < order g /\ u <> v)%N;
  edges_once : NoDup (map turned (pairs g));
  all_edges : Permutation (map turned (map ends (edges d))) (map turned (pairs g));
  (* 2. Few bends; no segment of length zero. *)
  few_bends : forall f, In f (edges d) -> (N.of_nat (length (bends f)) <= most_bends k)%N;
  no_zero_length : forall s, In s (segments d) -> at_ (fst s) <> at_ (snd s);
  (* 3. Angles: any two segments with a common corner, be it a bend or a vertex. *)
  angles : forall s t a b c, In s (segments d) -> In t (segments d) -> s <> t ->
    joins s a b -> joins t a c -> angle_kept (lengths k) k (at_ a) (at_ b) (at_ c);
  (* The drawing's metric is the promised one: equal fractions in equal places. *)
  same_metric : (0 < over d /\ 0 < lengths_over k)%Z /\
    forall place, In place [xx; yy; zz; xy; xz; yz] ->
      (place (metric d) * lengths_over k = place (lengths k) * over d)%Z;
  (* 4. No two vertices at one point, no vertex on another's edge, no crossings:
     all that two segments have in common is the point of a common corner. *)
  vertices_apart : forall v w, (v < order g)%N -> (w < order g)%N ->
    at_ (vertex d v) = at_ (vertex d w) -> v = w;
  vertices_off_edges : forall v s, (v < order g)%N -> In s (segments d) ->
    on s (at_ (vertex d v)) -> is_end (vertex d v) s;
  no_crossings : forall s t x, In s (segments d) -> In t (segments d) -> s <> t ->
    on s x -> on t x -> exists c, is_end c s /\ is_end c t /\ x = at_ c;
  (* 5. Directions, the plane of the vertices, the box of all points. *)
  in_directions : forall s, directions k <> [] -> In s (segments d) ->
    exists a, In a (directions k) /\ along a (towards (at_ (fst s)) (at_ (snd s)));
  vertices_in_plane : in_plane k = true -> forall p, In p (vertices d) -> pz p = 0%Z;
  in_box : forall b p p', size k = Some b -> In p (points d) -> In p' (points d) ->
    at_most (in_x b) (order g) (px p - px p') /\ at_most (in_y b) (order g) (py p - py p') /\
    at_most (in_z b) (order g) (pz p - pz p')
}.
