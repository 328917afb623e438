(* ar3d_proved: holds drawings, one a line, against the graphs of a file, one a line, and against the
   promise of the command line. *)
open Checker

let usage =
  "usage: ar3d_proved [DRAWINGS|-] --graphs FILE --bends B --cosine -P/Q --exactly|--at-least\n\
  \         --gram XX,YY,ZZ[,XY,XZ,YZ][:DENOMINATOR] [--directions X,Y,Z:X,Y,Z...] [--plane z=0]\n\
  \         [--box SIZE,SIZE,SIZE] [--pairs] [--times]\n\
   One drawing a line (JSON lines), one graph a line (graph6 or sparse6). A SIZE grows with the number n\n\
   of vertices: 16/3n, 12n^2, 726n^1/2+1800, 0n+7. The words of a theorem: ar3d list --promise ALGORITHM.\n\
   --pairs compares all pairs of segments; --times adds seconds of reading, advice and check.\n\
   Exit codes: 0 every drawing keeps the promise; 4 one does not; 2 usage, or a line that is not read."

let stop code message = prerr_endline message; exit code

(* Options with their values, each at most once, and the file of drawings. *)
let options arguments =
  let valued = [ "--graphs"; "--bends"; "--cosine"; "--gram"; "--directions"; "--plane"; "--box" ] in
  let plain = [ "--exactly"; "--at-least"; "--pairs"; "--times" ] in
  let rec go found file = function
    | [] -> (found, file)
    | name :: _ when List.mem_assoc name found -> stop 2 (name ^ " twice")
    | name :: rest when List.mem name plain -> go ((name, "") :: found) file rest
    | name :: value :: rest when List.mem name valued -> go ((name, value) :: found) file rest
    | name :: _ when String.length name > 1 && name.[0] = '-' -> stop 2 (name ^ ": unknown, or without a value; --help")
    | name :: rest when file = None -> go found (Some name) rest
    | name :: _ -> stop 2 (name ^ ": a second file of drawings") in
  go [] None arguments

let opened name = if name = "-" then stdin else try open_in_bin name with Sys_error why -> stop 2 why
let next channel = try Some (input_line channel) with End_of_file -> None

(* Whether the drawing is good, and what to say of it. *)
let judge k ~pairs ~times drawing_line graph_line =
  let t0 = Sys.time () in
  let label, d = Reader.drawing drawing_line in
  let g = Reader.graph graph_line in
  if label.real <> None && k.size <> None then
    raise (Reader.Bad "a drawing in a real type has a unit of its own: no --box");
  let t1 = Sys.time () in
  let advice = if pairs then no_advice else Advice.plan d in
  let t2 = Sys.time () in
  let good = check advice d g k in
  let t3 = Sys.time () in
  let seconds = if times then Printf.sprintf " read=%.3f advice=%.3f check=%.3f" (t1 -. t0) (t2 -. t1) (t3 -. t2) else "" in
  (good, Printf.sprintf "n=%s edges=%d%s %s" (Integer.to_string g.order) (List.length g.pairs) seconds (Promise.line k))

let () =
  let arguments = List.tl (Array.to_list Sys.argv) in
  if arguments = [ "--help" ] then (print_endline usage; exit 0);
  let found, file = options arguments in
  let value name = List.assoc_opt name found in
  let k = try Promise.of_options value with Promise.Bad why -> stop 2 why in
  let graphs = match value "--graphs" with None -> stop 2 "--graphs is missing" | Some f -> opened f in
  let drawings = opened (Option.value file ~default:"-") in
  let pairs = value "--pairs" <> None and times = value "--times" <> None in
  let good = ref 0 and refused = ref 0 and unread = ref 0 in
  let rec go number =
    match next drawings, next graphs with
    | None, None -> ()
    | drawing, graph ->
        (match
           match drawing, graph with
           | Some d, Some g -> judge k ~pairs ~times d g
           | Some _, None -> raise (Reader.Bad "no graph left")
           | None, _ -> raise (Reader.Bad "a graph without a drawing")
         with
         | true, what -> incr good; Printf.printf "%d: GOOD %s\n" number what
         | false, what -> incr refused; Printf.printf "%d: REFUSED %s\n" number what
         | exception Reader.Bad why -> incr unread; Printf.printf "%d: UNREADABLE %s\n" number why);
        if drawing <> None then go (number + 1)
  in
  go 1;
  if !good + !refused + !unread = 0 then (incr unread; print_endline "UNREADABLE nothing to check");
  Printf.printf "good %d, refused %d, not read %d\n%!" !good !refused !unread;
  exit (if !unread > 0 then 2 else if !refused > 0 then 4 else 0)
