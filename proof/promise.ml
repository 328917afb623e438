(* The promise from the words of a command line; trusted are [words], which writes it as words again,
   and [same]: a promise counts only if its words are the options that were given, text for text. *)
open Checker

exception Bad of string

let bad what = raise (Bad what)
let text = Integer.to_string

(* The printer. *)

let size_word b =
  let half = Integer.to_int b.half in
  text b.num
  ^ (if Integer.equal b.den Integer.one then "" else "/" ^ text b.den)
  ^ "n"
  ^ (if half = 2 then "" else if half mod 2 = 0 then "^" ^ string_of_int (half / 2)
     else "^" ^ string_of_int half ^ "/2")
  ^ (match Integer.sign b.constant with 0 -> "" | 1 -> "+" ^ text b.constant | _ -> text b.constant)

let commas l = String.concat "," (List.map text l)

let words k =
  let g = k.lengths in
  [ ("--bends", text k.most_bends);
    ("--cosine", text (Integer.neg k.minus_p) ^ "/" ^ text k.q);
    ((if k.equal then "--exactly" else "--at-least"), "");
    ("--gram",
     commas ([ g.xx; g.yy; g.zz ]
             @ (if List.for_all (Integer.equal Integer.zero) [ g.xy; g.xz; g.yz ] then []
                else [ g.xy; g.xz; g.yz ]))
     ^ (if Integer.equal k.lengths_over Integer.one then "" else ":" ^ text k.lengths_over)) ]
  @ (if k.directions = [] then []
     else [ ("--directions", String.concat ":" (List.map (fun p -> commas [ p.px; p.py; p.pz ]) k.directions)) ])
  @ (if k.in_plane then [ ("--plane", "z=0") ] else [])
  @ (match k.size with
     | None -> []
     | Some b -> [ ("--box", String.concat "," (List.map size_word [ b.in_x; b.in_y; b.in_z ])) ])

let line k = String.concat " " (List.map (fun (a, b) -> if b = "" then a else a ^ " " ^ b) (words k))

let same value k =
  let written = words k in
  List.iter
    (fun name ->
      match value name, List.assoc_opt name written with
      | Some given, Some text when given <> text -> bad (Printf.sprintf "%s '%s' is written '%s'" name given text)
      | Some _, None -> bad (name ^ " is not in the promise that was read")
      | None, Some _ -> bad (name ^ " was not given")
      | _ -> ())
    [ "--bends"; "--cosine"; "--exactly"; "--at-least"; "--gram"; "--directions"; "--plane"; "--box" ]

(* The parser. *)

let int s = try Integer.of_string s with Invalid_argument _ -> bad ("'" ^ s ^ "' is no integer")
let integers s = List.map int (String.split_on_char ',' s)

let size_of_word s =
  let cut c s = match String.index_opt s c with
    | None -> (s, None)
    | Some i -> (String.sub s 0 i, Some (String.sub s (i + 1) (String.length s - i - 1))) in
  match cut 'n' s with
  | _, None -> bad ("'" ^ s ^ "' is no size such as 16/3n, 12n^2 or 726n^1/2+1800")
  | factor, Some rest ->
      let num, den = cut '/' factor in
      let sign_at = match String.index_opt rest '+' with None -> String.index_opt rest '-' | i -> i in
      let power, constant = match sign_at with
        | None -> (rest, Integer.zero)
        | Some i ->
            let c = String.sub rest i (String.length rest - i) in
            (String.sub rest 0 i, int (if c.[0] = '+' then String.sub c 1 (String.length c - 1) else c)) in
      let half =
        if power = "" then Integer.of_int 2
        else if power.[0] <> '^' then bad ("'" ^ s ^ "': ^ expected behind n")
        else match cut '/' (String.sub power 1 (String.length power - 1)) with
          | p, None -> Integer.mul (Integer.of_int 2) (int p)
          | p, Some _ -> int p in
      if Integer.sign half < 0 || Integer.gt half (Integer.of_int 100) then bad ("'" ^ s ^ "': the power of n");
      { num = int num; den = (match den with None -> Integer.one | Some d -> int d); half; constant }

(* [value name] is the value of an option, if it is there, and "" if it takes none. *)
let of_options value =
  let need name = match value name with Some v -> v | None -> bad (name ^ " is missing") in
  let minus_p, q = match String.split_on_char '/' (need "--cosine") with
    | [ p; q ] -> (Integer.neg (int p), int q)
    | _ -> bad "--cosine is a fraction such as -1/3" in
  let equal = match value "--exactly", value "--at-least" with
    | Some _, None -> true
    | None, Some _ -> false
    | _ -> bad "either --exactly or --at-least" in
  let gram, lengths_over = match String.split_on_char ':' (need "--gram") with
    | [ g ] -> (integers g, Integer.one)
    | [ g; d ] -> (integers g, int d)
    | _ -> bad "--gram XX,YY,ZZ[,XY,XZ,YZ][:DENOMINATOR]" in
  let zero = Integer.zero in
  let lengths = match gram with
    | [ xx; yy; zz ] -> { xx; yy; zz; xy = zero; xz = zero; yz = zero }
    | [ xx; yy; zz; xy; xz; yz ] -> { xx; yy; zz; xy; xz; yz }
    | _ -> bad "--gram has three or six numbers" in
  let direction s = match integers s with
    | [ px; py; pz ] -> { px; py; pz }
    | _ -> bad "a direction has three numbers" in
  let directions = match value "--directions" with
    | None -> []
    | Some s -> List.map direction (String.split_on_char ':' s) in
  let size = match value "--box" with
    | None -> None
    | Some s -> (match List.map size_of_word (String.split_on_char ',' s) with
        | [ in_x; in_y; in_z ] -> Some { in_x; in_y; in_z }
        | _ -> bad "--box has three sizes") in
  let most_bends = int (need "--bends") in
  if Integer.sign most_bends < 0 then bad "--bends is not negative";
  let k = { most_bends; minus_p; q; equal; lengths; lengths_over; directions;
            in_plane = value "--plane" <> None; size } in
  same value k;
  if Integer.sign lengths_over <= 0 then bad "the denominator of --gram is positive";
  if not (sane k) then bad "no promise: cosines from -1 to 0, a positive definite matrix, sizes that grow";
  k
