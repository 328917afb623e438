#!/usr/bin/env bash
# A release is the same bytes twice and its packages work in a new Debian root.  release.sh SOURCE
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf --one-file-system "$scratch"' EXIT
git clone -q "$1" "$scratch/clone"
cd "$scratch/clone"
touch no-commit
tools/release "$scratch/first" 2>"$scratch/refusal" && exit 1
grep -q 'the checkout has changes' "$scratch/refusal"
rm no-commit
tools/release "$scratch/first"
tools/release "$scratch/second" >/dev/null
diff "$scratch/first/SHA256SUMS" "$scratch/second/SHA256SUMS"
(cd "$scratch/first" && sha256sum --check --quiet SHA256SUMS && grep -q '^- Ten algorithms' ar3d-*-notes.md)
tools/try-packages "$scratch/first"
