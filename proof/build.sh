#!/usr/bin/env bash
# Compiles the program OUTPUT of the extracted checker of drawings, and beside it ar3d_unsatisfiable of that of refutations; with
# --prove, proves first and extracts into the folder of OUTPUT.
#   proof/build.sh OUTPUT            needs ocamlfind, ocamlopt and zarith
#   proof/build.sh --prove OUTPUT    needs coqc, too; fails unless the extracted files are those that are committed
set -euo pipefail
prove=
if [ "${1:-}" = --prove ]; then prove=yes; shift; fi
source=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
output=$(realpath -m "${1:?usage: build.sh [--prove] OUTPUT}")
work=$output.build
mkdir -p "$work"
cp "$source"/*.v "$source"/*.ml "$source"/*.mli "$work"
cd "$work"
if [ -n "$prove" ]; then
  if grep -nE 'Admitted|admit|Axiom|Parameter|Conjecture|Unset|bypass_check' ./*.v; then
    echo "build.sh: something is taken for granted" >&2; exit 1
  fi
  for file in Spec Checker Geometry Edges OneBend OneBendOnFaces Sound Complete Wrong OneBendNeeded Extract Refutation ExtractRefutation; do coqc -Q . Drawing "$file.v"; done
  coqc -Q . Drawing Assumptions.v | tee assumptions.txt
  axioms='ClassicalDedekindReals\.sig_(not|forall)_dec|FunctionalExtensionality\.functional_extensionality_dep'
  if grep -vnE "^(Closed under the global context|Axioms:|($axioms)( :.*)?| .*)\$" assumptions.txt; then
    echo "build.sh: an assumption that is none of the three axioms" >&2; exit 1
  fi
  for file in checker.ml checker.mli refutation.ml refutation.mli; do cmp "$file" "$source/$file"; done
fi
compile() { ocamlfind ocamlopt -package zarith -inline 200 "$@"; }
compile -w -a -c integer.ml checker.mli checker.ml refutation.mli refutation.ml
compile -w +a-4-9-37-40..42-44-45-70 -c reader.ml promise.ml advice.ml main.ml dimacs.ml propagation.ml refute.ml
compile -linkpkg integer.cmx checker.cmx reader.cmx promise.cmx advice.cmx main.cmx -o "$output"
compile refutation.cmx dimacs.cmx propagation.cmx refute.cmx -o "$(dirname "$output")/ar3d_unsatisfiable"
