# Sourced by ./run-tests after tools/setup.sh.

# lint [FILE...]: eslint, clang-format, then clang-tidy, over the sources named or over all; prints every finding once.
# Builds the generated headers only. Needs the folder build/release configured.
lint() (
  cd "$AR3D_ROOT" || exit 2
  local folder=build/release scratch
  scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
  all_sources "$@" >"$scratch/sources"
  lint_scripts "$@" || exit 1
  [ -s "$scratch/sources" ] || { echo "ar3d: clang looks at nothing: no C++ among $*" >&2; exit 0; }
  clang-format --dry-run -Werror $(cat "$scratch/sources") || { echo "ar3d: not formatted; clang-format -i mends it" >&2; exit 1; }
  ninja -C "$folder" ar3d_generated >"$scratch/log" 2>&1 || { cat "$scratch/log" >&2; exit 1; }
  units_of "$folder" "$scratch/sources" >"$scratch/units"
  tidy_all "$folder" "$scratch"
)

# eslint over the viewer's modules and the .mjs files of the tree, or over those named.
lint_scripts() {
  local scripts
  scripts=$(git ls-files -- "${@:-.}" | grep -E '^(formats/drawings/viewer|apps/play|analysis/page)/[a-z]+\.js$|\.mjs$') || return 0
  tests/browser/run --install || { echo "ar3d: the scripts are not looked at: no eslint" >&2; return 1; }
  tests/browser/node_modules/.bin/eslint -c tests/browser/eslint.config.mjs --max-warnings 0 $scripts
}

# units_of FOLDER SOURCES: what the build compiles of the sources: each alone, or the unit that CMake made of it and its neighbours.
units_of() {
  local unit
  sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' "$1/compile_commands.json" | sed "s|^$PWD/||" | sort -u | while read -r unit; do
    case "$unit" in
      */arithmetic/x87.cpp) ;;  # clang has no -mfpmath=387
      */Unity/*) sed -n "s|^#include \"$PWD/\(.*\)\"|\1|p" "$unit" | grep -qFx -f "$2" && echo "$unit" ;;
      *) grep -qFx -e "$unit" "$2" && echo "$unit" ;;
    esac
  done
}

# The .cpp and .h files of the tree, or of the files and folders named.
all_sources() {
  git ls-files -- "${@:-.}" | grep -E '\.(cpp|h)$'
}

# tidy_all FOLDER SCRATCH: clang-tidy on each line of SCRATCH/units, as many at a time as there are cores. The units that CMake makes
# of tests stand in the build's folder, so their rules are named.
tidy_all() {
  local folder=$1 scratch=$2 total
  total=$(wc -l <"$scratch/units")
  xargs -P "$(nproc)" -I{} sh -c 'case "$1" in */tests/*) of=--config-file=tests/.clang-tidy ;; esac
      clang-tidy -p "$0" --quiet ${of:-} "$1" >"$2/$$.found" 2>"$2/$$.err" && echo passed || echo failed' \
    "$folder" {} "$scratch" <"$scratch/units" | {
    local done=0 failed=0 verdict
    while read -r verdict; do  # awk may keep back what it reads
      [ "$verdict" = passed ] || failed=$((failed + 1))
      done=$((done + 1))
      [ $((done % 50)) != 0 ] || echo "ar3d: clang-tidy, $done of $total files" >&2
    done
    [ $failed = 0 ]
  }
  local result=$?
  # A finding in a header is seen by every file that includes it.
  cat "$scratch"/*.found | awk '/^[^ ].*: (error|warning|note): / {shown = ($0 in seen); seen[$0]} !shown'
  [ $result = 0 ] || grep -hE "^(error|Error)" "$scratch"/*.err | sort -u
  return $result
}
