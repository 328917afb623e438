(** A checker of proofs that a formula in conjunctive normal form has no model, and the proof that it is right:
    [refuted_sound], at the end. A proof is a list of lemmas; each follows by unit propagation from clauses that it names.
    Nothing of drawings is in it, and nothing is taken for granted. *)
From Coq Require Import PArith List Bool.
Import ListNotations.

(** ** What is meant *)

(** Variable v is the literal v~0, its negation v~1. *)
Definition literal := positive.
Definition clause := list literal.
Definition formula := list clause.

(** A model gives each variable a value. *)
Definition model := positive -> bool.
Definition holds (m : model) (l : literal) : bool := match l with xO v => m v | xI v => negb (m v) | xH => false end.
Definition clause_holds (m : model) (c : clause) : bool := existsb (holds m) c.
Definition is_model (m : model) (f : formula) : Prop := forall c, In c f -> clause_holds m c = true.
Definition unsatisfiable (f : formula) : Prop := forall m, ~ is_model m f.

(** ** The checker *)

(** What numbers and literals are given: a tree along their binary digits. *)
Inductive tree (A : Type) := Leaf | Node (even : tree A) (one : option A) (odd : tree A).
Arguments Leaf {A}.
Arguments Node {A} _ _ _.

Fixpoint find {A} (i : positive) (t : tree A) : option A :=
  match t with
  | Leaf => None
  | Node l a r => match i with xO j => find j l | xI j => find j r | xH => a end
  end.

Fixpoint add {A} (i : positive) (a : A) (t : tree A) : tree A :=
  match t with
  | Leaf => match i with xO j => Node (add j a Leaf) None Leaf | xI j => Node Leaf None (add j a Leaf) | xH => Node Leaf (Some a) Leaf end
  | Node l b r => match i with xO j => Node (add j a l) b r | xI j => Node l b (add j a r) | xH => Node l (Some a) r end
  end.

Definition clauses := tree clause.
Definition literals := tree unit.
Definition mem (l : literal) (s : literals) : bool := match find l s with Some _ => true | None => false end.

(** The lemma [claim], under the number [name], by the clauses of the numbers [hints], in this order. *)
Record lemma := Follows { name : positive; claim : clause; hints : list positive }.

Definition opposite (l : literal) : literal := match l with xO v => xI v | xI v => xO v | xH => xH end.

(** What is left of a clause without the literals that are known to be false. *)
Inductive rest := Nothing | One (l : literal) | Several.

Fixpoint no_other (false_ones : literals) (l : literal) (c : clause) : bool :=
  match c with
  | [] => true
  | k :: r => if mem k false_ones then no_other false_ones l r
              else if Pos.eqb k l then no_other false_ones l r else false
  end.

Fixpoint left_of (false_ones : literals) (c : clause) : rest :=
  match c with
  | [] => Nothing
  | l :: r => if mem l false_ones then left_of false_ones r
              else if no_other false_ones l r then One l else Several
  end.

(** Whether the hints, taken in turn, leave nothing of a clause. *)
Fixpoint propagates (known : clauses) (false_ones : literals) (l : list positive) : bool :=
  match l with
  | [] => false
  | h :: r => match find h known with
    | None => false
    | Some c => match left_of false_ones c with
      | Nothing => true
      | One k => propagates known (add (opposite k) tt false_ones) r
      | Several => false
      end
    end
  end.

Definition all_of (c : clause) : literals := fold_left (fun s l => add l tt s) c Leaf.

Fixpoint follow (known : clauses) (proof : list lemma) : bool :=
  match proof with
  | [] => false
  | s :: r => if propagates known (all_of (claim s)) (hints s)
              then match claim s with [] => true | _ => follow (add (name s) (claim s) known) r end
              else false
  end.

Definition numbered_clauses (f : formula) : clauses :=
  snd (fold_left (fun a c => (Pos.succ (fst a), add (fst a) c (snd a))) f (xH, Leaf)).

(** The clauses of the formula have the numbers 1, 2, ... *)
Definition refuted (f : formula) (proof : list lemma) : bool := follow (numbered_clauses f) proof.

(** ** It is right *)

Section Model.
Variable m : model.
(** The clauses that are known hold, the literals that are known to be false do not. *)
Definition right_about (known : clauses) : Prop := forall i c, find i known = Some c -> clause_holds m c = true.
Definition all_false (s : literals) : Prop := forall l, mem l s = true -> holds m l = false.

Lemma opposite_false l : holds m l = true -> holds m (opposite l) = false.
Proof. destruct l; cbn; destruct (m _) || idtac; easy. Qed.

Lemma find_add {A} (a b : A) i : forall j t, find j (add i a t) = Some b -> j = i /\ b = a \/ find j t = Some b.
Proof.
  assert (E : forall j, find j (@Leaf A) = None) by (now intros []).
  induction i as [i IH|i IH|]; intros [j|j|] [|l c r]; cbn; intros H; rewrite ?E in H; try discriminate; auto;
    first [injection H as <-; left; now split
          |apply IH in H as [[-> ->]|H]; [left; now split|rewrite ?E in H; now right || discriminate]].
Qed.

Lemma mem_add l k s : mem l (add k tt s) = true -> l = k \/ mem l s = true.
Proof.
  unfold mem. destruct (find l (add k tt s)) eqn:F; [|easy]. apply find_add in F as [[-> _]|F]; [now left|].
  right. now rewrite F.
Qed.

Lemma all_false_add s l : all_false s -> holds m l = false -> all_false (add l tt s).
Proof. intros A H k K. apply mem_add in K as [->|K]; auto. Qed.

Lemma no_other_right s l c : all_false s -> no_other s l c = true -> clause_holds m c = true -> holds m l = true.
Proof.
  intros A. induction c as [|k r IH]; cbn; [easy|]. intros N H. apply orb_prop in H as [H|H].
  - destruct (mem k s) eqn:K; [apply A in K; congruence|]. destruct (Pos.eqb_spec k l) as [<-|]; easy.
  - destruct (mem k s); [auto|]. destruct (Pos.eqb k l); [auto|easy].
Qed.

Lemma left_of_right s c : all_false s -> clause_holds m c = true ->
  match left_of s c with Nothing => False | One l => holds m l = true | Several => True end.
Proof.
  intros A. induction c as [|l r IH]; cbn; [easy|]. intros H. apply orb_prop in H as [H|H].
  - destruct (mem l s) eqn:K; [apply A in K; congruence|]. now destruct (no_other s l r).
  - destruct (mem l s); [exact (IH H)|]. destruct (no_other s l r) eqn:N; [|exact I]. exact (no_other_right s l r A N H).
Qed.

Lemma propagates_right known : right_about known -> forall l s, all_false s -> propagates known s l = false.
Proof.
  intros K. induction l as [|h r IH]; intros s A; cbn; [reflexivity|].
  destruct (find h known) as [c|] eqn:F; [|reflexivity]. apply K, (left_of_right s c A) in F.
  destruct (left_of s c) as [|k|]; [easy| |reflexivity]. apply IH, all_false_add; [exact A|now apply opposite_false].
Qed.

Lemma all_of_false c : clause_holds m c = false -> all_false (all_of c).
Proof.
  unfold all_of. assert (E : all_false (@Leaf unit)) by now intros [].
  revert E. generalize (@Leaf unit). induction c as [|l r IH]; cbn; [auto|]. intros s A H.
  apply orb_false_iff in H as [H R]. apply IH; [now apply all_false_add|exact R].
Qed.

Lemma right_add known i c : right_about known -> clause_holds m c = true -> right_about (add i c known).
Proof. intros K H j b F. apply find_add in F as [[_ ->]|F]; [exact H|exact (K j b F)]. Qed.

Lemma follow_right proof : forall known, right_about known -> follow known proof = false.
Proof.
  induction proof as [|s r IH]; intros known K; cbn; [reflexivity|].
  destruct (clause_holds m (claim s)) eqn:H.
  - destruct (propagates _ _ _); [|reflexivity]. destruct (claim s) as [|l c]; [easy|]. now apply IH, right_add.
  - now rewrite (propagates_right known K) by now apply all_of_false.
Qed.

Lemma numbered_right f : is_model m f -> right_about (numbered_clauses f).
Proof.
  unfold numbered_clauses. assert (E : right_about (@Leaf clause)) by now intros [].
  revert E. generalize (@Leaf clause), 1%positive.
  induction f as [|c r IH]; cbn; [auto|]. intros known i K M. apply IH.
  - apply right_add; [exact K|apply M; now left].
  - intros b B. apply M. now right.
Qed.

End Model.

Theorem refuted_sound f proof : refuted f proof = true -> unsatisfiable f.
Proof. intros R m M. unfold refuted in R. now rewrite (follow_right m proof _ (numbered_right m f M)) in R. Qed.

(** It does refute something: x or y, x or not y, not x. And not without a clause, or by hints that are out of order. *)
Definition small : formula := [[2; 4]; [2; 5]; [3]]%positive.
Lemma small_refuted : refuted small [Follows 4 [2] [1; 2]; Follows 5 [] [4; 3]]%positive = true.
Proof. reflexivity. Qed.
Lemma small_not_refuted : refuted (List.tl small) [Follows 4 [2] [1; 2]; Follows 5 [] [4; 3]]%positive = false.
Proof. reflexivity. Qed.
