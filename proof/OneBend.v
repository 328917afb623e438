(** K5 has no drawing with at most one bend per edge and all angles at vertices and bends at least arccos(-1/3), with
    crossings or without: [K5_needs_two_bends], at the end. It speaks of [Good], the page of Spec.v, and of [K5]; who
    trusts Coq has to read no more. The proof is that of docs/open-questions.md, in its five steps:
    1. [tetrahedral]: at a vertex the directions of the edges sum to 0, and their inner products are -1/3.
    2. [edge_with_a_bend], [edge_without_a_bend]: the cosines at the two ends of an edge sum to at least 1 + 1/3.
    3. [at_a_vertex]: four times the cosines at a vertex are at most sqrt(8/3) times the chords of its six pairs.
    4. [triangle]: the three chords of a triangle sum to at most 3.
    5. [five_points], [too_much]: summed over K5, 10 (1 + 1/3) would be at most 30 / sqrt 6, which is less.
    No trigonometry: cosines are inner products of unit vectors, and the chord 2 sin(A/2) is the length of a difference
    of unit vectors. *)
From Coq Require Import ZArith NArith List Bool Permutation Reals Lra Lia Psatz.
From Drawing Require Import Spec Edges.
Import ListNotations.
Local Open Scope R_scope.

Definition vplus (u v : vec) : vec := Vec (vx u + vx v) (vy u + vy v) (vz u + vz v).
Definition vminus (u v : vec) : vec := Vec (vx u - vx v) (vy u - vy v) (vz u - vz v).
Definition vtimes (r : R) (u : vec) : vec := Vec (r * vx u) (r * vy u) (r * vz u).

Lemma by_squares x y : 0 <= y -> x * x <= y * y -> x <= y.
Proof. intros Y H. destruct (Rle_lt_dec x y) as [L|L]; [exact L|nra]. Qed.

Section Space.
Variable G : gram.
Hypothesis PD : positive_definite G.
Notation "u ** v" := (inner G u v) (at level 40).

(** ** Inner products, lengths, directions *)

Lemma inner_swap u v : u ** v = v ** u.
Proof. unfold inner. ring. Qed.
Lemma inner_plus u v w : vplus u v ** w = u ** w + v ** w.
Proof. unfold inner, vplus; cbn [vx vy vz]. ring. Qed.
Lemma inner_times r u w : vtimes r u ** w = r * (u ** w).
Proof. unfold inner, vtimes; cbn [vx vy vz]. ring. Qed.
Lemma minus_minus a b c d : vminus a b ** vminus c d = a ** c - a ** d - b ** c + b ** d.
Proof. unfold inner, vminus; cbn [vx vy vz]. ring. Qed.

Lemma zero_or_positive u : u = Vec 0 0 0 \/ 0 < u ** u.
Proof.
  destruct u as [x y z].
  destruct (Req_dec x 0) as [->|X]; [destruct (Req_dec y 0) as [->|Y]; [destruct (Req_dec z 0) as [->|Z]|]|].
  - now left.
  - right. apply PD. intros E. injection E. lra.
  - right. apply PD. intros E. injection E. lra.
  - right. apply PD. intros E. injection E. lra.
Qed.

Lemma inner_self u : 0 <= u ** u.
Proof. destruct (zero_or_positive u) as [->|H]; [unfold inner; cbn; lra|lra]. Qed.

Lemma cauchy_squares u v : (u ** v) * (u ** v) <= (u ** u) * (v ** v).
Proof.
  destruct (zero_or_positive v) as [->|V].
  - unfold inner; cbn. lra.
  - pose proof (inner_self (vminus (vtimes (v ** v) u) (vtimes (u ** v) v))) as H.
    rewrite minus_minus, !inner_times, !(inner_swap _ (vtimes _ _)), !inner_times, (inner_swap v u) in H.
    apply (Rmult_le_reg_l (v ** v)); [exact V|]. lra.
Qed.

Definition len (u : vec) : R := sqrt (u ** u).

Lemma len_0 u : 0 <= len u.
Proof. apply sqrt_pos. Qed.
Lemma len_squared u : len u * len u = u ** u.
Proof. apply sqrt_sqrt, inner_self. Qed.

Lemma cauchy u v : u ** v <= len u * len v.
Proof.
  apply by_squares; [apply Rmult_le_pos; apply len_0|].
  replace (len u * len v * (len u * len v)) with ((len u * len u) * (len v * len v)) by ring.
  rewrite !len_squared. apply cauchy_squares.
Qed.

Lemma len_at_most u r : 0 <= r -> u ** u <= r * r -> len u <= r.
Proof. intros P H. apply by_squares; [exact P|]. now rewrite len_squared. Qed.

Definition dist (a b : vec) : R := len (towards a b).
(** The unit vector from a towards b. *)
Definition dir (a b : vec) : vec := vtimes (/ dist a b) (towards a b).

Lemma dist_swap a b : dist a b = dist b a.
Proof. unfold dist, len. f_equal. unfold inner, towards; cbn [vx vy vz]. ring. Qed.

Lemma dist_positive a b : a <> b -> 0 < dist a b.
Proof.
  intros N. apply sqrt_lt_R0, PD. intros E. apply N. unfold towards in E. injection E as X Y Z.
  destruct a as [ax ay az], b as [bx by_ bz]; cbn [vx vy vz] in *. f_equal; lra.
Qed.

(** The law of cosines. *)
Lemma inner_towards a b c : towards a b ** towards a c
  = (dist a b * dist a b + dist a c * dist a c - dist b c * dist b c) / 2.
Proof. unfold dist. rewrite !len_squared. unfold inner, towards; cbn [vx vy vz]. field. Qed.

Lemma dist_triangle a b c : dist b c <= dist a b + dist a c.
Proof.
  pose proof (inner_towards a b c) as H. pose proof (cauchy (towards b a) (towards a c)) as K.
  replace (towards b a ** towards a c) with (- (towards a b ** towards a c)) in K
    by (unfold inner, towards; cbn [vx vy vz]; ring).
  fold (dist b a) (dist a c) in K. rewrite (dist_swap b a) in K.
  pose proof (len_0 (towards a b)). pose proof (len_0 (towards a c)). fold (dist a b) (dist a c) in *.
  apply by_squares; [lra|]. nra.
Qed.

Lemma dir_dir a b c : a <> b -> a <> c -> dir a b ** dir a c
  = (dist a b * dist a b + dist a c * dist a c - dist b c * dist b c) / (2 * dist a b * dist a c).
Proof.
  intros B C. apply dist_positive in B, C. unfold dir.
  rewrite inner_times, inner_swap, inner_times, inner_swap, inner_towards. field. lra.
Qed.

Lemma dir_unit a b : a <> b -> dir a b ** dir a b = 1.
Proof.
  intros B. pose proof (dist_positive a b B) as P. unfold dir.
  rewrite inner_times, inner_swap, inner_times, <- len_squared. fold (dist a b). field. lra.
Qed.

Lemma cosine_dir a b c : a <> b -> a <> c -> cosine G a b c = dir a b ** dir a c.
Proof.
  intros B C. apply dist_positive in B, C. unfold dir.
  rewrite inner_times, inner_swap, inner_times, inner_swap.
  unfold cosine. cbv zeta. fold (len (towards a b)) (len (towards a c)). fold (dist a b) (dist a c). field. lra.
Qed.

(** ** Step 1. Vertices: four unit vectors with inner products of at most -1/3 *)

Definition wide (t1 t2 t3 t4 : vec) : Prop :=
  (t1 ** t1 = 1 /\ t2 ** t2 = 1 /\ t3 ** t3 = 1 /\ t4 ** t4 = 1) /\
  (t1 ** t2 <= -1/3 /\ t1 ** t3 <= -1/3 /\ t1 ** t4 <= -1/3 /\
   t2 ** t3 <= -1/3 /\ t2 ** t4 <= -1/3 /\ t3 ** t4 <= -1/3).

(** They sum to 0, and all these inner products are -1/3. *)
Lemma tetrahedral t1 t2 t3 t4 : wide t1 t2 t3 t4 ->
  (forall e, t1 ** e + t2 ** e + t3 ** e + t4 ** e = 0) /\
  (t1 ** t2 = -1/3 /\ t1 ** t3 = -1/3 /\ t1 ** t4 = -1/3 /\
   t2 ** t3 = -1/3 /\ t2 ** t4 = -1/3 /\ t3 ** t4 = -1/3).
Proof.
  intros [[U1 [U2 [U3 U4]]] [H12 [H13 [H14 [H23 [H24 H34]]]]]].
  set (s := vplus (vplus t1 t2) (vplus t3 t4)).
  assert (S : forall e, s ** e = t1 ** e + t2 ** e + t3 ** e + t4 ** e)
    by (intros e; unfold s; rewrite !inner_plus; ring).
  assert (Q : s ** s = 4 + 2 * (t1 ** t2 + t1 ** t3 + t1 ** t4 + t2 ** t3 + t2 ** t4 + t3 ** t4)).
  { rewrite S, !(inner_swap _ s), !S, U1, U2, U3, U4, (inner_swap t2 t1), (inner_swap t3 t1),
      (inner_swap t4 t1), (inner_swap t3 t2), (inner_swap t4 t2), (inner_swap t4 t3). ring. }
  pose proof (inner_self s) as P. split.
  - intros e. rewrite <- S. pose proof (cauchy_squares s e) as C.
    assert (Z : s ** s = 0) by lra. rewrite Z in C. nra.
  - repeat split; lra.
Qed.

(** ** Step 2. Edges: the cosines at the two ends of an edge, between the edge and the straight line *)

Lemma edge_lengths l l' c r m : 0 < l -> 0 < l' -> 0 < c -> c <= l + l' -> -1 <= m -> m * (l * l') <= r ->
  1 + m <= (l * l + r) / (l * c) + (l' * l' + r) / (l' * c).
Proof.
  intros L L' C T M H.
  replace ((l * l + r) / (l * c) + (l' * l' + r) / (l' * c)) with ((l + l') * (l * l' + r) / (l * l' * c)) by (field; lra).
  assert (P : 0 < l * l') by now apply Rmult_lt_0_compat.
  apply (Rmult_le_reg_r (l * l' * c)); [now apply Rmult_lt_0_compat|].
  replace ((l + l') * (l * l' + r) / (l * l' * c) * (l * l' * c)) with ((l + l') * (l * l' + r)) by (field; lra).
  apply Rle_trans with ((1 + m) * (l * l') * (l + l')).
  - rewrite <- Rmult_assoc. apply Rmult_le_compat_l; [apply Rmult_le_pos|]; lra.
  - rewrite (Rmult_comm (l + l')). apply Rmult_le_compat_r; lra.
Qed.

Lemma edge_with_a_bend v b w m : v <> b -> w <> b -> v <> w -> -1 <= m -> cosine G b v w <= - m ->
  1 + m <= dir v b ** dir v w + dir w b ** dir w v.
Proof.
  intros VB WB VW M H. rewrite cosine_dir in H by auto. rewrite !dir_dir by auto. rewrite dir_dir in H by auto.
  rewrite (dist_swap w v), (dist_swap w b), (dist_swap b v) in *.
  pose proof (dist_triangle b v w) as T. rewrite (dist_swap b v) in T.
  apply dist_positive in VB, WB, VW. rewrite (dist_swap w b) in WB.
  set (l := dist v b) in *. set (l' := dist b w) in *. set (c := dist v w) in *.
  set (r := (c * c - l * l - l' * l') / 2).
  replace ((l * l + c * c - l' * l') / (2 * l * c)) with ((l * l + r) / (l * c)) by (unfold r; field; lra).
  replace ((l' * l' + c * c - l * l) / (2 * l' * c)) with ((l' * l' + r) / (l' * c)) by (unfold r; field; lra).
  apply edge_lengths; [assumption..|].
  apply (Rmult_le_compat_r (l * l')) in H; [|apply Rmult_le_pos; lra].
  replace ((l * l + l' * l' - c * c) / (2 * l * l') * (l * l')) with (- r) in H by (unfold r; field; lra). lra.
Qed.

Lemma edge_without_a_bend v w m : v <> w -> m <= 1 -> 1 + m <= dir v w ** dir v w + dir w v ** dir w v.
Proof. intros N M. rewrite !dir_unit by auto. lra. Qed.

(** ** Step 3. From above: the cosines at a vertex by the chords of its pairs of neighbours *)

(** The length of the difference of two of the four. *)
Definition edge_of_tetrahedron : R := sqrt (8 / 3).

Lemma pair_at_vertex t t' e e' : t ** t = 1 -> t' ** t' = 1 -> t ** t' = -1/3 ->
  vminus t t' ** vminus e e' <= edge_of_tetrahedron * len (vminus e e').
Proof.
  intros U U' H. replace edge_of_tetrahedron with (len (vminus t t')); [apply cauchy|].
  unfold len, edge_of_tetrahedron. f_equal. rewrite minus_minus, (inner_swap t' t), U, U', H. lra.
Qed.

Lemma at_a_vertex t1 t2 t3 t4 e1 e2 e3 e4 : wide t1 t2 t3 t4 ->
  4 * (t1 ** e1 + t2 ** e2 + t3 ** e3 + t4 ** e4) <=
  edge_of_tetrahedron * len (vminus e1 e2) + edge_of_tetrahedron * len (vminus e1 e3)
  + edge_of_tetrahedron * len (vminus e1 e4) + edge_of_tetrahedron * len (vminus e2 e3)
  + edge_of_tetrahedron * len (vminus e2 e4) + edge_of_tetrahedron * len (vminus e3 e4).
Proof.
  intros W. destruct (tetrahedral _ _ _ _ W) as [S [H12 [H13 [H14 [H23 [H24 H34]]]]]].
  destruct W as [[U1 [U2 [U3 U4]]] _].
  pose proof (pair_at_vertex t1 t2 e1 e2 U1 U2 H12) as K12. pose proof (pair_at_vertex t1 t3 e1 e3 U1 U3 H13) as K13.
  pose proof (pair_at_vertex t1 t4 e1 e4 U1 U4 H14) as K14. pose proof (pair_at_vertex t2 t3 e2 e3 U2 U3 H23) as K23.
  pose proof (pair_at_vertex t2 t4 e2 e4 U2 U4 H24) as K24. pose proof (pair_at_vertex t3 t4 e3 e4 U3 U4 H34) as K34.
  rewrite minus_minus in K12, K13, K14, K23, K24, K34.
  pose proof (S e1). pose proof (S e2). pose proof (S e3). pose proof (S e4). lra.
Qed.

(** ** Step 4. Triangles: the three chords 2 sin(A/2) sum to at most 3 *)

Definition chord (a b c : vec) : R := len (vminus (dir a b) (dir a c)).

Lemma chord_at_most a b c : a <> b -> a <> c ->
  chord a b c <= (dist b c + dist a b - dist a c) / (2 * dist a b)
               + (dist b c + dist a c - dist a b) / (2 * dist a c).
Proof.
  intros B C. pose proof (dist_triangle b a c) as T. pose proof (dist_triangle c a b) as T'.
  rewrite (dist_swap b a) in T. rewrite (dist_swap c a), (dist_swap c b) in T'.
  unfold chord. pose proof (dir_dir a b c B C) as D. pose proof (dir_unit a b B) as U. pose proof (dir_unit a c C) as U'.
  apply dist_positive in B, C.
  set (x := dist b c) in *. set (y := dist a c) in *. set (z := dist a b) in *.
  set (f := (x + z - y) / (2 * z)). set (g := (x + y - z) / (2 * y)).
  assert (F : 0 <= f) by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]).
  assert (K : 0 <= g) by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]).
  apply len_at_most; [lra|].
  rewrite minus_minus, (inner_swap (dir a c) (dir a b)), U, U', D.
  replace (1 - (z * z + y * y - x * x) / (2 * z * y) - (z * z + y * y - x * x) / (2 * z * y) + 1)
    with (4 * f * g) by (unfold f, g; field; lra).
  pose proof (Rle_0_sqr (f - g)) as S. unfold Rsqr in S. lra.
Qed.

Lemma triangle a b c : a <> b -> a <> c -> b <> c -> chord a b c + chord b a c + chord c a b <= 3.
Proof.
  intros AB AC BC. pose proof (chord_at_most a b c AB AC) as A.
  pose proof (chord_at_most b a c (not_eq_sym AB) BC) as B.
  pose proof (chord_at_most c a b (not_eq_sym AC) (not_eq_sym BC)) as C.
  rewrite (dist_swap b a) in B. rewrite (dist_swap c a), (dist_swap c b) in C.
  apply dist_positive in AB, AC, BC.
  set (x := dist b c) in *. set (y := dist a c) in *. set (z := dist a b) in *.
  assert (E : (x + z - y) / (2 * z) + (x + y - z) / (2 * y) + ((y + z - x) / (2 * z) + (y + x - z) / (2 * x))
    + ((z + y - x) / (2 * y) + (z + x - y) / (2 * x)) = 3) by (field; lra).
  lra.
Qed.

(** ** Step 5. The count over K5 *)

Definition two (v w : N) : Prop := (v < 5 /\ w < 5 /\ v <> w)%N.

(** [x v] is the point of vertex v, [t v w] the unit vector in which the edge vw leaves v. *)
Theorem five_points (x : N -> vec) (t : N -> N -> vec) m :
  (forall v w, two v w -> x v <> x w) ->
  (forall v w, two v w -> t v w ** t v w = 1) ->
  (forall v j k, two v j -> two v k -> j <> k -> t v j ** t v k <= -1/3) ->
  (forall v w, two v w -> 1 + m <= t v w ** dir (x v) (x w) + t w v ** dir (x w) (x v)) ->
  10 * (1 + m) <= 30 / sqrt 6.
Proof.
  intros APART UNIT ANGLE EDGE. pose (r := edge_of_tetrahedron).
  assert (R0 : 0 <= r) by apply sqrt_pos.
  assert (R6 : 30 / sqrt 6 = 30 * r / 4).
  { unfold r, edge_of_tetrahedron. replace (8 / 3) with ((4 * 4) / 6) by field.
    rewrite sqrt_div, sqrt_square by lra. field. apply Rgt_not_eq, sqrt_lt_R0. lra. }
  assert (VERTEX : forall v i j k l, two v i -> two v j -> two v k -> two v l ->
    two i j -> two i k -> two i l -> two j k -> two j l -> two k l ->
    4 * (t v i ** dir (x v) (x i) + t v j ** dir (x v) (x j) + t v k ** dir (x v) (x k) + t v l ** dir (x v) (x l)) <=
    r * chord (x v) (x i) (x j) + r * chord (x v) (x i) (x k) + r * chord (x v) (x i) (x l)
    + r * chord (x v) (x j) (x k) + r * chord (x v) (x j) (x l) + r * chord (x v) (x k) (x l)).
  { intros v i j k l VI VJ VK VL IJ IK IL JK JL KL. apply at_a_vertex.
    repeat split; first [apply UNIT; assumption | apply ANGLE; [assumption..|]];
      unfold two in *; intuition congruence. }
  assert (TRIANGLE : forall u v w, two u v -> two u w -> two v w ->
    r * chord (x u) (x v) (x w) + r * chord (x v) (x u) (x w) + r * chord (x w) (x u) (x v) <= 3 * r).
  { intros u v w UV UW VW. rewrite <- !Rmult_plus_distr_l, (Rmult_comm 3).
    apply Rmult_le_compat_l; [exact R0|]. apply triangle; apply APART; assumption. }
  rewrite R6. clear R6 APART UNIT ANGLE.
  assert (P : forall v w, (v <? 5)%N && (w <? 5)%N && negb (v =? w)%N = true -> two v w).
  { intros v w H. apply andb_prop in H as [H N]. apply andb_prop in H as [V W]. unfold two.
    now rewrite <- !N.ltb_lt, <- N.eqb_neq, <- negb_true_iff. }
  Ltac given H P := lazymatch type of H with two ?v ?w -> _ => given (H (P v w eq_refl)) P | _ => pose proof H end.
  given (VERTEX 0 1 2 3 4)%N P. given (VERTEX 1 0 2 3 4)%N P. given (VERTEX 2 0 1 3 4)%N P.
  given (VERTEX 3 0 1 2 4)%N P. given (VERTEX 4 0 1 2 3)%N P.
  given (EDGE 0 1)%N P. given (EDGE 0 2)%N P. given (EDGE 0 3)%N P. given (EDGE 0 4)%N P. given (EDGE 1 2)%N P.
  given (EDGE 1 3)%N P. given (EDGE 1 4)%N P. given (EDGE 2 3)%N P. given (EDGE 2 4)%N P. given (EDGE 3 4)%N P.
  given (TRIANGLE 0 1 2)%N P. given (TRIANGLE 0 1 3)%N P. given (TRIANGLE 0 1 4)%N P. given (TRIANGLE 0 2 3)%N P.
  given (TRIANGLE 0 2 4)%N P. given (TRIANGLE 0 3 4)%N P. given (TRIANGLE 1 2 3)%N P. given (TRIANGLE 1 2 4)%N P.
  given (TRIANGLE 1 3 4)%N P. given (TRIANGLE 2 3 4)%N P.
  clear VERTEX EDGE TRIANGLE P. lra.
Qed.

(** The same for points of real space: [x v] is vertex v, [c v w] the first corner after it on the way
    to w, which is vertex w or the bend of the edge. Vertices may coincide, and edges may cross. The
    m of a drawing is at most 0.2248, so it has a bend of at most 103.0 degrees. *)
Theorem K5_in_space (x : N -> vec) (c : N -> N -> vec) m : -1 < m <= 1 ->
  (forall v w, two v w -> x v <> c v w) ->
  (forall v j k, two v j -> two v k -> j <> k -> cosine G (x v) (c v j) (c v k) <= -1/3) ->
  (forall v w, two v w -> c v w = x w /\ c w v = x v \/ c v w = c w v /\ cosine G (c v w) (x v) (x w) <= - m) ->
  10 * (1 + m) <= 30 / sqrt 6.
Proof.
  intros M LONG ANGLE EDGE.
  assert (TURN : forall v w, two v w -> two w v) by (unfold two; intuition congruence).
  (* A bend between a point and itself would be of 0 degrees. *)
  assert (APART : forall v w, two v w -> x v <> x w).
  { intros v w T E. destruct (EDGE v w T) as [[W _]|[_ H]]; [apply (LONG v w T); congruence|].
    rewrite <- E, cosine_dir, dir_unit in H by (apply not_eq_sym, LONG, T). lra. }
  apply (five_points x (fun v w => dir (x v) (c v w))).
  - exact APART.
  - intros v w T. apply dir_unit, LONG, T.
  - intros v j k J K N. rewrite <- cosine_dir by (apply LONG; assumption). now apply ANGLE.
  - intros v w T. pose proof (LONG v w T) as L. pose proof (LONG w v (TURN v w T)) as L'.
    destruct (EDGE v w T) as [[-> ->]|[E H]].
    + apply edge_without_a_bend; [now apply APART|lra].
    + rewrite <- E in *. apply edge_with_a_bend; auto. lra.
Qed.

End Space.

(** That is less than the 40/3 of bends of at least arccos(-1/3). *)
Lemma too_much : 30 / sqrt 6 < 10 * (1 + 1/3).
Proof.
  assert (S : 9 / 4 < sqrt 6).
  { rewrite <- (sqrt_square (9 / 4)) by lra. apply sqrt_lt_1; lra. }
  apply (Rmult_lt_reg_r (sqrt 6)); [lra|].
  replace (30 / sqrt 6 * sqrt 6) with 30 by (field; lra). lra.
Qed.

(** ** Drawings *)

Definition K5 : graph := Graph 5 [(0, 1); (0, 2); (0, 3); (0, 4); (1, 2); (1, 3); (1, 4); (2, 3); (2, 4); (3, 4)]%N.

(** A drawing of K5, whatever crosses or coincides: its edges, each once, with at most one bend, no
    segment of length zero; angles at vertices of at least arccos(-1/3), at bends of at least arccos(-m). *)
Record One_bend (d : drawing) (G : gram) (m : R) : Prop := {
  is_K5 : Permutation (map turned (map ends (edges d))) (map turned (pairs K5));
  one_bend : forall f, In f (edges d) -> (length (bends f) <= 1)%nat;
  some_length : forall s, In s (segments d) -> at_ (fst s) <> at_ (snd s);
  at_vertices : forall s t v b c, In s (segments d) -> In t (segments d) -> s <> t ->
    joins s (vertex d v) b -> joins t (vertex d v) c -> cosine G (at_ (vertex d v)) (at_ b) (at_ c) <= -1/3;
  at_bends : forall s t e i p b c, In s (segments d) -> In t (segments d) -> s <> t ->
    joins s (Bend e i, p) b -> joins t (Bend e i, p) c -> cosine G (at_ (Bend e i, p)) (at_ b) (at_ c) <= - m }.

Section Drawn.
Variables (d : drawing) (G : gram) (m : R).
Hypothesis PD : positive_definite G.
Hypothesis D : One_bend d G m.

Lemma has_number {A} (l : list A) a : In a l -> forall i, exists n, In (n, a) (numbered i l).
Proof.
  induction l as [|b r IH]; [easy|]. cbn [In numbered]. intros [->|I] i; [eauto|].
  destruct (IH I (N.succ i)) as [n J]. eauto.
Qed.

Lemma one_number {A} (l : list A) n a b : In (n, a) (numbered 0 l) -> In (n, b) (numbered 0 l) -> a = b.
Proof.
  intros I J. apply in_numbered in I as [i [-> I]]. apply in_numbered in J as [j [E J]].
  assert (i = j) by lia. congruence.
Qed.

Lemma turned_swap v w : turned (v, w) = turned (w, v).
Proof. unfold turned; cbn [fst snd]. f_equal; lia. Qed.

(** The edge between v and w, with its number. *)
Definition between_them (v w : N) (f : N * edge) : bool :=
  let (a, b) := turned (ends (snd f)) in let (i, j) := turned (v, w) in N.eqb a i && N.eqb b j.
Definition edge_of (v w : N) : N * edge :=
  match find (between_them v w) (numbered 0 (edges d)) with Some f => f | None => (0%N, Edge 0 0 []) end.

Lemma edge_of_is v w : two v w ->
  In (edge_of v w) (numbered 0 (edges d)) /\ turned (ends (snd (edge_of v w))) = turned (v, w).
Proof.
  intros T.
  assert (I : In (turned (v, w)) (map turned (pairs K5))).
  { destruct T as [V [W N]].
    assert (V' : (v = 0 \/ v = 1 \/ v = 2 \/ v = 3 \/ v = 4)%N) by lia.
    assert (W' : (w = 0 \/ w = 1 \/ w = 2 \/ w = 3 \/ w = 4)%N) by lia.
    destruct V' as [->|[->|[->|[->| ->]]]], W' as [->|[->|[->|[->| ->]]]]; try congruence;
      cbn; repeat ((left; reflexivity) || right). }
  apply (Permutation_in _ (Permutation_sym (is_K5 _ _ _ D))) in I. rewrite map_map in I.
  apply in_map_iff in I as [f [E I]]. destruct (has_number _ _ I 0%N) as [n J]. unfold edge_of.
  destruct (find _ _) as [f'|] eqn:F.
  - apply find_some in F as [F B]. split; [exact F|]. unfold between_them in B.
    destruct (turned (ends (snd f'))), (turned (v, w)). apply andb_prop in B as [B B'].
    apply N.eqb_eq in B, B'. now subst.
  - apply (find_none _ _ F) in J. unfold between_them in J. cbn [snd] in J. rewrite E in J.
    destruct (turned (v, w)). now rewrite !N.eqb_refl in J.
Qed.

Lemma edge_of_swap v w : edge_of v w = edge_of w v.
Proof. unfold edge_of, between_them. now rewrite turned_swap. Qed.

(** The first corner after v on the way to w. *)
Definition next (v w : N) : corner :=
  let (e, f) := edge_of v w in match bends f with [] => vertex d w | b :: _ => (Bend e 0, b) end.

Lemma joins_swap s a b : joins s a b -> joins s b a.
Proof. unfold joins. tauto. Qed.

(** A segment from v to w, or one from each of the two to a bend, whichever way the edge is listed. *)
Lemma ways v w : two v w ->
  (next v w = vertex d w /\ next w v = vertex d v /\
     exists s, In s (segments d) /\ joins s (vertex d v) (vertex d w)) \/
  (exists e i p s t, next v w = (Bend e i, p) /\ next w v = (Bend e i, p) /\ In s (segments d) /\ In t (segments d) /\
     s <> t /\ joins s (Bend e i, p) (vertex d v) /\ joins t (Bend e i, p) (vertex d w)).
Proof.
  intros T. destruct (edge_of_is v w T) as [I E]. unfold next. rewrite (edge_of_swap w v).
  destruct (edge_of v w) as [e f]. cbn [snd] in E.
  assert (B : (length (bends f) <= 1)%nat).
  { apply in_numbered in I as [j [_ I]]. apply nth_error_In in I. now apply (one_bend _ _ _ D). }
  assert (S : forall s, In s (steps (polyline d e f)) -> In s (segments d)).
  { intros s S. apply in_flat_map. now exists (e, f). }
  assert (W : tail f = v /\ head f = w \/ tail f = w /\ head f = v).
  { unfold turned, ends in E; cbn [fst snd] in E. injection E. lia. }
  unfold polyline, steps in S. destruct (bends f) as [|b [|b' r]]; [left|right|cbn in B; lia].
  - repeat split. cbn in S. exists (vertex d (tail f), vertex d (head f)). split; [apply S; now left|].
    unfold joins. destruct W as [[-> ->]|[-> ->]]; auto.
  - cbn in S. exists e, 0%N, b. set (c := (Bend e 0, b)) in *.
    pose proof (S _ (or_introl eq_refl)) as S1. pose proof (S _ (or_intror (or_introl eq_refl))) as S2.
    assert (N : (vertex d (tail f), c) <> (c, vertex d (head f))) by discriminate.
    destruct W as [[W W']|[W W']]; rewrite W, W' in *.
    + exists (vertex d v, c), (c, vertex d w). unfold joins. repeat split; auto.
    + exists (c, vertex d v), (vertex d w, c). unfold joins. repeat split; auto.
Qed.

Lemma leaves v w : two v w -> exists s, In s (segments d) /\ joins s (vertex d v) (next v w).
Proof.
  intros T. destruct (ways v w T) as [[-> [_ [s [S J]]]]|[e [i [p [s [t [-> [_ [S [_ [_ [J _]]]]]]]]]]]]; [eauto|].
  exists s. split; [exact S|]. now apply joins_swap.
Qed.

Lemma joins_apart s a b : In s (segments d) -> joins s a b -> at_ a <> at_ b.
Proof. intros S J. pose proof (some_length _ _ _ D s S). destruct J as [->| ->]; cbn [fst snd] in *; auto. Qed.

Lemma next_apart v w : two v w -> at_ (vertex d v) <> at_ (next v w).
Proof. intros T. destruct (leaves v w T) as [s [S J]]. exact (joins_apart s _ _ S J). Qed.

(** The edges of a vertex leave it in different segments. *)
Lemma next_differs v j k : two v j -> two v k -> j <> k -> next v j <> next v k.
Proof.
  intros J K N. destruct (edge_of_is v j J) as [I E]. destruct (edge_of_is v k K) as [I' E'].
  unfold next. destruct (edge_of v j) as [e f], (edge_of v k) as [e' f']. cbn [snd] in E, E'.
  destruct (bends f), (bends f'); unfold vertex; intros H; try discriminate.
  - injection H as H _. contradiction.
  - injection H as H _. subst e'. rewrite (one_number _ _ _ _ I I'), E' in E.
    unfold turned in E; cbn [fst snd] in E. injection E. lia.
Qed.

Lemma joins_one s a b c : joins s a b -> joins s a c -> b = c.
Proof. unfold joins. intuition congruence. Qed.

Theorem one_bend_of_K5 : -1 < m <= 1 -> 10 * (1 + m) <= 30 / sqrt 6.
Proof.
  intros M. apply (K5_in_space G PD (fun v => at_ (vertex d v)) (fun v w => at_ (next v w)) m M next_apart).
  - intros v j k J K N. destruct (leaves v j J) as [s [S SJ]]. destruct (leaves v k K) as [t [T TJ]].
    apply (at_vertices _ _ _ D s t v _ _ S T); [|exact SJ|exact TJ].
    intros <-. apply (next_differs v j k J K N). exact (joins_one _ _ _ _ SJ TJ).
  - intros v w T. destruct (ways v w T) as [[-> [-> _]]|[e [i [p [s [t [-> [-> [S [S' [N [J J']]]]]]]]]]]]; [now left|right].
    split; [reflexivity|]. exact (at_bends _ _ _ D s t e i p _ _ S S' N J J').
Qed.

End Drawn.

Lemma third p n : (0 < n)%Z -> (n <= 3 * p)%Z -> - IZR p / IZR n <= -1/3.
Proof.
  intros N H. apply IZR_lt in N. apply IZR_le in H. rewrite mult_IZR in H.
  apply (Rmult_le_reg_r (3 * IZR n)); [lra|].
  replace (- IZR p / IZR n * (3 * IZR n)) with (- (3 * IZR p)) by (field; lra).
  replace (-1 / 3 * (3 * IZR n)) with (- IZR n) by field. lra.
Qed.

(** With angles of at least arccos(-1/3) at vertices and bends there is no such drawing. *)
Theorem K5_needs_two_bends_even_with_crossings d G : positive_definite G -> ~ One_bend d G (1/3).
Proof.
  intros PD D. pose proof (one_bend_of_K5 d G (1/3) PD D ltac:(lra)). pose proof too_much. lra.
Qed.

Theorem K5_needs_two_bends d k : (most_bends k <= 1)%N -> (q k <= 3 * minus_p k)%Z -> ~ Good d K5 k.
Proof.
  intros B C D. apply (K5_needs_two_bends_even_with_crossings d (lengths k)); [apply (metric_means _ _ _ D)|].
  assert (A : forall s t a b c, In s (segments d) -> In t (segments d) -> s <> t -> joins s a b -> joins t a c ->
    cosine (lengths k) (at_ a) (at_ b) (at_ c) <= -1/3).
  { intros s t a b c S T N J J'. pose proof (angles _ _ _ D s t a b c S T N J J') as H.
    pose proof (third _ _ (proj1 (cosine_means _ _ _ D)) C). unfold angle_kept in H.
    destruct (equal k); lra. }
  constructor.
  - apply (all_edges _ _ _ D).
  - intros f F. pose proof (few_bends _ _ _ D f F). lia.
  - apply (no_zero_length _ _ _ D).
  - intros s t v b c. apply A.
  - intros s t e i p b c S T N J J'. pose proof (A s t _ b c S T N J J'). lra.
Qed.
