#!/usr/bin/env bash
# A release is the same bytes twice, its packages work in a new Debian root, and so does what pip makes of it.  release.sh SOURCE
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
(cd "$scratch/first" && sha256sum --check --quiet SHA256SUMS && grep -q '^### Drawings' ar3d-*-notes.md)
tools/try-packages "$scratch/first"
PATH=/usr/bin:$PATH
python3 -m venv --system-site-packages build/env
build/env/bin/pip install --no-build-isolation .
build/env/bin/python -c 'import ar3d; assert ar3d.certify([(0, 1)], ar3d.draw([(0, 1)])); print(ar3d.__file__)' | grep "^$PWD/build/env/"
