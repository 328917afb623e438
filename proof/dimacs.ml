(* Formulas (DIMACS) and their proofs (DRAT, text or binary). What a formula says is read in any way; then [print] writes it
   as the format has it, and it counts only if that is the file, byte for byte, but for comments in front. So [print] and
   [without_comments] are trusted, [parse] and the reading of proofs are not. *)
open Refutation

exception Bad of string

let bad what = raise (Bad what)
let most = 1 lsl 30

(* Trusted. Literal 2v is variable v, 2v + 1 its negation. *)
let print variables (f : formula) =
  let b = Buffer.create 65536 in
  Printf.bprintf b "p cnf %d %d\n" variables (List.length f);
  let literal l =
    if l land 1 = 1 then Buffer.add_char b '-';
    Buffer.add_string b (string_of_int (l / 2));
    Buffer.add_char b ' ' in
  List.iter (fun c -> List.iter literal c; Buffer.add_string b "0\n") f;
  Buffer.contents b

(* Trusted: lines in front that begin with c. *)
let rec without_comments text =
  if text <> "" && text.[0] = 'c' then
    match String.index_opt text '\n' with
    | None -> ""
    | Some i -> without_comments (String.sub text (i + 1) (String.length text - i - 1))
  else text

let literal_of number =
  if number = 0 || abs number >= most then bad "no literal";
  if number > 0 then 2 * number else (-2 * number) + 1

(* The words of a text, one after the other; "" at the end. *)
let words text =
  let at = ref 0 and size = String.length text in
  let blank c = c = ' ' || c = '\n' || c = '\t' || c = '\r' in
  fun () ->
    while !at < size && blank (String.unsafe_get text !at) do incr at done;
    let start = !at in
    while !at < size && not (blank (String.unsafe_get text !at)) do incr at done;
    String.sub text start (!at - start)

let int_of word = match int_of_string_opt word with Some n -> n | None -> bad ("no number: " ^ String.escaped word)

let parse text =
  let next = words text in
  if next () <> "p" || next () <> "cnf" then bad "it does not begin with p cnf";
  let variables = int_of (next ()) in
  let _ = next () in
  let rec clause acc word =
    if word = "" then bad "the last clause does not end"
    else match int_of word with 0 -> List.rev acc | n -> clause (literal_of n :: acc) (next ()) in
  let rec clauses acc = match next () with "" -> List.rev acc | word -> clauses (clause [] word :: acc) in
  (variables, clauses [])

let formula text =
  let text = without_comments text in
  let variables, f = parse text in
  if not (String.equal (print variables f) text) then bad "not as DIMACS writes what it says";
  f

type step = Derive of int array | Delete of int array

(* Calls [f] with each step of a proof. A binary one has a byte 0 behind each step, a text has none. *)
let iter_steps f text =
  if String.contains text '\000' then begin
    let at = ref 0 and size = String.length text in
    let byte () = if !at >= size then bad "the last step does not end"; incr at; Char.code text.[!at - 1] in
    let rec number shift acc =
      let b = byte () in
      if shift > 28 then bad "no literal";
      let acc = acc lor ((b land 127) lsl shift) in
      if b > 127 then number (shift + 7) acc else acc in
    let rec literals acc = match number 0 0 with 0 -> Array.of_list (List.rev acc) | 1 -> bad "no literal" | l -> literals (l :: acc) in
    while !at < size do
      match byte () with
      | 97 -> f (Derive (literals []))
      | 100 -> f (Delete (literals []))
      | _ -> bad "a step that neither adds nor deletes"
    done
  end
  else begin
    let next = words text in
    let rec literals acc = function
      | "" -> bad "the last step does not end"
      | word -> (match int_of word with 0 -> Array.of_list (List.rev acc) | n -> literals (literal_of n :: acc) (next ())) in
    let rec go = function
      | "" -> ()
      | "d" -> f (Delete (literals [] (next ()))); go (next ())
      | word -> f (Derive (literals [] word)); go (next ()) in
    go (next ())
  end
