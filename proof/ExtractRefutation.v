(** The checker of refutations as OCaml. A positive becomes an int: it is a literal or the number of a clause, below 2^32 as they
    are read, and the checker makes none that is larger than one it has but for the next number. The strings are trusted. *)
From Coq Require Import PArith Extraction ExtrOcamlBasic.
From Drawing Require Import Refutation.

Extract Inductive positive => "int" [ "(fun p -> 2 * p + 1)" "(fun p -> 2 * p)" "1" ]
  "(fun odd even one p -> if p = 1 then one () else if p land 1 = 1 then odd (p lsr 1) else even (p lsr 1))".
Extract Inlined Constant Pos.succ => "succ".
Extract Inlined Constant Pos.eqb => "Int.equal".

Extraction "refutation.ml" refuted.
