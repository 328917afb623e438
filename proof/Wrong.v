(** What is not good: for each line of [Good] drawings, graphs or promises with that one fault. A
    [Good] that asks less does not pass this file. *)
From Coq Require Import ZArith NArith List.
From Drawing Require Import Spec Checker Sound Complete.
Import ListNotations.
Local Open Scope Z_scope.

Lemma wrong d g k : check no_advice d g k = false -> ~ Good d g k.
Proof. intros H G. apply (check_complete no_advice) in G. congruence. Qed.
Ltac is_wrong := apply wrong; vm_compute; reflexivity.

(** What is right: three corners of a square as vertices, the fourth as a bend. *)
Definition cube := Gram 1 1 1 0 0 0.
Definition o := Point 0 0 0.
Definition a := Point 4 0 0.
Definition b := Point 0 4 0.
Definition c := Point 4 4 0.
Definition square l v := Drawing v [Edge 0 1 []; Edge 2 0 []; Edge 1 2 l] cube 1.
Definition three := Graph 3 [(0, 1); (0, 2); (1, 2)]%N.
Definition axes := [Point 1 0 0; Point 0 2 0; Point 0 0 1].
Definition flat := Bound 0 1 2 0.
Definition even := Bound 4 3 2 0.
Definition right_angles := Promise 1 0 1 true cube 1 axes true (Some (Box even even flat)).
Definition sized x y z := Promise 1 0 1 true cube 1 axes true (Some (Box x y z)).
Definition free := Promise 9 0 1 false cube 1 [] false None. (* at least 90 degrees, nothing else *)

Lemma right : Good (square [c] [o; a; b]) three right_angles.
Proof. apply (check_sound no_advice). vm_compute. reflexivity. Qed.
Lemma right_scaled : Good (Drawing [o; a; b] [Edge 0 1 []; Edge 2 0 []; Edge 1 2 [c]] (Gram 2 2 2 0 0 0) 2) three right_angles.
Proof. apply (check_sound no_advice). vm_compute. reflexivity. Qed.

(* cosine_means *)
Lemma q_zero p e : ~ Good (Drawing [o; a; b] [Edge 0 1 []; Edge 0 2 []] cube 1) (Graph 3 [(0, 1); (0, 2)]%N)
  (Promise 1 p 0 e cube 1 [] false None).
Proof. apply wrong. unfold check, sane. reflexivity. Qed.
Lemma no_angle : ~ Good (Drawing [o; a] [Edge 0 1 []] cube 1) (Graph 2 [(0, 1)]%N) (Promise 1 2 1 true cube 1 [] false None).
Proof. is_wrong. Qed.
Lemma acute_promise : ~ Good (Drawing [o; a] [Edge 0 1 []] cube 1) (Graph 2 [(0, 1)]%N) (Promise 1 (-1) 2 true cube 1 [] false None).
Proof. is_wrong. Qed.
(* metric_means *)
Lemma indefinite : ~ Good (Drawing [o; a] [Edge 0 1 []] (Gram 1 1 (-1) 0 0 0) 1) (Graph 2 [(0, 1)]%N)
  (Promise 1 0 1 true (Gram 1 1 (-1) 0 0 0) 1 [] false None).
Proof. is_wrong. Qed.
Lemma semidefinite : ~ Good (Drawing [o; a] [Edge 0 1 []] (Gram 1 1 1 1 0 0) 1) (Graph 2 [(0, 1)]%N)
  (Promise 1 0 1 true (Gram 1 1 1 1 0 0) 1 [] false None).
Proof. is_wrong. Qed.
(* size_means *)
Lemma over_zero : ~ Good (square [c] [o; a; b]) three (sized even (Bound 4 0 2 9) flat).
Proof. is_wrong. Qed.
Lemma shrinking : ~ Good (square [c] [o; a; b]) three (sized even even (Bound (-1) 1 2 9)).
Proof. is_wrong. Qed.
(* all_vertices *)
Lemma vertex_missing : ~ Good (square [c] [o; a; b]) (Graph 4 (pairs three)) free.
Proof. is_wrong. Qed.
Lemma vertex_more : ~ Good (square [c] [o; a; b; Point 9 9 9]) three free.
Proof. is_wrong. Qed.
(* edges_exist *)
Lemma loop : ~ Good (Drawing [o] [Edge 0 0 [a; c; b]] cube 1) (Graph 1 [(0, 0)]%N) free.
Proof. is_wrong. Qed.
Lemma no_such_vertex : ~ Good (Drawing [a] [Edge 0 1 []] cube 1) (Graph 1 [(0, 1)]%N) free.
Proof. is_wrong. Qed.
(* edges_once *)
Lemma doubled : ~ Good (Drawing [o; a] [Edge 0 1 []; Edge 1 0 [c; b]] cube 1) (Graph 2 [(0, 1); (1, 0)]%N) free.
Proof. is_wrong. Qed.
(* all_edges *)
Lemma edge_missing : ~ Good (Drawing [o; a; b] [Edge 0 1 []; Edge 2 0 []] cube 1) three free.
Proof. is_wrong. Qed.
Lemma edge_more : ~ Good (square [c] [o; a; b]) (Graph 3 [(0, 1); (0, 2)]%N) free.
Proof. is_wrong. Qed.
Lemma edge_elsewhere : ~ Good (square [c] [o; a; b; Point 9 9 9]) (Graph 4 [(0, 1); (0, 2); (1, 3)]%N) free.
Proof. is_wrong. Qed.
(* few_bends *)
Lemma bend_more : ~ Good (square [Point 4 2 0; c] [o; a; b]) three (Promise 1 0 1 false cube 1 [] false None).
Proof. is_wrong. Qed.
(* no_zero_length *)
Lemma bend_on_vertex : ~ Good (square [c; b] [o; a; b]) three free.
Proof. is_wrong. Qed.
Lemma bend_twice : ~ Good (square [c; c] [o; a; b]) three free.
Proof. is_wrong. Qed.
(* angles *)
Lemma acute_bend : ~ Good (square [Point 5 5 0] [o; a; b]) three free.
Proof. is_wrong. Qed.
Lemma acute_vertex : ~ Good (square [c] [o; a; Point 1 4 0]) three free.
Proof. is_wrong. Qed.
Lemma straight : ~ Good (square [Point 4 2 0; c] [o; a; b]) three (Promise 9 0 1 true cube 1 [] false None).
Proof. is_wrong. Qed.
(* same_metric *)
Lemma other_metric : ~ Good (Drawing [o; a] [Edge 0 1 []] (Gram 1 1 2 0 0 0) 1) (Graph 2 [(0, 1)]%N) free.
Proof. is_wrong. Qed.
Lemma other_unit : ~ Good (Drawing [o; a] [Edge 0 1 []] cube 2) (Graph 2 [(0, 1)]%N) free.
Proof. is_wrong. Qed.
Lemma negative_unit : ~ Good (Drawing [o; a] [Edge 0 1 []] (Gram (-1) (-1) (-1) 0 0 0) (-1)) (Graph 2 [(0, 1)]%N) free.
Proof. is_wrong. Qed.
(* vertices_apart *)
Lemma one_point : ~ Good (Drawing [o; o] [] cube 1) (Graph 2 []) free.
Proof. is_wrong. Qed.
(* vertices_off_edges *)
Lemma vertex_on_edge : ~ Good (Drawing [o; a; Point 1 0 0] [Edge 0 1 []] cube 1) (Graph 3 [(0, 1)]%N) free.
Proof. is_wrong. Qed.
Lemma vertex_on_bend : ~ Good (square [c] [o; a; b; c]) (Graph 4 (pairs three)) free.
Proof. is_wrong. Qed.
(* no_crossings *)
Definition cross_graph := Graph 4 [(0, 1); (2, 3)]%N.
Lemma crossing : ~ Good (Drawing [o; a; Point 1 1 0; Point 1 (-1) 0] [Edge 0 1 []; Edge 2 3 []] cube 1) cross_graph free.
Proof. is_wrong. Qed.
Lemma bend_on_edge : ~ Good (Drawing [o; a; Point 1 1 0; Point 1 0 1] [Edge 0 1 []; Edge 2 3 [Point 1 0 0]] cube 1) cross_graph free.
Proof. is_wrong. Qed.
Lemma bend_on_bend : ~ Good (Drawing [o; c; Point 4 0 (-1); Point 4 0 1] [Edge 0 1 [a]; Edge 2 3 [a]] cube 1) cross_graph free.
Proof. is_wrong. Qed.
Lemma edge_on_itself : ~ Good (Drawing [o; Point 2 0 (-2)] [Edge 0 1 [a; c; Point 4 4 2; Point 2 4 2; Point 2 0 2]] cube 1)
  (Graph 2 [(0, 1)]%N) free.
Proof. is_wrong. Qed.
(* in_directions *)
Lemma slanted : ~ Good (Drawing [o; a; c] [Edge 0 1 []; Edge 0 2 [Point (-4) 4 0]] cube 1) (Graph 3 [(0, 1); (0, 2)]%N)
  (Promise 9 0 1 false cube 1 axes false None).
Proof. is_wrong. Qed.
Lemma no_direction : ~ Good (square [c] [o; a; b]) three (Promise 9 0 1 false cube 1 [o] false None).
Proof. is_wrong. Qed.
(* vertices_in_plane *)
Lemma lifted : ~ Good (square [Point 4 4 1] [Point 0 0 1; Point 4 0 1; Point 0 4 1]) three (Promise 9 0 1 false cube 1 [] true None).
Proof. is_wrong. Qed.
(* in_box *)
Lemma long_in_x : ~ Good (square [c] [o; a; b]) three (sized (Bound 23 10 1 0) even flat). (* 2.3 sqrt 3 < 4 *)
Proof. is_wrong. Qed.
Lemma long_in_y : ~ Good (square [c] [o; a; b]) three (sized even (Bound 1 1 2 0) flat).
Proof. is_wrong. Qed.
Lemma long_in_z : ~ Good (square [Point 4 0 1; Point 4 4 1; c] [o; a; b]) three (Promise 9 0 1 true cube 1 [] true (Some (Box even even flat))).
Proof. is_wrong. Qed.
