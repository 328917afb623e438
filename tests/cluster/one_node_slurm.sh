#!/usr/bin/env bash
# A Slurm of one node, this machine, for as long as a command runs:
#   tests/cluster/one_node_slurm.sh FOLDER COMMAND...
# Starts munged, slurmctld and slurmd as root with everything they write below FOLDER, runs the command with
# SLURM_CONF set, and ends them again. Exit code: the command's; 99 if Slurm does not come up.
# Debian packages: slurm-wlm, munge.
set -u
folder=$(mkdir -p "$1" && cd "$1" && pwd)
shift
export SLURM_CONF="$folder/slurm.conf"
host=$(hostname -s)
socket="$folder/munge.socket"
pids=()

stop() {
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null; done
  for pid in "${pids[@]}"; do wait "$pid" 2>/dev/null; done
}
trap stop EXIT

mkdir -p "$folder/state" "$folder/spool" "$folder/munge"
chmod 700 "$folder/munge"
head -c 1024 /dev/urandom > "$folder/munge/key"
chmod 600 "$folder/munge/key"
cat > "$SLURM_CONF" <<END
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
AuthInfo=socket=$socket
CryptoType=crypto/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$(free -m | awk '/^Mem:/ {print $2}') State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END

# The authentication daemon insists on directories that only root can write.
munged --foreground --force --key-file="$folder/munge/key" --socket="$socket" \
  --log-file="$folder/munge/log" --pid-file="$folder/munge/pid" --seed-file="$folder/munge/seed" \
  > "$folder/munged.out" 2>&1 &
pids+=($!)
for _ in $(seq 50); do [ -S "$socket" ] && break; sleep 0.1; done
slurmctld -D -i > "$folder/slurmctld.out" 2>&1 &
pids+=($!)
slurmd -D > "$folder/slurmd.out" 2>&1 &
pids+=($!)

for _ in $(seq 100); do
  [ "$(sinfo --noheader --format=%T 2>/dev/null)" = idle ] && break
  sleep 0.2
done
if [ "$(sinfo --noheader --format=%T 2>/dev/null)" != idle ]; then
  echo "one_node_slurm.sh: Slurm does not come up; see $folder" >&2
  tail -n 5 "$folder"/*.out "$folder"/*.log "$folder/munge/log" >&2
  exit 99
fi
"$@"
