(** What the theorems rest on: Coq's real numbers, and nothing else; the last one not even on those. A test reads what this prints. *)
From Drawing Require Import Edges Complete Wrong OneBend OneBendOnFaces OneBendNeeded Refutation.
Print Assumptions check_iff.
Print Assumptions edges_meet_in_vertices.
Print Assumptions segments_differ.
Print Assumptions K5_needs_two_bends.
Print Assumptions faces_need_two_bends.
Print Assumptions six_edges_have_two.
Print Assumptions refuted_sound.
