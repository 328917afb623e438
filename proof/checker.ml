
(** val negb : bool -> bool **)

let negb = function
| true -> false
| false -> true

(** val fst : ('a1 * 'a2) -> 'a1 **)

let fst = function
| (x, _) -> x

(** val snd : ('a1 * 'a2) -> 'a2 **)

let snd = function
| (_, y) -> y

type comparison =
| Eq
| Lt
| Gt

(** val compOpp : comparison -> comparison **)

let compOpp = function
| Eq -> Eq
| Lt -> Gt
| Gt -> Lt

module Pos =
 struct
  (** val succ : Integer.t -> Integer.t **)

  let rec succ x =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
      (fun p -> (fun p -> Integer.shift_left p 1) (succ p))
      (fun p -> (fun p -> Integer.succ (Integer.shift_left p 1)) p)
      (fun _ -> (fun p -> Integer.shift_left p 1) Integer.one)
      x

  (** val add : Integer.t -> Integer.t -> Integer.t **)

  let rec add x y =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun q0 -> (fun p -> Integer.shift_left p 1)
        (add_carry p q0))
        (fun q0 -> (fun p -> Integer.succ (Integer.shift_left p 1))
        (add p q0))
        (fun _ -> (fun p -> Integer.shift_left p 1) (succ p))
        y)
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun q0 -> (fun p -> Integer.succ (Integer.shift_left p 1))
        (add p q0))
        (fun q0 -> (fun p -> Integer.shift_left p 1) (add p q0))
        (fun _ -> (fun p -> Integer.succ (Integer.shift_left p 1)) p)
        y)
      (fun _ ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun q0 -> (fun p -> Integer.shift_left p 1) (succ q0))
        (fun q0 -> (fun p -> Integer.succ (Integer.shift_left p 1))
        q0)
        (fun _ -> (fun p -> Integer.shift_left p 1) Integer.one)
        y)
      x

  (** val add_carry : Integer.t -> Integer.t -> Integer.t **)

  and add_carry x y =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun q0 -> (fun p -> Integer.succ (Integer.shift_left p 1))
        (add_carry p q0))
        (fun q0 -> (fun p -> Integer.shift_left p 1)
        (add_carry p q0))
        (fun _ -> (fun p -> Integer.succ (Integer.shift_left p 1)) (succ p))
        y)
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun q0 -> (fun p -> Integer.shift_left p 1)
        (add_carry p q0))
        (fun q0 -> (fun p -> Integer.succ (Integer.shift_left p 1))
        (add p q0))
        (fun _ -> (fun p -> Integer.shift_left p 1) (succ p))
        y)
      (fun _ ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun q0 -> (fun p -> Integer.succ (Integer.shift_left p 1))
        (succ q0))
        (fun q0 -> (fun p -> Integer.shift_left p 1) (succ q0))
        (fun _ -> (fun p -> Integer.succ (Integer.shift_left p 1))
        Integer.one)
        y)
      x

  (** val pred_double : Integer.t -> Integer.t **)

  let rec pred_double x =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
      (fun p -> (fun p -> Integer.succ (Integer.shift_left p 1))
      ((fun p -> Integer.shift_left p 1) p))
      (fun p -> (fun p -> Integer.succ (Integer.shift_left p 1))
      (pred_double p))
      (fun _ -> Integer.one)
      x

  (** val mul : Integer.t -> Integer.t -> Integer.t **)

  let rec mul x y =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
      (fun p -> add y ((fun p -> Integer.shift_left p 1) (mul p y)))
      (fun p -> (fun p -> Integer.shift_left p 1) (mul p y))
      (fun _ -> y)
      x

  (** val iter : ('a1 -> 'a1) -> 'a1 -> Integer.t -> 'a1 **)

  let rec iter f x n0 =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
      (fun n' -> f (iter f (iter f x n') n'))
      (fun n' -> iter f (iter f x n') n')
      (fun _ -> f x)
      n0

  (** val compare_cont :
      comparison -> Integer.t -> Integer.t -> comparison **)

  let rec compare_cont r x y =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun q0 -> compare_cont r p q0)
        (fun q0 -> compare_cont Gt p q0)
        (fun _ -> Gt)
        y)
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun q0 -> compare_cont Lt p q0)
        (fun q0 -> compare_cont r p q0)
        (fun _ -> Gt)
        y)
      (fun _ ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun _ -> Lt)
        (fun _ -> Lt)
        (fun _ -> r)
        y)
      x

  (** val compare : Integer.t -> Integer.t -> comparison **)

  let compare =
    compare_cont Eq

  (** val eqb : Integer.t -> Integer.t -> bool **)

  let rec eqb p q0 =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
      (fun p0 ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun q1 -> eqb p0 q1)
        (fun _ -> false)
        (fun _ -> false)
        q0)
      (fun p0 ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun _ -> false)
        (fun q1 -> eqb p0 q1)
        (fun _ -> false)
        q0)
      (fun _ ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun _ -> false)
        (fun _ -> false)
        (fun _ -> true)
        q0)
      p
 end

module N =
 struct
  (** val compare : Integer.t -> Integer.t -> comparison **)

  let compare n0 m =
    (fun zero pos n -> if Integer.sign n = 0 then zero () else pos n)
      (fun _ ->
      (fun zero pos n -> if Integer.sign n = 0 then zero () else pos n)
        (fun _ -> Eq)
        (fun _ -> Lt)
        m)
      (fun n' ->
      (fun zero pos n -> if Integer.sign n = 0 then zero () else pos n)
        (fun _ -> Gt)
        (fun m' -> Pos.compare n' m')
        m)
      n0
 end

module Z =
 struct
  (** val double : Integer.t -> Integer.t **)

  let double x =
    (fun zero pos neg z -> let s = Integer.sign z in
    if s = 0 then zero () else if s > 0 then pos z else neg (Integer.neg z))
      (fun _ -> Integer.zero)
      (fun p -> ((fun p -> Integer.shift_left p 1) p))
      (fun p -> Integer.neg ((fun p -> Integer.shift_left p 1) p))
      x

  (** val succ_double : Integer.t -> Integer.t **)

  let succ_double x =
    (fun zero pos neg z -> let s = Integer.sign z in
    if s = 0 then zero () else if s > 0 then pos z else neg (Integer.neg z))
      (fun _ -> Integer.one)
      (fun p -> ((fun p -> Integer.succ (Integer.shift_left p 1))
      p))
      (fun p -> Integer.neg (Pos.pred_double p))
      x

  (** val pred_double : Integer.t -> Integer.t **)

  let pred_double x =
    (fun zero pos neg z -> let s = Integer.sign z in
    if s = 0 then zero () else if s > 0 then pos z else neg (Integer.neg z))
      (fun _ -> Integer.neg Integer.one)
      (fun p -> (Pos.pred_double p))
      (fun p -> Integer.neg ((fun p -> Integer.succ (Integer.shift_left p 1))
      p))
      x

  (** val pos_sub : Integer.t -> Integer.t -> Integer.t **)

  let rec pos_sub x y =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun q0 -> double (pos_sub p q0))
        (fun q0 -> succ_double (pos_sub p q0))
        (fun _ -> ((fun p -> Integer.shift_left p 1) p))
        y)
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun q0 -> pred_double (pos_sub p q0))
        (fun q0 -> double (pos_sub p q0))
        (fun _ -> (Pos.pred_double p))
        y)
      (fun _ ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
        (fun q0 -> Integer.neg ((fun p -> Integer.shift_left p 1)
        q0))
        (fun q0 -> Integer.neg (Pos.pred_double q0))
        (fun _ -> Integer.zero)
        y)
      x

  (** val opp : Integer.t -> Integer.t **)

  let opp x =
    (fun zero pos neg z -> let s = Integer.sign z in
    if s = 0 then zero () else if s > 0 then pos z else neg (Integer.neg z))
      (fun _ -> Integer.zero)
      (fun x2 -> Integer.neg x2)
      (fun x2 -> x2)
      x

  (** val pow_pos : Integer.t -> Integer.t -> Integer.t **)

  let pow_pos z2 =
    Pos.iter (Integer.mul z2) Integer.one

  (** val pow : Integer.t -> Integer.t -> Integer.t **)

  let pow x y =
    (fun zero pos neg z -> let s = Integer.sign z in
    if s = 0 then zero () else if s > 0 then pos z else neg (Integer.neg z))
      (fun _ -> Integer.one)
      (fun p -> pow_pos x p)
      (fun _ -> Integer.zero)
      y

  (** val compare : Integer.t -> Integer.t -> comparison **)

  let compare x y =
    (fun zero pos neg z -> let s = Integer.sign z in
    if s = 0 then zero () else if s > 0 then pos z else neg (Integer.neg z))
      (fun _ ->
      (fun zero pos neg z -> let s = Integer.sign z in
    if s = 0 then zero () else if s > 0 then pos z else neg (Integer.neg z))
        (fun _ -> Eq)
        (fun _ -> Lt)
        (fun _ -> Gt)
        y)
      (fun x' ->
      (fun zero pos neg z -> let s = Integer.sign z in
    if s = 0 then zero () else if s > 0 then pos z else neg (Integer.neg z))
        (fun _ -> Gt)
        (fun y' -> Pos.compare x' y')
        (fun _ -> Gt)
        y)
      (fun x' ->
      (fun zero pos neg z -> let s = Integer.sign z in
    if s = 0 then zero () else if s > 0 then pos z else neg (Integer.neg z))
        (fun _ -> Lt)
        (fun _ -> Lt)
        (fun y' -> compOpp (Pos.compare x' y'))
        y)
      x

  (** val of_N : Integer.t -> Integer.t **)

  let of_N n0 =
    (fun zero pos n -> if Integer.sign n = 0 then zero () else pos n)
      (fun _ -> Integer.zero)
      (fun p -> p)
      n0
 end

(** val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1 **)

let rec fold_left f l a0 =
  match l with
  | [] -> a0
  | b :: t0 -> fold_left f t0 (f a0 b)

(** val existsb : ('a1 -> bool) -> 'a1 list -> bool **)

let rec existsb f = function
| [] -> false
| a :: l0 -> (||) (f a) (existsb f l0)

(** val forallb : ('a1 -> bool) -> 'a1 list -> bool **)

let rec forallb f = function
| [] -> true
| a :: l0 -> (&&) (f a) (forallb f l0)

type point = { px : Integer.t; py : Integer.t; pz : Integer.t }

type edge = { tail : Integer.t; head : Integer.t; bends : point list }

type gram = { xx : Integer.t; yy : Integer.t; zz : Integer.t; xy : Integer.t;
              xz : Integer.t; yz : Integer.t }

type drawing = { vertices : point list; edges : edge list; metric : gram;
                 over : Integer.t }

type graph = { order : Integer.t; pairs : (Integer.t * Integer.t) list }

type bound = { num : Integer.t; den : Integer.t; half : Integer.t;
               constant : Integer.t }

type box = { in_x : bound; in_y : bound; in_z : bound }

type promise = { most_bends : Integer.t; minus_p : Integer.t; q : Integer.t;
                 equal : bool; lengths : gram; lengths_over : Integer.t;
                 directions : point list; in_plane : bool; size : box option }

type name =
| Vertex of Integer.t
| Bend of Integer.t * Integer.t

type corner = name * point

type segment = corner * corner

(** val ends : edge -> Integer.t * Integer.t **)

let ends f =
  (f.tail, f.head)

(** val turned : (Integer.t * Integer.t) -> Integer.t * Integer.t **)

let turned e =
  ((Integer.min (fst e) (snd e)), (Integer.max (fst e) (snd e)))

module PositiveMap =
 struct
  type key = Integer.t

  type 'a tree =
  | Leaf
  | Node of 'a tree * 'a option * 'a tree

  type 'a t = 'a tree

  (** val empty : 'a1 t **)

  let empty =
    Leaf

  (** val find : key -> 'a1 t -> 'a1 option **)

  let rec find i = function
  | Leaf -> None
  | Node (l, o, r) ->
    ((fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
       (fun ii -> find ii r)
       (fun ii -> find ii l)
       (fun _ -> o)
       i)

  (** val mem : key -> 'a1 t -> bool **)

  let rec mem i = function
  | Leaf -> false
  | Node (l, o, r) ->
    ((fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
       (fun ii -> mem ii r)
       (fun ii -> mem ii l)
       (fun _ -> match o with
                 | Some _ -> true
                 | None -> false)
       i)

  (** val add : key -> 'a1 -> 'a1 t -> 'a1 t **)

  let rec add i v = function
  | Leaf ->
    ((fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
       (fun ii -> Node (Leaf, None, (add ii v Leaf)))
       (fun ii -> Node ((add ii v Leaf), None, Leaf))
       (fun _ -> Node (Leaf, (Some v), Leaf))
       i)
  | Node (l, o, r) ->
    ((fun odd even one p -> if Integer.equal p Integer.one then one () else
    (if Integer.is_odd p then odd else even) (Integer.shift_right p 1))
       (fun ii -> Node (l, o, (add ii v r)))
       (fun ii -> Node ((add ii v l), o, r))
       (fun _ -> Node (l, (Some v), r))
       i)
 end

(** val diff : point -> point -> point **)

let diff a b =
  { px = (Integer.sub b.px a.px); py = (Integer.sub b.py a.py); pz =
    (Integer.sub b.pz a.pz) }

(** val dot : point -> point -> Integer.t **)

let dot u v =
  Integer.add (Integer.add (Integer.mul u.px v.px) (Integer.mul u.py v.py))
    (Integer.mul u.pz v.pz)

(** val cross : point -> point -> point **)

let cross u v =
  { px = (Integer.sub (Integer.mul u.py v.pz) (Integer.mul u.pz v.py)); py =
    (Integer.sub (Integer.mul u.pz v.px) (Integer.mul u.px v.pz)); pz =
    (Integer.sub (Integer.mul u.px v.py) (Integer.mul u.py v.px)) }

(** val zinner : gram -> point -> point -> Integer.t **)

let zinner g u v =
  Integer.add
    (Integer.add
      (Integer.add
        (Integer.add
          (Integer.add (Integer.mul g.xx (Integer.mul u.px v.px))
            (Integer.mul g.yy (Integer.mul u.py v.py)))
          (Integer.mul g.zz (Integer.mul u.pz v.pz)))
        (Integer.mul g.xy
          (Integer.add (Integer.mul u.px v.py) (Integer.mul u.py v.px))))
      (Integer.mul g.xz
        (Integer.add (Integer.mul u.px v.pz) (Integer.mul u.pz v.px))))
    (Integer.mul g.yz
      (Integer.add (Integer.mul u.py v.pz) (Integer.mul u.pz v.py)))

(** val apart : Integer.t -> Integer.t -> Integer.t -> Integer.t -> bool **)

let apart a b c d =
  if Integer.lt a c
  then (&&) ((&&) (Integer.lt a d) (Integer.lt b c)) (Integer.lt b d)
  else (&&) ((&&) ((&&) (Integer.lt c a) (Integer.lt d a)) (Integer.lt c b))
         (Integer.lt d b)

(** val separates : point -> point -> point -> point -> point -> bool **)

let separates h a b c d =
  apart (dot h a) (dot h b) (dot h c) (dot h d)

(** val boxes_apart : point -> point -> point -> point -> bool **)

let boxes_apart a b c d =
  (||) ((||) (apart a.px b.px c.px d.px) (apart a.py b.py c.py d.py))
    (apart a.pz b.pz c.pz d.pz)

(** val disjoint : point -> point -> point -> point -> bool **)

let disjoint a b c d =
  (||) (boxes_apart a b c d)
    (let u = diff a b in
     let v = diff c d in
     let n0 = cross u v in
     (||)
       ((||)
         ((||)
           ((||)
             ((||) (separates n0 a b c d) (separates (cross n0 u) a b c d))
             (separates (cross n0 v) a b c d)) (separates u a b c d))
         (separates v a b c d))
       (let w = diff a c in
        (||) (separates (cross u (cross w u)) a b c d)
          (separates (cross v (cross w v)) a b c d)))

(** val angle_ok : gram -> promise -> point -> point -> point -> bool **)

let angle_ok g k a b c =
  let u = diff a b in
  let v = diff a c in
  let g0 = zinner g u v in
  let l = Integer.mul (Integer.mul g0 g0) (Integer.mul k.q k.q) in
  let r =
    Integer.mul (Integer.mul k.minus_p k.minus_p)
      (Integer.mul (zinner g u u) (zinner g v v))
  in
  (&&) (Integer.leq g0 Integer.zero)
    (if k.equal then Integer.equal l r else Integer.leq r l)

(** val metric_ok : gram -> bool **)

let metric_ok g =
  let m = Integer.sub (Integer.mul g.xx g.yy) (Integer.mul g.xy g.xy) in
  let l = Integer.sub (Integer.mul g.xx g.zz) (Integer.mul g.xz g.xz) in
  let o = Integer.sub (Integer.mul g.xx g.yz) (Integer.mul g.xy g.xz) in
  (&&) ((&&) (Integer.lt Integer.zero g.xx) (Integer.lt Integer.zero m))
    (Integer.lt Integer.zero
      (Integer.sub (Integer.mul m l) (Integer.mul o o)))

(** val same_point : point -> point -> bool **)

let same_point a b =
  (&&) ((&&) (Integer.equal a.px b.px) (Integer.equal a.py b.py))
    (Integer.equal a.pz b.pz)

(** val same_name : name -> name -> bool **)

let same_name a b =
  match a with
  | Vertex v ->
    (match b with
     | Vertex w -> Integer.equal v w
     | Bend (_, _) -> false)
  | Bend (e, i) ->
    (match b with
     | Vertex _ -> false
     | Bend (f, j) -> (&&) (Integer.equal e f) (Integer.equal i j))

(** val same : corner -> corner -> bool **)

let same a b =
  (&&) (same_name (fst a) (fst b)) (same_point (snd a) (snd b))

(** val fine : gram -> promise -> corner -> corner -> corner -> bool **)

let fine g k a b c =
  (||) ((||) (same a b) (same a c)) (angle_ok g k (snd a) (snd b) (snd c))

(** val pair_ok : gram -> promise -> segment -> segment -> bool **)

let pair_ok g k s t0 =
  let (a, b) = s in
  let (c, d) = t0 in
  (||) (boxes_apart (snd a) (snd b) (snd c) (snd d))
    (let ac = same a c in
     let ad = same a d in
     let bc = same b c in
     let bd = same b d in
     if (||) ((||) ((||) ac ad) bc) bd
     then (&&)
            ((&&)
              ((&&) ((||) (negb ac) (fine g k a b d))
                ((||) (negb ad) (fine g k a b c)))
              ((||) (negb bc) (fine g k b a d)))
            ((||) (negb bd) (fine g k b a c))
     else disjoint (snd a) (snd b) (snd c) (snd d))

(** val parts : Integer.t **)

let parts =
  ((fun p -> Integer.shift_left p 1) ((fun p -> Integer.shift_left p 1)
    ((fun p -> Integer.shift_left p 1) ((fun p -> Integer.shift_left p 1)
    ((fun p -> Integer.shift_left p 1) ((fun p -> Integer.shift_left p 1)
    ((fun p -> Integer.shift_left p 1) ((fun p -> Integer.shift_left p 1)
    ((fun p -> Integer.shift_left p 1) ((fun p -> Integer.shift_left p 1)
    ((fun p -> Integer.shift_left p 1) ((fun p -> Integer.shift_left p 1)
    ((fun p -> Integer.shift_left p 1) ((fun p -> Integer.shift_left p 1)
    ((fun p -> Integer.shift_left p 1) ((fun p -> Integer.shift_left p 1)
    ((fun p -> Integer.shift_left p 1) ((fun p -> Integer.shift_left p 1)
    ((fun p -> Integer.shift_left p 1) ((fun p -> Integer.shift_left p 1)
    Integer.one))))))))))))))))))))

type piece = { whole : segment; from : Integer.t; till : Integer.t }

type plan =
| Together
| Cut of point * Integer.t * plan * plan
| Part of point * plan * plan * plan * plan

type advice = { cuts : plan; ratio : (Integer.t -> Integer.t -> Integer.t) }

(** val no_advice : advice **)

let no_advice =
  { cuts = Together; ratio = (fun _ _ -> Integer.zero) }

(** val each : ('a1 -> 'a2) -> 'a1 list -> 'a2 list -> 'a2 list **)

let rec each f l r =
  match l with
  | [] -> r
  | a :: m -> each f m ((f a) :: r)

(** val sift : ('a1 -> bool) -> 'a1 list -> 'a1 list -> 'a1 list **)

let rec sift f l r =
  match l with
  | [] -> r
  | a :: m -> sift f m (if f a then a :: r else r)

(** val before : Integer.t -> piece -> piece list -> piece list **)

let before m s l =
  if Integer.leq s.from m
  then { whole = s.whole; from = s.from; till = (Integer.min m s.till) } :: l
  else l

(** val behind : Integer.t -> piece -> piece list -> piece list **)

let behind m s l =
  if Integer.leq m s.till
  then { whole = s.whole; from = (Integer.max m s.from); till = s.till } :: l
  else l

(** val divide :
    (Integer.t -> Integer.t -> Integer.t) -> point -> Integer.t -> piece list
    -> piece list -> piece list -> piece list * piece list **)

let rec divide ratio0 h c l low high =
  match l with
  | [] -> (low, high)
  | s :: r ->
    let x = Integer.sub (dot h (snd (fst s.whole))) c in
    let y = Integer.sub (dot h (snd (snd s.whole))) c in
    if (&&) (Integer.lt x Integer.zero) (Integer.lt y Integer.zero)
    then divide ratio0 h c r (s :: low) high
    else if (&&) (Integer.lt Integer.zero x) (Integer.lt Integer.zero y)
         then divide ratio0 h c r low (s :: high)
         else let rises = Integer.lt x y in
              let o = if rises then Integer.sub y x else Integer.sub x y in
              let n0 =
                Integer.mul (if rises then Integer.sub Integer.zero x else x)
                  parts
              in
              let m = ratio0 n0 o in
              let e = Integer.sub n0 (Integer.mul m o) in
              if (&&)
                   ((&&) (Integer.lt Integer.zero o)
                     (Integer.leq Integer.zero e)) (Integer.leq e o)
              then if rises
                   then divide ratio0 h c r
                          (before (Integer.add m Integer.one) s low)
                          (behind m s high)
                   else divide ratio0 h c r (behind m s low)
                          (before (Integer.add m Integer.one) s high)
              else divide ratio0 h c r (s :: low) (s :: high)

(** val level : point -> piece -> bool **)

let level h s =
  Integer.equal (dot h (snd (fst s.whole))) (dot h (snd (snd s.whole)))

(** val sloping : point -> piece -> bool **)

let sloping h s =
  negb (level h s)

type boxed = { inside : segment; x0 : Integer.t; x1 : Integer.t;
               y0 : Integer.t; y1 : Integer.t; z0 : Integer.t; z1 : Integer.t }

(** val box_of : piece -> boxed **)

let box_of s =
  let a = snd (fst s.whole) in
  let b = snd (snd s.whole) in
  let at_ = fun c t0 ->
    Integer.add (Integer.mul (c a) parts)
      (Integer.mul t0 (Integer.sub (c b) (c a)))
  in
  let x = at_ (fun p -> p.px) s.from in
  let x' = at_ (fun p -> p.px) s.till in
  let y = at_ (fun p -> p.py) s.from in
  let y' = at_ (fun p -> p.py) s.till in
  let z2 = at_ (fun p -> p.pz) s.from in
  let z' = at_ (fun p -> p.pz) s.till in
  { inside = s.whole; x0 = (Integer.min x x'); x1 = (Integer.max x x'); y0 =
  (Integer.min y y'); y1 = (Integer.max y y'); z0 = (Integer.min z2 z'); z1 =
  (Integer.max z2 z') }

(** val far : boxed -> boxed -> bool **)

let far s t0 =
  (||)
    ((||)
      ((||)
        ((||) ((||) (Integer.lt s.x1 t0.x0) (Integer.lt t0.x1 s.x0))
          (Integer.lt s.y1 t0.y0)) (Integer.lt t0.y1 s.y0))
      (Integer.lt s.z1 t0.z0)) (Integer.lt t0.z1 s.z0)

(** val near_ok : (segment -> segment -> bool) -> boxed -> boxed -> bool **)

let near_ok f s t0 =
  (||) (far s t0) (f s.inside t0.inside)

(** val all_pairs : ('a1 -> 'a1 -> bool) -> 'a1 list -> bool **)

let rec all_pairs f = function
| [] -> true
| a :: r -> (&&) (forallb (f a) r) (all_pairs f r)

(** val across_ok :
    (segment -> segment -> bool) -> (Integer.t -> Integer.t -> Integer.t) ->
    plan -> piece list -> piece list -> bool **)

let rec across_ok f ratio0 p l m =
  match p with
  | Together ->
    let m0 = each box_of m [] in
    forallb (fun s -> forallb (near_ok f (box_of s)) m0) l
  | Cut (h, c, low, high) ->
    let (l1, l2) = divide ratio0 h c l [] [] in
    let (m1, m2) = divide ratio0 h c m [] [] in
    (&&) (across_ok f ratio0 low l1 m1) (across_ok f ratio0 high l2 m2)
  | Part (h, p0, q0, r, o) ->
    let l1 = sift (level h) l [] in
    let l2 = sift (sloping h) l [] in
    let m1 = sift (level h) m [] in
    let m2 = sift (sloping h) m [] in
    (&&)
      ((&&)
        ((&&) (across_ok f ratio0 p0 l1 m1) (across_ok f ratio0 q0 l1 m2))
        (across_ok f ratio0 r l2 m1)) (across_ok f ratio0 o l2 m2)

(** val pairs_ok :
    (segment -> segment -> bool) -> (Integer.t -> Integer.t -> Integer.t) ->
    plan -> piece list -> bool **)

let rec pairs_ok f ratio0 p l =
  match p with
  | Together -> all_pairs (near_ok f) (each box_of l [])
  | Cut (h, c, low, high) ->
    let (l1, l2) = divide ratio0 h c l [] [] in
    (&&) (pairs_ok f ratio0 low l1) (pairs_ok f ratio0 high l2)
  | Part (h, p0, q0, _, o) ->
    let l1 = sift (level h) l [] in
    let l2 = sift (sloping h) l [] in
    (&&) ((&&) (pairs_ok f ratio0 p0 l1) (across_ok f ratio0 q0 l1 l2))
      (pairs_ok f ratio0 o l2)

type table = point PositiveMap.t

(** val fill : Integer.t -> point list -> table -> table **)

let rec fill i l t0 =
  match l with
  | [] -> t0
  | p :: r -> fill (Integer.succ i) r (PositiveMap.add (Integer.succ i) p t0)

(** val look : table -> Integer.t -> point option **)

let look t0 v =
  PositiveMap.find (Integer.succ v) t0

(** val walk :
    Integer.t -> Integer.t -> corner -> point list -> corner -> segment list
    -> segment list **)

let rec walk e i a l z2 acc =
  match l with
  | [] -> (a, z2) :: acc
  | p :: r ->
    let b = ((Bend (e, i)), p) in
    walk e (Integer.succ i) b r z2 ((a, b) :: acc)

(** val gather :
    table -> Integer.t -> edge list -> segment list -> segment list option **)

let rec gather t0 e l acc =
  match l with
  | [] -> Some acc
  | f :: r ->
    (match look t0 f.tail with
     | Some a ->
       (match look t0 f.head with
        | Some b ->
          gather t0 (Integer.succ e) r
            (walk e Integer.zero ((Vertex f.tail), a) f.bends ((Vertex
              f.head), b) acc)
        | None -> None)
     | None -> None)

(** val dots : Integer.t -> point list -> segment list -> segment list **)

let rec dots i l acc =
  match l with
  | [] -> acc
  | p :: r ->
    let c = ((Vertex i), p) in dots (Integer.succ i) r ((c, c) :: acc)

(** val count : Integer.t -> 'a1 list -> Integer.t **)

let rec count i = function
| [] -> i
| _ :: r -> count (Integer.succ i) r

(** val pair_key : Integer.t -> (Integer.t * Integer.t) -> Integer.t **)

let pair_key n0 e =
  Integer.succ (Integer.add (Integer.mul n0 (fst e)) (snd e))

(** val once :
    ('a1 -> Integer.t) -> 'a1 list -> unit PositiveMap.t -> unit
    PositiveMap.t option **)

let rec once f l t0 =
  match l with
  | [] -> Some t0
  | a :: r ->
    (match PositiveMap.find (f a) t0 with
     | Some _ -> None
     | None -> once f r (PositiveMap.add (f a) () t0))

(** val graph_ok : drawing -> graph -> bool **)

let graph_ok d g =
  let n0 = g.order in
  let wanted = fun e -> pair_key n0 (turned e) in
  let drawn = fun f -> pair_key n0 (turned (ends f)) in
  (&&)
    ((&&)
      ((&&)
        ((&&) (Integer.equal (count Integer.zero d.vertices) n0)
          (forallb (fun e ->
            (&&) ((&&) (Integer.lt (fst e) n0) (Integer.lt (snd e) n0))
              (negb (Integer.equal (fst e) (snd e)))) g.pairs))
        (forallb (fun f ->
          (&&) (Integer.lt f.tail n0) (Integer.lt f.head n0)) d.edges))
      (Integer.equal (count Integer.zero d.edges)
        (count Integer.zero g.pairs)))
    (match once wanted g.pairs PositiveMap.empty with
     | Some t0 ->
       (match once drawn d.edges PositiveMap.empty with
        | Some _ -> forallb (fun f -> PositiveMap.mem (drawn f) t0) d.edges
        | None -> false)
     | None -> false)

(** val zero : point **)

let zero =
  { px = Integer.zero; py = Integer.zero; pz = Integer.zero }

(** val along_ok : point -> point -> bool **)

let along_ok a u =
  (&&) (negb (same_point a zero)) (same_point (cross a u) zero)

(** val direction_ok : promise -> segment -> bool **)

let direction_ok k s =
  match k.directions with
  | [] -> true
  | p :: l0 ->
    let u = diff (snd (fst s)) (snd (snd s)) in
    existsb (fun a -> along_ok a u) (p :: l0)

(** val plane_ok : promise -> drawing -> bool **)

let plane_ok k d =
  (||) (negb k.in_plane)
    (forallb (fun p -> Integer.equal p.pz Integer.zero) d.vertices)

(** val at_most_ok : bound -> Integer.t -> Integer.t -> bool **)

let at_most_ok b n0 e =
  let l = Integer.mul b.den (Integer.sub e b.constant) in
  (||) (Integer.leq l Integer.zero)
    (Integer.leq (Integer.mul l l)
      (Integer.mul (Integer.mul b.num b.num)
        (Z.pow (Z.of_N n0) (Z.of_N b.half))))

(** val fold_points : ('a1 -> point -> 'a1) -> drawing -> 'a1 -> 'a1 **)

let fold_points f d a =
  fold_left (fun a0 e -> fold_left f e.bends a0) d.edges
    (fold_left f d.vertices a)

(** val spread : (point -> Integer.t) -> drawing -> point -> Integer.t **)

let spread c d p =
  Integer.sub (fold_points (fun m o -> Integer.max m (c o)) d (c p))
    (fold_points (fun m o -> Integer.min m (c o)) d (c p))

(** val box_ok : promise -> drawing -> graph -> bool **)

let box_ok k d g =
  match k.size with
  | Some b ->
    (match d.vertices with
     | [] -> true
     | p :: _ ->
       (&&)
         ((&&) (at_most_ok b.in_x g.order (spread (fun p0 -> p0.px) d p))
           (at_most_ok b.in_y g.order (spread (fun p0 -> p0.py) d p)))
         (at_most_ok b.in_z g.order (spread (fun p0 -> p0.pz) d p)))
  | None -> true

(** val bound_ok : bound -> bool **)

let bound_ok b =
  (&&) (Integer.lt Integer.zero b.den) (Integer.leq Integer.zero b.num)

(** val sane : promise -> bool **)

let sane k =
  (&&)
    ((&&)
      ((&&)
        ((&&) (Integer.lt Integer.zero k.q)
          (Integer.leq Integer.zero k.minus_p)) (Integer.leq k.minus_p k.q))
      (metric_ok k.lengths))
    (match k.size with
     | Some b ->
       (&&) ((&&) (bound_ok b.in_x) (bound_ok b.in_y)) (bound_ok b.in_z)
     | None -> true)

(** val same_metric_ok : drawing -> promise -> bool **)

let same_metric_ok d k =
  (&&)
    ((&&) (Integer.lt Integer.zero d.over)
      (Integer.lt Integer.zero k.lengths_over))
    (forallb (fun place ->
      Integer.equal (Integer.mul (place d.metric) k.lengths_over)
        (Integer.mul (place k.lengths) d.over)) ((fun g ->
      g.xx) :: ((fun g -> g.yy) :: ((fun g -> g.zz) :: ((fun g ->
      g.xy) :: ((fun g -> g.xz) :: ((fun g -> g.yz) :: [])))))))

(** val check : advice -> drawing -> graph -> promise -> bool **)

let check p d g k =
  (&&)
    ((&&)
      ((&&)
        ((&&) ((&&) ((&&) (sane k) (same_metric_ok d k)) (graph_ok d g))
          (forallb (fun f ->
            Integer.leq (count Integer.zero f.bends) k.most_bends) d.edges))
        (plane_ok k d)) (box_ok k d g))
    (match gather (fill Integer.zero d.vertices PositiveMap.empty)
             Integer.zero d.edges [] with
     | Some l ->
       (&&)
         (forallb (fun s ->
           (&&) (negb (same_point (snd (fst s)) (snd (snd s))))
             (direction_ok k s)) l)
         (pairs_ok (pair_ok k.lengths k) p.ratio p.cuts
           (each (fun s -> { whole = s; from = Integer.zero; till = parts })
             (dots Integer.zero d.vertices l) []))
     | None -> false)
