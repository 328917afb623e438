#!/usr/bin/env bash
# README's two commands in both orders, and .ci/run, in trees where nothing is compiled.
#   tests/house/commands.sh SOURCE_DIR
# Configures only: ninja does nothing in these trees, so that the list of tests names programs that are not built.
set -eu
source=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "commands.sh: $*" >&2; exit 1; }

# tree NAME: a copy of the tree without builds.
tree() {
  mkdir -p "$scratch/$1/bin"
  cd "$scratch/$1"
  ln -s $(ls -d "$source"/* | grep -v /build$) .
  cp --remove-destination "$source"/{ar3d,run-tests} .
  printf '#!/bin/bash\n[[ $2 = %s/*/build/* && $3 != -t ]] || exec /usr/bin/ninja "$@"\n' "$scratch" >bin/ninja
  chmod +x bin/ninja
}
program() { PATH=$PWD/bin:$PATH ./ar3d list >program.log 2>&1 || grep -q 'apps/ar3d: No such file' program.log || fail "$(cat program.log)"; }
tests() { PATH=$PWD/bin:$PATH ./run-tests -N | tail -n +2; }

tree tests_first
tests >alone
for name in python.package proof.refuses_what_is_wrong browser.site ar3d_kernels_tests_NOT_BUILT ar3d_apps_tests_NOT_BUILT; do
  grep -q "Test .*: $name" alone || fail "./run-tests runs no $name"
done
program
tests | cmp - alone || fail "./run-tests, ./ar3d, ./run-tests: another list of tests than ./run-tests alone"
tree program_first
program
grep -q '^AR3D_TESTS:BOOL=OFF' build/release/CMakeCache.txt || fail "./ar3d alone configures the tests"
tests | cmp - ../tests_first/alone || fail "./ar3d, ./run-tests: another list of tests than ./run-tests alone"

# .ci/run types what README says, in a clone of the commit; with --all it lints, too, and goes on after a failure, which it tells.
mkdir -p "$scratch/ci/.ci"
cd "$scratch/ci"
cp "$source/.ci/run" .ci
printf '#!/bin/bash\necho "$0 $*"; ls; [ "$*" != --lint ]\n' >ar3d
chmod +x ar3d
cp ar3d run-tests
git init -q . && git add . && git -c user.name=a -c user.email=a@b.c commit -q -m all
touch not-committed
code=0
.ci/run >../two || code=$?
[ $code = 0 ] || fail ".ci/run ends with $code although no command failed"
.ci/run --all >../said || code=$?
[ $code = 1 ] || fail ".ci/run --all ends with $code although a command failed"
[ "$(grep -o 'ar3d: .* took' ../two)" = "$(grep -o 'ar3d: .* took' ../said | head -2)" ] || fail ".ci/run types more than README says"
sed 's/ took [0-9]* s$//' ../said | cmp - <(
  for command in "./ar3d study run quick" ./run-tests "./run-tests --lint" "./run-tests --check --part"; do
    [ "$command" = ./run-tests ] && echo "$command " || echo "$command"
    printf 'ar3d\nrun-tests\nar3d: %s\n' "$command"
  done) || fail ".ci/run does otherwise than it should"
