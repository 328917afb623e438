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
  echo "ar3d: installing with apt-get:$missing" >&2
  local apt="$sudo env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=600" log
  log=$(mktemp)
  { waiting_for_lists "$log" $apt update && $apt install -y $missing >"$log" 2>&1; } || {
    cat "$log" >&2
    rm -f "$log"
    echo "ar3d: installation failed. Type: sudo apt-get install -y$missing" >&2
    return 2
  }
  rm -f "$log"
}

# waiting_for_lists LOG COMMAND...: runs apt-get update, again while another package manager holds the lists (at most ten minutes);
# DPkg::Lock::Timeout waits for dpkg's lock, not for theirs. What apt-get prints goes to the log.
waiting_for_lists() {
  local log=$1 tries=0
  shift
  until "$@" >"$log" 2>&1; do
    grep -q 'Could not get lock' "$log" && [ $tries -lt 120 ] || return 1
    [ $tries -gt 0 ] || echo "ar3d: waiting for another package manager" >&2
    tries=$((tries + 1))
    sleep 5
  done
}

# folder_of PRESET: where it builds; the program alone is built where ./run-tests builds everything, which uses its objects.
folder_of() { echo "$AR3D_ROOT/build/${1/#program/release}"; }

# configure PRESET [cmake options...]: also a folder that was configured otherwise. AR3D_CONFIGURE holds further options.
configure() {
  local preset=$1 log="$(folder_of "$1")/setup.log"
  shift
  mkdir -p "${log%/*}"
  [ -f "${log%/*}/build.ninja" ] || echo "ar3d: configuring ($preset)" >&2
  (cd "$AR3D_ROOT" && cmake --preset "$preset" ${AR3D_CONFIGURE:-} "$@") >"$log" 2>&1 || { cat "$log" >&2; return 1; }
}

# build PRESET TARGET: configures where that was not done, then lets ninja decide what has changed.
# The output goes to a log that is shown only if something fails; a build of more than two seconds says how far it is.
build() {
  local preset=$1 target=$2 folder=$(folder_of "$1") ninja
  local log="$folder/setup.log"
  [ -f "$folder/build.ninja" ] || configure "$preset" || return 1
  ninja -C "$folder" "$target" >"$log" 2>&1 &
  ninja=$!
  report_progress $ninja "$log" "$preset"
  wait $ninja || { grep -vE '^\[[0-9]+/[0-9]+\]' "$log" >&2; return 1; }
}

# report_progress PID LOG PRESET: while ninja runs, how many of its steps are done, in per cent: after two seconds, then at every tenth.
report_progress() {
  local pid=$1 log=$2 preset=$3 percent shown=-1 waited=0
  while kill -0 "$pid" 2>/dev/null; do
    sleep 0.2
    waited=$((waited + 1))
    [ $waited -ge 10 ] || continue
    percent=$(tail -c 4000 "$log" | sed -n 's|^\[\([0-9]*\)/\([0-9]*\)\].*|\1 \2|p' | awk 'END {if ($2 > 0) print int(10 * $1 / $2) * 10; else print 0}')
    if [ $waited = 10 ]; then echo "ar3d: building ($preset), the first time takes minutes" >&2; fi
    if [ "$percent" -gt "$shown" ]; then
      if [ "$percent" -gt 0 ]; then echo "ar3d: building ($preset), $percent %" >&2; fi
      shown=$percent
    fi
  done
}

# with_mpi: builds the program for mpirun, with the packages that this takes.
with_mpi() {
  local cache="$AR3D_ROOT/build/release/CMakeCache.txt"
  install_packages "$AR3D_ROOT/tools/packages-mpi.txt" || return 2
  [ -f "$cache" ] && grep -q '^AR3D_MPI:BOOL=ON' "$cache" || configure program -DAR3D_MPI=ON || return 1
  build program ar3d_mpi
}

# Two builds at once in one folder would disturb each other.
locked() {
  mkdir -p "$AR3D_ROOT/build"
  (flock 9 && "$@" 9>&-) 9>"$AR3D_ROOT/build/.lock"
}
