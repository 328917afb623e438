#!/usr/bin/env bash
# What `pip wheel .` makes, and what docs/python.md says to type, can be imported in a new virtual environment, draws and proves; without
# a network.  wheel.sh SOURCE
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf --one-file-system "$scratch"' EXIT
git clone -q "$1" "$scratch/clone"
cd "$scratch/clone"
PATH=/usr/bin:$PATH
# Neither pip nor the build may ask anybody: there is no network where the system lets us take it away.
offline=$(unshare --net true 2>/dev/null && echo "unshare --net" || true)
export PIP_NO_INDEX=1 PIP_DISABLE_PIP_VERSION_CHECK=1
$offline python3 -m pip wheel --no-build-isolation --no-deps --wheel-dir "$scratch/wheels" .
python3 -m venv --system-site-packages build/env
proves() {
  (cd / && "$scratch/clone/build/env/bin/python" -c 'import ar3d; assert ar3d.certify([(0, 1)], ar3d.draw([(0, 1)])); print(ar3d.__file__)') |
    grep "^$scratch/clone/build/env/"
}
$offline build/env/bin/pip install --no-deps "$scratch"/wheels/ar3d-*.whl
proves
(cd / && printf 'D~{\n' | "$scratch/clone/build/env/bin/ar3d" draw - --algorithm diamond | "$scratch/clone/build/env/bin/ar3d" verify -) |
  grep '^1 certified'
build/env/bin/python -m pip uninstall -q --yes ar3d
build/env/bin/pip install --no-build-isolation .
proves
