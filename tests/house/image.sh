#!/usr/bin/env bash
# Runs the steps of Dockerfile in a new Debian root, then its command: as root; mmdebstrap.
#   tests/house/image.sh SOURCE
set -euo pipefail
source=$1
sources=/etc/apt/sources.list.d/debian.sources
[ -s "$sources" ] || sources=/etc/apt/sources.list
scratch=$(mktemp -d)
root=$scratch/root
trap 'rm -rf --one-file-system "$scratch"' EXIT
inside() {
  unshare --mount --pid --fork bash -euc 'mount -t proc proc "$0/proc"; mount --rbind /dev "$0/dev"
    exec chroot "$0" env -i PATH=/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive bash -euo pipefail -c "$1"' "$root" "$1"
}
grep -qx "FROM debian:12" "$source/Dockerfile"
mmdebstrap --quiet --variant=apt bookworm "$root" "$sources"
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
folder=/
while read -r step words; do
  case $step in
    FROM) ;;
    RUN) inside "cd $folder; $words" ;;
    COPY) [ "$words" = ". /ar3d" ] && git clone -q "$source" "$root/ar3d" ;;
    WORKDIR) folder=$words && mkdir -p "$root$folder" ;;
    CMD) inside "cd $folder; $(python3 -c 'import json, shlex, sys; print(shlex.join(json.loads(sys.argv[1])))' "$words")" ;;
    *) echo "image.sh: a step that is not known: $step" >&2; exit 1 ;;
  esac
done <"$source/Dockerfile"
ls "$root/work/ar3d-quick.html"
