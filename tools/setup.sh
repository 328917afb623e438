# Sourced by ./ar3d and ./run-tests. Installs what is missing and builds; silent when nothing has to be done.

# missing_packages FILE...: the packages listed in the files that are not installed, on one line.
missing_packages() {
  local name missing=""
  for name in $(sed 's/#.*//' "$@"); do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null)" = installed ] && continue
    [ "$name" = npm ] && command -v npm >/dev/null && continue
    missing="$missing $name"
  done
  echo "$missing"
}

# install_packages FILE...: installs the missing ones as root or with sudo, else prints the line to type.
install_packages() {
  local missing sudo=""
  command -v dpkg-query >/dev/null || { echo "ar3d: this set-up needs Debian or Ubuntu; see README.md for the list of packages" >&2; return 2; }
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo >/dev/null && { [ -t 0 ] || sudo -n true 2>/dev/null; }; then
      sudo=sudo
    else
      echo "ar3d: packages are missing. Type: sudo apt-get install -y$missing" >&2
      return 2
    fi
  fi
  echo "ar3d: installing$missing" >&2
  { $sudo apt-get update -qq && $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq $missing; } >&2 || {
    echo "ar3d: installation failed. Type: sudo apt-get install -y$missing" >&2
    return 2
  }
}

# build PRESET TARGET [cmake options...]: configures once, then lets ninja decide what has changed.
# The output goes to a log that is shown only if something fails; a build of more than two seconds says so.
build() {
  local preset=$1 target=$2 folder="$AR3D_ROOT/build/$1" log ninja
  shift 2
  mkdir -p "$folder"
  log="$folder/setup.log"
  if [ ! -f "$folder/build.ninja" ] || [ "${AR3D_RECONFIGURE:-}" = 1 ]; then
    echo "ar3d: configuring ($preset)" >&2
    (cd "$AR3D_ROOT" && cmake --preset "$preset" "$@") >"$log" 2>&1 || { cat "$log" >&2; return 1; }
  fi
  ninja -C "$folder" "$target" >"$log" 2>&1 &
  ninja=$!
  for _ in 1 2 3 4 5 6 7 8 9 10; do
    kill -0 $ninja 2>/dev/null || break
    sleep 0.2
  done
  if kill -0 $ninja 2>/dev/null; then echo "ar3d: building ($preset), the first time takes minutes" >&2; fi
  wait $ninja || { grep -vE '^\[[0-9]+/[0-9]+\]' "$log" >&2; return 1; }
}

# with_mpi [cmake options...]: builds the program for mpirun, with the packages that this takes.
with_mpi() {
  local cache="$AR3D_ROOT/build/release/CMakeCache.txt"
  install_packages "$AR3D_ROOT/tools/packages-mpi.txt" || return 2
  [ -f "$cache" ] && grep -q '^AR3D_MPI:BOOL=ON' "$cache" || local AR3D_RECONFIGURE=1
  build release ar3d_mpi "$@" -DAR3D_MPI=ON
}

# Two builds at once in one folder would disturb each other.
locked() {
  mkdir -p "$AR3D_ROOT/build"
  (flock 9 && "$@" 9>&-) 9>"$AR3D_ROOT/build/.lock"
}
