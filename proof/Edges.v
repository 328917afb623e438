(** The promise in terms of edges: two edges meet only in vertices at which both end. *)
From Coq Require Import ZArith NArith List Reals Lia Permutation.
From Drawing Require Import Spec.
Import ListNotations.
Local Open Scope N_scope.

(** x is on the e-th edge f. *)
Definition on_edge (d : drawing) (e : N) (f : edge) (x : vec) : Prop :=
  exists s, In s (steps (polyline d e f)) /\ on s x.

Lemma in_numbered {A} (l : list A) : forall i e f, In (e, f) (numbered i l) ->
  exists j, e = i + N.of_nat j /\ nth_error l j = Some f.
Proof.
  induction l as [|a r IH]; cbn [numbered]; intros i e f H; [easy|]. destruct H as [H|H].
  - injection H as -> ->. exists O. split; [lia|reflexivity].
  - apply IH in H as [j [-> E]]. exists (S j). split; [lia|exact E].
Qed.

Lemma in_steps s l : In s (steps l) -> In (fst s) l /\ In (snd s) l.
Proof.
  destruct s as [a b]. unfold steps; cbn [fst snd]. intros H. split.
  - now apply in_combine_l in H.
  - apply in_combine_r in H. destruct l; [easy|]. now right.
Qed.

Lemma corner_of d e f c : In c (polyline d e f) ->
  (exists v, (v = tail f \/ v = head f) /\ c = vertex d v) \/ (exists i p, c = (Bend e i, p)).
Proof.
  unfold polyline. intros [H|H]; [left; eauto|].
  apply in_app_iff in H as [H|[H|[]]]; [|left; eauto].
  apply in_map_iff in H as [[i p] [H _]]. right. exists i, p. now rewrite <- H.
Qed.

(** A corner of two edges is a vertex of both. *)
Lemma common_corner d e f e' f' c : e <> e' -> In c (polyline d e f) -> In c (polyline d e' f') ->
  exists v, (v = tail f \/ v = head f) /\ (v = tail f' \/ v = head f') /\ c = vertex d v.
Proof.
  intros N H H'. apply corner_of in H as [[v [V ->]]|[i [p ->]]];
    apply corner_of in H' as [[w [W E]]|[j [o E]]]; try discriminate.
  - exists v. assert (v = w) as -> by now injection E. auto.
  - injection E as E _ _. contradiction.
Qed.

Theorem edges_meet_in_vertices d g k : Good d g k -> forall e f e' f' x,
  In (e, f) (numbered 0 (edges d)) -> In (e', f') (numbered 0 (edges d)) -> e <> e' ->
  on_edge d e f x -> on_edge d e' f' x ->
  exists v, (v = tail f \/ v = head f) /\ (v = tail f' \/ v = head f') /\ x = at_ (vertex d v).
Proof.
  intros G e f e' f' x E E' N [s [S X]] [t [T Y]].
  assert (SS : In s (segments d)) by (apply in_flat_map; now exists (e, f)).
  assert (TS : In t (segments d)) by (apply in_flat_map; now exists (e', f')).
  pose proof (in_steps _ _ S) as [S1 S2]. pose proof (in_steps _ _ T) as [T1 T2].
  assert (D : s <> t).
  { intros <-.
    destruct (common_corner _ _ _ _ _ _ N S1 T1) as [v [V [V' EV]]].
    destruct (common_corner _ _ _ _ _ _ N S2 T2) as [w [W [W' EW]]].
    assert (VW : v <> w).
    { intros ->. apply (no_zero_length _ _ _ G s SS). now rewrite EV, EW. }
    assert (U : turned (ends f) = turned (ends f')).
    { unfold turned, ends; cbn [fst snd]. f_equal; lia. }
    apply in_numbered in E as [i [-> E]]. apply in_numbered in E' as [j [-> E']].
    assert (ND : NoDup (map turned (map ends (edges d)))).
    { eapply Permutation_NoDup; [apply Permutation_sym, (all_edges _ _ _ G)|apply (edges_once _ _ _ G)]. }
    rewrite NoDup_nth_error in ND. apply N. f_equal. f_equal. apply ND.
    - rewrite !map_length. apply nth_error_Some. now rewrite E.
    - now rewrite !(map_nth_error turned _ _ (map_nth_error ends _ _ E)),
        (map_nth_error turned _ _ (map_nth_error ends _ _ E')), U. }
  destruct (no_crossings _ _ _ G s t x SS TS D X Y) as [c [C [C' ->]]].
  assert (I : In c (polyline d e f)) by now destruct C as [->| ->].
  assert (I' : In c (polyline d e' f')) by now destruct C' as [->| ->].
  destruct (common_corner _ _ _ _ _ _ N I I') as [v [V [V' ->]]]. eauto.
Qed.

(** A vertex on an edge is one of its ends. *)
Corollary no_vertex_inside d g k : Good d g k -> forall v e f, (v < order g)%N ->
  In (e, f) (numbered 0 (edges d)) -> on_edge d e f (at_ (vertex d v)) -> v = tail f \/ v = head f.
Proof.
  intros G v e f V E [s [S X]].
  assert (SS : In s (segments d)) by (apply in_flat_map; now exists (e, f)).
  destruct (in_steps _ _ S) as [A B].
  assert (I : In (vertex d v) (polyline d e f)).
  { destruct (vertices_off_edges _ _ _ G v s V SS X) as [->| ->]; assumption. }
  apply corner_of in I as [[w [W I]]|[i [p I]]]; [|discriminate]. now injection I as ->.
Qed.

(** Two segments of one edge have at most the bend between them in common. *)
Corollary no_edge_meets_itself d g k : Good d g k -> forall e f s t x,
  In (e, f) (numbered 0 (edges d)) -> In s (steps (polyline d e f)) -> In t (steps (polyline d e f)) ->
  s <> t -> on s x -> on t x -> exists c, is_end c s /\ is_end c t /\ x = at_ c.
Proof.
  intros G e f s t x E S T. apply (no_crossings _ _ _ G); apply in_flat_map; now exists (e, f).
Qed.

(** ** No segment is listed twice *)

Lemma numbered_nodup {A} (l : list A) : forall i, NoDup (map fst (numbered i l)).
Proof.
  induction l as [|a r IH]; intros i; cbn; constructor; [|apply IH].
  intros H. apply in_map_iff in H as [[j b] [E H]]. cbn in E; subst.
  apply in_numbered in H as [n [E _]]. lia.
Qed.

Lemma combine_nodup {A B} (l : list A) : forall (m : list B), NoDup l -> NoDup (combine l m).
Proof.
  induction l as [|a r IH]; intros [|b m] H; cbn; try constructor; inversion H; subst.
  - intros I. apply in_combine_l in I. contradiction.
  - now apply IH.
Qed.

Lemma NoDup_app {A} (l m : list A) : NoDup l -> NoDup m -> (forall x, In x l -> In x m -> False) -> NoDup (l ++ m).
Proof.
  induction l as [|a r IH]; intros L M D; [exact M|]. inversion L; subst. cbn. constructor.
  - rewrite in_app_iff. intros [I|I]; [contradiction|]. apply (D a); [now left|exact I].
  - apply IH; [assumption..|]. intros x X. apply D. now right.
Qed.

Lemma flat_map_nodup {A B} (f : A -> list B) l : NoDup l -> (forall a, In a l -> NoDup (f a)) ->
  (forall a b x, In a l -> In b l -> a <> b -> In x (f a) -> In x (f b) -> False) -> NoDup (flat_map f l).
Proof.
  induction l as [|a r IH]; intros N F D; cbn; [constructor|]. inversion N; subst.
  apply NoDup_app.
  - apply F. now left.
  - apply IH; [assumption| |]; intros; [apply F; now right|].
    eapply D; [right; exact H|right; exact H0| | |]; eauto.
  - intros x X Y. apply in_flat_map in Y as [b [Bi Y]].
    apply (D a b x); [now left|now right| |exact X|exact Y]. intros ->. contradiction.
Qed.

Lemma polyline_nodup d e f : tail f <> head f -> NoDup (polyline d e f).
Proof.
  intros T. apply (NoDup_map_inv fst). unfold polyline. cbn [map]. rewrite map_app, map_map. cbn [map fst].
  constructor.
  - intros H. apply in_app_iff in H as [H|[H|[]]].
    + apply in_map_iff in H as [b [E _]]. discriminate.
    + injection H as H. congruence.
  - apply NoDup_app.
    + rewrite <- (map_map fst (fun i => Bend e i)). apply FinFun.Injective_map_NoDup.
      * intros i j E. now injection E.
      * apply numbered_nodup.
    + constructor; [easy|constructor].
    + intros x X [<-|[]]. apply in_map_iff in X as [b [E _]]. discriminate.
Qed.

(** In a good drawing no segment is listed twice: [s <> t] in [angles] and [no_crossings] misses no pair. *)
Theorem segments_differ d g k : Good d g k -> NoDup (segments d).
Proof.
  intros G.
  assert (ND : NoDup (map turned (map ends (edges d)))).
  { eapply Permutation_NoDup; [apply Permutation_sym, (all_edges _ _ _ G)|apply (edges_once _ _ _ G)]. }
  unfold segments. apply flat_map_nodup.
  - apply (NoDup_map_inv fst), numbered_nodup.
  - intros [e f] I. apply combine_nodup, polyline_nodup.
    apply in_numbered in I as [j [_ E]]. apply nth_error_In in E.
    assert (K : In (turned (ends f)) (map turned (pairs g))).
    { eapply Permutation_in; [apply (all_edges _ _ _ G)|]. now apply in_map, in_map. }
    apply in_map_iff in K as [[u v] [K P]]. apply (edges_exist _ _ _ G) in P as [_ [_ P]].
    unfold turned, ends in K; cbn [fst snd] in K |- *. injection K. lia.
  - intros [e f] [e' f'] s E E' N S T. cbn [fst snd] in *.
    assert (NE : e <> e').
    { intros ->. apply N. f_equal. apply in_numbered in E as [i [I E]]. apply in_numbered in E' as [j [J E']].
      assert (i = j) by lia. subst. congruence. }
    assert (SS : In s (segments d)) by (apply in_flat_map; now exists (e, f)).
    pose proof (in_steps _ _ S) as [S1 S2]. pose proof (in_steps _ _ T) as [T1 T2].
    destruct (common_corner _ _ _ _ _ _ NE S1 T1) as [v [V [V' EV]]].
    destruct (common_corner _ _ _ _ _ _ NE S2 T2) as [w [W [W' EW]]].
    assert (VW : v <> w).
    { intros ->. apply (no_zero_length _ _ _ G s SS). now rewrite EV, EW. }
    assert (U : turned (ends f) = turned (ends f')).
    { unfold turned, ends; cbn [fst snd]. f_equal; lia. }
    apply in_numbered in E as [i [-> E]]. apply in_numbered in E' as [j [-> E']].
    rewrite NoDup_nth_error in ND. apply NE. f_equal. f_equal. apply ND.
    + rewrite !map_length. apply nth_error_Some. now rewrite E.
    + now rewrite !(map_nth_error turned _ _ (map_nth_error ends _ _ E)),
        (map_nth_error turned _ _ (map_nth_error ends _ _ E')), U.
Qed.
