(** The checker as OCaml. Z, N and positive become integers of zarith, numbers as they are.
    The strings below are trusted. *)
From Coq Require Import ZArith NArith Extraction ExtrOcamlBasic.
From Drawing Require Import Spec Checker.

Extract Inductive positive => "Integer.t"
  [ "(fun p -> Integer.succ (Integer.shift_left p 1))" "(fun p -> Integer.shift_left p 1)" "Integer.one" ]
  "(fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))".
Extract Inductive Z => "Integer.t" [ "Integer.zero" "" "Integer.neg" ]
  "(fun zero pos neg z -> let s = Integer.sign z in
    if s = 0 then zero () else if s > 0 then pos z else neg (Integer.neg z))".
Extract Inductive N => "Integer.t" [ "Integer.zero" "" ]
  "(fun zero pos n -> if Integer.sign n = 0 then zero () else pos n)".

Extract Inlined Constant Z.add => "Integer.add".
Extract Inlined Constant Z.sub => "Integer.sub".
Extract Inlined Constant Z.mul => "Integer.mul".
Extract Inlined Constant Z.min => "Integer.min".
Extract Inlined Constant Z.max => "Integer.max".
Extract Inlined Constant Z.ltb => "Integer.lt".
Extract Inlined Constant Z.leb => "Integer.leq".
Extract Inlined Constant Z.eqb => "Integer.equal".
Extract Inlined Constant N.add => "Integer.add".
Extract Inlined Constant N.mul => "Integer.mul".
Extract Inlined Constant N.min => "Integer.min".
Extract Inlined Constant N.max => "Integer.max".
Extract Inlined Constant N.ltb => "Integer.lt".
Extract Inlined Constant N.leb => "Integer.leq".
Extract Inlined Constant N.eqb => "Integer.equal".
Extract Inlined Constant N.succ => "Integer.succ".
Extract Inlined Constant N.succ_pos => "Integer.succ".

Extraction "checker.ml" check no_advice.
