(** Along face diagonals one bend per edge is not enough for any graph whose vertices all have degree 3, with crossings or
    without: [faces_need_two_bends], at the end. Where two bends suffice, at least six edges have two, one for each of the
    directions x, -x, y, -y, z, -z: [six_edges_have_two]. Both speak of [Good], the page of Spec.v. The proof is that of
    docs/open-questions.md, in its steps:
    1. [star], [bend]: three diagonals of at least 120 degrees have +1 in each direction; a bend never turns from +1 to -1.
    2. [last_way]: of the vertices that are furthest in a direction, take the edge that leaves with +1.
    3. [serves]: it comes back, so it goes +1, 0, -1 and has two bends.
    4. [serves_one]: it does so in that one direction only. *)
From Coq Require Import ZArith NArith List Bool Permutation Reals Lra Lia Psatz.
From Drawing Require Import Spec Edges OneBend.
Import ListNotations.

(** ** Face diagonals, directions of the axes, and what is finite *)

Definition faces : list point :=
  flat_map (fun a => flat_map (fun b => [Point a b 0; Point a 0 b; Point 0 a b]) [1; -1]%Z) [1; -1]%Z.
Definition axes : list point :=
  [Point 1 0 0; Point (-1) 0 0; Point 0 1 0; Point 0 (-1) 0; Point 0 0 1; Point 0 0 (-1)].
Definition dot (a b : point) : Z := (px a * px b + py a * py b + pz a * pz b)%Z.

Ltac tried T H := apply (fun t => proj1 (forallb_forall _ _) t _ H) in T; cbv beta in T.

Local Open Scope Z_scope.

(** Step 1. *)
Lemma star s a b c : In s axes -> In a faces -> In b faces -> In c faces ->
  dot a b <= -1 -> dot a c <= -1 -> dot b c <= -1 -> dot s a = 1 \/ dot s b = 1 \/ dot s c = 1.
Proof.
  intros S A B C AB AC BC.
  assert (T : forallb (fun s => forallb (fun a => forallb (fun b => forallb (fun c =>
    negb ((dot a b <=? -1) && (dot a c <=? -1) && (dot b c <=? -1))
    || ((dot s a =? 1) || (dot s b =? 1) || (dot s c =? 1))) faces) faces) faces) axes = true) by (vm_compute; reflexivity).
  tried T S. tried T A. tried T B. tried T C. lia.
Qed.

Lemma bend s a b : In s axes -> In a faces -> In b faces -> 1 <= dot a b -> dot s a = 1 -> dot s b = 0 \/ dot s b = 1.
Proof.
  intros S A B AB.
  assert (T : forallb (fun s => forallb (fun a => forallb (fun b =>
    negb ((1 <=? dot a b) && (dot s a =? 1)) || (dot s b =? 0) || (dot s b =? 1)) faces) faces) axes = true)
    by (vm_compute; reflexivity).
  tried T S. tried T A. tried T B. lia.
Qed.

Lemma along_axis s a : In s axes -> In a faces -> -1 <= dot s a <= 1.
Proof.
  intros S A.
  assert (T : forallb (fun s => forallb (fun a => (-1 <=? dot s a) && (dot s a <=? 1)) faces) axes = true)
    by (vm_compute; reflexivity).
  tried T S. tried T A. lia.
Qed.

Lemma one_axis s t a b : In s axes -> In t axes -> In a faces -> In b faces ->
  dot s a = 1 -> dot t a = 1 -> dot s b = 0 -> dot t b = 0 -> s = t.
Proof.
  intros S T A B SA TA SB TB.
  assert (E : forallb (fun s => forallb (fun t => forallb (fun a => forallb (fun b =>
    negb ((dot s a =? 1) && (dot t a =? 1) && (dot s b =? 0) && (dot t b =? 0)) || (dot s t =? 1)) faces) faces) axes) axes = true)
    by (vm_compute; reflexivity).
  tried E S. tried E T. tried E A. tried E B.
  assert (D : dot s t = 1) by lia. clear - S T D. cbn in S, T.
  decompose [or] S; decompose [or] T; subst; tauto || discriminate D.
Qed.

(** ** Real space *)

Local Open Scope R_scope.

Definition cube : gram := Gram 1 1 1 0 0 0.
Definition height (s : point) (u : vec) : R := IZR (px s) * vx u + IZR (py s) * vy u + IZR (pz s) * vz u.

(** From a to b the way is t > 0 times the diagonal f. *)
Definition step (t : R) (f : point) (a b : vec) : Prop :=
  0 < t /\ In f faces /\ towards a b = Vec (t * IZR (px f)) (t * IZR (py f)) (t * IZR (pz f)).

Lemma height_step s t f a b : step t f a b -> height s b = height s a + t * IZR (dot s f).
Proof.
  intros [_ [_ E]]. unfold towards in E. injection E as X Y Z. unfold height, dot. rewrite !plus_IZR, !mult_IZR.
  replace (vx b) with (vx a + t * IZR (px f)) by lra. replace (vy b) with (vy a + t * IZR (py f)) by lra.
  replace (vz b) with (vz a + t * IZR (pz f)) by lra. ring.
Qed.

Definition minus (f : point) : point := Point (- px f) (- py f) (- pz f).

Lemma minus_face f : In f faces -> In (minus f) faces.
Proof. intros F. cbn in F |- *. decompose [or] F; subst; try contradiction; cbn; tauto. Qed.

Lemma step_back t f a b : step t f a b -> step t (minus f) b a.
Proof.
  intros [T [F E]]. split; [exact T|]. split.
  - now apply minus_face.
  - unfold towards, minus in *; cbn [px py pz] in *. rewrite !opp_IZR. injection E as X Y Z. f_equal; lra.
Qed.

Lemma cosine_steps a b c t f r g : step t f a b -> step r g a c -> cosine cube a b c = IZR (dot f g) / 2.
Proof.
  intros [T [F E]] [R [H E']]. unfold cosine. rewrite E, E'.
  assert (TWO : forall u k, In k faces -> inner cube (Vec (u * IZR (px k)) (u * IZR (py k)) (u * IZR (pz k)))
    (Vec (u * IZR (px k)) (u * IZR (py k)) (u * IZR (pz k))) = 2 * (u * u)).
  { intros u k K. cbn in K. decompose [or] K; subst; try contradiction; unfold inner; cbn; ring. }
  rewrite !TWO by assumption. rewrite <- sqrt_mult by nra.
  replace (2 * (t * t) * (2 * (r * r))) with ((2 * t * r) * (2 * t * r)) by ring. rewrite sqrt_square by nra.
  unfold inner, dot; cbn [cube xx yy zz xy xz yz vx vy vz]. rewrite !plus_IZR, !mult_IZR. field. lra.
Qed.

Lemma at_least_120 a b c t f r g : step t f a b -> step r g a c -> cosine cube a b c <= -1/2 -> (dot f g <= -1)%Z.
Proof. intros S S' C. rewrite (cosine_steps _ _ _ _ _ _ _ S S') in C. apply le_IZR. lra. Qed.

(** All steps along diagonals, all bends of at least 120 degrees. *)
Fixpoint good_way (l : list vec) : Prop :=
  match l with
  | a :: (b :: r) as m =>
    (exists t f, step t f a b) /\ match r with c :: _ => cosine cube b a c <= -1/2 | [] => True end /\ good_way m
  | _ => True
  end.

Lemma next_step s a b c t f r g : In s axes -> step t f a b -> step r g b c -> cosine cube b a c <= -1/2 ->
  dot s f = 1%Z -> (dot s g = 0 \/ dot s g = 1)%Z.
Proof.
  intros S F H C. pose proof (at_least_120 _ _ _ _ _ _ _ (step_back _ _ _ _ F) H C) as D. apply (bend s f g S).
  - apply F.
  - apply H.
  - unfold dot, minus in *; cbn [px py pz] in D. lia.
Qed.

(** The four corners of an edge with two bends, which goes up, level and down. *)
Definition serves (s : point) (a b c e : vec) : Prop :=
  height s a < height s b /\ height s b = height s c /\ height s e < height s c.

(** Step 3. An edge that leaves with +1 and does not end higher has two bends and comes back. *)
Lemma comes_back s x y l t f : In s axes -> good_way (x :: l ++ [y]) -> (length l <= 2)%nat ->
  step t f x (hd y l) -> dot s f = 1%Z -> height s y <= height s x -> exists p q, l = [p; q] /\ serves s x p q y.
Proof.
  intros S W N F E H. destruct l as [|p [|q [|? ?]]]; cbn [hd] in F; cbn in N; [| | |lia].
  - apply (height_step s) in F as K. rewrite E in K. destruct F as [T _]. lra.
  - destruct W as [_ [C [[r [g G]] _]]]. pose proof (next_step s _ _ _ _ _ _ _ S F G C E) as D.
    apply (height_step s) in F as K. apply (height_step s) in G as L. rewrite E in K.
    destruct F as [T _], G as [R _]. destruct D as [D|D]; rewrite D in L; lra.
  - destruct W as [_ [C [[r [g G]] [C' [[u [h U]] _]]]]]. pose proof (next_step s _ _ _ _ _ _ _ S F G C E) as D.
    exists p, q. split; [reflexivity|]. unfold serves.
    apply (height_step s) in F as K. apply (height_step s) in G as L. apply (height_step s) in U as M. rewrite E in K.
    assert (F' := F). assert (G' := G). assert (U' := U). destruct F' as [T _], G' as [R _], U' as [V _].
    destruct D as [D|D].
    + rewrite D in L. lra.
    + pose proof (next_step s _ _ _ _ _ _ _ S G U C' D) as D'. rewrite D in L. destruct D' as [D'|D']; rewrite D' in M; lra.
Qed.

(** Step 4. *)
Lemma serves_one s t x p q y : In s axes -> In t axes -> good_way [x; p; q; y] ->
  serves s x p q y -> serves t x p q y -> s = t.
Proof.
  intros S T [[a [f F]] [_ [[b [g G]] _]]] [S1 [S2 _]] [T1 [T2 _]].
  rewrite (height_step s _ _ _ _ F) in S1. rewrite (height_step s _ _ _ _ G) in S2.
  rewrite (height_step t _ _ _ _ F) in T1. rewrite (height_step t _ _ _ _ G) in T2.
  destruct F as [A [F _]], G as [B [G _]].
  assert (UP : forall k, In k axes -> 0 < a * IZR (dot k f) -> dot k f = 1%Z).
  { intros k K P. pose proof (along_axis k f K F). assert (0 < dot k f)%Z by (apply lt_IZR; nra). lia. }
  assert (LEVEL : forall k, b * IZR (dot k g) = 0 -> dot k g = 0%Z) by (intros k P; apply eq_IZR; nra).
  apply (one_axis s t f g); auto; apply UP + apply LEVEL; auto; lra.
Qed.

Lemma highest (h : N -> R) n : (0 < n)%N -> exists v, (v < n)%N /\ forall w, (w < n)%N -> h w <= h v.
Proof.
  induction n as [|n IH] using N.peano_ind; [lia|]. intros _. destruct (N.eq_dec n 0) as [->|P].
  - exists 0%N. split; [lia|]. intros w W. replace w with 0%N by lia. lra.
  - destruct IH as [v [V H]]; [lia|]. destruct (Rle_lt_dec (h n) (h v)) as [L|L].
    + exists v. split; [lia|]. intros w W. destruct (N.eq_dec w n) as [->|]; [exact L|]. apply H. lia.
    + exists n. split; [lia|]. intros w W. destruct (N.eq_dec w n) as [->|]; [lra|]. apply Rlt_le, (Rle_lt_trans _ (h v)); [apply H; lia|exact L].
Qed.

(** [x v] is the point of vertex v, [way v w l] says that an edge goes from v by the points l to w. Vertices may
    coincide, and edges may cross. *)
Theorem in_space (n : N) (x : N -> vec) (way : N -> N -> list vec -> Prop) : (0 < n)%N ->
  (forall v w l, way v w l -> (w < n)%N /\ (length l <= 2)%nat /\ good_way (x v :: l ++ [x w])) ->
  (forall v, (v < n)%N -> exists w1 w2 w3 l1 l2 l3, way v w1 l1 /\ way v w2 l2 /\ way v w3 l3 /\
    cosine cube (x v) (hd (x w1) l1) (hd (x w2) l2) <= -1/2 /\ cosine cube (x v) (hd (x w1) l1) (hd (x w3) l3) <= -1/2 /\
    cosine cube (x v) (hd (x w2) l2) (hd (x w3) l3) <= -1/2) ->
  forall s, In s axes -> exists v w p q, way v w [p; q] /\ serves s (x v) p q (x w).
Proof.
  intros P WAY STAR s S. destruct (highest (fun v => height s (x v)) n P) as [v [V TOP]].
  assert (FIRST : forall w l, way v w l -> exists t f, step t f (x v) (hd (x w) l)).
  { intros w l W. apply WAY in W as [_ [_ W]]. destruct l; apply W. }
  assert (LEAVES : forall w l t f, way v w l -> step t f (x v) (hd (x w) l) -> dot s f = 1%Z ->
    exists v w p q, way v w [p; q] /\ serves s (x v) p q (x w)).
  { intros w l t f W F E. destruct (WAY _ _ _ W) as [I [N G]].
    destruct (comes_back s (x v) (x w) l t f S G N F E (TOP w I)) as [p [q [-> H]]]. now exists v, w, p, q. }
  destruct (STAR v V) as [w1 [w2 [w3 [l1 [l2 [l3 [W1 [W2 [W3 [C12 [C13 C23]]]]]]]]]]].
  destruct (FIRST _ _ W1) as [t1 [f1 F1]], (FIRST _ _ W2) as [t2 [f2 F2]], (FIRST _ _ W3) as [t3 [f3 F3]].
  destruct (star s f1 f2 f3) as [E|[E|E]]; eauto; try apply F1; try apply F2; try apply F3; eapply at_least_120; eauto.
Qed.

(** ** Drawings *)

Definition adjacent (g : graph) (v w : N) : Prop := In (turned (v, w)) (map turned (pairs g)).
(** All vertices have degree 3, at least: there are at most three directions of 120 degrees. *)
Definition three_neighbours (g : graph) : Prop := forall v, (v < order g)%N ->
  exists a b c, a <> b /\ a <> c /\ b <> c /\ adjacent g v a /\ adjacent g v b /\ adjacent g v c.

(** A drawing of g along face diagonals, whatever crosses or coincides: at most two bends, no segment of length zero,
    angles of at least 120 degrees. *)
Record On_faces (d : drawing) (g : graph) : Prop := {
  in_graph : forall v w, adjacent g v w -> (w < order g)%N;
  its_edges : Permutation (map turned (map ends (edges d))) (map turned (pairs g));
  two_bends : forall f, In f (edges d) -> (length (bends f) <= 2)%nat;
  diagonal : forall s, In s (segments d) -> exists t f, step t f (at_ (fst s)) (at_ (snd s));
  wide_angles : forall s t a b c, In s (segments d) -> In t (segments d) -> s <> t ->
    joins s a b -> joins t a c -> cosine cube (at_ a) (at_ b) (at_ c) <= -1/2 }.

(** In the direction s the edge goes up, level and down. *)
Definition edge_serves (d : drawing) (s : point) (f : edge) : Prop := exists p q, bends f = [p; q] /\
  serves s (at_ (vertex d (tail f))) (real p) (real q) (at_ (vertex d (head f))).

Section Drawn.
Variables (d : drawing) (g : graph).
Hypothesis D : On_faces d g.
Definition place (v : N) : vec := at_ (vertex d v).

(** The edge f leads from v by the points l to w, from its tail to its head or back. *)
Definition leads (f : edge) (v w : N) (l : list vec) : Prop :=
  tail f = v /\ head f = w /\ l = map real (bends f) \/ head f = v /\ tail f = w /\ l = rev (map real (bends f)).

Lemma leads_well e f v w l : In (e, f) (numbered 0 (edges d)) -> leads f v w l ->
  good_way (place v :: l ++ [place w]) /\ exists s c, In s (segments d) /\ joins s (vertex d v) c /\
    at_ c = hd (place w) l /\ (c = vertex d w \/ exists i p, c = (Bend e i, p)).
Proof.
  intros I L.
  assert (B : (length (bends f) <= 2)%nat).
  { apply in_numbered in I as [j [_ I]]. apply nth_error_In in I. now apply (two_bends _ _ D). }
  assert (S : forall s, In s (steps (polyline d e f)) -> In s (segments d)).
  { intros s S. apply in_flat_map. now exists (e, f). }
  assert (ON : forall a b, In (a, b) (segments d) -> exists t f, step t f (at_ a) (at_ b)) by (intros; now apply (diagonal _ _ D (a, b))).
  assert (OFF : forall a b, In (a, b) (segments d) -> exists t f, step t f (at_ b) (at_ a)).
  { intros a b H. apply ON in H as [t [h H]]. exists t, (minus h). now apply step_back. }
  assert (TURN : forall a b c, In (a, b) (segments d) -> In (b, c) (segments d) -> (a, b) <> (b, c) ->
    cosine cube (at_ b) (at_ a) (at_ c) <= -1/2 /\ cosine cube (at_ b) (at_ c) (at_ a) <= -1/2).
  { intros a b c H H' N. split; [apply (wide_angles _ _ D (a, b) (b, c))|apply (wide_angles _ _ D (b, c) (a, b))]; unfold joins; auto. }
  unfold polyline, steps in S.
  destruct (bends f) as [|p [|q [|? ?]]] eqn:E; cbn in B, S; [| | |lia].
  - pose proof (S _ (or_introl eq_refl)) as S1.
    destruct L as [[<- [<- ->]]|[<- [<- ->]]]; rewrite E; unfold place; cbn [map rev app good_way hd].
    + split; [auto|]. exists (vertex d (tail f), vertex d (head f)), (vertex d (head f)). unfold joins. auto.
    + split; [auto|]. exists (vertex d (tail f), vertex d (head f)), (vertex d (tail f)). unfold joins. auto.
  - pose proof (S _ (or_introl eq_refl)) as S1. pose proof (S _ (or_intror (or_introl eq_refl))) as S2.
    destruct (TURN _ _ _ S1 S2) as [C C']; [discriminate|].
    destruct L as [[<- [<- ->]]|[<- [<- ->]]]; rewrite E; unfold place; cbn [map rev app good_way hd].
    + split; [exact (conj (ON _ _ S1) (conj C (conj (ON _ _ S2) (conj Logic.I Logic.I))))|].
      exists (vertex d (tail f), (Bend e 0, p)), (Bend e 0, p). unfold joins. repeat split; eauto.
    + split; [exact (conj (OFF _ _ S2) (conj C' (conj (OFF _ _ S1) (conj Logic.I Logic.I))))|].
      exists ((Bend e 0, p), vertex d (head f)), (Bend e 0, p). unfold joins. repeat split; eauto.
  - pose proof (S _ (or_introl eq_refl)) as S1. pose proof (S _ (or_intror (or_introl eq_refl))) as S2.
    pose proof (S _ (or_intror (or_intror (or_introl eq_refl)))) as S3.
    destruct (TURN _ _ _ S1 S2) as [C C']; [discriminate|]. destruct (TURN _ _ _ S2 S3) as [K K']; [discriminate|].
    destruct L as [[<- [<- ->]]|[<- [<- ->]]]; rewrite E; unfold place; cbn [map rev app good_way hd].
    + split; [exact (conj (ON _ _ S1) (conj C (conj (ON _ _ S2) (conj K (conj (ON _ _ S3) (conj Logic.I Logic.I))))))|].
      exists (vertex d (tail f), (Bend e 0, p)), (Bend e 0, p). unfold joins. repeat split; eauto.
    + split; [exact (conj (OFF _ _ S3) (conj K' (conj (OFF _ _ S2) (conj C' (conj (OFF _ _ S1) (conj Logic.I Logic.I))))))|].
      exists ((Bend e 1, q), vertex d (head f)), (Bend e 1, q). unfold joins. repeat split; eauto.
Qed.

Lemma edge_between v w : adjacent g v w -> exists e f l, In (e, f) (numbered 0 (edges d)) /\ leads f v w l /\
  turned (ends f) = turned (v, w).
Proof.
  intros A. apply (Permutation_in _ (Permutation_sym (its_edges _ _ D))) in A. rewrite map_map in A.
  apply in_map_iff in A as [f [E A]]. destruct (has_number _ _ A 0%N) as [e I].
  assert (W : tail f = v /\ head f = w \/ head f = v /\ tail f = w).
  { unfold turned, ends in E; cbn [fst snd] in E. injection E. lia. }
  unfold leads. destruct W as [[T H]|[H T]]; exists e, f.
  - exists (map real (bends f)). repeat split; [exact I|left; auto|exact E].
  - exists (rev (map real (bends f))). repeat split; [exact I|right; auto|exact E].
Qed.

Definition way (v w : N) (l : list vec) : Prop := exists e f, In (e, f) (numbered 0 (edges d)) /\ leads f v w l.

(** The edges to two neighbours leave a vertex at 120 degrees or more. *)
Lemma leave_apart v a b : adjacent g v a -> adjacent g v b -> a <> b -> forall e f l e' f' l',
  In (e, f) (numbered 0 (edges d)) -> leads f v a l -> turned (ends f) = turned (v, a) ->
  In (e', f') (numbered 0 (edges d)) -> leads f' v b l' -> turned (ends f') = turned (v, b) ->
  cosine cube (place v) (hd (place a) l) (hd (place b) l') <= -1/2.
Proof.
  intros A B N e f l e' f' l' I L E I' L' E'.
  destruct (leads_well _ _ _ _ _ I L) as [_ [s [c [S [J [<- C]]]]]].
  destruct (leads_well _ _ _ _ _ I' L') as [_ [t [c' [T [J' [<- C']]]]]].
  apply (wide_angles _ _ D s t); try assumption. intros <-. assert (H := joins_one _ _ _ _ J J'). subst c'.
  destruct C as [->|[i [p ->]]], C' as [C'|[i' [p' C']]]; try discriminate.
  - injection C' as C' _. contradiction.
  - injection C' as C' _ _. subst e'. rewrite (one_number _ _ _ _ I I'), E' in E.
    unfold turned in E; cbn [fst snd] in E. injection E. lia.
Qed.

Theorem served s : (0 < order g)%N -> three_neighbours g -> In s axes -> exists f, In f (edges d) /\ edge_serves d s f.
Proof.
  intros P CUBIC S. destruct (in_space (order g) place way P) with (s := s) as [v [w [p [q [[e [f [I L]]] H]]]]]; [| |exact S|].
  - intros v w l [e [f [I L]]]. split; [|split; [|eapply leads_well; eauto]].
    + apply (in_graph _ _ D v). eapply Permutation_in; [apply (its_edges _ _ D)|]. rewrite map_map.
      apply in_map_iff. exists f. apply in_numbered in I as [j [_ I]]. apply nth_error_In in I. split; [|exact I].
      unfold leads in L. unfold turned, ends; cbn [fst snd]. destruct L as [[-> [-> _]]|[-> [-> _]]]; [reflexivity|f_equal; lia].
    + apply in_numbered in I as [j [_ I]]. apply nth_error_In in I. pose proof (two_bends _ _ D f I).
      destruct L as [[_ [_ ->]]|[_ [_ ->]]]; rewrite ?rev_length, map_length; assumption.
  - intros v V. destruct (CUBIC v V) as [a [b [c [AB [AC [BC [A [B C]]]]]]]].
    destruct (edge_between _ _ A) as [e1 [f1 [l1 [I1 [L1 E1]]]]], (edge_between _ _ B) as [e2 [f2 [l2 [I2 [L2 E2]]]]],
      (edge_between _ _ C) as [e3 [f3 [l3 [I3 [L3 E3]]]]].
    exists a, b, c, l1, l2, l3. unfold way. repeat split; eauto.
    + exact (leave_apart v a b A B AB _ _ _ _ _ _ I1 L1 E1 I2 L2 E2).
    + exact (leave_apart v a c A C AC _ _ _ _ _ _ I1 L1 E1 I3 L3 E3).
    + exact (leave_apart v b c B C BC _ _ _ _ _ _ I2 L2 E2 I3 L3 E3).
  - apply in_numbered in I as [j [_ I]]. apply nth_error_In in I. pose proof (two_bends _ _ D f I) as B.
    exists f. split; [exact I|].
    destruct L as [[T [E L]]|[E [T L]]]; destruct (bends f) as [|p' [|q' [|? ?]]] eqn:Q; cbn in L, B; try discriminate; try lia;
      injection L as -> ->; exists p', q'; subst; (split; [exact Q|]).
    + exact H.
    + unfold serves, place in *. lra.
Qed.

Theorem serves_one_axis s t f : In s axes -> In t axes -> In f (edges d) -> edge_serves d s f -> edge_serves d t f -> s = t.
Proof.
  intros S T F [p [q [B H]]] [p' [q' [B' H']]]. rewrite B in B'. injection B' as <- <-.
  destruct (has_number _ _ F 0%N) as [e I].
  apply (serves_one s t (place (tail f)) (real p) (real q) (place (head f))); try assumption.
  apply (leads_well e f (tail f) (head f) [real p; real q]); [exact I|]. left. now rewrite B.
Qed.

End Drawn.

Lemma chosen {A B} (R : A -> B -> Prop) (all : list B) : forall l, NoDup l -> (forall a, In a l -> exists b, In b all /\ R a b) ->
  (forall a a' b, In a l -> In a' l -> In b all -> R a b -> R a' b -> a = a') ->
  exists m, NoDup m /\ incl m all /\ Forall2 R l m.
Proof.
  induction l as [|a l IH]; intros N E U.
  - exists []. repeat split; [constructor|easy|constructor].
  - inversion N as [|? ? A' N']; subst. destruct IH as [m [M [I F]]]; [exact N'|intros; apply E; now right| |].
    { intros a1 a2 b H1 H2. apply U; now right. }
    destruct (E a (or_introl eq_refl)) as [b [Ib Rb]]. exists (b :: m). repeat split; [|now apply incl_cons|now constructor].
    constructor; [|exact M]. intros H. apply A'.
    assert (X : exists a', In a' l /\ R a' b).
    { clear - F H. induction F as [|a' b' l m Rab F IH]; [easy|]. destruct H as [->|H]; [exists a'; auto with datatypes|].
      destruct (IH H) as [c [C C']]. exists c. auto with datatypes. }
    destruct X as [a' [Ia Ra]]. rewrite (U a a' b); auto with datatypes.
Qed.

(** The promise of angles of at least 120 degrees along face diagonals. *)
Record Diagonal (k : promise) : Prop := {
  grid : lengths k = cube;
  along_faces : directions k <> [] /\ incl (directions k) faces;
  angles_120 : (q k <= 2 * minus_p k)%Z }.

Lemma no_way a b x y z : towards a b = Vec (0 * x) (0 * y) (0 * z) -> a = b.
Proof. destruct a as [ax ay az], b as [bx by_ bz]. unfold towards; cbn [vx vy vz]. intros E. injection E as X Y Z. f_equal; lra. Qed.

Lemma good_on_faces d g k : Diagonal k -> (most_bends k <= 2)%N -> Good d g k -> On_faces d g.
Proof.
  intros K B H. constructor.
  - intros v w A. apply in_map_iff in A as [[a b] [E A]]. apply (edges_exist _ _ _ H) in A.
    unfold turned in E; cbn [fst snd] in E. injection E. lia.
  - apply (all_edges _ _ _ H).
  - intros f F. pose proof (few_bends _ _ _ H f F). lia.
  - intros s S. destruct (in_directions _ _ _ H s (proj1 (along_faces _ K)) S) as [a [A [t E]]].
    apply (proj2 (along_faces _ K)) in A. destruct (Rtotal_order t 0) as [T|[->|T]].
    + exists (- t), (minus a). split; [lra|]. split; [now apply minus_face|]. rewrite E. unfold minus; cbn [px py pz].
      rewrite !opp_IZR. f_equal; ring.
    + exfalso. exact (no_zero_length _ _ _ H s S (no_way _ _ _ _ _ E)).
    + now exists t, a.
  - intros s t a b c S T N J J'. pose proof (angles _ _ _ H s t a b c S T N J J') as C. rewrite (grid _ K) in C.
    destruct (cosine_means _ _ _ H) as [Q _]. pose proof (angles_120 _ K) as M.
    apply IZR_lt in Q. apply IZR_le in M. rewrite mult_IZR in M.
    assert (HALF : - IZR (minus_p k) / IZR (q k) <= -1/2).
    { apply (Rmult_le_reg_r (2 * IZR (q k))); [lra|].
      replace (- IZR (minus_p k) / IZR (q k) * (2 * IZR (q k))) with (- (2 * IZR (minus_p k))) by (field; lra). lra. }
    unfold angle_kept in C. destruct (equal k); lra.
Qed.

Theorem six_edges_have_two d g k : (0 < order g)%N -> three_neighbours g -> Diagonal k -> (most_bends k <= 2)%N -> Good d g k ->
  exists six, NoDup six /\ incl six (edges d) /\ Forall2 (edge_serves d) axes six /\ length six = 6%nat /\
    forall f, In f six -> length (bends f) = 2%nat.
Proof.
  intros P CUBIC K B H. apply good_on_faces in H as F; [|assumption..].
  destruct (chosen (edge_serves d) (edges d) axes) as [six [N [I E]]].
  - unfold axes. repeat constructor; cbn; intuition discriminate.
  - intros s S. now apply (served d g F).
  - intros s t f. apply (serves_one_axis d g F).
  - exists six. repeat split; try assumption; [clear - E; change 6%nat with (length axes); induction E; cbn; congruence|].
    intros f. clear - E. induction E as [|s f' l m [p [q [E' _]]] E IH]; [easy|]. intros [<-|M]; [now rewrite E'|auto].
Qed.

Theorem faces_need_two_bends d g k : (0 < order g)%N -> three_neighbours g -> Diagonal k -> (most_bends k <= 1)%N -> ~ Good d g k.
Proof.
  intros P CUBIC K B H. destruct (six_edges_have_two d g k P CUBIC K ltac:(lia) H) as [six [_ [I [_ [L T]]]]].
  destruct six as [|f six]; [discriminate|]. pose proof (T f (or_introl eq_refl)) as T'.
  pose proof (few_bends _ _ _ H f (I f (or_introl eq_refl))). lia.
Qed.
