#!/bin/sh
# SPDX-License-Identifier: LGPL-2.1-or-later
# Fills many models as jobs of a one-node Slurm that this script starts, kills the run in the middle, and
# resumes it. Needs root, and Debian's snakemake, slurm-wlm, munge, freecad-python3.
#
#   cluster.sh [COUNT]     how many models (300), cut from those of ../shared/cad
#
# SUTURE_PROGRAM   the program, by default the one in build/release
set -eu
source=$(dirname "$(dirname "$(dirname "$(readlink -f "$0")")")")
count=${1:-300}
program=${SUTURE_PROGRAM:-$source/build/release/bin/suture}
cad=$source/../shared/cad/files
[ -d "$cad" ] || { echo "cluster.sh: skipped: there is no $cad"; exit 77; }
dir=$(mktemp -d)
node=$(hostname -s)

end_daemons() {
    for file in "$dir"/slurm/*.pid; do
        [ ! -s "$file" ] || kill "$(cat "$file")" 2>/dev/null || true
    done
}
trap 'end_daemons; [ -n "${SUTURE_KEEP-}" ] || { sleep 2; rm -rf "$dir"; }' EXIT

start_slurm() {
    mkdir -p "$dir/slurm/state" "$dir/slurm/spool"
    cd "$dir/slurm"
    head -c 1024 /dev/urandom >munge.key
    chmod 400 munge.key
    chmod 755 "$dir" "$dir/slurm"
    munged --force --key-file="$PWD/munge.key" --socket="$PWD/munge.socket" --pid-file="$PWD/munged.pid" \
        --log-file="$PWD/munged.log" --seed-file="$PWD/munged.seed"
    cat >slurm.conf <<CONF
ClusterName=one
SlurmctldHost=$node(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket=$PWD/munge.socket
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$PWD/state
SlurmdSpoolDir=$PWD/spool
SlurmctldPidFile=$PWD/slurmctld.pid
SlurmdPidFile=$PWD/slurmd.pid
SlurmctldLogFile=$PWD/slurmctld.log
SlurmdLogFile=$PWD/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
ReturnToService=2
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=8000 State=UNKNOWN
PartitionName=all Nodes=$node Default=YES State=UP
CONF
    export SLURM_CONF=$PWD/slurm.conf
    slurmctld -f slurm.conf
    slurmd -f slurm.conf
    for _ in $(seq 30); do
        ! sinfo -h -o %t | grep -q idle || return 0
        sleep 1
    done
    echo "cluster.sh: Slurm did not come up:" >&2
    tail -5 slurmctld.log slurmd.log >&2
    exit 1
}

run_flow() {
    snakemake -q -s Snakefile --profile slurm --jobs "$(nproc)" \
        --config models=../models out=../out suture="$program"
}

/usr/bin/python3 -B "$source/tests/ship/cut_models.py" "$dir/models" "$count" \
    "$cad/0044_bb_boxblend_03_colored.stp" "$cad/0045_bb_boxblend_03_colored_mirrored.stp" \
    "$cad/simple_wing.stp" "$cad/Handle_SO101.step" "$cad/Trigger_SO101.step" "$cad/hip_aa_support.STEP" \
    "$cad/lower_leg_structure_fork.STEP"
start_slurm
cp -r "$source/docs/examples/batch" "$dir/batch"
cd "$dir/batch"

run_flow >"$dir/first.log" 2>&1 &
flow=$!
while [ "$(find "$dir/out" -name '*.json' 2>/dev/null | wc -l)" -lt $((count / 3)) ]; do
    kill -0 $flow || { tail -20 "$dir/first.log"; exit 1; }
    sleep 1
done
pkill -KILL -P $flow || true # the snakemake of this run
kill -KILL $flow 2>/dev/null || true
scancel -u root
sleep 3
find "$dir/out" -name '*.json' -printf '%p %T@\n' | sort >"$dir/before"
echo "killed after $(wc -l <"$dir/before") of $count"

snakemake -q -s Snakefile --unlock --cores 1 --config models=../models out=../out >/dev/null 2>&1
run_flow >"$dir/second.log" 2>&1 || { tail -20 "$dir/second.log"; exit 1; }
find "$dir/out" -name '*.json' -printf '%p %T@\n' | sort >"$dir/after"
lost=$(join -v1 "$dir/before" "$dir/after" | wc -l)
again=$(join "$dir/before" "$dir/after" | awk '$2 != $3' | wc -l)
cut -d, -f2 "$dir/out/summary.csv" | sort | uniq -c
echo "of what was done, $lost lost and $again done again; $(($(wc -l <"$dir/out/summary.csv") - 1)) in the summary"
[ "$lost" = 0 ] && [ "$(wc -l <"$dir/after")" = "$count" ] && [ "$again" -le "$(nproc)" ]
