
val negb : bool -> bool

val fst : ('a1 * 'a2) -> 'a1

val snd : ('a1 * 'a2) -> 'a2

type comparison =
| Eq
| Lt
| Gt

val compOpp : comparison -> comparison

module Pos :
 sig
  val succ : Integer.t -> Integer.t

  val add : Integer.t -> Integer.t -> Integer.t

  val add_carry : Integer.t -> Integer.t -> Integer.t

  val pred_double : Integer.t -> Integer.t

  val mul : Integer.t -> Integer.t -> Integer.t

  val iter : ('a1 -> 'a1) -> 'a1 -> Integer.t -> 'a1

  val compare_cont : comparison -> Integer.t -> Integer.t -> comparison

  val compare : Integer.t -> Integer.t -> comparison

  val eqb : Integer.t -> Integer.t -> bool
 end

module N :
 sig
  val compare : Integer.t -> Integer.t -> comparison
 end

module Z :
 sig
  val double : Integer.t -> Integer.t

  val succ_double : Integer.t -> Integer.t

  val pred_double : Integer.t -> Integer.t

  val pos_sub : Integer.t -> Integer.t -> Integer.t

  val opp : Integer.t -> Integer.t

  val pow_pos : Integer.t -> Integer.t -> Integer.t

  val pow : Integer.t -> Integer.t -> Integer.t

  val compare : Integer.t -> Integer.t -> comparison

  val of_N : Integer.t -> Integer.t
 end

val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1

val existsb : ('a1 -> bool) -> 'a1 list -> bool

val forallb : ('a1 -> bool) -> 'a1 list -> bool

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

val ends : edge -> Integer.t * Integer.t

val turned : (Integer.t * Integer.t) -> Integer.t * Integer.t

module PositiveMap :
 sig
  type key = Integer.t

  type 'a tree =
  | Leaf
  | Node of 'a tree * 'a option * 'a tree

  type 'a t = 'a tree

  val empty : 'a1 t

  val find : key -> 'a1 t -> 'a1 option

  val mem : key -> 'a1 t -> bool

  val add : key -> 'a1 -> 'a1 t -> 'a1 t
 end

val diff : point -> point -> point

val dot : point -> point -> Integer.t

val cross : point -> point -> point

val zinner : gram -> point -> point -> Integer.t

val apart : Integer.t -> Integer.t -> Integer.t -> Integer.t -> bool

val separates : point -> point -> point -> point -> point -> bool

val boxes_apart : point -> point -> point -> point -> bool

val disjoint : point -> point -> point -> point -> bool

val angle_ok : gram -> promise -> point -> point -> point -> bool

val metric_ok : gram -> bool

val same_point : point -> point -> bool

val same_name : name -> name -> bool

val same : corner -> corner -> bool

val fine : gram -> promise -> corner -> corner -> corner -> bool

val pair_ok : gram -> promise -> segment -> segment -> bool

val parts : Integer.t

type piece = { whole : segment; from : Integer.t; till : Integer.t }

type plan =
| Together
| Cut of point * Integer.t * plan * plan
| Part of point * plan * plan * plan * plan

type advice = { cuts : plan; ratio : (Integer.t -> Integer.t -> Integer.t) }

val no_advice : advice

val each : ('a1 -> 'a2) -> 'a1 list -> 'a2 list -> 'a2 list

val sift : ('a1 -> bool) -> 'a1 list -> 'a1 list -> 'a1 list

val before : Integer.t -> piece -> piece list -> piece list

val behind : Integer.t -> piece -> piece list -> piece list

val divide :
  (Integer.t -> Integer.t -> Integer.t) -> point -> Integer.t -> piece list
  -> piece list -> piece list -> piece list * piece list

val level : point -> piece -> bool

val sloping : point -> piece -> bool

type boxed = { inside : segment; x0 : Integer.t; x1 : Integer.t;
               y0 : Integer.t; y1 : Integer.t; z0 : Integer.t; z1 : Integer.t }

val box_of : piece -> boxed

val far : boxed -> boxed -> bool

val near_ok : (segment -> segment -> bool) -> boxed -> boxed -> bool

val all_pairs : ('a1 -> 'a1 -> bool) -> 'a1 list -> bool

val across_ok :
  (segment -> segment -> bool) -> (Integer.t -> Integer.t -> Integer.t) ->
  plan -> piece list -> piece list -> bool

val pairs_ok :
  (segment -> segment -> bool) -> (Integer.t -> Integer.t -> Integer.t) ->
  plan -> piece list -> bool

type table = point PositiveMap.t

val fill : Integer.t -> point list -> table -> table

val look : table -> Integer.t -> point option

val walk :
  Integer.t -> Integer.t -> corner -> point list -> corner -> segment list ->
  segment list

val gather :
  table -> Integer.t -> edge list -> segment list -> segment list option

val dots : Integer.t -> point list -> segment list -> segment list

val count : Integer.t -> 'a1 list -> Integer.t

val pair_key : Integer.t -> (Integer.t * Integer.t) -> Integer.t

val once :
  ('a1 -> Integer.t) -> 'a1 list -> unit PositiveMap.t -> unit PositiveMap.t
  option

val graph_ok : drawing -> graph -> bool

val zero : point

val along_ok : point -> point -> bool

val direction_ok : promise -> segment -> bool

val plane_ok : promise -> drawing -> bool

val at_most_ok : bound -> Integer.t -> Integer.t -> bool

val fold_points : ('a1 -> point -> 'a1) -> drawing -> 'a1 -> 'a1

val spread : (point -> Integer.t) -> drawing -> point -> Integer.t

val box_ok : promise -> drawing -> graph -> bool

val bound_ok : bound -> bool

val sane : promise -> bool

val same_metric_ok : drawing -> promise -> bool

val check : advice -> drawing -> graph -> promise -> bool
