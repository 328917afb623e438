(* Drawings (JSON lines) and graphs (graph6, sparse6). What a line says is read in any way at all;
   then [print_drawing] or [print_graph] writes it as the format has it, and the line counts only if
   it is that text, byte for byte. So the two printers are trusted, the parsers are not. *)
open Checker

exception Bad of string

let bad what = raise (Bad what)

(* What a line says besides the drawing: its algorithm, of a drawing in a real type the type and the
   exponent of the unit 2^e, and names of vertices, which nothing looks at. *)
type label = { algorithm : string; real : (string * Integer.t) option; names : string list option }

let cube = { xx = Integer.one; yy = Integer.one; zz = Integer.one;
             xy = Integer.zero; xz = Integer.zero; yz = Integer.zero }

(* Printers: trusted. What two different readings would print alike they do not print. *)

let print_drawing label d =
  if label.real <> None && not (d.metric = cube && Integer.equal d.over Integer.one) then
    bad "a drawing in a real type has the metric of the cube";
  let b = Buffer.create 65536 in
  let put = Buffer.add_string b in
  let int z = put (Integer.to_string z) in
  let text s =
    if String.exists (fun c -> c < ' ' || c = '"' || c = '\\') s then bad "a text with an escape";
    put "\""; put s; put "\"" in
  let list f l =
    put "[";
    List.iteri (fun i a -> if i > 0 then put ","; f a) l;
    put "]" in
  let coordinate z = if label.real = None then int z else (put "\""; int z; put "\"") in
  let point p = list coordinate [ p.px; p.py; p.pz ] in
  let g = d.metric in
  put "{\"n\":"; put (string_of_int (List.length d.vertices));
  put ",\"algorithm\":"; text label.algorithm;
  (match label.real with
   | None ->
       put ",\"gram\":";
       list (list int) [ [ g.xx; g.xy; g.xz ]; [ g.xy; g.yy; g.yz ]; [ g.xz; g.yz; g.zz ] ];
       put ",\"gram_denominator\":"; int d.over
   | Some (name, exponent) ->
       put ",\"real_type\":"; text name; put ",\"unit_exponent\":"; int exponent);
  put ",\"vertices\":"; list point d.vertices;
  put ",\"edges\":";
  list (fun e -> put "["; int e.tail; put ","; int e.head; put ","; list point e.bends; put "]") d.edges;
  Option.iter (fun names -> put ",\"names\":"; list text names) label.names;
  put "}";
  Buffer.contents b

(* Six bits a character, the first one highest; [fill] ends the last character. *)
let sixes put n bits fill =
  let char c = put (Char.chr (63 + c)) in
  let rec digits k = if k > 0 then (char ((n lsr (6 * (k - 1))) land 63); digits (k - 1)) in
  if n < 63 then digits 1
  else if n < 258048 then (char 63; digits 3)
  else (char 63; char 63; digits 6);
  let buffer = ref 0 and used = ref 0 in
  bits (fun bit ->
      buffer := (!buffer lsl 1) lor bit;
      incr used;
      if !used = 6 then (char !buffer; buffer := 0; used := 0));
  if !used > 0 then char ((!buffer lsl (6 - !used)) lor fill (6 - !used))

(* nauty's formats.txt; the pairs (u, v) with u < v < n in ascending order of (v, u); sparse6 may
   hold loops and a pair twice. *)
let print_graph sparse n pairs =
  let b = Buffer.create 1024 in
  ignore (List.fold_left
            (fun (v', u') (u, v) ->
              let ascend = if sparse then u <= v && v' <= v else u < v && (v' < v || (v' = v && u' < u)) in
              if not (0 <= u && v < n && ascend) then bad "pairs of vertices that do not ascend";
              (v, u))
            (0, 0) pairs);
  if not sparse then
    sixes (Buffer.add_char b) n
      (fun bit ->
        let left = ref pairs in
        for v = 1 to n - 1 do
          for u = 0 to v - 1 do
            match !left with
            | (u', v') :: rest when u = u' && v = v' -> bit 1; left := rest
            | _ -> bit 0
          done
        done)
      (fun _ -> 0)
  else begin
    Buffer.add_char b ':';
    let rec width m = if m = 0 then 0 else 1 + width (m lsr 1) in
    let k = if n = 0 then 0 else width (n - 1) in
    let current = ref 0 in
    let number bit x = for i = k - 1 downto 0 do bit ((x lsr i) land 1) done in
    sixes (Buffer.add_char b) n
      (fun bit ->
        List.iter
          (fun (u, v) ->
            if v = !current then bit 0
            else if v = !current + 1 then bit 1
            else (bit 1; number bit v; bit 0);
            current := v;
            number bit u)
          pairs)
      (fun rest ->
        let ones = (1 lsl rest) - 1 in
        if n = 1 lsl k && !current = n - 2 && rest > k then ones lsr 1 else ones)
  end;
  Buffer.contents b

(* Parsers. *)

let longest_number = 1000  (* characters with the sign, as in formats/drawings/drawing_jsonl_reader.cpp *)

let parse_drawing line =
  if String.contains line '\000' then bad "a NUL byte";
  let i = ref 0 in
  let length = String.length line in
  let peek () = if !i < length then String.unsafe_get line !i else '\000' in
  let fail what = bad (Printf.sprintf "%s expected at byte %d" what (!i + 1)) in
  let eat text =
    let l = String.length text in
    if !i + l > length || String.sub line !i l <> text then fail text;
    i := !i + l in
  let text () =
    eat "\"";
    match String.index_from_opt line !i '"' with
    | None -> fail "\""
    | Some till ->
        let s = String.sub line !i (till - !i) in
        i := till + 1;
        s in
  let int () =
    let from = !i in
    if peek () = '-' then incr i;
    let digits = !i in
    while (match peek () with '0' .. '9' -> true | _ -> false) do incr i done;
    if !i = digits then fail "an integer";
    if !i - from > longest_number then bad (Printf.sprintf "a number of more than %d characters" longest_number);
    if !i - from < 18 then Integer.of_int (int_of_string (String.sub line from (!i - from)))
    else Integer.of_string (String.sub line from (!i - from)) in
  let list item =
    eat "[";
    if peek () = ']' then (incr i; [])
    else
      let rec more acc =
        let acc = item () :: acc in
        if peek () = ',' then (incr i; more acc) else (eat "]"; List.rev acc) in
      more [] in
  eat "{\"n\":";
  ignore (int ());
  eat ",\"algorithm\":";
  let algorithm = text () in
  eat ",\"";
  let real, (metric, over) =
    if peek () = 'g' then begin
      eat "gram\":";
      match list (fun () -> list int) with
      | [ [ xx; xy; xz ]; [ _; yy; yz ]; [ _; _; zz ] ] ->
          eat ",\"gram_denominator\":";
          (None, ({ xx; yy; zz; xy; xz; yz }, int ()))
      | _ -> bad "a Gram matrix has three rows of three"
    end else begin
      eat "real_type\":";
      let name = text () in
      eat ",\"unit_exponent\":";
      (Some (name, int ()), (cube, Integer.one))
    end in
  let coordinate () =
    if real = None then int () else (eat "\""; let z = int () in eat "\""; z) in
  let point () =
    eat "[";
    let px = coordinate () in
    eat ",";
    let py = coordinate () in
    eat ",";
    let pz = coordinate () in
    eat "]";
    { px; py; pz } in
  eat ",\"vertices\":";
  let vertices = list point in
  eat ",\"edges\":";
  let edges =
    list (fun () ->
        eat "[";
        let tail = int () in
        eat ",";
        let head = int () in
        eat ",";
        let bends = list point in
        eat "]";
        if Integer.sign tail < 0 || Integer.sign head < 0 then bad "a negative vertex";
        { tail; head; bends }) in
  let names = if peek () = ',' then (eat ",\"names\":"; Some (list text)) else None in
  eat "}";
  ({ algorithm; real; names }, { vertices; edges; metric; over })

(* n, whether it is sparse6, and the pairs. *)
let parse_graph line =
  let sparse = line <> "" && line.[0] = ':' in
  let at = ref (if sparse then 1 else 0) in
  let byte () =
    if !at >= String.length line then bad "the graph is too short";
    let b = Char.code line.[!at] - 63 in
    incr at;
    if b < 0 || b > 63 then bad "a character that no graph has";
    b in
  let rec number k acc = if k = 0 then acc else number (k - 1) ((acc lsl 6) lor byte ()) in
  let n = match byte () with
    | 63 -> (match byte () with 63 -> number 6 0 | b -> number 2 b)
    | b -> b in
  let left = ref 0 and buffer = ref 0 in
  let bit () =
    if !left = 0 then (buffer := byte (); left := 6);
    decr left;
    (!buffer lsr !left) land 1 in
  let pairs = ref [] in
  if sparse then begin
    let rec width m = if m = 0 then 0 else 1 + width (m lsr 1) in
    let k = if n = 0 then 0 else width (n - 1) in
    let v = ref 0 in
    try
      while !at < String.length line || !left > k do
        if bit () = 1 then incr v;
        let x = ref 0 in
        for _ = 1 to k do x := (!x lsl 1) lor bit () done;
        if !x >= n || !v >= n then raise Exit;
        if !x > !v then v := !x else pairs := (!x, !v) :: !pairs
      done
    with Exit -> ()
  end
  else begin
    if n > 100000 then bad "a graph6 line of more than 100000 vertices";
    for v = 1 to n - 1 do for u = 0 to v - 1 do if bit () = 1 then pairs := (u, v) :: !pairs done done
  end;
  (sparse, n, List.rev !pairs)

let same text line = if not (String.equal text line) then bad "not as the format writes what it says"

let drawing line =
  let label, d = parse_drawing line in
  same (print_drawing label d) line;
  (label, d)

let graph line =
  let sparse, n, pairs = parse_graph line in
  same (print_graph sparse n pairs) line;
  { order = Integer.of_int n;
    pairs = List.rev_map (fun (u, v) -> (Integer.of_int u, Integer.of_int v)) pairs }
