(* Not trusted: how to halve space so that few pairs of segments stay together. Wrong advice costs
   time, never truth. Coordinates are native integers, without their lowest bits if they are long:
   then a cut is not quite where it was planned. *)
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

(* To divide a segment takes about as long as to compare it with so many; a cut that saves less is none. *)
let share_of_cut = 12.
let worth cost touched pairs = (1. -. cost) *. float pairs > share_of_cut *. float touched && cost < 0.95

let rec take n = function a :: r when n > 0 -> a :: take (n - 1) r | _ -> []
let rec twos = function [] -> [] | a :: r -> List.rev_append (List.rev_map (fun b -> (a, b)) r) (twos r)

(* Sorts the first n of a: they are few. *)
let sort a n =
  for i = 1 to n - 1 do
    let x = a.(i) in
    let j = ref (i - 1) in
    while !j >= 0 && a.(!j) > x do a.(!j + 1) <- a.(!j); decr j done;
    a.(!j + 1) <- x
  done

(* The numbers of ids that hold, in order. *)
let part holds ids =
  let n = Array.length ids in
  let out = Array.make n 0 and k = ref 0 in
  for i = 0 to n - 1 do
    let j = Array.unsafe_get ids i in
    if holds j then (Array.unsafe_set out !k j; incr k)
  done;
  Array.sub out 0 !k

let pick ids size =
  let n = Array.length ids in
  let s = min n size in
  Array.init s (fun i -> ids.(i * n / s))

let make (d : drawing) : plan =
  let place = Array.of_list d.vertices in
  let bits = ref 0 in
  let see p = List.iter (fun z -> bits := max !bits (Integer.numbits z)) [ p.px; p.py; p.pz ] in
  Array.iter see place;
  List.iter (fun (e : edge) -> List.iter see e.bends) d.edges;
  let shift = max 0 (!bits - 38) in
  room := 1 lsl (57 - min 38 !bits);
  let int z = Integer.to_int (Integer.shift_right z shift) in
  let size = List.fold_left (fun s (e : edge) -> s + 1 + List.length e.bends) (Array.length place) d.edges in
  let x0 = Array.make size 0 and y0 = Array.make size 0 and z0 = Array.make size 0 in
  let x1 = Array.make size 0 and y1 = Array.make size 0 and z1 = Array.make size 0 in
  let at = ref 0 in
  let add p r =
    let i = !at in
    incr at;
    x0.(i) <- int p.px; y0.(i) <- int p.py; z0.(i) <- int p.pz;
    x1.(i) <- int r.px; y1.(i) <- int r.py; z1.(i) <- int r.pz in
  Array.iter (fun p -> add p p) place;
  List.iter
    (fun (e : edge) ->
      let v i = place.(Integer.to_int i) in
      add (List.fold_left (fun a b -> add a b; b) (v e.tail) e.bends) (v e.head))
    d.edges;
  let direction = Array.init size (fun i -> primitive (x1.(i) - x0.(i), y1.(i) - y0.(i), z1.(i) - z0.(i))) in
  let budget = ref (120 * size) and spent = ref 0 in
  let spend k = spent := !spent + k; if !spent > !budget then raise Too_much in
  let low_of (a, b, c) j =
    min ((a * x0.(j)) + (b * y0.(j)) + (c * z0.(j))) ((a * x1.(j)) + (b * y1.(j)) + (c * z1.(j))) in
  let high_of (a, b, c) j =
    max ((a * x0.(j)) + (b * y0.(j)) + (c * z0.(j))) ((a * x1.(j)) + (b * y1.(j)) + (c * z1.(j))) in
  let level (a, b, c) j = let (e, f, g) = direction.(j) in (a * e) + (b * f) + (c * g) = 0 in
  (* the most frequent directions, each of at least one in twelve *)
  let frequent ids =
    let t = Hashtbl.create 64 and total = ref 0 in
    Array.iter
      (fun j ->
        let k = direction.(j) in
        if k <> nought then begin
          incr total;
          Hashtbl.replace t k (1 + try Hashtbl.find t k with Not_found -> 0)
        end)
      (pick ids 240);
    let l = Hashtbl.fold (fun k n l -> if n * 12 >= !total && n > 1 then (n, k) :: l else l) t [] in
    List.map snd (List.sort (fun a b -> compare b a) l) in
  let normals l = usable (List.map (fun (a, b) -> cross a b) (twos l)) in
  let lows = Array.make 80 0 and highs = Array.make 80 0 and places = Array.make 160 0 in
  (* where to cut two lists at once (the same list for pairs of one): cost, normal, place *)
  let best candidates a b =
    let one = a == b in
    let cost = ref infinity and what = ref ((1, 0, 0), 0) in
    let search candidates samples quantiles of_ends =
      let sa = pick a samples in
      let sb = if one then [||] else pick b samples in
      let na = Array.length sa and nb = Array.length sb in
      let n = na + nb in
      List.iter
        (fun h ->
          for i = 0 to n - 1 do
            let j = if i < na then sa.(i) else sb.(i - na) in
            let u = low_of h j and v = high_of h j in
            lows.(i) <- u;
            highs.(i) <- v;
            if of_ends then (places.(2 * i) <- u - 1; places.((2 * i) + 1) <- v)
            else places.(i) <- (u + v) asr 1
          done;
          let s = if of_ends then 2 * n else n in
          sort places s;
          List.iter
            (fun k ->
              let c = places.(k * (s - 1) / 16) in
              let below from till = let k = ref 0 in for i = from to till do if lows.(i) <= c then incr k done; !k in
              let above from till = let k = ref 0 in for i = from to till do if highs.(i) > c then incr k done; !k in
              let la = below 0 (na - 1) and ha = above 0 (na - 1) in
              let lb = if one then la else below na (n - 1) and hb = if one then ha else above na (n - 1) in
              let x = float ((la * lb) + (ha * hb)) /. float (na * if one then na else nb) in
              if x < !cost then (cost := x; what := (h, c)))
            quantiles)
        candidates in
    let pairs = Array.length a * Array.length b in
    search candidates 20 [ 6; 8; 10 ] false;
    if !cost > 0.75 && pairs > 1500 then search candidates 40 [ 1; 3; 5; 7; 8; 9; 11; 13; 15 ] true;
    if !cost > 0.6 && pairs > 20000 then begin
      let some x = Array.to_list (Array.map (fun j -> direction.(j)) (pick x 7)) in
      let d = List.sort_uniq compare (List.filter (fun d -> d <> nought) (some a @ some b)) in
      let more = normals d @ usable (List.concat_map (fun d -> List.map (cross d) axes) d) in
      search (List.sort_uniq compare more) 40 [ 2; 4; 6; 7; 8; 9; 10; 12; 14 ] false
    end;
    (!cost, !what) in
  let point (a, b, c) m = { px = Integer.of_int (m * a); py = Integer.of_int (m * b); pz = Integer.of_int (m * c) } in
  (* h . x = c + 1/2, times two *)
  let cut (h, c) low high = Cut (point h 2, Integer.shift_left (Integer.of_int ((2 * c) + 1)) shift, low, high) in
  let divide (h, c) ids = (part (fun j -> low_of h j <= c) ids, part (fun j -> high_of h j > c) ids) in
  let rec halve candidates ids depth =
    let n = Array.length ids in
    spend n;
    let all () = spend (n * n / 2); Together in
    if n <= leaf || depth = 0 then all ()
    else
      let (cost, where) = best candidates ids ids in
      if not (worth cost n (n * n / 2)) then all ()
      else
        let (a, b) = divide where ids in
        let low = halve candidates a (depth - 1) in
        cut where low (halve candidates b (depth - 1)) in
  let rec halve2 candidates a b depth =
    let n = Array.length a * Array.length b in
    spend (Array.length a + Array.length b);
    let all () = spend n; Together in
    if n <= leaf * (Array.length a + Array.length b) / 2 || depth = 0 then all ()
    else
      let (cost, where) = best candidates a b in
      if not (worth cost (Array.length a + Array.length b) n) then all ()
      else
        let (a1, a2) = divide where a and (b1, b2) = divide where b in
        let low = halve2 candidates a1 b1 (depth - 1) in
        cut where low (halve2 candidates a2 b2 (depth - 1)) in
  let inside = function
    | [] -> []
    | [ d ] -> usable (d :: List.map (cross d) axes)
    | l ->
        let n = normals l in
        let sums = List.concat_map (fun ((a, b, c), (d, e, f)) -> [ (a + d, b + e, c + f); (a - d, b - e, c - f) ]) (twos l) in
        usable (n @ List.concat_map (fun h -> List.map (cross h) (l @ sums)) n) in
  let candidates l rest = take 24 (List.sort_uniq compare (inside (take 2 l))) @ (if rest then generic else axes) in
  let share l ids = (* of the segments in one of these directions *)
    let s = pick ids 240 in
    let k = Array.fold_left (fun k j -> if direction.(j) = nought || List.mem direction.(j) l then k + 1 else k) 0 s in
    float k /. float (max 1 (Array.length s)) in
  (* the plane that parts the list into the most even halves *)
  let parting ids =
    let askew d = cross d (3, 7, 11) in
    let l = frequent ids in
    let hs = usable (match l with
      | [] -> []
      | [ d ] -> if share l ids > 0.95 then [] else [ askew d ]
      | l -> normals (take 7 l) @ List.map askew (take 7 l)) in
    let s = pick ids 240 in
    let n = Array.length s in
    snd (List.fold_left
           (fun (k, best) h ->
             let m = Array.fold_left (fun k j -> if level h j then k + 1 else k) 0 s in
             let m = min m (n - m) in
             if m > k then (m, Some h) else (k, best))
           (n / 20, None) hs) in
  let apart h ids = (part (level h) ids, part (fun j -> not (level h j)) ids) in
  let finish ids = let l = frequent ids in halve (candidates l (share l ids < 0.9)) ids 60 in
  let finish2 a b =
    let l = frequent a and m = frequent b in
    let rest = share l a < 0.9 || share m b < 0.9 in
    halve2 (candidates (List.sort_uniq compare (take 2 l @ take 2 m)) rest) a b 60 in
  let rec single ids depth =
    if Array.length ids <= 400 || depth = 0 then finish ids
    else match parting ids with
      | None -> finish ids
      | Some h ->
          let (a, b) = apart h ids in
          Part (point h 1, single a (depth - 1), double a b 6, Together, single b (depth - 1))
  and double a b depth =
    if Array.length a * Array.length b <= 20000 || depth = 0 then finish2 a b
    else
      match (match parting a with Some h -> Some h | None -> parting b) with
      | None -> finish2 a b
      | Some h ->
          let (a1, a2) = apart h a and (b1, b2) = apart h b in
          Part (point h 1, double a1 b1 (depth - 1), double a1 b2 (depth - 1),
                double a2 b1 (depth - 1), double a2 b2 (depth - 1)) in
  let all = Array.init size (fun i -> i) in
  (* the plain way first; if it costs too much, by directions *)
  if size <= 200 then Together
  else
    try halve generic all 60
    with Too_much -> budget := max_int; single all 6

(* Nothing that fails here is a reason to refuse. *)
let plan d = try make d with _ -> Together
