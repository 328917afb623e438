(** The geometry behind the checker: what its integer tests say of real numbers. *)
From Coq Require Import ZArith NArith List Bool Reals Lra Psatz.
From Drawing Require Import Spec Checker.
Local Open Scope R_scope.

(** Splits every boolean test in the context into its parts. *)
Ltac split_tests :=
  repeat match goal with
  | H : _ && _ = true |- _ => apply andb_prop in H; destruct H
  | H : (_ <? _)%Z = true |- _ => apply Z.ltb_lt in H
  | H : (_ <=? _)%Z = true |- _ => apply Z.leb_le in H
  | H : (_ =? _)%Z = true |- _ => apply Z.eqb_eq in H
  | H : N.eqb _ _ = true |- _ => apply N.eqb_eq in H
  | H : N.ltb _ _ = true |- _ => apply N.ltb_lt in H
  | H : N.leb _ _ = true |- _ => apply N.leb_le in H
  | H : negb _ = true |- _ => apply negb_true_iff in H
  end.

(** ** Separation *)

Definition rdot (h : point) (x : vec) : R :=
  IZR (px h) * vx x + IZR (py h) * vy x + IZR (pz h) * vz x.

Lemma rdot_real h p : rdot h (real p) = IZR (dot h p).
Proof. unfold rdot, dot, real; cbn. rewrite !plus_IZR, !mult_IZR. reflexivity. Qed.

Lemma between_rdot h a b x : between a b x ->
  exists t, 0 <= t <= 1 /\ rdot h x = rdot h a + t * (rdot h b - rdot h a).
Proof.
  intros [t [T ->]]. exists t. split; [exact T|]. unfold rdot; cbn. ring.
Qed.

Lemma convex_below t a b m : 0 <= t <= 1 -> a < m -> b < m -> a + t * (b - a) < m.
Proof. intros. destruct (Rlt_le_dec a b); nra. Qed.

Lemma convex_above t a b m : 0 <= t <= 1 -> m < a -> m < b -> m < a + t * (b - a).
Proof. intros. destruct (Rlt_le_dec a b); nra. Qed.

Lemma apart_cases a b c d : apart a b c d = true ->
  (a < c /\ a < d /\ b < c /\ b < d \/ c < a /\ d < a /\ c < b /\ d < b)%Z.
Proof.
  unfold apart. destruct (a <? c)%Z eqn:E; intros H; split_tests; lia.
Qed.

Lemma separates_sound h a b c d x : separates h a b c d = true ->
  between (real a) (real b) x -> between (real c) (real d) x -> False.
Proof.
  intros H X Y. apply apart_cases in H.
  apply (between_rdot h) in X as [t [T X]]. apply (between_rdot h) in Y as [s [S Y]].
  rewrite !rdot_real in X, Y.
  assert (L : forall i j, (i < j)%Z -> IZR i < IZR j) by (intros; now apply IZR_lt).
  destruct H as [[A [B [C D]]]|[A [B [C D]]]];
    apply L in A; apply L in B; apply L in C; apply L in D.
  - assert (rdot h x < rdot h x); [|lra].
    rewrite X at 1. rewrite Y. apply convex_below; [easy| |]; apply convex_above; easy.
  - assert (rdot h x < rdot h x); [|lra].
    rewrite Y at 1. rewrite X. apply convex_below; [easy| |]; apply convex_above; easy.
Qed.

Lemma axis_x a b c d : apart (px a) (px b) (px c) (px d) = separates (Point 1 0 0) a b c d.
Proof. unfold separates, dot. f_equal; cbn [px py pz]; ring. Qed.
Lemma axis_y a b c d : apart (py a) (py b) (py c) (py d) = separates (Point 0 1 0) a b c d.
Proof. unfold separates, dot. f_equal; cbn [px py pz]; ring. Qed.
Lemma axis_z a b c d : apart (pz a) (pz b) (pz c) (pz d) = separates (Point 0 0 1) a b c d.
Proof. unfold separates, dot. f_equal; cbn [px py pz]; ring. Qed.

Lemma boxes_apart_sound a b c d x : boxes_apart a b c d = true ->
  between (real a) (real b) x -> between (real c) (real d) x -> False.
Proof.
  unfold boxes_apart. rewrite axis_x, axis_y, axis_z. intros H.
  intros X Y. apply orb_prop in H as [H|H]; [apply orb_prop in H as [H|H]|];
    exact (separates_sound _ _ _ _ _ x H X Y).
Qed.

Theorem disjoint_sound a b c d x : disjoint a b c d = true ->
  between (real a) (real b) x -> between (real c) (real d) x -> False.
Proof.
  unfold disjoint. cbv zeta. intros H X Y.
  repeat match goal with K : _ || _ = true |- _ => apply orb_prop in K as [H|H] end;
    first [ exact (boxes_apart_sound _ _ _ _ x H X Y)
          | exact (separates_sound _ _ _ _ _ x H X Y) ].
Qed.

(** ** Pieces of segments *)

(** The point x of the piece, at the part t of its segment. *)
Definition at_part (s : piece) (t : R) (x : vec) : Prop :=
  let a := at_ (fst (whole s)) in let b := at_ (snd (whole s)) in
  0 <= t <= 1 /\ IZR (from s) <= t * IZR parts <= IZR (till s) /\
  x = Vec (vx a + t * (vx b - vx a)) (vy a + t * (vy b - vy a)) (vz a + t * (vz b - vz a)).
Definition holds (s : piece) (x : vec) : Prop := exists t, at_part s t x.

Lemma parts_positive : 0 < IZR parts.
Proof. apply IZR_lt. reflexivity. Qed.

Lemma whole_holds s x : on s x -> holds (Piece s 0 parts) x.
Proof.
  intros [t [T X]]. exists t. split; [exact T|]. split; [|exact X]. cbn [from till].
  pose proof parts_positive. nra.
Qed.

Lemma at_part_rdot h s t x : at_part s t x ->
  let a := dot h (snd (fst (whole s))) in let b := dot h (snd (snd (whole s))) in
  rdot h x = IZR a + t * (IZR b - IZR a).
Proof.
  intros [_ [_ ->]]. cbv zeta. rewrite <- !rdot_real. unfold at_, rdot; cbn [vx vy vz]. ring.
Qed.

(** A piece with less on one side of m still has what is on the other. *)
Lemma before_holds m s t x l : at_part s t x -> t * IZR parts <= IZR m ->
  exists u, before m s l = u :: l /\ whole u = whole s /\ holds u x.
Proof.
  intros [T [[F L] X]] M. unfold before. destruct (Z.leb_spec (from s) m) as [K|K].
  - eexists. split; [reflexivity|]. split; [reflexivity|]. exists t. split; [exact T|]. split; [|exact X].
    cbn [from till]. split; [exact F|]. now destruct (Z.min_spec m (till s)) as [[_ ->]|[_ ->]].
  - apply IZR_lt in K. lra.
Qed.
Lemma behind_holds m s t x l : at_part s t x -> IZR m <= t * IZR parts ->
  exists u, behind m s l = u :: l /\ whole u = whole s /\ holds u x.
Proof.
  intros [T [[F L] X]] M. unfold behind. destruct (Z.leb_spec m (till s)) as [K|K].
  - eexists. split; [reflexivity|]. split; [reflexivity|]. exists t. split; [exact T|]. split; [|exact X].
    cbn [from till]. split; [|exact L]. now destruct (Z.max_spec m (from s)) as [[_ ->]|[_ ->]].
  - apply IZR_lt in K. lra.
Qed.

(** Where a segment passes a plane: it rises by o, and by n parts until it is there. *)
Lemma passes n o m t : (0 < o)%Z -> (0 <= n * parts - m * o <= o)%Z ->
  (t * IZR o <= IZR n -> t * IZR parts <= IZR (m + 1)) /\ (IZR n <= t * IZR o -> IZR m <= t * IZR parts).
Proof.
  intros O [E E']. apply IZR_lt in O. apply IZR_le in E, E'. rewrite minus_IZR, !mult_IZR in *.
  rewrite plus_IZR. pose proof parts_positive as P. split; intros H.
  - apply (Rmult_le_reg_r (IZR o)); [exact O|]. apply (Rmult_le_compat_r (IZR parts)) in H; lra.
  - apply (Rmult_le_reg_r (IZR o)); [exact O|]. apply (Rmult_le_compat_r (IZR parts)) in H; lra.
Qed.

(** A step of [divide]: what is added is of the same segment, and has every point on its side. *)
Definition adds (s : piece) (l l' : list piece) : Prop :=
  l' = l \/ exists u, l' = u :: l /\ whole u = whole s.
Definition keeps (s : piece) (l l' : list piece) (x : vec) : Prop :=
  exists u, l' = u :: l /\ whole u = whole s /\ holds u x.

Lemma before_adds m s l : adds s l (before m s l).
Proof. unfold before, adds. destruct (from s <=? m)%Z; [right; eauto|now left]. Qed.
Lemma behind_adds m s l : adds s l (behind m s l).
Proof. unfold behind, adds. destruct (m <=? till s)%Z; [right; eauto|now left]. Qed.
Lemma self_adds s l : adds s l (s :: l).
Proof. right; eauto. Qed.

Lemma divide_step ratio h c s r low high : exists low' high',
  divide ratio h c (s :: r) low high = divide ratio h c r low' high' /\
  adds s low low' /\ adds s high high' /\
  forall x, holds s x ->
    (rdot h x <= IZR c -> keeps s low low' x) /\ (IZR c <= rdot h x -> keeps s high high' x).
Proof.
  cbn [divide]. cbv zeta.
  set (x := (dot h (snd (fst (whole s))) - c)%Z). set (y := (dot h (snd (snd (whole s))) - c)%Z).
  assert (AT : forall p t, at_part s t p -> 0 <= t <= 1 /\ rdot h p = IZR c + (IZR x + t * (IZR y - IZR x))).
  { intros p t T. split; [apply T|]. rewrite (at_part_rdot h s t p T). unfold x, y. rewrite !minus_IZR. ring. }
  assert (SELF : forall p l, holds s p -> keeps s l (s :: l) p) by (intros p l H; exists s; auto).
  destruct ((x <? 0) && (y <? 0))%Z eqn:B; [|clear B; destruct ((0 <? x) && (0 <? y))%Z eqn:B].
  - exists (s :: low), high. split; [reflexivity|]. split; [apply self_adds|]. split; [now left|].
    intros p H. split; [auto|]. intros L. exfalso. destruct H as [t T]. apply AT in T as [T E]. split_tests.
    apply IZR_lt in H, H0. pose proof (convex_below t _ _ _ T H H0). lra.
  - exists low, (s :: high). split; [reflexivity|]. split; [now left|]. split; [apply self_adds|].
    intros p H. split; [|auto]. intros L. exfalso. destruct H as [t T]. apply AT in T as [T E]. split_tests.
    apply IZR_lt in H, H0. pose proof (convex_above t _ _ _ T H H0). lra.
  - clear B. destruct (x <? y)%Z;
      match goal with |- context [(_ - ?m * _)%Z] => set (k := m) end;
      match goal with |- context [if ?b then _ else _] => destruct b eqn:B end.
    2, 4: exists (s :: low), (s :: high); split; [reflexivity|]; split; [apply self_adds|]; split; [apply self_adds|]; auto.
    + eexists _, _. split; [reflexivity|]. split; [apply before_adds|]. split; [apply behind_adds|].
      intros p [t T]. pose proof (AT _ _ T) as [T' E]. split_tests.
      destruct (passes (0 - x) (y - x) k t) as [P P']; [assumption|easy|]. rewrite !minus_IZR in P, P'.
      split; intros L; [apply (before_holds _ _ t _ _ T)|apply (behind_holds _ _ t _ _ T)]; [apply P|apply P']; lra.
    + eexists _, _. split; [reflexivity|]. split; [apply behind_adds|]. split; [apply before_adds|].
      intros p [t T]. pose proof (AT _ _ T) as [T' E]. split_tests.
      destruct (passes x (x - y) k t) as [P P']; [assumption|easy|]. rewrite !minus_IZR in P, P'.
      split; intros L; [apply (behind_holds _ _ t _ _ T)|apply (before_holds _ _ t _ _ T)]; [apply P'|apply P]; lra.
Qed.

(** ** The box of a piece *)

Lemma in_range a b f l t : 0 <= t <= 1 -> IZR f <= t * IZR parts <= IZR l ->
  let u := (a * parts + f * (b - a))%Z in let v := (a * parts + l * (b - a))%Z in
  IZR (Z.min u v) <= (IZR a + t * (IZR b - IZR a)) * IZR parts <= IZR (Z.max u v).
Proof.
  intros T L u v. set (w := (IZR a + t * (IZR b - IZR a)) * IZR parts).
  assert (U : IZR u = IZR a * IZR parts + IZR f * (IZR b - IZR a))
    by (unfold u; rewrite plus_IZR, !mult_IZR, minus_IZR; ring).
  assert (V : IZR v = IZR a * IZR parts + IZR l * (IZR b - IZR a))
    by (unfold v; rewrite plus_IZR, !mult_IZR, minus_IZR; ring).
  assert (W : w = IZR a * IZR parts + t * IZR parts * (IZR b - IZR a)) by (unfold w; ring).
  assert (IZR u <= w <= IZR v \/ IZR v <= w <= IZR u) as C by (rewrite U, V, W; destruct (Rle_dec (IZR a) (IZR b)); [left|right]; nra).
  pose proof (IZR_le _ _ (Z.le_min_l u v)). pose proof (IZR_le _ _ (Z.le_min_r u v)).
  pose proof (IZR_le _ _ (Z.le_max_l u v)). pose proof (IZR_le _ _ (Z.le_max_r u v)). lra.
Qed.

Lemma far_sound s t x : far (box_of s) (box_of t) = true -> holds s x -> holds t x -> False.
Proof.
  intros H [a [A [L ->]]] [b [B [M E]]]. injection E as EX EY EZ.
  pose proof (fun c d => in_range c d _ _ _ A L) as RS. pose proof (fun c d => in_range c d _ _ _ B M) as RT.
  assert (NO : forall i j r, IZR i <= r -> r <= IZR j -> (j <? i)%Z = true -> False).
  { intros i j r I J K. apply Z.ltb_lt, IZR_lt in K. lra. }
  unfold far, box_of in H; cbn [x0 x1 y0 y1 z0 z1] in H. unfold at_, real in EX, EY, EZ; cbn [vx vy vz] in *.
  repeat match goal with K : _ || _ = true |- _ => apply orb_prop in K as [H|H] end;
    (eapply NO; [| |exact H]); clear H NO.
  1, 5, 9: exact (proj1 (RT _ _)).
  2, 5, 8: exact (proj1 (RS _ _)).
  all: rewrite ?EX, ?EY, ?EZ; first [exact (proj2 (RT _ _))|rewrite <- ?EX, <- ?EY, <- ?EZ; exact (proj2 (RS _ _))].
Qed.

(** ** The metric *)

Lemma vec_eq u v : vx u = vx v -> vy u = vy v -> vz u = vz v -> u = v.
Proof. destruct u, v; cbn; now intros -> -> ->. Qed.

Lemma towards_real a b : towards (real a) (real b) = real (diff a b).
Proof. unfold towards, real, diff; cbn. now rewrite !minus_IZR. Qed.

Lemma inner_real G u v : inner G (real u) (real v) = IZR (zinner G u v).
Proof. unfold inner, zinner, real; cbn. now rewrite !plus_IZR, !mult_IZR, !plus_IZR, !mult_IZR. Qed.

Lemma metric_sound G : metric_ok G = true -> positive_definite G.
Proof.
  unfold metric_ok, positive_definite. intros H u U. split_tests.
  destruct G as [a b c d e f]; cbn [xx yy zz xy xz yz] in *.
  apply IZR_lt in H, H0, H1. rewrite !minus_IZR, !mult_IZR, !minus_IZR, !mult_IZR in *.
  unfold inner; cbn [xx yy zz xy xz yz].
  destruct u as [x y z]; cbn [vx vy vz].
  set (A := IZR a) in *; set (B := IZR b) in *; set (C := IZR c) in *.
  set (D := IZR d) in *; set (E := IZR e) in *; set (F := IZR f) in *.
  set (m := A * B - D * D) in *. set (l := A * C - E * E) in *. set (o := A * F - D * E) in *.
  set (I := _ + _ + _ + _ + _ + _).
  (* completing the square, twice *)
  assert (Q : A * m * I =
    m * ((A * x + D * y + E * z) * (A * x + D * y + E * z))
    + (m * y + o * z) * (m * y + o * z) + (m * l - o * o) * (z * z)).
  { subst I m l o. ring. }
  assert (P : 0 < A * m) by now apply Rmult_lt_0_compat.
  assert (S : forall r, 0 <= r * r) by (intros; apply Rle_0_sqr).
  assert (N : 0 <= m * ((A * x + D * y + E * z) * (A * x + D * y + E * z)))
    by (apply Rmult_le_pos; [lra|apply S]).
  assert (N' : 0 <= (m * l - o * o) * (z * z)) by (apply Rmult_le_pos; [lra|apply S]).
  pose proof (S (m * y + o * z)) as N''.
  destruct (Rlt_le_dec 0 I) as [|L]; [assumption|]. exfalso. apply U.
  assert (Z0 : A * m * I <= 0) by nra.
  assert (SQ : forall r, r <> 0 -> 0 < r * r) by (intros; now apply Rsqr_pos_lt).
  assert (NE : forall r r', 0 < r -> r' <> 0 -> r * r' <> 0)
    by (intros; apply Rmult_integral_contrapositive_currified; lra).
  destruct (Req_dec z 0) as [->|K].
  2:{ pose proof (Rmult_lt_0_compat _ _ H0 (SQ _ K)). lra. }
  destruct (Req_dec y 0) as [->|K].
  2:{ pose proof (SQ _ (NE _ _ H1 K)). nra. }
  destruct (Req_dec x 0) as [->|K]; [reflexivity|].
  pose proof (Rmult_lt_0_compat _ _ H1 (SQ _ (NE _ _ H K))). nra.
Qed.

(** The three vectors that show the minors to be positive. *)
Lemma metric_complete G : positive_definite G -> metric_ok G = true.
Proof.
  intros PD. unfold metric_ok. cbv zeta.
  assert (T : forall p, p <> Point 0 0 0 -> (0 < zinner G p p)%Z).
  { intros p P. apply lt_IZR. rewrite <- inner_real. apply PD. intros E. apply P.
    destruct p as [x y z]. unfold real in E; cbn [px py pz] in E. injection E as X Y Z.
    apply eq_IZR in X, Y, Z. now subst. }
  destruct G as [a b c d e f]. cbn [xx yy zz xy xz yz] in *.
  assert (A : (0 < a)%Z).
  { specialize (T (Point 1 0 0)). unfold zinner in T; cbn [xx yy zz xy xz yz px py pz] in T.
    assert (a = a * (1 * 1))%Z by ring. assert (Point 1 0 0 <> Point 0 0 0) by discriminate.
    specialize (T H0). lia. }
  assert (M : (0 < a * b - d * d)%Z).
  { specialize (T (Point (- d) a 0)). unfold zinner in T; cbn [xx yy zz xy xz yz px py pz] in T.
    assert (N : Point (- d) a 0 <> Point 0 0 0) by (intros [= _ E]; lia).
    specialize (T N). match type of T with (0 < ?X)%Z => replace X with (a * (a * b - d * d))%Z in T by ring end.
    apply Z.mul_pos_cancel_l in T; assumption. }
  set (m := (a * b - d * d)%Z) in *.
  specialize (T (Point (d * f - b * e) (d * e - a * f) m)).
  unfold zinner in T; cbn [xx yy zz xy xz yz px py pz] in T.
  assert (N : Point (d * f - b * e) (d * e - a * f) m <> Point 0 0 0) by (intros [= _ _ E]; lia).
  specialize (T N).
  match type of T with (0 < ?X)%Z => assert (E : (a * X = m * (m * (a * c - e * e) - (a * f - d * e) * (a * f - d * e)))%Z)
    by (unfold m; ring) end.
  apply (Z.mul_pos_pos a) in T; [|exact A]. rewrite E in T. apply Z.mul_pos_cancel_l in T; [|exact M].
  rewrite !andb_true_iff, !Z.ltb_lt. auto.
Qed.

(** ** Angles *)

Lemma length_positive G : positive_definite G -> forall a b, real a <> real b ->
  0 < IZR (zinner G (diff a b) (diff a b)).
Proof.
  intros PD a b B. rewrite <- inner_real, <- towards_real. apply PD. intros T. apply B.
  unfold towards in T; injection T; intros. apply vec_eq; cbn in *; lra.
Qed.

Lemma angle_sound G k a b c : positive_definite G -> (0 <= minus_p k)%Z -> (0 < q k)%Z ->
  real a <> real b -> real a <> real c -> angle_ok G k a b c = true ->
  angle_kept G k (real a) (real b) (real c).
Proof.
  intros PD P Q B C H. unfold angle_ok in H. apply andb_prop in H as [H E].
  apply Z.leb_le in H. unfold angle_kept, cosine. rewrite !towards_real, !inner_real.
  apply (length_positive G PD) in B, C.
  set (g := zinner G (diff a b) (diff a c)) in *.
  set (U := zinner G (diff a b) (diff a b)) in *.
  set (V := zinner G (diff a c) (diff a c)) in *.
  pose proof (sqrt_lt_R0 _ B) as SB. pose proof (sqrt_lt_R0 _ C) as SC.
  pose proof (sqrt_sqrt _ (Rlt_le _ _ B)) as QB. pose proof (sqrt_sqrt _ (Rlt_le _ _ C)) as QC.
  set (r := sqrt (IZR U)) in *. set (s := sqrt (IZR V)) in *.
  apply IZR_le in H, P. apply IZR_lt in Q.
  set (p := IZR (minus_p k)) in *. set (n := IZR (q k)) in *.
  assert (RS : 0 < r * s) by now apply Rmult_lt_0_compat.
  assert (W : p * (r * s) * (p * (r * s)) = p * p * (IZR U * IZR V)) by (rewrite <- QB, <- QC; ring).
  destruct (equal k).
  - apply Z.eqb_eq in E. apply (f_equal IZR) in E. rewrite !mult_IZR in E. fold p n in E.
    assert (X : - IZR g * n = p * (r * s)).
    { apply Rsqr_inj; [nra|nra|]. unfold Rsqr. rewrite W. nra. }
    apply (Rmult_eq_reg_r (r * s * n)); [|nra]. field_simplify; nra.
  - apply Z.leb_le, IZR_le in E. rewrite !mult_IZR in E. fold p n in E.
    assert (X : p * (r * s) <= - IZR g * n).
    { apply Rsqr_incr_0; [|nra|nra]. unfold Rsqr. rewrite W. nra. }
    apply (Rmult_le_reg_r (r * s * n)); [nra|].
    replace (IZR g / (r * s) * (r * s * n)) with (IZR g * n) by (field; lra).
    replace (- p / n * (r * s * n)) with (- p * (r * s)) by (field; lra). lra.
Qed.

(** ... and back: what keeps the promise passes the test. *)
Lemma angle_complete G k a b c : positive_definite G -> (0 <= minus_p k)%Z -> (0 < q k)%Z ->
  real a <> real b -> real a <> real c ->
  angle_kept G k (real a) (real b) (real c) -> angle_ok G k a b c = true.
Proof.
  intros PD P Q B C H. unfold angle_ok. cbv zeta.
  unfold angle_kept, cosine in H. rewrite !towards_real, !inner_real in H.
  apply (length_positive G PD) in B, C.
  set (g := zinner G (diff a b) (diff a c)) in *.
  set (U := zinner G (diff a b) (diff a b)) in *.
  set (V := zinner G (diff a c) (diff a c)) in *.
  pose proof (sqrt_lt_R0 _ B) as SB. pose proof (sqrt_lt_R0 _ C) as SC.
  pose proof (sqrt_sqrt _ (Rlt_le _ _ B)) as QB. pose proof (sqrt_sqrt _ (Rlt_le _ _ C)) as QC.
  set (r := sqrt (IZR U)) in *. set (s := sqrt (IZR V)) in *.
  apply IZR_le in P. apply IZR_lt in Q.
  assert (RS : 0 < r * s) by now apply Rmult_lt_0_compat.
  assert (RN : 0 < r * s * IZR (q k)) by now apply Rmult_lt_0_compat.
  assert (L : IZR g / (r * s) * (r * s * IZR (q k)) = IZR g * IZR (q k)) by (field; lra).
  assert (R : - IZR (minus_p k) / IZR (q k) * (r * s * IZR (q k)) = - (IZR (minus_p k) * (r * s))) by (field; lra).
  assert (W : IZR (minus_p k) * (r * s) * (IZR (minus_p k) * (r * s))
    = IZR (minus_p k) * IZR (minus_p k) * (IZR U * IZR V)) by (rewrite <- QB, <- QC; ring).
  assert (K : 0 <= IZR (minus_p k) * (r * s)) by nra.
  apply andb_true_intro. destruct (equal k).
  - apply (f_equal (fun x => x * (r * s * IZR (q k)))) in H. rewrite L, R in H. split.
    + apply Z.leb_le, le_IZR. nra.
    + apply Z.eqb_eq, eq_IZR. rewrite !mult_IZR, <- W.
      replace (IZR g * IZR g * (IZR (q k) * IZR (q k)))
        with (IZR g * IZR (q k) * (IZR g * IZR (q k))) by ring. rewrite H. ring.
  - apply (Rmult_le_compat_r (r * s * IZR (q k))) in H; [|lra]. rewrite L, R in H. split.
    + apply Z.leb_le, le_IZR. nra.
    + apply Z.leb_le, le_IZR. rewrite !mult_IZR, <- W.
      replace (IZR g * IZR g * (IZR (q k) * IZR (q k)))
        with (- (IZR g * IZR (q k)) * - (IZR g * IZR (q k))) by ring.
      apply Rmult_le_compat; lra.
Qed.

(** Segments from a at an angle of at least 90 degrees have only a in common. *)
Lemma only_there G k a b c x : positive_definite G -> angle_ok G k a b c = true ->
  between (real a) (real b) x -> between (real a) (real c) x -> x = real a.
Proof.
  intros PD H [t [T X]] [s [S Y]]. unfold angle_ok in H. apply andb_prop in H as [H _].
  apply Z.leb_le, IZR_le in H. rewrite <- inner_real, <- !towards_real in H.
  set (u := towards (real a) (real b)) in *. set (v := towards (real a) (real c)) in *.
  assert (EX : towards (real a) x = Vec (t * vx u) (t * vy u) (t * vz u)).
  { rewrite X. unfold towards; cbn. f_equal; ring. }
  assert (EY : towards (real a) x = Vec (s * vx v) (s * vy v) (s * vz v)).
  { rewrite Y. unfold towards; cbn. f_equal; ring. }
  set (w := towards (real a) x) in *.
  assert (W : inner G w w = t * s * inner G u v).
  { rewrite EX at 1. rewrite EY. unfold inner; cbn [vx vy vz]. ring. }
  assert (TS : 0 <= t * s) by nra.
  assert (inner G w w <= 0) by (rewrite W; nra).
  assert (Z0 : w = Vec 0 0 0).
  { destruct (Req_dec (vx w) 0) as [E1|E1]; [destruct (Req_dec (vy w) 0) as [E2|E2];
      [destruct (Req_dec (vz w) 0) as [E3|E3]; [now apply vec_eq|]|]|];
      exfalso; (assert (NW : w <> Vec 0 0 0) by (intros K; rewrite K in *; cbn in *; lra));
      apply PD in NW; lra. }
  unfold w, towards in Z0. injection Z0. intros. apply vec_eq; cbn in *; lra.
Qed.

(** ** Directions *)

Lemma same_point_iff a b : same_point a b = true <-> a = b.
Proof.
  unfold same_point. destruct a as [x y z], b as [x' y' z']; cbn. split; intros H.
  - split_tests. now subst.
  - injection H as -> -> ->. now rewrite !Z.eqb_refl.
Qed.

Lemma real_inj a b : real a = real b -> a = b.
Proof. destruct a, b. intros [= X Y Z]. apply eq_IZR in X, Y, Z. now subst. Qed.

Lemma quotient x y a b : a <> 0 -> b * y = a * x -> x = y / a * b.
Proof. intros A E. replace (y / a * b) with (b * y / a) by (field; exact A). rewrite E. field. exact A. Qed.

Lemma along_sound a b c : along_ok a (diff b c) = true -> along a (towards (real b) (real c)).
Proof.
  unfold along_ok. intros H. apply andb_prop in H as [H C]. apply same_point_iff in C.
  assert (A : a <> zero) by (intros ->; discriminate H).
  rewrite towards_real. generalize dependent (diff b c). intros u C.
  injection C as C1 C2 C3.
  assert (D1 : IZR (py a) * IZR (pz u) = IZR (pz a) * IZR (py u)) by (rewrite <- !mult_IZR; f_equal; lia).
  assert (D2 : IZR (pz a) * IZR (px u) = IZR (px a) * IZR (pz u)) by (rewrite <- !mult_IZR; f_equal; lia).
  assert (D3 : IZR (px a) * IZR (py u) = IZR (py a) * IZR (px u)) by (rewrite <- !mult_IZR; f_equal; lia).
  unfold along, real.
  destruct (Z.eq_dec (px a) 0) as [X|X]; [destruct (Z.eq_dec (py a) 0) as [Y|Y];
    [destruct (Z.eq_dec (pz a) 0) as [Z|Z]|]|].
  - destruct a; cbn in *; subst; contradiction.
  - apply not_0_IZR in Z. exists (IZR (pz u) / IZR (pz a)). apply vec_eq; cbn; apply quotient; try exact Z; lra.
  - apply not_0_IZR in Y. exists (IZR (py u) / IZR (py a)). apply vec_eq; cbn; apply quotient; try exact Y; lra.
  - apply not_0_IZR in X. exists (IZR (px u) / IZR (px a)). apply vec_eq; cbn; apply quotient; try exact X; lra.
Qed.

Lemma along_complete a b c : real b <> real c -> along a (towards (real b) (real c)) ->
  along_ok a (diff b c) = true.
Proof.
  rewrite towards_real. intros N [t E]. unfold along_ok. apply andb_true_intro. split.
  - apply negb_true_iff, not_true_iff_false. intros H. apply same_point_iff in H. subst a.
    unfold real, zero, diff in E; cbn [px py pz] in E. injection E as X Y Z.
    rewrite minus_IZR in X, Y, Z. apply N. unfold real. f_equal; lra.
  - apply same_point_iff. clear N. destruct (diff b c) as [x y z]. unfold real in E. injection E as X Y Z.
    unfold cross, zero; cbn [px py pz]. f_equal; apply eq_IZR; rewrite minus_IZR, !mult_IZR, ?X, ?Y, ?Z; ring.
Qed.

(** ** Lengths that grow with n *)

Lemma power n h : let s := sqrt (IZR (Z.of_N n)) ^ N.to_nat h in 0 <= s /\ s * s = IZR (Z.of_N n ^ Z.of_N h).
Proof.
  assert (N0 : 0 <= IZR (Z.of_N n)) by (apply IZR_le; lia). split.
  - apply pow_le, sqrt_pos.
  - rewrite <- Rpow_mult_distr, sqrt_sqrt by exact N0. rewrite pow_IZR. now rewrite N_nat_Z.
Qed.

Lemma at_most_iff b n e : sane_bound b -> at_most_ok b n e = true <-> at_most b n e.
Proof.
  unfold at_most_ok, at_most, sane_bound. intros [D N]. cbv zeta.
  apply IZR_lt in D. apply IZR_le in N. destruct (power n (half b)) as [S0 SS].
  set (s := sqrt (IZR (Z.of_N n)) ^ N.to_nat (half b)) in *.
  assert (NS : 0 <= IZR (num b) * s) by now apply Rmult_le_pos.
  assert (F : IZR (den b) * (IZR (num b) / IZR (den b) * s + IZR (constant b))
    = IZR (num b) * s + IZR (den b) * IZR (constant b)) by (field; lra).
  rewrite orb_true_iff, !Z.leb_le. split.
  - intros K. apply (Rmult_le_reg_l (IZR (den b))); [exact D|]. rewrite F.
    destruct K as [K|K]; apply IZR_le in K.
    + rewrite mult_IZR, minus_IZR in K. lra.
    + rewrite !mult_IZR, minus_IZR, <- SS in K.
      destruct (Rle_lt_dec (IZR (den b) * (IZR e - IZR (constant b))) (IZR (num b) * s)) as [L|L]; [lra|exfalso].
      set (l := IZR (den b) * (IZR e - IZR (constant b))) in *. set (r := IZR (num b) * s) in *.
      assert (r * r < l * l) by nra. unfold r in *. nra.
  - intros H. destruct (Z_le_gt_dec (den b * (e - constant b)) 0) as [L|L]; [now left|right].
    apply le_IZR. rewrite !mult_IZR, <- SS. apply Z.gt_lt, IZR_lt in L.
    rewrite mult_IZR, minus_IZR in *.
    apply (Rmult_le_compat_l (IZR (den b))) in H; [|lra]. rewrite F in H.
    set (l := IZR (den b) * (IZR e - IZR (constant b))) in *. set (r := IZR (num b) * s) in *.
    assert (l <= r) by (unfold l; lra).
    replace (IZR (num b) * IZR (num b) * (s * s)) with (r * r) by (unfold r; ring).
    apply Rmult_le_compat; lra.
Qed.
