
val fst : ('a1 * 'a2) -> 'a1

val snd : ('a1 * 'a2) -> 'a2



module Pos :
 sig
 end

val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1

type literal = int

type clause = literal list

type formula = clause list

type 'a tree =
| Leaf
| Node of 'a tree * 'a option * 'a tree

val find : int -> 'a1 tree -> 'a1 option

val add : int -> 'a1 -> 'a1 tree -> 'a1 tree

type clauses = clause tree

type literals = unit tree

val mem : literal -> literals -> bool

type lemma = { name : int; claim : clause; hints : int list }

val opposite : literal -> literal

type rest =
| Nothing
| One of literal
| Several

val no_other : literals -> literal -> clause -> bool

val left_of : literals -> clause -> rest

val propagates : clauses -> literals -> int list -> bool

val all_of : clause -> literals

val follow : clauses -> lemma list -> bool

val numbered_clauses : formula -> clauses

val refuted : formula -> lemma list -> bool
