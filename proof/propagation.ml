(* Finds the hints that [Refutation.refuted] wants: propagates units with two watched literals, lemma after lemma, and keeps
   of each one the clauses that led to its contradiction. Lemmas that nothing needs are left out at the end. Not trusted. *)

exception Refused of string

(* Arrays that grow. *)
type vector = { mutable data : int array; mutable size : int }

let vector () = { data = [||]; size = 0 }

let push v x =
  if v.size = Array.length v.data then begin
    let larger = Array.make (max 4 (2 * v.size)) 0 in
    Array.blit v.data 0 larger 0 v.size;
    v.data <- larger
  end;
  v.data.(v.size) <- x;
  v.size <- v.size + 1

(* A clause in [arena]: its length (0 when deleted), its name, its literals, of which the first two are watched. *)
type t = {
  arena : vector;
  watches : vector array; (* of each literal: pairs of a clause and a literal of it *)
  is_true : Bytes.t; (* of each literal *)
  reason : int array; (* of each variable: its clause, or -1 *)
  unit_name : int array; (* of each variable that is fixed: the name of the unit clause *)
  seen : Bytes.t; (* of each variable *)
  trail : int array; mutable trailed : int; mutable head : int; mutable fixed : int;
  by_literals : (int, int) Hashtbl.t; (* clauses by the hash of their literals *)
  mutable names : int;
  lemmas : (int * int array * string) Stack.t; (* name, literals, hints *)
}

let holds s l = Bytes.get s.is_true l <> '\000'
let length s c = s.arena.data.(c)
let name s c = s.arena.data.(c + 1)
let literal s c i = s.arena.data.(c + 2 + i)

let assign s l why =
  Bytes.set s.is_true l '\001';
  s.reason.(l / 2) <- why;
  s.trail.(s.trailed) <- l;
  s.trailed <- s.trailed + 1

(* Moves the watches of a literal that became false. The clause in which all are false, or -1. *)
let propagate_false s l =
  let w = s.watches.(l) and kept = ref 0 and i = ref 0 and conflict = ref (-1) in
  while !i < w.size do
    let c = w.data.(!i) and blocking = w.data.(!i + 1) in
    let keep other = w.data.(!kept) <- c; w.data.(!kept + 1) <- other; kept := !kept + 2 in
    i := !i + 2;
    if !conflict >= 0 || holds s blocking then keep blocking
    else begin
      let a = s.arena.data in
      let size = a.(c) in
      if size > 0 then begin
        if a.(c + 2) = l then begin a.(c + 2) <- a.(c + 3); a.(c + 3) <- l end;
        let first = a.(c + 2) in
        if holds s first then keep first
        else begin
          let k = ref 2 in
          while !k < size && holds s (a.(c + 2 + !k) lxor 1) do incr k done;
          if !k < size then begin
            let other = a.(c + 2 + !k) in
            a.(c + 3) <- other; a.(c + 2 + !k) <- l;
            push s.watches.(other) c; push s.watches.(other) first
          end
          else begin
            keep first;
            if holds s (first lxor 1) then conflict := c else assign s first c
          end
        end
      end
    end
  done;
  w.size <- !kept;
  !conflict

let rec propagate s =
  if s.head = s.trailed then -1
  else begin
    let l = s.trail.(s.head) in
    s.head <- s.head + 1;
    match propagate_false s (l lxor 1) with -1 -> propagate s | c -> c
  end

(* Hints as text: seven bits a character. *)
let packed hints =
  let b = Buffer.create 64 in
  let rec put n = if n < 128 then Buffer.add_char b (Char.chr n) else (Buffer.add_char b (Char.chr (n land 127 + 128)); put (n lsr 7)) in
  List.iter put hints;
  Buffer.contents b

let unpacked text =
  let found = ref [] and n = ref 0 and shift = ref 0 in
  String.iter (fun c ->
      n := !n lor ((Char.code c land 127) lsl !shift);
      if c < '\128' then (found := !n :: !found; n := 0; shift := 0) else shift := !shift + 7) text;
  List.rev !found

let note s literals hints =
  s.names <- s.names + 1;
  Stack.push (s.names, literals, packed hints) s.lemmas;
  s.names

(* The clauses that make all literals of clause c false, in the order of the trail, and c. *)
let hints_of s c =
  let mark c = for i = 0 to length s c - 1 do Bytes.set s.seen (literal s c i / 2) '\001' done in
  let units = ref [] and found = ref [ name s c ] in
  mark c;
  for i = s.trailed - 1 downto 0 do
    let v = s.trail.(i) / 2 in
    if Bytes.get s.seen v <> '\000' then begin
      Bytes.set s.seen v '\000';
      if i < s.fixed then units := s.unit_name.(v) :: !units
      else if s.reason.(v) >= 0 then begin
        found := name s s.reason.(v) :: !found;
        mark s.reason.(v);
        Bytes.set s.seen v '\000'
      end
    end
  done;
  !units @ !found

(* Units that follow without a decision become lemmas. Whether there is a contradiction. *)
let fix s =
  let conflict = propagate s in
  for i = s.fixed to s.trailed - 1 do
    let l = s.trail.(i) in
    let c = s.reason.(l / 2) in
    s.unit_name.(l / 2) <-
      (if length s c = 1 then name s c
       else begin
         let others = List.filter (fun k -> k <> l) (List.init (length s c) (literal s c)) in
         note s [| l |] (List.map (fun k -> s.unit_name.(k / 2)) others @ [ name s c ])
       end);
  done;
  s.fixed <- s.trailed;
  conflict >= 0 && (ignore (note s [||] (hints_of s conflict)); true)

let hash literals = Array.fold_left (fun h l -> h + (l * l * 0x9E3779B1) + (l lxor (l lsl 17))) 0 literals

(* Adds a clause with its name. Whether the empty one follows. *)
let add s named literals =
  let c = s.arena.size in
  push s.arena (Array.length literals); push s.arena named;
  let free, fallen = List.partition (fun l -> not (holds s (l lxor 1))) (Array.to_list literals) in
  List.iter (push s.arena) (free @ fallen);
  Hashtbl.add s.by_literals (hash literals) c;
  let size = Array.length literals in
  if size >= 2 then begin
    let first = literal s c 0 and second = literal s c 1 in
    push s.watches.(first) c; push s.watches.(first) second;
    push s.watches.(second) c; push s.watches.(second) first
  end;
  match free with
  | [] -> ignore (note s [||] (hints_of s c)); true
  | [ l ] -> if holds s l then false else (assign s l c; fix s)
  | _ -> false

let delete s literals =
  let sorted a = let a = Array.copy a in Array.sort compare a; a in
  let h = hash literals and wanted = sorted literals in
  let same c = length s c = Array.length literals && sorted (Array.init (length s c) (literal s c)) = wanted in
  let rec without = function [] -> (None, []) | c :: r when same c -> (Some c, r) | c :: r -> let f, l = without r in (f, c :: l) in
  (* A clause that fixed a variable stays as the lemma that says so. *)
  match without (Hashtbl.find_all s.by_literals h) with
  | None, _ -> ()
  | Some c, rest ->
      while Hashtbl.mem s.by_literals h do Hashtbl.remove s.by_literals h done;
      List.iter (Hashtbl.add s.by_literals h) (List.rev rest);
      if length s c > 1 then s.arena.data.(c) <- 0

(* Hints for a lemma: assumes that its literals are false and propagates. *)
let derive s literals =
  let already = List.find_opt (holds s) (Array.to_list literals) in
  let hints =
    match already with
    | Some l -> [ s.unit_name.(l / 2) ]
    | None ->
        Array.iter (fun l -> if not (holds s (l lxor 1)) then assign s (l lxor 1) (-1)) literals;
        let conflict = propagate s in
        if conflict < 0 then raise (Refused "does not follow by unit propagation");
        let found = hints_of s conflict in
        for i = s.fixed to s.trailed - 1 do Bytes.set s.is_true s.trail.(i) '\000' done;
        s.trailed <- s.fixed;
        s.head <- s.fixed;
        found in
  add s (note s literals hints) literals

(* The lemmas that the last one needs. *)
let needed s =
  let wanted = Bytes.make (s.names + 1) '\000' in
  Bytes.set wanted s.names '\001';
  Stack.fold (fun found (named, literals, text) ->
      if Bytes.get wanted named = '\000' then found
      else begin
        let hints = unpacked text in
        List.iter (fun h -> Bytes.set wanted h '\001') hints;
        { Refutation.name = named; claim = Array.to_list literals; hints } :: found
      end) [] s.lemmas

(* The lemmas for the checker, and how many the proof has. *)
let hints (f : Refutation.formula) proof =
  let largest = ref 1 in
  let see l = largest := max !largest l in
  List.iter (List.iter see) f;
  Dimacs.iter_steps (function Derive c | Delete c -> Array.iter see c) proof;
  let variables = (!largest / 2) + 1 in
  let s = { arena = vector (); watches = Array.init (2 * variables) (fun _ -> vector ()); is_true = Bytes.make (2 * variables) '\000';
            reason = Array.make variables (-1); unit_name = Array.make variables 0; seen = Bytes.make variables '\000';
            trail = Array.make variables 0; trailed = 0; head = 0; fixed = 0; by_literals = Hashtbl.create 65536;
            names = List.length f; lemmas = Stack.create () } in
  let count = ref 0 in
  let finished = ref false in
  List.iteri (fun i c -> if not !finished then finished := add s (i + 1) (Array.of_list (List.sort_uniq compare c))) f;
  let step = function
    | Dimacs.Delete c -> if not !finished then delete s c
    | Dimacs.Derive c ->
        incr count;
        if not !finished then
          let c = Array.of_list (List.sort_uniq compare (Array.to_list c)) in
          if not (Array.exists (fun l -> Array.mem (l lxor 1) c) c) then
            finished := (try derive s c with Refused why -> raise (Refused (Printf.sprintf "lemma %d %s" !count why))) in
  Dimacs.iter_steps step proof;
  if not !finished then raise (Refused "the empty clause is not reached");
  (needed s, !count)
