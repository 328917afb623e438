(* ar3d_unsatisfiable: holds formulas (DIMACS) against the proofs beside them (DRAT). *)

let usage =
  "usage: ar3d_unsatisfiable [--times] FORMULA.cnf...\n\
   The proof that FORMULA.cnf has no model is FORMULA.drat (DRAT, text or binary): every lemma has to follow by unit\n\
   propagation, until the empty clause does. --times adds seconds of reading, propagation and check.\n\
   Exit codes: 0 every formula is proved unsatisfiable; 4 one is not; 2 usage, or a file that is not read."

let stop code message = prerr_endline message; exit code

let contents name =
  try
    let file = open_in_bin name in
    Fun.protect ~finally:(fun () -> close_in file) (fun () -> really_input_string file (in_channel_length file))
  with Sys_error why -> raise (Dimacs.Bad why) | End_of_file -> raise (Dimacs.Bad (name ^ ": shorter than its size"))

let judge times name =
  let t0 = Sys.time () in
  let f = Dimacs.formula (contents name) in
  let proof = contents (Filename.chop_suffix name ".cnf" ^ ".drat") in
  let t1 = Sys.time () in
  let lemmas, count = Propagation.hints f proof in
  let t2 = Sys.time () in
  if not (Refutation.refuted f lemmas) then raise (Propagation.Refused "the hints prove nothing");
  let t3 = Sys.time () in
  let seconds = if times then Printf.sprintf " read=%.3f propagation=%.3f check=%.3f" (t1 -. t0) (t2 -. t1) (t3 -. t2) else "" in
  Printf.sprintf "clauses=%d lemmas=%d needed=%d%s" (List.length f) count (List.length lemmas) seconds

let () =
  let arguments = List.tl (Array.to_list Sys.argv) in
  if arguments = [ "--help" ] then (print_endline usage; exit 0);
  let times = List.mem "--times" arguments in
  let files = List.filter (fun a -> a <> "--times") arguments in
  List.iter (fun name -> if not (Filename.check_suffix name ".cnf") then stop 2 (name ^ ": unknown, or no file .cnf; --help")) files;
  if files = [] then stop 2 usage;
  let proved = ref 0 and refused = ref 0 and unread = ref 0 in
  let say name verdict what = Printf.printf "%s: %s %s\n%!" name verdict what in
  List.iter (fun name ->
      match judge times name with
      | what -> incr proved; say name "UNSATISFIABLE" what
      | exception Propagation.Refused why -> incr refused; say name "REFUSED" why
      | exception Dimacs.Bad why -> incr unread; say name "UNREADABLE" why) files;
  Printf.printf "unsatisfiable %d, refused %d, not read %d\n%!" !proved !refused !unread;
  exit (if !unread > 0 then 2 else if !refused > 0 then 4 else 0)
