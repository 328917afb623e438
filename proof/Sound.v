(** What the checker accepts is good. *)
From Coq Require Import ZArith NArith List Bool Reals Lra Lia Permutation FMapPositive.
From Drawing Require Import Spec Checker Geometry Edges.
Import ListNotations.

(** ** Names and corners *)

Lemma same_iff a b : same a b = true <-> a = b.
Proof.
  unfold same. destruct a as [n p], b as [m o]; cbn. rewrite andb_true_iff, same_point_iff.
  split.
  - intros [H ->]. f_equal. destruct n, m; cbn in H; try discriminate; split_tests; now subst.
  - intros [= -> ->]. split; [|reflexivity]. destruct m; cbn; now rewrite !N.eqb_refl.
Qed.

Local Open Scope R_scope.

Lemma between_left a b : between a b a.
Proof. exists 0. split; [lra|]. destruct a; cbn. f_equal; ring. Qed.
Lemma between_right a b : between a b b.
Proof. exists 1. split; [lra|]. destruct b; cbn. f_equal; ring. Qed.
Lemma between_same a x : between a a x -> x = a.
Proof. intros [t [_ ->]]. destruct a; cbn. f_equal; ring. Qed.
Lemma between_swap a b x : between a b x -> between b a x.
Proof. intros [t [T ->]]. exists (1 - t). split; [lra|]. f_equal; ring. Qed.

Lemma joins_on s a b : joins s a b -> on s (at_ a).
Proof. intros [->| ->]; [apply between_left|apply between_right]. Qed.
Lemma joins_end s a b : joins s a b -> is_end a s.
Proof. unfold is_end. intros [->| ->]; cbn; auto. Qed.

Lemma cosine_swap G a b c : cosine G a b c = cosine G a c b.
Proof.
  unfold cosine. cbv zeta. rewrite (Rmult_comm (sqrt _) (sqrt _)).
  f_equal. unfold inner. ring.
Qed.
Lemma angle_swap G k a b c : angle_kept G k a b c -> angle_kept G k a c b.
Proof. unfold angle_kept. now rewrite cosine_swap. Qed.

(** ** A pair of segments *)

(** A segment of positive length, or a vertex as a segment. *)
Definition proper (s : segment) : Prop := at_ (fst s) <> at_ (snd s) \/ fst s = snd s.

Lemma fine_meet G k a b c x : positive_definite G -> fine G k a b c = true ->
  between (at_ a) (at_ b) x -> between (at_ a) (at_ c) x -> x = at_ a.
Proof.
  unfold fine. intros PD H X Y. apply orb_prop in H as [H|H]; [apply orb_prop in H as [H|H]|].
  - apply same_iff in H as <-. now apply between_same.
  - apply same_iff in H as <-. now apply between_same.
  - eapply only_there; eauto.
Qed.

Lemma pair_meet G k s t x : positive_definite G -> pair_ok G k s t = true ->
  on s x -> on t x -> exists c, is_end c s /\ is_end c t /\ x = at_ c.
Proof.
  destruct s as [a b], t as [c d]. unfold pair_ok, on, is_end; cbn [fst snd]. cbv zeta.
  intros PD H X Y. apply orb_prop in H as [H|H].
  { exfalso. exact (boxes_apart_sound _ _ _ _ x H X Y). }
  destruct (same a c) eqn:AC; [|destruct (same a d) eqn:AD; [|destruct (same b c) eqn:BC;
    [|destruct (same b d) eqn:BD]]]; cbn [orb] in H.
  5:{ exfalso. exact (disjoint_sound _ _ _ _ x H X Y). }
  all: repeat match goal with K : _ && _ = true |- _ => apply andb_prop in K as [? ?] end;
    cbn [negb orb] in *.
  - apply same_iff in AC as <-. exists a. repeat split; auto. eapply fine_meet; eauto.
  - apply same_iff in AD as <-. exists a. repeat split; auto. eapply fine_meet; eauto using between_swap.
  - apply same_iff in BC as <-. exists b. repeat split; auto. eapply fine_meet; eauto using between_swap.
  - apply same_iff in BD as <-. exists b. repeat split; auto. eapply fine_meet; eauto using between_swap.
Qed.

Lemma fine_angle G k a b c : at_ a <> at_ b -> at_ a <> at_ c -> fine G k a b c = true ->
  angle_ok G k (snd a) (snd b) (snd c) = true.
Proof.
  unfold fine. intros B C H. apply orb_prop in H as [H|H]; [apply orb_prop in H as [H|H]|exact H];
    apply same_iff in H; subst; contradiction.
Qed.

Lemma pair_angle G k s t a b c : positive_definite G -> (0 <= minus_p k)%Z -> (0 < q k)%Z ->
  at_ (fst s) <> at_ (snd s) -> at_ (fst t) <> at_ (snd t) ->
  pair_ok G k s t = true -> joins s a b -> joins t a c ->
  angle_kept G k (at_ a) (at_ b) (at_ c).
Proof.
  intros PD P Q S T H JS JT.
  assert (F : fine G k a b c = true).
  { pose proof (joins_on _ _ _ JS) as X. pose proof (joins_on _ _ _ JT) as Y.
    assert (AA : same a a = true) by now apply same_iff.
    destruct JS as [->| ->], JT as [->| ->]; unfold pair_ok in H; cbn [fst snd] in *;
      (apply orb_prop in H as [H|H];
       [exfalso; exact (boxes_apart_sound _ _ _ _ _ H X Y)|]);
      cbv zeta in H; rewrite AA, ?orb_true_r in H; cbn [orb negb] in H;
      repeat match goal with K : _ && _ = true |- _ => apply andb_prop in K as [? ?] end;
      assumption. }
  assert (at_ a <> at_ b) by (destruct JS as [->| ->]; cbn in S; auto).
  assert (at_ a <> at_ c) by (destruct JT as [->| ->]; cbn in T; auto).
  apply angle_sound; auto. now apply fine_angle.
Qed.

(** ** All pairs *)

Lemma all_pairs_in {A} (f : A -> A -> bool) l s t : all_pairs f l = true ->
  In s l -> In t l -> s <> t -> f s t = true \/ f t s = true.
Proof.
  induction l as [|a r IH]; [easy|]. cbn. intros H. apply andb_prop in H as [H K].
  rewrite forallb_forall in H. intros [->|S] [->|T] N; auto; try contradiction.
Qed.

Lemma sift_in {A} (f : A -> bool) l : forall r a,
  In a r \/ In a l /\ f a = true -> In a (sift f l r).
Proof.
  induction l as [|b m IH]; cbn; intros r a H.
  - now destruct H as [|[[] _]].
  - apply IH. destruct H as [H|[[->|H] E]]; [left|left|auto].
    + destruct (f b); [now right|assumption].
    + rewrite E. now left.
Qed.

(** A list has a piece of the segment s with the point x. *)
Definition has (l : list piece) (s : segment) (x : vec) : Prop := exists u, In u l /\ whole u = s /\ holds u x.

Lemma each_is {A B} (f : A -> B) l : forall r, each f l r = rev (map f l) ++ r.
Proof.
  induction l as [|a m IH]; cbn; intros r; [reflexivity|]. now rewrite IH, <- app_assoc.
Qed.
Lemma each_in {A B} (f : A -> B) l a : In a l -> In (f a) (each f l []).
Proof. intros I. rewrite each_is, app_nil_r, <- in_rev. now apply in_map. Qed.

Lemma whole_has l s x : In s l -> on s x -> has (each (fun s => Piece s 0 parts) l []) s x.
Proof.
  intros I X. exists (Piece s 0 parts). split; [exact (each_in (fun s => Piece s 0 parts) l s I)|].
  split; [reflexivity|]. now apply whole_holds.
Qed.

(** Every point is on one side, and that side's list has it on the same segments. *)
Lemma divide_has ratio h c s x l : forall low high,
  (rdot h x <= IZR c -> has l s x \/ has low s x -> has (fst (divide ratio h c l low high)) s x) /\
  (IZR c <= rdot h x -> has l s x \/ has high s x -> has (snd (divide ratio h c l low high)) s x).
Proof.
  assert (NIL : ~ has [] s x) by (intros [u [[] _]]).
  assert (MORE : forall t k k', adds t k k' -> has k s x -> has k' s x).
  { intros t k k' [->|[v [-> _]]] [u [U H]]; exists u; auto using in_cons. }
  assert (KEEP : forall t k k', keeps t k k' x -> whole t = s -> has k' s x).
  { intros t k k' [u [-> [W H]]] <-. exists u. split; [now left|]. auto. }
  induction l as [|t r IH]; intros low high.
  - split; (intros _ [H|H]; [contradiction|exact H]).
  - destruct (divide_step ratio h c t r low high) as [low' [high' [-> [AL [AH K]]]]].
    destruct (IH low' high') as [IL IA]. split; intros S H; [apply (IL S)|apply (IA S)];
      (destruct H as [[u [[->|U] [W H]]]|H]; [right|left; exists u; auto|right; eauto]);
      eapply KEEP; try exact W; now apply (K x H).
Qed.

Lemma side ratio h c x :
  (forall s l, has l s x -> has (fst (divide ratio h c l [] [])) s x) \/
  (forall s l, has l s x -> has (snd (divide ratio h c l [] [])) s x).
Proof.
  destruct (Rle_dec (rdot h x) (IZR c)) as [L|L]; [left|right]; intros s l H;
    (apply divide_has; [lra|now left]).
Qed.

Lemma level_or_sloping h s x l : has l s x ->
  has (sift (level h) l []) s x \/ has (sift (sloping h) l []) s x.
Proof.
  intros [u [I H]]. destruct (level h u) eqn:E; [left|right]; exists u; (split; [|exact H]);
    apply sift_in; right; split; auto.
  unfold sloping. now rewrite E.
Qed.

Lemma near_sound f u v x : near_ok f (box_of u) (box_of v) = true -> holds u x -> holds v x ->
  f (whole u) (whole v) = true.
Proof.
  unfold near_ok. intros H U V. apply orb_prop in H as [H|H]; [|exact H].
  exfalso. exact (far_sound _ _ _ H U V).
Qed.

Lemma across_ok_sound f ratio p : forall l m s t x, across_ok f ratio p l m = true ->
  has l s x -> has m t x -> f s t = true.
Proof.
  induction p as [|h c low IL high IH|h p IP q IQ r IR o IO]; cbn; intros l m s t x H S T.
  - destruct S as [u [U [<- X]]], T as [v [V [<- Y]]]. rewrite forallb_forall in H. apply H in U.
    rewrite forallb_forall in U. eapply near_sound; [|eassumption..]. now apply U, each_in.
  - destruct (side ratio h c x) as [B|A].
    + apply B in S, T. destruct (divide ratio h c l), (divide ratio h c m).
      apply andb_prop in H as [H _]. eapply IL; eauto.
    + apply A in S, T. destruct (divide ratio h c l), (divide ratio h c m).
      apply andb_prop in H as [_ H]. eapply IH; eauto.
  - apply andb_prop in H as [H HO]. apply andb_prop in H as [H HR]. apply andb_prop in H as [HP HQ].
    destruct (level_or_sloping h s x l S), (level_or_sloping h t x m T); eauto.
Qed.

Lemma pairs_ok_sound f ratio p : forall l s t x, pairs_ok f ratio p l = true ->
  has l s x -> has l t x -> s <> t -> f s t = true \/ f t s = true.
Proof.
  induction p as [|h c low IL high IH|h p IP q IQ r IR o IO]; cbn; intros l s t x H S T N.
  - destruct S as [u [U [<- X]]], T as [v [V [<- Y]]]. apply (each_in box_of) in U, V.
    apply (all_pairs_in _ _ _ _ H U) in V as [K|K].
    + left. eapply near_sound; eassumption.
    + right. eapply near_sound; eassumption.
    + intros E. apply N. now apply (f_equal inside) in E.
  - destruct (side ratio h c x) as [B|A].
    + apply B in S, T. destruct (divide ratio h c l).
      apply andb_prop in H as [H _]. eapply IL; eauto.
    + apply A in S, T. destruct (divide ratio h c l).
      apply andb_prop in H as [_ H]. eapply IH; eauto.
  - apply andb_prop in H as [H HO]. apply andb_prop in H as [HP HQ].
    destruct (level_or_sloping h s x l S), (level_or_sloping h t x l T); eauto using across_ok_sound.
Qed.

(** ** The list of segments *)

Local Open Scope N_scope.

Lemma look_fill l : forall i t v p, look (fill i l t) v = Some p ->
  (exists j, v = i + N.of_nat j /\ nth_error l j = Some p) \/ look t v = Some p.
Proof.
  induction l as [|a r IH]; cbn [fill]; intros i t v p H; [auto|].
  apply IH in H as [[j [-> E]]|H].
  - left. exists (S j). split; [lia|exact E].
  - unfold look in *. destruct (N.eq_dec v i) as [->|K].
    + rewrite PositiveMap.gss in H. left. exists O. split; [lia|exact H].
    + rewrite PositiveMap.gso in H; [auto|]. intros E. apply K.
      apply (f_equal N.pos) in E. rewrite !N.succ_pos_spec in E. lia.
Qed.

Definition faithful (d : drawing) (t : table) : Prop :=
  forall v p, look t v = Some p -> vertex d v = (Vertex v, p).

Lemma fill_faithful d : faithful d (fill 0 (vertices d) (PositiveMap.empty point)).
Proof.
  intros v p H. apply look_fill in H as [[j [-> E]]|H].
  - unfold vertex. rewrite N.add_0_l, Nnat.Nat2N.id. f_equal. now apply nth_error_nth.
  - unfold look in H. now rewrite PositiveMap.gempty in H.
Qed.

Lemma walk_is e l : forall i a z acc, walk e i a l z acc =
  rev (steps (a :: map (fun b => (Bend e (fst b), snd b)) (numbered i l) ++ [z])) ++ acc.
Proof.
  induction l as [|p r IH]; intros i a z acc; [reflexivity|].
  cbn [walk numbered map app]. rewrite IH. unfold steps. cbn [tl combine rev].
  now rewrite <- app_assoc.
Qed.

Lemma gather_is d t l : faithful d t -> forall e acc out, gather t e l acc = Some out ->
  out = rev (flat_map (fun f => steps (polyline d (fst f) (snd f))) (numbered e l)) ++ acc.
Proof.
  intros F. induction l as [|f r IH]; cbn [gather]; intros e acc out H.
  - now injection H as <-.
  - destruct (look t (tail f)) as [a|] eqn:A; [|discriminate].
    destruct (look t (head f)) as [b|] eqn:B; [|discriminate].
    apply F in A, B. apply IH in H. rewrite H, walk_is.
    cbn [numbered flat_map fst snd]. unfold polyline at 2. now rewrite A, B, rev_app_distr, app_assoc.
Qed.

Definition dot_of (a : N * point) : segment := ((Vertex (fst a), snd a), (Vertex (fst a), snd a)).

Lemma dots_is l : forall i acc, dots i l acc = rev (map dot_of (numbered i l)) ++ acc.
Proof.
  induction l as [|p r IH]; intros i acc; [reflexivity|].
  cbn [dots numbered map rev]. now rewrite IH, <- app_assoc.
Qed.

Lemma numbered_in {A} (l : list A) : forall i j a, nth_error l j = Some a ->
  In (i + N.of_nat j, a) (numbered i l).
Proof.
  induction l as [|b r IH]; intros i [|j] a E; try discriminate; cbn in *.
  - left. injection E as ->. f_equal. lia.
  - right. replace (i + N.pos (Pos.of_succ_nat j)) with (N.succ i + N.of_nat j) by lia. now apply IH.
Qed.

(** All that is compared: the segments, and the vertices as segments. *)
Lemma all_in d acc s : In s (dots 0 (vertices d) acc) <->
  In s acc \/ exists v, v < N.of_nat (length (vertices d)) /\ s = (vertex d v, vertex d v).
Proof.
  rewrite dots_is, in_app_iff, <- in_rev, in_map_iff. split; (intros [H|H]; [right|left]); auto.
  - destruct H as [[i p] [<- H]]. apply in_numbered in H as [j [-> E]]. exists (0 + N.of_nat j).
    assert (j < length (vertices d))%nat by (apply nth_error_Some; congruence).
    split; [lia|]. unfold dot_of, vertex; cbn [fst snd].
    now rewrite N.add_0_l, Nnat.Nat2N.id, (nth_error_nth _ _ _ E).
  - destruct H as [v [V ->]]. exists (v, nth (N.to_nat v) (vertices d) (Point 0 0 0)). split; [reflexivity|].
    replace v with (0 + N.of_nat (N.to_nat v)) at 1 by lia. apply numbered_in, nth_error_nth'. lia.
Qed.

(** ** The graph *)

Lemma count_is {A} (l : list A) : forall i, count i l = i + N.of_nat (length l).
Proof. induction l as [|a r IH]; cbn [count length]; intros i; [|rewrite IH]; lia. Qed.

Lemma key_inj n u v u' v' : v < n -> v' < n -> pair_key n (u, v) = pair_key n (u', v') -> (u, v) = (u', v').
Proof.
  unfold pair_key; cbn [fst snd]. intros V V' E. apply (f_equal N.pos) in E. rewrite !N.succ_pos_spec in E.
  apply N.succ_inj in E. apply N.div_mod_unique in E; [|assumption..]. destruct E. congruence.
Qed.

Section Once.
  Context {A : Type} (f : A -> positive).
  Implicit Type t : PositiveMap.t unit.
  Let has t i : Prop := PositiveMap.find i t <> None.

  Lemma add_has t i j : has (PositiveMap.add i tt t) j <-> i = j \/ has t j.
  Proof.
    unfold has. destruct (Pos.eq_dec j i) as [->|D].
    - rewrite PositiveMap.gss. split; [auto|discriminate].
    - rewrite PositiveMap.gso by assumption. intuition congruence.
  Qed.

  Lemma once_sound l : forall t t', once f l t = Some t' ->
    NoDup (map f l) /\ (forall i, In i (map f l) -> ~ has t i) /\
    forall i, has t' i <-> has t i \/ In i (map f l).
  Proof.
    induction l as [|a r IH]; cbn [once map]; intros t t' H.
    - injection H as <-. split; [constructor|]. split; [easy|]. cbn. tauto.
    - destruct (PositiveMap.find (f a) t) eqn:F; [discriminate|].
      apply IH in H as [D [N H]]. split; [|split].
      + constructor; [|assumption]. intros I. apply (N _ I), add_has. now left.
      + intros i [<-|I]; [unfold has; now rewrite F|]. intros K. apply (N _ I), add_has. now right.
      + intros i. rewrite H, add_has. cbn. tauto.
  Qed.

  Lemma once_complete l : forall t, NoDup (map f l) -> (forall i, In i (map f l) -> ~ has t i) ->
    exists t', once f l t = Some t'.
  Proof.
    induction l as [|a r IH]; cbn [once map]; intros t D N; [eauto|]. inversion D; subst.
    destruct (PositiveMap.find (f a) t) eqn:F.
    - exfalso. apply (N (f a)); [now left|]. unfold has. now rewrite F.
    - apply IH; [assumption|]. intros i I. rewrite add_has. intros [<-|K]; [contradiction|].
      apply (N i); [now right|assumption].
  Qed.
End Once.

(** ** The box *)

Lemma fold_points_is {A} (f : A -> point -> A) d a : fold_points f d a = fold_left f (points d) a.
Proof.
  unfold fold_points, points. rewrite fold_left_app. generalize (fold_left f (vertices d) a).
  induction (edges d) as [|e r IH]; intros b; [reflexivity|].
  cbn [fold_left flat_map]. now rewrite fold_left_app, IH.
Qed.

Local Open Scope Z_scope.

Lemma fold_max c l : forall a, let m := fold_left (fun m (o : point) => Z.max m (c o)) l a in
  a <= m /\ (forall o, In o l -> c o <= m) /\ (m = a \/ exists o, In o l /\ m = c o).
Proof.
  induction l as [|p r IH]; cbn [fold_left]; intros a; [split; [lia|split; [easy|auto]]|].
  destruct (IH (Z.max a (c p))) as [L [U E]]. cbv zeta. set (m := fold_left _ _ _) in *.
  split; [lia|]. split; [intros o [<-|O]; [lia|auto]|].
  destruct E as [E|[o [O E]]]; [|right; exists o; split; [now right|assumption]].
  destruct (Z.max_spec a (c p)) as [[_ M]|[_ M]]; rewrite M in E; [right; exists p; split; [now left|assumption]|auto].
Qed.

Lemma fold_min c l : forall a, let m := fold_left (fun m (o : point) => Z.min m (c o)) l a in
  m <= a /\ (forall o, In o l -> m <= c o) /\ (m = a \/ exists o, In o l /\ m = c o).
Proof.
  induction l as [|p r IH]; cbn [fold_left]; intros a; [split; [lia|split; [easy|auto]]|].
  destruct (IH (Z.min a (c p))) as [L [U E]]. cbv zeta. set (m := fold_left _ _ _) in *.
  split; [lia|]. split; [intros o [<-|O]; [lia|auto]|].
  destruct E as [E|[o [O E]]]; [|right; exists o; split; [now right|assumption]].
  destruct (Z.min_spec a (c p)) as [[_ M]|[_ M]]; rewrite M in E; [auto|right; exists p; split; [now left|assumption]].
Qed.

(** The spread is the largest difference. *)
Lemma spread_is c d p : In p (points d) ->
  (forall o o', In o (points d) -> In o' (points d) -> c o - c o' <= spread c d p) /\
  exists o o', In o (points d) /\ In o' (points d) /\ spread c d p = c o - c o'.
Proof.
  intros P. unfold spread. rewrite !fold_points_is.
  destruct (fold_max c (points d) (c p)) as [_ [U E]], (fold_min c (points d) (c p)) as [_ [L F]].
  split; [intros o o' O O'; specialize (U o O); specialize (L o' O'); lia|].
  destruct E as [E|[o [O E]]], F as [F|[o' [O' F]]]; rewrite E, F; eauto.
Qed.

Lemma at_most_less b n e e' : e <= e' -> at_most b n e' -> at_most b n e.
Proof. unfold at_most. intros H K. apply IZR_le in H. lra. Qed.

Local Open Scope N_scope.

(** ** The theorem *)

Lemma sane_iff k : sane k = true <-> (0 < q k /\ 0 <= minus_p k <= q k)%Z /\ metric_ok (lengths k) = true /\
  forall b, size k = Some b -> sane_bound (in_x b) /\ sane_bound (in_y b) /\ sane_bound (in_z b).
Proof.
  unfold sane, sane_bound, bound_ok. rewrite !andb_true_iff, Z.ltb_lt, !Z.leb_le.
  destruct (size k) as [b|].
  - rewrite !andb_true_iff, !Z.ltb_lt, !Z.leb_le. split.
    + intros [[? ?] ?]. split; [tauto|]. split; [tauto|]. intros b' [= <-]. tauto.
    + intros [? [? H]]. specialize (H b eq_refl). tauto.
  - split; [|tauto]. intros [? _]. split; [tauto|]. split; [tauto|discriminate].
Qed.

Lemma same_metric_iff d k : same_metric_ok d k = true <-> (0 < over d /\ 0 < lengths_over k)%Z /\
  forall place, In place [xx; yy; zz; xy; xz; yz] -> (place (metric d) * lengths_over k = place (lengths k) * over d)%Z.
Proof.
  unfold same_metric_ok. rewrite !andb_true_iff, !Z.ltb_lt, forallb_forall.
  split; intros [H K]; (split; [exact H|]); intros place P; apply Z.eqb_eq || apply Z.eqb_eq, K; auto.
Qed.

Lemma plane_iff d k : plane_ok k d = true <-> (in_plane k = true -> forall p, In p (vertices d) -> pz p = 0%Z).
Proof.
  unfold plane_ok. rewrite orb_true_iff, negb_true_iff, forallb_forall.
  destruct (in_plane k); split; try easy.
  - intros [H|H] _ p P; [discriminate|]. now apply Z.eqb_eq, H.
  - intros H. right. intros p P. now apply Z.eqb_eq, H.
  - now left.
Qed.

(** What is asked of the graph, and what follows from it. *)
Lemma graph_sound d g : graph_ok d g = true ->
  N.of_nat (length (vertices d)) = order g /\
  (forall u v, In (u, v) (pairs g) -> u < order g /\ v < order g /\ u <> v) /\
  NoDup (map turned (pairs g)) /\ Permutation (map turned (map ends (edges d))) (map turned (pairs g)) /\
  forall f, In f (edges d) -> tail f < order g /\ head f < order g.
Proof.
  unfold graph_ok. cbv zeta. intros H.
  apply andb_prop in H as [H SET]. apply andb_prop in H as [H MANY].
  apply andb_prop in H as [H DRAWN]. apply andb_prop in H as [SIZE EXIST].
  apply N.eqb_eq in SIZE, MANY. rewrite !count_is, ?N.add_0_l in *.
  rewrite forallb_forall in DRAWN, EXIST.
  assert (D : forall f, In f (edges d) -> tail f < order g /\ head f < order g).
  { intros f F. apply DRAWN in F. apply andb_prop in F. now rewrite !N.ltb_lt in F. }
  assert (E : forall u v, In (u, v) (pairs g) -> u < order g /\ v < order g /\ u <> v).
  { intros u v I. apply EXIST in I. cbn in I. split_tests. now apply N.eqb_neq in H0. }
  destruct (once _ (pairs g) _) as [t|] eqn:T; [|discriminate].
  destruct (once _ (edges d) _) as [t'|] eqn:T'; [|discriminate].
  apply once_sound in T as [N [_ T]]. apply once_sound in T' as [N' _].
  rewrite forallb_forall in SET.
  split; [exact SIZE|]. split; [exact E|]. split; [|split; [|exact D]].
  - apply (NoDup_map_inv (pair_key (order g))). now rewrite map_map.
  - rewrite map_map. apply NoDup_Permutation_bis.
    + apply (NoDup_map_inv (pair_key (order g))). now rewrite map_map.
    + rewrite !map_length. lia.
    + intros a I. apply in_map_iff in I as [f [<- F]].
      assert (K : In (pair_key (order g) (turned (ends f))) (map (fun e => pair_key (order g) (turned e)) (pairs g))).
      { apply SET in F. rewrite PositiveMap.mem_find in F. destruct (T (pair_key (order g) (turned (ends f)))) as [T1 _].
        destruct T1 as [T1|T1]; [|now rewrite PositiveMap.gempty in T1|exact T1].
        destruct (PositiveMap.find _ t); [discriminate|discriminate F]. }
      apply in_map_iff in K as [[u v] [K P]]. apply E in P as Q. apply D in F.
      unfold turned in K. apply key_inj in K; cbn [fst snd ends] in *; [|lia|lia].
      apply in_map_iff. exists (u, v). now split.
Qed.

Theorem check_sound p d g k : check p d g k = true -> Good d g k.
Proof.
  unfold check. intros H.
  apply andb_prop in H as [H SEG]. apply andb_prop in H as [H BOX]. apply andb_prop in H as [H PLANE].
  apply andb_prop in H as [H FEW]. apply andb_prop in H as [H GRAPH].
  apply andb_prop in H as [SANE SAME].
  apply sane_iff in SANE as [PQ [PD MEANS]]. apply metric_sound in PD.
  assert (Q := proj1 PQ). assert (P := proj1 (proj2 PQ)).
  apply graph_sound in GRAPH as [SIZE [EXIST [ONCE [SET DRAWN]]]].
  rewrite forallb_forall in FEW.
  destruct (gather _ _ _ _) as [l|] eqn:GA; [|discriminate].
  apply andb_prop in SEG as [EACH PAIRS]. rewrite forallb_forall in EACH.
  apply (gather_is _ _ _ (fill_faithful d)) in GA. rewrite app_nil_r in GA. fold (segments d) in GA.
  assert (IN : forall s, In s (segments d) -> In s l) by (intros s; rewrite GA, <- in_rev; auto).
  assert (LONG : forall s, In s (segments d) -> at_ (fst s) <> at_ (snd s)).
  { intros s S E. pose proof (EACH _ (IN _ S)) as K. cbv beta in K. apply andb_prop in K as [K _].
    apply negb_true_iff in K. rewrite (proj2 (same_point_iff _ _)) in K; [discriminate|].
    now apply real_inj. }
  set (all := dots 0 (vertices d) l) in *.
  assert (SA : forall s, In s (segments d) -> In s all).
  { intros s S. apply all_in. left. auto. }
  assert (VA : forall v, v < order g -> In (vertex d v, vertex d v) all).
  { intros v V. apply all_in. right. exists v. split; [lia|reflexivity]. }
  assert (MEET : forall s t x, In s all -> In t all -> s <> t -> on s x -> on t x ->
    exists c, is_end c s /\ is_end c t /\ x = at_ c).
  { intros s t x S T N X Y. destruct (pairs_ok_sound _ _ _ _ _ _ x PAIRS (whole_has _ _ _ S X) (whole_has _ _ _ T Y) N)
      as [K|K].
    - eapply pair_meet; eauto.
    - eapply pair_meet in K as [c [? [? ?]]]; eauto. }
  constructor; auto.
  - intros f F. apply FEW, N.leb_le in F. now rewrite count_is, N.add_0_l in F.
  - intros s t a b c S T N JS JT.
    destruct (pairs_ok_sound _ _ _ _ _ _ (at_ a) PAIRS (whole_has _ _ _ (SA _ S) (joins_on _ _ _ JS))
                (whole_has _ _ _ (SA _ T) (joins_on _ _ _ JT)) N) as [K|K].
    + exact (pair_angle _ _ _ _ _ _ _ PD P Q (LONG _ S) (LONG _ T) K JS JT).
    + apply angle_swap.
      exact (pair_angle _ _ _ _ _ _ _ PD P Q (LONG _ T) (LONG _ S) K JT JS).
  - now apply same_metric_iff.
  - intros v w V W E. destruct (N.eq_dec v w) as [|K]; [assumption|].
    destruct (MEET (vertex d v, vertex d v) (vertex d w, vertex d w) (at_ (vertex d v)))
      as [c [C [D _]]]; auto.
    { intros F. apply K. now injection F. }
    { apply between_left. }
    { rewrite E. apply between_left. }
    assert (C' : c = vertex d v) by now destruct C.
    assert (D' : c = vertex d w) by now destruct D.
    rewrite C' in D'. now injection D'.
  - intros v s V S O.
    destruct (MEET (vertex d v, vertex d v) s (at_ (vertex d v))) as [c [C [D _]]]; auto.
    { intros F. apply (LONG s S). now rewrite <- F. }
    { apply between_left. }
    assert (C' : c = vertex d v) by now destruct C. now rewrite <- C'.
  - intros s NE S. apply IN, EACH, andb_prop in S as [_ S]. unfold direction_ok in S.
    destruct (directions k) as [|a r]; [contradiction|]. cbv zeta in S.
    apply existsb_exists in S as [b [B S]]. exists b. split; [exact B|]. now apply along_sound.
  - now apply plane_iff.
  - intros b o o' B O O'. unfold box_ok in BOX. rewrite B in BOX.
    destruct (vertices d) as [|v r] eqn:VS.
    { exfalso. unfold points in O. rewrite VS in O. apply in_flat_map in O as [f [F _]].
      apply DRAWN in F. cbn in SIZE. lia. }
    assert (V : In v (points d)) by (unfold points; rewrite VS; now left).
    destruct (MEANS b B) as [MX [MY MZ]].
    apply andb_prop in BOX as [BOX Z]. apply andb_prop in BOX as [X Y].
    apply at_most_iff in X, Y, Z; [|assumption..].
    repeat split; (eapply at_most_less; [|eassumption]); now apply (spread_is _ d v V).
Qed.
