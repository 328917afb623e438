
(** val fst : ('a1 * 'a2) -> 'a1 **)

let fst = function
| (x, _) -> x

(** val snd : ('a1 * 'a2) -> 'a2 **)

let snd = function
| (_, y) -> y



module Pos =
 struct
 end

(** val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1 **)

let rec fold_left f l a0 =
  match l with
  | [] -> a0
  | b :: t -> fold_left f t (f a0 b)

type literal = int

type clause = literal list

type formula = clause list

type 'a tree =
| Leaf
| Node of 'a tree * 'a option * 'a tree

(** val find : int -> 'a1 tree -> 'a1 option **)

let rec find i = function
| Leaf -> None
| Node (l, a, r) ->
  ((fun odd even one p -> if p = 1 then one () else if p land 1 = 1 then odd (p lsr 1) else even (p lsr 1))
     (fun j -> find j r)
     (fun j -> find j l)
     (fun _ -> a)
     i)

(** val add : int -> 'a1 -> 'a1 tree -> 'a1 tree **)

let rec add i a = function
| Leaf ->
  ((fun odd even one p -> if p = 1 then one () else if p land 1 = 1 then odd (p lsr 1) else even (p lsr 1))
     (fun j -> Node (Leaf, None, (add j a Leaf)))
     (fun j -> Node ((add j a Leaf), None, Leaf))
     (fun _ -> Node (Leaf, (Some a), Leaf))
     i)
| Node (l, b, r) ->
  ((fun odd even one p -> if p = 1 then one () else if p land 1 = 1 then odd (p lsr 1) else even (p lsr 1))
     (fun j -> Node (l, b, (add j a r)))
     (fun j -> Node ((add j a l), b, r))
     (fun _ -> Node (l, (Some a), r))
     i)

type clauses = clause tree

type literals = unit tree

(** val mem : literal -> literals -> bool **)

let mem l s =
  match find l s with
  | Some _ -> true
  | None -> false

type lemma = { name : int; claim : clause; hints : int list }

(** val opposite : literal -> literal **)

let opposite l =
  (fun odd even one p -> if p = 1 then one () else if p land 1 = 1 then odd (p lsr 1) else even (p lsr 1))
    (fun v -> (fun p -> 2 * p) v)
    (fun v -> (fun p -> 2 * p + 1) v)
    (fun _ -> 1)
    l

type rest =
| Nothing
| One of literal
| Several

(** val no_other : literals -> literal -> clause -> bool **)

let rec no_other false_ones l = function
| [] -> true
| k :: r ->
  if mem k false_ones
  then no_other false_ones l r
  else if Int.equal k l then no_other false_ones l r else false

(** val left_of : literals -> clause -> rest **)

let rec left_of false_ones = function
| [] -> Nothing
| l :: r ->
  if mem l false_ones
  then left_of false_ones r
  else if no_other false_ones l r then One l else Several

(** val propagates : clauses -> literals -> int list -> bool **)

let rec propagates known false_ones = function
| [] -> false
| h :: r ->
  (match find h known with
   | Some c ->
     (match left_of false_ones c with
      | Nothing -> true
      | One k -> propagates known (add (opposite k) () false_ones) r
      | Several -> false)
   | None -> false)

(** val all_of : clause -> literals **)

let all_of c =
  fold_left (fun s l -> add l () s) c Leaf

(** val follow : clauses -> lemma list -> bool **)

let rec follow known = function
| [] -> false
| s :: r ->
  if propagates known (all_of s.claim) s.hints
  then (match s.claim with
        | [] -> true
        | _ :: _ -> follow (add s.name s.claim known) r)
  else false

(** val numbered_clauses : formula -> clauses **)

let numbered_clauses f =
  snd
    (fold_left (fun a c -> ((succ (fst a)), (add (fst a) c (snd a)))) f (1,
      Leaf))

(** val refuted : formula -> lemma list -> bool **)

let refuted f proof =
  follow (numbered_clauses f) proof
