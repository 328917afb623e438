(* Not trusted: how to halve space so that few pairs of segments stay together. Wrong advice costs
   time, never truth. Coordinates are native integers, counted from the drawing's least corner, without
   their lowest bits if they are long: then a cut is not quite where it was planned. *)
open Checker

exception Too_much

let rec gcd a b = if b = 0 then abs a else gcd b (a mod b)

let primitive (a, b, c) =
  let g = gcd a (gcd b c) in
  if g = 0 then (0, 0, 0)
  else
    let s = if a < 0 || (a = 0 && (b < 0 || (b = 0 && c < 0))) then -g else g in
    (a / s, b / s, c / s)

(* A normal, tilted a little if it is long, so that its products with points are native. *)
let room = ref 0x80000
let rec short (a, b, c) =
  if abs a < !room && abs b < !room && abs c < !room then primitive (a, b, c) else short (a / 2, b / 2, c / 2)
let nought = (0, 0, 0)

let cross (a, b, c) (d, e, f) =
  let w = (1 lsl 30) in
  if List.exists (fun x -> abs x > w) [ a; b; c; d; e; f ] then nought
  else primitive ((b * f) - (c * e), (c * d) - (a * f), (a * e) - (b * d))

let usable l = List.filter (fun h -> h <> nought) (List.map short l)
let axes = [ (1, 0, 0); (0, 1, 0); (0, 0, 1) ]
let generic =
  axes @ [ (1, 1, 0); (1, -1, 0); (1, 0, 1); (1, 0, -1); (0, 1, 1); (0, 1, -1);
           (1, 1, 1); (1, 1, -1); (1, -1, 1); (-1, 1, 1) ]

let leaf = 32              (* so few are compared all with all *)

(* To divide a piece takes about as long as to compare it with so many; a cut that saves less is none. *)
let share_of_cut = 12.
let worth cost touched pairs = (1. -. cost) *. float pairs > share_of_cut *. float touched && cost < 0.95

let rec take n = function a :: r when n > 0 -> a :: take (n - 1) r | _ -> []
let rec twos = function [] -> [] | a :: r -> List.rev_append (List.rev_map (fun b -> (a, b)) r) (twos r)

(* Sorts the first n of a: they are few. *)
let sort (a : float array) n =
  for i = 1 to n - 1 do
    let x = a.(i) in
    let j = ref (i - 1) in
    while !j >= 0 && a.(!j) > x do a.(!j + 1) <- a.(!j); decr j done;
    a.(!j + 1) <- x
  done

(* A cell: numbers of segments, and between which parts of each its points there are, from 0 to 1. *)
type cell = { ids : int array; from : float array; till : float array }

let size_of cell = Array.length cell.ids
let whole ids = let n = Array.length ids in { ids; from = Array.make n 0.; till = Array.make n 1. }

(* The pieces whose segments hold, in order. *)
let part holds cell =
  let n = size_of cell in
  let ids = Array.make n 0 and from = Array.make n 0. and till = Array.make n 0. and k = ref 0 in
  for i = 0 to n - 1 do
    if holds cell.ids.(i) then begin
      ids.(!k) <- cell.ids.(i); from.(!k) <- cell.from.(i); till.(!k) <- cell.till.(i); incr k
    end
  done;
  { ids = Array.sub ids 0 !k; from = Array.sub from 0 !k; till = Array.sub till 0 !k }

let pick cell size =
  let n = size_of cell in
  let s = min n size in
  { ids = Array.init s (fun i -> cell.ids.(i * n / s)); from = Array.init s (fun i -> cell.from.(i * n / s));
    till = Array.init s (fun i -> cell.till.(i * n / s)) }

(* The segments of a drawing, its vertices among them as segments of length zero, in native integers
   without their lowest [shift] bits; and what the search for advice may still cost. *)
type work = {
  size : int;
  corner : point;   (* the least coordinates *)
  shift : int;
  extent : int;     (* no coordinate is larger *)
  x0 : int array; y0 : int array; z0 : int array;  (* where each segment begins *)
  x1 : int array; y1 : int array; z1 : int array;  (* where it ends *)
  direction : (int * int * int) array;
  mutable budget : int;
  mutable spent : int;
}

(* As many comparisons for each segment as the search may cost before it is done by directions. *)
let budget_of_segment = 120

(* The least and the largest coordinates. *)
let corners (d : drawing) =
  let least a b = if Integer.gt a b then b else a and most a b = if Integer.gt a b then a else b in
  let both f p r = { px = f p.px r.px; py = f p.py r.py; pz = f p.pz r.pz } in
  let see (low, high) p = (both least low p, both most high p) in
  let start = List.hd d.vertices in  (* a graph without vertices needs no advice: [plan] *)
  List.fold_left (fun c (e : edge) -> List.fold_left see c e.bends) (List.fold_left see (start, start) d.vertices) d.edges

let work_of (d : drawing) =
  let place = Array.of_list d.vertices in
  let corner, high = corners d in
  let far a b = Integer.numbits (Integer.sub b a) in
  let bits = max (far corner.px high.px) (max (far corner.py high.py) (far corner.pz high.pz)) in
  let shift = max 0 (bits - 38) in
  room := 1 lsl (53 - min 38 bits);
  let int z least = Integer.to_int (Integer.shift_right (Integer.sub z least) shift) in
  let size = List.fold_left (fun s (e : edge) -> s + 1 + List.length e.bends) (Array.length place) d.edges in
  let zeros () = Array.make size 0 in
  let x0 = zeros () and y0 = zeros () and z0 = zeros () in
  let x1 = zeros () and y1 = zeros () and z1 = zeros () in
  let at = ref 0 in
  let add p r =
    let i = !at in
    incr at;
    x0.(i) <- int p.px corner.px; y0.(i) <- int p.py corner.py; z0.(i) <- int p.pz corner.pz;
    x1.(i) <- int r.px corner.px; y1.(i) <- int r.py corner.py; z1.(i) <- int r.pz corner.pz in
  Array.iter (fun p -> add p p) place;
  List.iter
    (fun (e : edge) ->
      let v i = place.(Integer.to_int i) in
      add (List.fold_left (fun a b -> add a b; b) (v e.tail) e.bends) (v e.head))
    d.edges;
  let direction = Array.init size (fun i -> primitive (x1.(i) - x0.(i), y1.(i) - y0.(i), z1.(i) - z0.(i))) in
  { size; corner; shift; extent = 1 lsl (bits - shift); x0; y0; z0; x1; y1; z1; direction; budget = budget_of_segment * size; spent = 0 }

let spend work cost =
  work.spent <- work.spent + cost;
  if work.spent > work.budget then raise Too_much

(* The product of a normal with the first and the last point of segment j. *)
let start_of w (a, b, c) j = (a * w.x0.(j)) + (b * w.y0.(j)) + (c * w.z0.(j))
let end_of w (a, b, c) j = (a * w.x1.(j)) + (b * w.y1.(j)) + (c * w.z1.(j))

(* Is segment j parallel to the planes of this normal? *)
let level w (a, b, c) j =
  let (e, f, g) = w.direction.(j) in
  (a * e) + (b * f) + (c * g) = 0

(* ---- Where to cut: normals are tried on a sample of the segments. *)

let lows = Array.make 80 0.
let highs = Array.make 80 0.
let places = Array.make 160 0.

(* A sample of two cells, the first of them [first] pieces long; of pairs within one cell, of that cell. *)
type sample = { of_both : cell; first : int; one : bool }

let sample_of a b size =
  let one = a == b in
  let of_a = pick a size in
  let of_b = if one then whole [||] else pick b size in
  { of_both = { ids = Array.append of_a.ids of_b.ids; from = Array.append of_a.from of_b.from; till = Array.append of_a.till of_b.till };
    first = size_of of_a; one }

(* Puts where the segments of a sample lie along a normal into lows and highs, and sorts the places for cuts: the
   middles of the segments, or their ends. Returns how many places there are. *)
let spread work normal sample of_ends =
  let cell = sample.of_both in
  let n = size_of cell in
  for i = 0 to n - 1 do
    let j = cell.ids.(i) in
    let a = start_of work normal j and b = end_of work normal j in
    let u = float a +. (cell.from.(i) *. float (b - a)) and v = float a +. (cell.till.(i) *. float (b - a)) in
    let low = if u < v then u else v and high = if u < v then v else u in
    lows.(i) <- low;
    highs.(i) <- high;
    if of_ends then (places.(2 * i) <- low -. 1.; places.((2 * i) + 1) <- high)
    else places.(i) <- (low +. high) /. 2.
  done;
  let count = if of_ends then 2 * n else n in
  sort places count;
  count

(* The share of pairs that stay together after a cut at this place. *)
let share_together sample place =
  let below from till = let k = ref 0 in for i = from to till do if lows.(i) <= place then incr k done; !k in
  let above from till = let k = ref 0 in for i = from to till do if highs.(i) > place then incr k done; !k in
  let first = sample.first and n = size_of sample.of_both in
  let below_a = below 0 (first - 1) and above_a = above 0 (first - 1) in
  let below_b = if sample.one then below_a else below first (n - 1) in
  let above_b = if sample.one then above_a else above first (n - 1) in
  let pairs = first * if sample.one then first else n - first in
  float ((below_a * below_b) + (above_a * above_b)) /. float pairs

(* The best of [found] = (cost, (normal, place)) and of cuts along these normals at these sixteenths. *)
let search work sample sixteenths of_ends normals found =
  List.fold_left
    (fun found normal ->
      let count = spread work normal sample of_ends in
      List.fold_left
        (fun (cost, cut) sixteenth ->
          let place = places.(sixteenth * (count - 1) / 16) in
          let share = share_together sample place in
          if share < cost then (share, (normal, place)) else (cost, cut))
        found sixteenths)
    found normals

let normals_of directions = usable (List.map (fun (a, b) -> cross a b) (twos directions))

(* Normals of planes that hold directions of the segments themselves. *)
let normals_between work a b =
  let some cell = Array.to_list (Array.map (fun j -> work.direction.(j)) (pick cell 7).ids) in
  let directions = List.sort_uniq compare (List.filter (fun d -> d <> nought) (some a @ some b)) in
  let beside_axes = usable (List.concat_map (fun d -> List.map (cross d) axes) directions) in
  List.sort_uniq compare (normals_of directions @ beside_axes)

(* Where to cut two lists at once (the same list for pairs of one): (cost, (normal, place)). Many pairs are worth a
   finer search if the first cut is a bad one. *)
let best work candidates a b =
  let pairs = size_of a * size_of b in
  let found = search work (sample_of a b 20) [ 6; 8; 10 ] false candidates (infinity, ((1, 0, 0), 0.)) in
  let found =
    if fst found > 0.75 && pairs > 1500 then
      search work (sample_of a b 40) [ 1; 3; 5; 7; 8; 9; 11; 13; 15 ] true candidates found
    else found in
  if fst found > 0.6 && pairs > 20000 then
    search work (sample_of a b 40) [ 2; 4; 6; 7; 8; 9; 10; 12; 14 ] false (normals_between work a b) found
  else found

(* ---- Halving space along normals. *)

let point (a, b, c) m = { px = Integer.of_int (m * a); py = Integer.of_int (m * b); pz = Integer.of_int (m * c) }

(* Cuts stand at odd multiples of 1 / scale, where no corner is. *)
let scale_of work (a, b, c) = if (abs a + abs b + abs c) * work.extent < 1 lsl 30 then 64 else 2
let exact scale place = int_of_float (floor (place *. float scale)) lor 1

let cut work (normal, place) low high =
  let scale = scale_of work normal in
  let h = point normal scale and c = work.corner in
  let at_corner = Integer.add (Integer.mul h.px c.px) (Integer.add (Integer.mul h.py c.py) (Integer.mul h.pz c.pz)) in
  Cut (h, Integer.add at_corner (Integer.shift_left (Integer.of_int (exact scale place)) work.shift), low, high)

let beyond = 1e-6  (* the checker keeps a little more than what is on a side *)

let divide work (normal, place) cell =
  let n = size_of cell in
  let side () = { ids = Array.make n 0; from = Array.make n 0.; till = Array.make n 0. } in
  let low = side () and high = side () and l = ref 0 and h = ref 0 in
  let scale = scale_of work normal in
  let place = exact scale place in
  let put side k j from till =
    if from <= till then (side.ids.(!k) <- j; side.from.(!k) <- from; side.till.(!k) <- till; incr k) in
  for i = 0 to n - 1 do
    let j = cell.ids.(i) and from = cell.from.(i) and till = cell.till.(i) in
    let a = scale * start_of work normal j and b = scale * end_of work normal j in
    if a <= place && b <= place then put low l j from till
    else if a > place && b > place then put high h j from till
    else begin
      let t = float (place - a) /. float (b - a) in
      let before = min till (t +. beyond) and behind = max from (t -. beyond) in
      if a < b then (put low l j from before; put high h j behind till)
      else (put high h j from before; put low l j behind till)
    end
  done;
  let cut side k = { ids = Array.sub side.ids 0 k; from = Array.sub side.from 0 k; till = Array.sub side.till 0 k } in
  (cut low !l, cut high !h)

(* A cut of n pieces that leaves nearly all of them on both sides. *)
let idle n below above = 8 * (size_of below + size_of above) > 15 * n

let rec halve work candidates ids depth =
  let n = size_of ids in
  spend work n;
  let all () = spend work (n * n / 2); Together in
  if n <= leaf || depth = 0 then all ()
  else
    let (cost, where) = best work candidates ids ids in
    if not (worth cost n (n * n / 2)) then all ()
    else
      let (below, above) = divide work where ids in
      if idle n below above then all ()
      else
        let low = halve work candidates below (depth - 1) in
        cut work where low (halve work candidates above (depth - 1))

(* The same for pairs of one segment of a and one of b. *)
let rec halve_pairs work candidates a b depth =
  let segments = size_of a + size_of b and pairs = size_of a * size_of b in
  spend work segments;
  let all () = spend work pairs; Together in
  if pairs <= leaf * segments / 2 || depth = 0 then all ()
  else
    let (cost, where) = best work candidates a b in
    if not (worth cost segments pairs) then all ()
    else
      let (below_a, above_a) = divide work where a and (below_b, above_b) = divide work where b in
      if idle (size_of a) below_a above_a && idle (size_of b) below_b above_b then all ()
      else
        let low = halve_pairs work candidates below_a below_b (depth - 1) in
        cut work where low (halve_pairs work candidates above_a above_b (depth - 1))

(* ---- By directions, where space alone does not part the segments. *)

let direction_sample = 240
let deepest_halving = 60

(* The most frequent directions, each of at least one segment in twelve. *)
let frequent work ids =
  let times = Hashtbl.create 64 and total = ref 0 in
  Array.iter
    (fun j ->
      let d = work.direction.(j) in
      if d <> nought then begin
        incr total;
        Hashtbl.replace times d (1 + try Hashtbl.find times d with Not_found -> 0)
      end)
    (pick ids direction_sample).ids;
  let often = Hashtbl.fold (fun d n l -> if n * 12 >= !total && n > 1 then (n, d) :: l else l) times [] in
  List.map snd (List.sort (fun a b -> compare b a) often)

(* The share of the segments that run in one of these directions. *)
let share work directions ids =
  let sample = (pick ids direction_sample).ids in
  let runs j = work.direction.(j) = nought || List.mem work.direction.(j) directions in
  let count = Array.fold_left (fun k j -> if runs j then k + 1 else k) 0 sample in
  float count /. float (max 1 (Array.length sample))

(* Normals that part segments of these directions. *)
let inside = function
  | [] -> []
  | [ d ] -> usable (d :: List.map (cross d) axes)
  | directions ->
      let normals = normals_of directions in
      let both ((a, b, c), (d, e, f)) = [ (a + d, b + e, c + f); (a - d, b - e, c - f) ] in
      let sums = List.concat_map both (twos directions) in
      usable (normals @ List.concat_map (fun h -> List.map (cross h) (directions @ sums)) normals)

let candidates directions rest =
  take 24 (List.sort_uniq compare (inside (take 2 directions))) @ (if rest then generic else axes)

let halve_by_directions work ids =
  let l = frequent work ids in
  halve work (candidates l (share work l ids < 0.9)) ids deepest_halving

let halve_pairs_by_directions work a b =
  let l = frequent work a and m = frequent work b in
  let rest = share work l a < 0.9 || share work m b < 0.9 in
  halve_pairs work (candidates (List.sort_uniq compare (take 2 l @ take 2 m)) rest) a b deepest_halving

(* The normal whose planes part the list into the most even halves: segments in such planes, and the others. *)
let parting work ids =
  let askew d = cross d (3, 7, 11) in
  let normals = usable (match frequent work ids with
    | [] -> []
    | [ d ] -> if share work [ d ] ids > 0.95 then [] else [ askew d ]
    | l -> normals_of (take 7 l) @ List.map askew (take 7 l)) in
  let sample = (pick ids direction_sample).ids in
  let n = Array.length sample in
  let evener (most, best) normal =
    let count = Array.fold_left (fun k j -> if level work normal j then k + 1 else k) 0 sample in
    let smaller = min count (n - count) in
    if smaller > most then (smaller, Some normal) else (most, best) in
  snd (List.fold_left evener (n / 20, None) normals)

let apart work normal ids = (part (level work normal) ids, part (fun j -> not (level work normal j)) ids)

let few_to_part = 400
let few_pairs_to_part = 20000
let deepest_parting = 6

let rec part_one work ids depth =
  match if size_of ids <= few_to_part || depth = 0 then None else parting work ids with
  | None -> halve_by_directions work ids
  | Some normal ->
      let (a, b) = apart work normal ids in
      Part (point normal 1, part_one work a (depth - 1), part_pairs work a b deepest_parting,
            Together, part_one work b (depth - 1))

and part_pairs work a b depth =
  let normal =
    if size_of a * size_of b <= few_pairs_to_part || depth = 0 then None
    else match parting work a with Some h -> Some h | None -> parting work b in
  match normal with
  | None -> halve_pairs_by_directions work a b
  | Some h ->
      let (a1, a2) = apart work h a and (b1, b2) = apart work h b in
      Part (point h 1, part_pairs work a1 b1 (depth - 1), part_pairs work a1 b2 (depth - 1),
            part_pairs work a2 b1 (depth - 1), part_pairs work a2 b2 (depth - 1))

let few_segments = 200

(* The plain way first; if it costs too much and most segments run in a few directions, by these. *)
let make (d : drawing) : plan =
  let work = work_of d in
  let all = whole (Array.init work.size (fun i -> i)) in
  if share work (frequent work all) all < 0.9 then work.budget <- max_int;
  if work.size <= few_segments then Together
  else
    try halve work generic all deepest_halving
    with Too_much ->
      work.budget <- max_int;
      part_one work all deepest_parting

(* A quotient rounded down. *)
let ratio n d = if Integer.sign d = 0 then Integer.zero else Integer.fdiv n d

(* Nothing that fails here is a reason to refuse. *)
let plan d = { cuts = (try make d with _ -> Together); ratio }
