(** Completeness: what the test of two segments does not call disjoint has a point in common,
    and all that is good is accepted, whatever the advice. *)
From Coq Require Import ZArith NArith List Bool Reals Lra Lia Psatz Permutation FMapPositive.
From Drawing Require Import Spec Checker Geometry Edges Sound.
Import ListNotations.
Local Open Scope Z_scope.

Lemma not_apart a b c d : apart a b c d = false ->
  (c <= a \/ d <= a \/ c <= b \/ d <= b) /\ (a <= c \/ a <= d \/ b <= c \/ b <= d).
Proof.
  unfold apart. intros H. destruct (Z.ltb_spec a c);
    rewrite !andb_false_iff, !Z.ltb_ge in H; lia.
Qed.

Lemma dot_diff h a b : dot h (diff a b) = dot h b - dot h a.
Proof. unfold dot, diff; cbn [px py pz]. ring. Qed.

(** As seen from a: the one segment goes from 0 to h . u, the other from h . w to h . w + h . v. *)
Lemma not_separates h a b c d : separates h a b c d = false ->
  let u := dot h (diff a b) in let v := dot h (diff c d) in let w := dot h (diff a c) in
  (w <= 0 \/ w + v <= 0 \/ w <= u \/ w + v <= u) /\ (0 <= w \/ 0 <= w + v \/ u <= w \/ u <= w + v).
Proof. intros H u v w. apply not_apart in H. subst u v w. rewrite !dot_diff. lia. Qed.

Definition nonzero (u : point) : bool := negb (same_point u (Point 0 0 0)).

Lemma nonzero_dot u : nonzero u = true -> 0 < dot u u.
Proof.
  unfold nonzero, same_point, dot. destruct u as [x y z]; cbn [px py pz]. intros H.
  apply negb_true_iff in H. rewrite !andb_false_iff, !Z.eqb_neq in H. nia.
Qed.

Lemma zero_point u : nonzero u = false -> u = Point 0 0 0.
Proof.
  unfold nonzero, same_point. destruct u as [x y z]; cbn [px py pz]. intros H.
  apply negb_false_iff in H. split_tests. now subst.
Qed.

(** A meeting point from two fractions with the same denominator. *)
Lemma meeting a b c d t s m : 0 < m -> 0 <= t <= m -> 0 <= s <= m ->
  (forall f, f = px \/ f = py \/ f = pz ->
     m * f (diff a c) = t * f (diff a b) - s * f (diff c d)) ->
  exists x, between (real a) (real b) x /\ between (real c) (real d) x.
Proof.
  intros M T S F.
  assert (FX := F px (or_introl eq_refl)).
  assert (FY := F py (or_intror (or_introl eq_refl))).
  assert (FZ := F pz (or_intror (or_intror eq_refl))). clear F.
  unfold diff in *; cbn [px py pz] in *.
  apply (f_equal IZR) in FX, FY, FZ.
  rewrite minus_IZR, !mult_IZR, !minus_IZR in FX, FY, FZ.
  destruct T as [T T'], S as [S S'].
  apply IZR_lt in M. apply IZR_le in T, T', S, S'.
  assert (unit : forall r, (0 <= r -> r <= IZR m -> 0 <= r / IZR m <= 1)%R).
  { intros r R0 R1. split.
    - apply Rmult_le_pos; [assumption|]. left. now apply Rinv_0_lt_compat.
    - apply (Rmult_le_reg_r (IZR m)); [assumption|]. unfold Rdiv.
      rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_1_l by lra. assumption. }
  eexists. split.
  - exists (IZR t / IZR m)%R. split; [now apply unit|reflexivity].
  - exists (IZR s / IZR m)%R. split; [now apply unit|]. unfold real; cbn [vx vy vz].
    f_equal; apply (Rmult_eq_reg_l (IZR m)); try lra;
      rewrite !Rmult_plus_distr_l; unfold Rdiv; rewrite <- !Rmult_assoc, !(Rmult_comm (IZR m)), 
        !(Rmult_assoc _ (IZR m)), ?(Rmult_comm (IZR m)).
    all: field_simplify; try lra.
Qed.

(** Not parallel: solve for the parameters by determinants. *)
Lemma skew_complete a b c d :
  let u := diff a b in let v := diff c d in let n := cross u v in
  nonzero n = true -> separates n a b c d = false ->
  separates (cross n u) a b c d = false -> separates (cross n v) a b c d = false ->
  exists x, between (real a) (real b) x /\ between (real c) (real d) x.
Proof.
  intros u v n N HN HU HV. apply nonzero_dot in N.
  apply not_separates in HN, HU, HV. fold u v in HN, HU, HV. cbv zeta in HN, HU, HV.
  set (w := diff a c) in *.
  assert (E1 : dot n u = 0) by (subst n; unfold dot, cross; cbn [px py pz]; ring).
  assert (E2 : dot n v = 0) by (subst n; unfold dot, cross; cbn [px py pz]; ring).
  assert (E3 : dot (cross n u) u = 0) by (unfold dot, cross; cbn [px py pz]; ring).
  assert (E4 : dot (cross n v) v = 0) by (unfold dot, cross; cbn [px py pz]; ring).
  assert (E5 : dot (cross n u) v = dot n n)
    by (subst n; unfold dot, cross; cbn [px py pz]; ring).
  assert (E6 : dot (cross n v) u = - dot n n)
    by (subst n; unfold dot, cross; cbn [px py pz]; ring).
  rewrite E1, E2 in HN. rewrite E3, E5 in HU. rewrite E4, E6 in HV.
  assert (W : dot n w = 0) by lia.
  apply (meeting a b c d (- dot (cross n v) w) (- dot (cross n u) w) (dot n n)); [lia|lia|lia|].
  fold u v w.
  assert (K : forall f, f = px \/ f = py \/ f = pz ->
    dot n n * f w = dot n w * f n + (- dot (cross n v) w) * f u - (- dot (cross n u) w) * f v).
  { intros f [->|[->| ->]]; subst n; unfold dot, cross; cbn [px py pz]; ring. }
  intros f F. rewrite (K f F), W. ring.
Qed.

Lemma parallel_scale u v : cross u v = Point 0 0 0 ->
  forall f, f = px \/ f = py \/ f = pz -> dot u u * f v = dot u v * f u.
Proof.
  destruct u as [x y z], v as [x' y' z']. unfold cross, dot; cbn [px py pz].
  intros [= N1 N2 N3] f [->|[->| ->]]; cbn [px py pz].
  - assert (E : (x*x+y*y+z*z) * x' - (x*x'+y*y'+z*z') * x = z*(z*x'-x*z') - y*(x*y'-y*x')) by ring.
    rewrite N2, N3 in E. lia.
  - assert (E : (x*x+y*y+z*z) * y' - (x*x'+y*y'+z*z') * y = x*(x*y'-y*x') - z*(y*z'-z*y')) by ring.
    rewrite N1, N3 in E. lia.
  - assert (E : (x*x+y*y+z*z) * z' - (x*x'+y*y'+z*z') * z = y*(y*z'-z*y') - x*(z*x'-x*z')) by ring.
    rewrite N1, N2 in E. lia.
Qed.

Lemma dot_swap u v : dot u v = dot v u.
Proof. unfold dot. ring. Qed.

Lemma cross_zero_swap u v : cross u v = Point 0 0 0 -> cross v u = Point 0 0 0.
Proof. unfold cross. intros [= N1 N2 N3]. f_equal; lia. Qed.

(** Parallel, u not zero: all of it is on one line, along which intervals overlap. *)
Lemma parallel_complete a b c d :
  let u := diff a b in let v := diff c d in let w := diff a c in
  nonzero u = true -> cross u v = Point 0 0 0 -> separates u a b c d = false ->
  separates (cross u (cross w u)) a b c d = false ->
  exists x, between (real a) (real b) x /\ between (real c) (real d) x.
Proof.
  intros u v w U N HU HW. apply nonzero_dot in U.
  apply not_separates in HU, HW. fold u v w in HU, HW. cbv zeta in HU, HW.
  set (h := cross u (cross w u)) in *.
  pose proof (parallel_scale u v N) as V.
  assert (VX := V px (or_introl eq_refl)).
  assert (VY := V py (or_intror (or_introl eq_refl))).
  assert (VZ := V pz (or_intror (or_intror eq_refl))).
  assert (E1 : dot h u = 0) by (subst h; unfold dot, cross; cbn [px py pz]; ring).
  assert (E2 : dot h v = 0).
  { assert (dot h v = dot u u * dot w v - dot w u * dot u v)
      by (subst h; unfold dot, cross; cbn [px py pz]; ring).
    assert (dot u u * dot w v = px w * (dot u u * px v) + py w * (dot u u * py v) + pz w * (dot u u * pz v))
      by (unfold dot; ring).
    rewrite VX, VY, VZ in H0.
    assert (px w * (dot u v * px u) + py w * (dot u v * py u) + pz w * (dot u v * pz u) = dot u v * dot w u)
      by (unfold dot; ring).
    lia. }
  rewrite E1, E2 in HW. assert (HZ : dot h w = 0) by lia.
  assert (Q : dot (cross w u) (cross w u) = 0)
    by (rewrite <- HZ; subst h; unfold dot, cross; cbn [px py pz]; ring).
  assert (QZ : nonzero (cross w u) = false).
  { destruct (nonzero (cross w u)) eqn:E; [|reflexivity]. apply nonzero_dot in E. lia. }
  apply zero_point, cross_zero_swap in QZ. pose proof (parallel_scale u w QZ) as W.
  set (m := dot u u) in *. set (p := dot u w) in *. set (r := dot u v) in *.
  (* the other segment goes from p / m to (p + r) / m *)
  assert (C : 0 <= p <= m \/ 0 <= p + r <= m \/ p < 0 /\ m < p + r \/ p + r < 0 /\ m < p) by lia.
  assert (M : 0 < m * m) by nia.
  destruct C as [C|[C|[C|C]]].
  - apply (meeting a b c d p 0 m); [lia|lia|lia|]. intros f F. fold u v w. rewrite (W f F). ring.
  - apply (meeting a b c d (p + r) m m); [lia|lia|lia|]. intros f F. fold u v w.
    rewrite (W f F), (V f F). ring.
  - (* 0 is inside *)
    apply (meeting a b c d 0 (- p) r); [lia|lia|lia|]. intros f F. fold u v w.
    specialize (W f F). specialize (V f F).
    assert (m * (r * f w) = m * (- (- p * f v))) by (transitivity (r * (m * f w)); [ring|];
      rewrite W; transitivity (p * (m * f v)); [rewrite V; ring|ring]).
    apply Z.mul_reg_l in H; lia.
  - apply (meeting a b c d 0 p (- r)); [lia|lia|lia|]. intros f F. fold u v w.
    specialize (W f F). specialize (V f F).
    assert (m * (- r * f w) = m * (- (p * f v))) by (transitivity (- r * (m * f w)); [ring|];
      rewrite W; transitivity (- p * (m * f v)); [rewrite V; ring|ring]).
    apply Z.mul_reg_l in H; lia.
Qed.

(** u zero, v not: a point and a segment. *)
Lemma point_complete a c d :
  let v := diff c d in let w := diff a c in
  nonzero v = true -> separates v a a c d = false ->
  separates (cross v (cross w v)) a a c d = false ->
  exists x, between (real a) (real a) x /\ between (real c) (real d) x.
Proof.
  intros v w V HV HW. apply nonzero_dot in V.
  apply not_separates in HV, HW. fold v w in HV, HW. cbv zeta in HV, HW.
  set (h := cross v (cross w v)) in *.
  assert (Z0 : forall h, dot h (diff a a) = 0) by (intros; rewrite dot_diff; ring).
  rewrite Z0 in HV, HW.
  assert (E1 : dot h v = 0) by (subst h; unfold dot, cross; cbn [px py pz]; ring).
  rewrite E1 in HW. assert (HZ : dot h w = 0) by lia.
  assert (Q : dot (cross w v) (cross w v) = 0)
    by (rewrite <- HZ; subst h; unfold dot, cross; cbn [px py pz]; ring).
  assert (QZ : nonzero (cross w v) = false).
  { destruct (nonzero (cross w v)) eqn:E; [|reflexivity]. apply nonzero_dot in E. lia. }
  apply zero_point, cross_zero_swap in QZ. pose proof (parallel_scale v w QZ) as W.
  apply (meeting a a c d 0 (- dot v w) (dot v v)); [lia|lia|lia|].
  intros f F. fold v w. rewrite (W f F).
  replace (f (diff a a)) with 0 by (destruct F as [->|[->| ->]]; unfold diff; cbn; lia). ring.
Qed.

Theorem disjoint_complete a b c d : disjoint a b c d = false ->
  exists x, between (real a) (real b) x /\ between (real c) (real d) x.
Proof.
  unfold disjoint. cbv zeta. intros H.
  repeat match goal with K : _ || _ = false |- _ => apply orb_false_iff in K as [? ?] end.
  destruct (nonzero (cross (diff a b) (diff c d))) eqn:N.
  { now apply skew_complete. }
  apply zero_point in N.
  destruct (nonzero (diff a b)) eqn:U.
  { now apply parallel_complete. }
  apply zero_point in U.
  assert (E : b = a).
  { destruct a as [x y z], b as [x' y' z']. unfold diff in U; cbn [px py pz] in U. injection U as U1 U2 U3.
    f_equal; lia. }
  subst b. destruct (nonzero (diff c d)) eqn:V.
  { now apply point_complete. }
  apply zero_point in V.
  assert (E : d = c).
  { destruct c as [x y z], d as [x' y' z']. unfold diff in V; cbn [px py pz] in V. injection V as V1 V2 V3.
    f_equal; lia. }
  subst d. unfold boxes_apart in *.
  repeat match goal with K : _ || _ = false |- _ => apply orb_false_iff in K as [? ?] end.
  repeat match goal with K : apart _ _ _ _ = false |- _ => apply not_apart in K end.
  assert (c = a) as -> by (destruct a as [x y z], c as [x' y' z']; cbn [px py pz] in *; f_equal; lia).
  exists (real a). split; exists 0%R; (split; [lra|]); unfold real; cbn; f_equal; lra.
Qed.

Corollary disjoint_iff a b c d : disjoint a b c d = true <->
  forall x, ~ (between (real a) (real b) x /\ between (real c) (real d) x).
Proof.
  split.
  - intros H x [X Y]. exact (disjoint_sound _ _ _ _ x H X Y).
  - intros H. destruct (disjoint a b c d) eqn:E; [reflexivity|].
    apply disjoint_complete in E as [x X]. now apply H in X.
Qed.

(** ** All pairs *)

Lemma sift_is {A} (f : A -> bool) l : forall r, sift f l r = rev (filter f l) ++ r.
Proof.
  induction l as [|a m IH]; cbn; intros r; [reflexivity|]. rewrite IH.
  destruct (f a); [|reflexivity]. cbn. now rewrite <- app_assoc.
Qed.

Lemma sift_nodup (f : piece -> bool) l : NoDup (map whole l) -> NoDup (map whole (sift f l [])).
Proof.
  rewrite sift_is, app_nil_r, map_rev. intros N. apply NoDup_rev. induction l as [|s r IH]; [constructor|].
  cbn in *. inversion N; subst. destruct (f s); cbn; [|auto]. constructor; [|auto].
  intros I. apply H1. apply in_map_iff in I as [u [<- U]]. apply in_map, (proj1 (filter_In _ _ _) U).
Qed.

(** A list that has of each segment only what others have, and no segment twice. *)
Definition within (l k : list piece) : Prop :=
  (forall u, In u k -> In (whole u) (map whole l)) /\ (NoDup (map whole l) -> NoDup (map whole k)).

Lemma sift_within f l : within l (sift f l []).
Proof.
  split; [|apply sift_nodup]. intros u. rewrite sift_is, app_nil_r, <- in_rev, filter_In. intros [U _].
  now apply in_map.
Qed.

Lemma divide_within ratio h c l :
  within l (fst (divide ratio h c l [] [])) /\ within l (snd (divide ratio h c l [] [])).
Proof.
  assert (G : forall low high, let out := divide ratio h c l low high in
    within (l ++ low) (fst out) /\ within (l ++ high) (snd out)).
  { assert (ADD : forall s r k k', adds s k k' -> forall m, within (r ++ k') m -> within ((s :: r) ++ k) m).
    { intros s r k k' [->|[u [-> W]]] m [I N]; split.
      - intros v V. right. now apply I.
      - intros D. inversion D; auto.
      - intros v V. apply I in V. rewrite map_app in V |- *. cbn in *. rewrite W in V. rewrite in_app_iff in *. cbn in V. tauto.
      - intros D. apply N. rewrite map_app in *. cbn in *. rewrite W. eapply Permutation_NoDup; [|exact D].
        apply Permutation_middle. }
    induction l as [|s r IH]; intros low high out; [split; (split; [intros u; apply in_map|auto])|].
    destruct (divide_step ratio h c s r low high) as [low' [high' [E [AL [AH _]]]]].
    subst out. rewrite E. split; eapply ADD; try eassumption; apply IH. }
  specialize (G [] []). now rewrite !app_nil_r in G.
Qed.

Lemma within_all {l k} (P : segment -> Prop) : within l k -> (forall u, In u l -> P (whole u)) ->
  forall u, In u k -> P (whole u).
Proof. intros [I _] H u U. apply I in U. apply in_map_iff in U as [v [<- V]]. auto. Qed.

Lemma across_ok_complete f ratio p : forall l m,
  (forall s t, In s l -> In t m -> f (whole s) (whole t) = true) -> across_ok f ratio p l m = true.
Proof.
  assert (SUB : forall l m l' m', within l l' -> within m m' ->
    (forall s t, In s l -> In t m -> f (whole s) (whole t) = true) ->
    forall s t, In s l' -> In t m' -> f (whole s) (whole t) = true).
  { intros l m l' m' L M F s t S T. revert s S. apply (within_all (fun s => f s (whole t) = true) L). intros s S.
    revert t T. apply (within_all (fun t => f (whole s) t = true) M). auto. }
  induction p as [|h c low IL high IH|h p IP q IQ r IR o IO]; cbn [across_ok]; intros l m F.
  - apply forallb_forall. intros s S. apply forallb_forall. intros t T.
    rewrite each_is, app_nil_r, <- in_rev in T. apply in_map_iff in T as [u [<- U]].
    unfold near_ok. cbn [inside box_of]. now rewrite (F s u S U), orb_true_r.
  - destruct (divide_within ratio h c l) as [LL LH], (divide_within ratio h c m) as [ML MH].
    destruct (divide ratio h c l), (divide ratio h c m).
    apply andb_true_intro. split; [apply IL|apply IH]; eauto.
  - cbv zeta. repeat (apply andb_true_intro; split); [apply IP|apply IQ|apply IR|apply IO];
      (eapply SUB; [apply sift_within|apply sift_within|exact F]).
Qed.

Lemma pairs_ok_complete f ratio p : forall l, NoDup (map whole l) ->
  (forall s t, In s l -> In t l -> whole s <> whole t -> f (whole s) (whole t) = true) -> pairs_ok f ratio p l = true.
Proof.
  assert (SUB : forall l l', within l l' ->
    (forall s t, In s l -> In t l -> whole s <> whole t -> f (whole s) (whole t) = true) ->
    forall s t, In s l' -> In t l' -> whole s <> whole t -> f (whole s) (whole t) = true).
  { intros l l' L F s t S T. revert s S. apply (within_all (fun s => s <> whole t -> f s (whole t) = true) L). intros s S.
    revert t T. apply (within_all (fun t => whole s <> t -> f (whole s) t = true) L). auto. }
  induction p as [|h c low IL high IH|h p IP q IQ r IR o IO]; cbn [pairs_ok]; intros l N F.
  - rewrite each_is, app_nil_r, <- map_rev. apply NoDup_rev in N. rewrite <- map_rev in N.
    assert (F' : forall s t, In s (rev l) -> In t (rev l) -> whole s <> whole t -> f (whole s) (whole t) = true)
      by (intros s t S T; apply in_rev in S, T; auto).
    clear F. induction (rev l) as [|a r IH]; [reflexivity|]. cbn in N. inversion N; subst. cbn [map all_pairs].
    apply andb_true_intro. split.
    + apply forallb_forall. intros t T. apply in_map_iff in T as [u [<- U]]. unfold near_ok; cbn [inside box_of].
      rewrite (F' a u); [apply orb_true_r|now left|now right|]. intros E. apply H1. rewrite E. now apply in_map.
    + apply IH; [assumption|]. intros s t S T. apply F'; now right.
  - destruct (divide_within ratio h c l) as [LL LH]. destruct (divide ratio h c l).
    apply andb_true_intro. split; [apply IL; [now apply LL|]|apply IH; [now apply LH|]]; eauto.
  - cbv zeta. pose proof (sift_within (level h) l) as LL. pose proof (sift_within (sloping h) l) as LS.
    repeat (apply andb_true_intro; split).
    + apply IP; [now apply LL|]. eauto.
    + apply across_ok_complete. intros s t S T. rewrite !sift_is, !app_nil_r, <- !in_rev, !filter_In in S, T.
      apply F; try easy. intros E. destruct S as [_ S], T as [_ T]. unfold sloping, level in *. rewrite E in S.
      now rewrite S in T.
    + apply IO; [now apply LS|]. eauto.
Qed.

(** ** The list of segments *)

Local Open Scope N_scope.

Lemma look_filled l : forall i t v, look t v <> None \/ i <= v < i + N.of_nat (length l) ->
  look (fill i l t) v <> None.
Proof.
  induction l as [|a r IH]; cbn [fill length]; intros i t v H; [destruct H; [assumption|lia]|].
  apply IH. destruct (N.eq_dec v i) as [->|K].
  - left. unfold look. rewrite PositiveMap.gss. discriminate.
  - destruct H as [H|H]; [left|right; lia]. unfold look in *. rewrite PositiveMap.gso; [assumption|].
    intros E. apply K. apply (f_equal N.pos) in E. rewrite !N.succ_pos_spec in E. lia.
Qed.

Lemma gather_complete t l : (forall f, In f l -> look t (tail f) <> None /\ look t (head f) <> None) ->
  forall e acc, gather t e l acc <> None.
Proof.
  induction l as [|f r IH]; cbn [gather]; intros H e acc; [discriminate|].
  destruct (H f (or_introl eq_refl)) as [A B].
  destruct (look t (tail f)); [|contradiction]. destruct (look t (head f)); [|contradiction].
  apply IH. intros f' F. apply H. now right.
Qed.

(** ** A pair of segments *)

Section Right.
  Context (d : drawing) (g : graph) (k : promise) (G : Good d g k).

  (** What is compared: a segment, or a vertex as one. *)
  Definition compared (s : segment) : Prop :=
    In s (segments d) \/ exists v, v < order g /\ s = (vertex d v, vertex d v).

  Lemma dot_or_segment s : compared s -> fst s = snd s \/ In s (segments d).
  Proof. intros [S|[v [_ ->]]]; auto. Qed.

  Lemma meet_in_corner s t x : compared s -> compared t -> s <> t -> on s x -> on t x ->
    exists c, is_end c s /\ is_end c t.
  Proof.
    intros [S|[v [V ->]]] [T|[w [W ->]]] N X Y.
    - destruct (no_crossings _ _ _ G s t x S T N X Y) as [c [C [D _]]]. eauto.
    - apply between_same in Y as ->. exists (vertex d w). split; [|now left].
      now apply (vertices_off_edges _ _ _ G).
    - apply between_same in X as ->. exists (vertex d v). split; [now left|].
      now apply (vertices_off_edges _ _ _ G).
    - exfalso. apply N. apply between_same in X, Y. cbn [fst] in *.
      assert (v = w) as -> by (apply (vertices_apart _ _ _ G); congruence). reflexivity.
  Qed.

  Lemma fine_complete s t a b c : compared s -> compared t -> s <> t -> joins s a b -> joins t a c ->
    fine (lengths k) k a b c = true.
  Proof.
    intros S T N JS JT. unfold fine. rewrite !orb_true_iff, !same_iff.
    apply dot_or_segment in S, T.
    destruct S as [S|S]; [left; left; destruct JS as [->| ->]; cbn in S; congruence|].
    destruct T as [T|T]; [left; right; destruct JT as [->| ->]; cbn in T; congruence|].
    right. destruct (cosine_means _ _ _ G) as [Q [P _]].
    apply angle_complete; [apply (metric_means _ _ _ G)|assumption|assumption| | |].
    - apply (no_zero_length _ _ _ G) in S. destruct JS as [->| ->]; cbn in S; auto.
    - apply (no_zero_length _ _ _ G) in T. destruct JT as [->| ->]; cbn in T; auto.
    - exact (angles _ _ _ G s t a b c S T N JS JT).
  Qed.

  Lemma pair_complete s t : compared s -> compared t -> s <> t -> pair_ok (lengths k) k s t = true.
  Proof.
    intros S T N. pose proof (fun x => meet_in_corner s t x S T N) as M.
    pose proof (fun a b c => fine_complete s t a b c S T N) as F.
    destruct s as [a b], t as [c o]. unfold pair_ok. cbv zeta.
    destruct (boxes_apart _ _ _ _); [reflexivity|]. cbn [orb].
    destruct (same a c) eqn:AC, (same a o) eqn:AO, (same b c) eqn:BC, (same b o) eqn:BO; cbn [orb negb].
    16:{ apply disjoint_iff. intros x [X Y]. destruct (M x X Y) as [e [C D]]. unfold is_end in C, D; cbn in C, D.
      destruct C as [->| ->], D as [D|D]; apply same_iff in D; congruence. }
    all: repeat match goal with H : same _ _ = true |- _ => apply same_iff in H end; subst;
      rewrite ?andb_true_r; repeat (apply andb_true_intro; split); try reflexivity;
      apply F; unfold joins; auto.
  Qed.
End Right.

(** ** The graph *)

Lemma graph_complete d g k : Good d g k -> graph_ok d g = true.
Proof.
  intros G. unfold graph_ok. cbv zeta. rewrite !count_is, !N.add_0_l, (all_vertices _ _ _ G), N.eqb_refl.
  pose proof (edges_exist _ _ _ G) as E. pose proof (all_edges _ _ _ G) as P. rewrite map_map in P.
  assert (D : forall f, In f (edges d) -> exists u v, In (u, v) (pairs g) /\ turned (u, v) = turned (ends f)).
  { intros f F. apply (in_map (fun f => turned (ends f))) in F. apply (Permutation_in _ P) in F.
    apply in_map_iff in F as [[u v] [F I]]. eauto. }
  assert (IN : forall f, In f (edges d) -> tail f < order g /\ head f < order g).
  { intros f F. apply D in F as [u [v [I F]]]. apply E in I. unfold turned, ends in F; cbn [fst snd] in F.
    injection F. lia. }
  assert (KEY : forall A (f : A -> N * N) l, (forall a, In a l -> fst (f a) < order g /\ snd (f a) < order g) ->
    NoDup (map (fun a => turned (f a)) l) -> NoDup (map (fun a => pair_key (order g) (turned (f a))) l)).
  { intros A f l H. induction l as [|a r IH]; cbn [map]; [constructor|]. intros N. inversion N; subst.
    constructor; [|apply IH; [intros; apply H; now right|assumption]].
    intros I. apply in_map_iff in I as [b [I B]]. apply H2. apply in_map_iff. exists b. split; [|exact B].
    pose proof (H a (or_introl eq_refl)). pose proof (H b (or_intror B)).
    unfold turned in I |- *. apply key_inj in I; [exact I|lia|lia]. }
  pose proof (edges_once _ _ _ G) as O.
  rewrite !(proj2 (forallb_forall _ _)).
  - rewrite <- (map_length (fun f => turned (ends f))), (Permutation_length P), map_length, N.eqb_refl. cbn [andb].
    edestruct (once_complete (fun e => pair_key (order g) (turned e)) (pairs g)) as [t T].
    { apply (KEY _ (fun e => e)); [|exact O]. intros [u v] I. apply E in I. cbn. tauto. }
    { intros i _ H. now rewrite PositiveMap.gempty in H. }
    edestruct (once_complete (fun f => pair_key (order g) (turned (ends f))) (edges d)) as [t' T'].
    { apply (KEY _ ends); [exact IN|]. eapply Permutation_NoDup; [apply Permutation_sym, P|exact O]. }
    { intros i _ H. now rewrite PositiveMap.gempty in H. }
    rewrite T, T'. apply forallb_forall. intros f F. apply D in F as [u [v [I F]]].
    apply once_sound in T as [_ [_ T]]. rewrite PositiveMap.mem_find.
    destruct (PositiveMap.find _ t) eqn:K; [reflexivity|]. exfalso. apply (T (pair_key (order g) (turned (ends f)))); [|exact K].
    right. apply in_map_iff. exists (u, v). now rewrite F.
  - intros f F. apply IN in F. now rewrite !(proj2 (N.ltb_lt _ _)).
  - intros [u v] I. apply E in I as [U [V D']]. cbn [fst snd].
    rewrite !(proj2 (N.ltb_lt _ _)) by assumption. now apply N.eqb_neq in D' as ->.
Qed.

(** ** The theorem *)

Theorem check_complete p d g k : Good d g k -> check p d g k = true.
Proof.
  intros G. unfold check.
  rewrite (proj2 (sane_iff k)), (proj2 (same_metric_iff d k)), (graph_complete _ _ _ G), (proj2 (plane_iff d k)).
  2: exact (vertices_in_plane _ _ _ G).
  2: exact (same_metric _ _ _ G).
  2:{ split; [exact (cosine_means _ _ _ G)|]. split; [apply metric_complete, (metric_means _ _ _ G)|exact (size_means _ _ _ G)]. }
  cbn [andb]. rewrite andb_true_r. repeat (apply andb_true_intro; split).
  - apply forallb_forall. intros f F. apply N.leb_le. rewrite count_is, N.add_0_l. now apply (few_bends _ _ _ G).
  - unfold box_ok. destruct (size k) as [b|] eqn:B; [|reflexivity].
    destruct (vertices d) as [|v r] eqn:V; [reflexivity|].
    assert (I : In v (points d)) by (unfold points; rewrite V; now left).
    destruct (size_means _ _ _ G b B) as [X [Y Z]].
    assert (S : forall c, exists o o', In o (points d) /\ In o' (points d) /\ spread c d v = (c o - c o')%Z)
      by (intros c; now apply spread_is).
    destruct (S px) as [o1 [o2 [O1 [O2 E1]]]], (S py) as [o3 [o4 [O3 [O4 E2]]]], (S pz) as [o5 [o6 [O5 [O6 E3]]]].
    rewrite E1, E2, E3. repeat (apply andb_true_intro; split); apply at_most_iff; try assumption;
      [apply (in_box _ _ _ G b o1 o2 B O1 O2)|apply (in_box _ _ _ G b o3 o4 B O3 O4)|apply (in_box _ _ _ G b o5 o6 B O5 O6)].
  - destruct (gather _ _ _ _) as [l|] eqn:GA.
    2:{ exfalso. revert GA. apply gather_complete. intros f F.
      assert (IN : tail f < order g /\ head f < order g).
      { pose proof (graph_complete _ _ _ G) as K. now apply graph_sound in K as [_ [_ [_ [_ K]]]]; apply K. }
      rewrite <- (all_vertices _ _ _ G) in IN. split; apply look_filled; right; lia. }
    apply (gather_is _ _ _ (fill_faithful d)) in GA. rewrite app_nil_r in GA. fold (segments d) in GA.
    assert (L : forall s, In s l <-> In s (segments d)) by (intros s; rewrite GA; symmetry; apply in_rev).
    apply andb_true_intro. split.
    + apply forallb_forall. intros s S. apply L in S. apply andb_true_intro. split.
      * apply negb_true_iff, not_true_iff_false. intros E. apply same_point_iff in E.
        apply (no_zero_length _ _ _ G s S). unfold at_. now apply (f_equal real) in E.
      * unfold direction_ok. destruct (directions k) as [|a r] eqn:D; [reflexivity|]. cbv zeta.
        destruct (in_directions _ _ _ G s) as [b [I A]]; [now rewrite D|exact S|].
        apply existsb_exists. exists b. rewrite <- D. split; [exact I|].
        apply along_complete; [|exact A]. apply (no_zero_length _ _ _ G s S).
    + assert (C : forall s, In s (dots 0 (vertices d) l) -> compared d g s).
      { intros s S. apply all_in in S. rewrite (all_vertices _ _ _ G), L in S. exact S. }
      assert (W : forall l r, map whole (each (fun s => Piece s 0 parts) l r) = rev l ++ map whole r).
      { intros m r. rewrite each_is, map_app, map_rev, map_map. cbn. now rewrite map_id. }
      apply pairs_ok_complete.
      * rewrite W, app_nil_r. apply NoDup_rev. rewrite dots_is. apply NoDup_app.
        -- apply NoDup_rev. apply (NoDup_map_inv (fun s => fst (fst s))). rewrite map_map. cbn.
           rewrite <- (map_map fst Vertex). apply FinFun.Injective_map_NoDup; [intros i j E; now injection E|].
           apply numbered_nodup.
        -- rewrite GA. apply NoDup_rev, (segments_differ _ _ _ G).
        -- intros s S T. apply L in T. apply (no_zero_length _ _ _ G s T).
           rewrite <- in_rev, in_map_iff in S. destruct S as [a [<- _]]. reflexivity.
      * intros s t S T N. apply (in_map whole) in S, T. rewrite W, app_nil_r, <- in_rev in S, T.
        apply (pair_complete _ _ _ G); auto.
Qed.

Theorem check_iff p d g k : check p d g k = true <-> Good d g k.
Proof. split; [apply check_sound|apply check_complete]. Qed.

