#!/usr/bin/env bash
# What base/README.md says of OpenMP's threads.
#   tests/house/openmp.sh SOURCE_DIR PROGRAM
set -eu
source=$1 program=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
fail() { echo "openmp.sh: $*" >&2; exit 1; }
# threads FILE: how many threads of one team name themselves there.
threads() { grep -oE 'level 1 thread 0x[0-9a-f]+' "$1" | sort -u | wc -l; }

# No other way to make a thread for work.
git -C "$source" grep -lE 'std::(jthread|thread|async)\b[^:]|pthread_create' -- '*.cpp' '*.h' ':!tests' >found || true
printf '%s\n' base/parallel.cpp store/journal/journal_writer.cpp store/journal/journal_writer.h >expected
diff expected found || fail "threads are made elsewhere than base/README.md says"

# Threads that wait sleep, unless the user says otherwise.
OMP_DISPLAY_ENV=true "$program" list formats 2>&1 >/dev/null | grep -q "OMP_WAIT_POLICY *= *'PASSIVE'" || fail "threads that wait do not sleep"
OMP_WAIT_POLICY=active OMP_DISPLAY_ENV=true "$program" list formats 2>&1 >/dev/null | grep -q "OMP_WAIT_POLICY *= *'ACTIVE'" ||
  fail "OMP_WAIT_POLICY is not honoured"

# Rows and a certificate are shared by two threads, in any binding and with fewer threads than are asked for: the same comes out.
"$program" generate random-4-regular -n 70000 --seed 1 | "$program" draw - --algorithm diamond -o drawing.jsonl
OMP_NUM_THREADS=1 OMP_DISPLAY_AFFINITY=true "$program" verify drawing.jsonl --json >one 2>said
[ "$(threads said)" = 0 ] || fail "a certificate takes more threads than it is given"
for setting in OMP_NUM_THREADS=2 "OMP_NUM_THREADS=2 OMP_PROC_BIND=true" "OMP_NUM_THREADS=4 OMP_DYNAMIC=true" \
    "OMP_NUM_THREADS=4 OMP_THREAD_LIMIT=2" "OMP_NUM_THREADS=2,2 OMP_MAX_ACTIVE_LEVELS=2"; do
  env $setting OMP_DISPLAY_AFFINITY=true "$program" verify drawing.jsonl --json >several 2>said || fail "$setting: $(tail -1 said)"
  cmp one several || fail "$setting: another certificate"
  [ "$(threads said)" -ge 2 ] || fail "$setting: a certificate is not shared"
done
OMP_DISPLAY_AFFINITY=true "$program" study run smoke -q --threads 2 -o two.h5 2>said >/dev/null
[ "$(threads said)" = 2 ] || fail "rows are not shared by two threads"
/usr/bin/python3 -c 'import h5py, sys; sys.exit(any(b"SPIN" in row["name"] for row in h5py.File("two.h5")["environments"]))' ||
  fail "a study records how long threads spin, which older ones do not"
OMP_THREAD_LIMIT=1 OMP_DISPLAY_AFFINITY=true "$program" study run smoke -q -o limited.h5 2>said >/dev/null
[ "$(threads said)" = 0 ] || fail "OMP_THREAD_LIMIT is not honoured"
OMP_THREAD_LIMIT=1 "$program" study run smoke -q --threads 2 -o none.h5 2>said && fail "two threads where one is allowed"
grep -qx 'ar3d: cannot start 2 threads: the system allows fewer' said || fail "$(cat said)"

# Threads that the system does not give are done without: 64 stacks of 64 MB.
(ulimit -s 65536 && ulimit -v 2000000 && exec "$program" verify drawing.jsonl --json --threads 64) >several 2>said || fail "$(cat said)"
cmp one several || fail "with few threads another certificate"
