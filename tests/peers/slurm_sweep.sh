#!/usr/bin/env bash
# A sweep as a Slurm job array, on a cluster of one node that this test starts and stops itself.
#
#   slurm_sweep.sh PROGRAM CASE      ends with 77 (skipped) where Slurm is not installed or cannot be started
set -euo pipefail
readonly program=$1 case_file=$2

skip() {
    printf 'skipped: %s\n' "$*"
    exit 77
}

for tool in munged slurmctld slurmd sbatch squeue; do
    command -v "$tool" > /dev/null || [[ -x /usr/sbin/$tool ]] ||
        skip "$tool is not installed (Debian: slurmctld slurmd slurm-client munge)"
done
[[ "$(id -u)" == 0 ]] || skip "the test's own cluster needs root"
pgrep -x slurmctld > /dev/null && skip "a Slurm controller is running already"
export PATH=$PATH:/usr/sbin

folder=$(mktemp -d)
chmod 755 "$folder"
pids=()
finish() {
    for pid in "${pids[@]}"; do kill "$pid" 2> /dev/null || true; done
    wait 2> /dev/null || true
    rm -rf "$folder"
}
trap finish EXIT

start_munge() {
    dd if=/dev/urandom of="$folder/key" bs=128 count=1 status=none
    chmod 400 "$folder/key"
    munged --foreground --force --key-file="$folder/key" --socket="$folder/munge.socket" --pid-file="$folder/munge.pid" \
        --log-file="$folder/munge.log" --seed-file="$folder/munge.seed" > "$folder/munged.out" 2>&1 &
    pids+=($!)
}

write_configuration() {
    local host
    host=$(hostname -s)
    mkdir -p "$folder/state" "$folder/spool"
    cat > "$folder/slurm.conf" << END
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
CredType=cred/munge
SlurmctldPort=36817
SlurmdPort=36818
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=4000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
    export SLURM_CONF=$folder/slurm.conf
}

wait_for_node() {
    for _ in $(seq 60); do
        [[ "$(sinfo --noheader --format=%t 2> /dev/null)" == idle ]] && return
        sleep 0.5
    done
    cat "$folder"/*.out >&2 || true
    skip "the test's own cluster does not come up"
}

start_munge
write_configuration
slurmctld -D > "$folder/slurmctld.out" 2>&1 &
pids+=($!)
slurmd -D > "$folder/slurmd.out" 2>&1 &
pids+=($!)
wait_for_node

cd "$folder"
cat > study.toml << END
[study]
case = "$case_file"
[vary]
run.resolution = 8
material.friction_angle_deg = [34, 36, 38, 40]
source.base_angle_deg = [30, 33]
END
export RUNOUT=$program OMP_WAIT_POLICY=passive
"$program" sweep study.toml --slurm --shard 0/3 > job.sh
sbatch --wait job.sh
"$program" merge all.db shard-*.db
"$program" sweep study.toml --db whole.db -j 1 --quiet
diff <("$program" table whole.db) <("$program" table all.db)
[[ "$("$program" table all.db --list --format csv | wc -l)" == 9 ]]
printf 'the merged table of three parts is that of one sweep\n'
