#!/bin/bash
# Runs a sweep on a Slurm of this machine alone, kills workers in the middle, and compares the results with those of a
# plain sweep. Needs root and the Debian packages slurm-wlm and munge:
#
#     apt-get install slurm-wlm munge && cargo build --release && sudo studies/clusters/run_on_slurm.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
gouge=$PWD/target/release/gouge
work=$(mktemp -d)
trap 'scancel -u root 2> /dev/null; pkill slurmd; pkill slurmctld; rm -rf "$work"' EXIT

host=$(hostname -s)
mkdir -p /etc/slurm /run/munge "$work/state" "$work/spool"
[ -f /etc/munge/munge.key ] || mungekey --create
chown munge: /etc/munge/munge.key /run/munge
pgrep munged > /dev/null || runuser -u munge -- munged
cat > /etc/slurm/slurm.conf <<END
ClusterName=one
SlurmctldHost=$host
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SchedulerParameters=requeue_delay=1
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
NodeName=$host CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
slurmctld && slurmd
for _ in $(seq 60); do sinfo -h -o %t | grep -q idle && break; sleep 1; done
sinfo

source studies/clusters/common.sh
"$gouge" sweep export slurm "$work/sweep.toml" --out "$work/cluster" --minutes 2 --most-chunks 4 > "$work/job.sh"
# The runs of this test are short: four chunks nevertheless.
sed -i 's/--array=0-0/--array=0-3/; s/--chunks 1/--chunks 4/' "$work/job.sh"
sbatch "$work/job.sh"
# Slurm ends a worker before its limit (the notice makes it leave checkpoints and be queued again), and one is killed
# without notice.
sleep 6
scancel --signal=TERM --batch "$(squeue -h -o %i -t R | head -1)"
sleep 4
pkill -KILL -f "sweep work" -o || true
for _ in $(seq 300); do
    squeue -h | grep -q . || break
    sleep 1
done
# What was killed without notice is submitted again by the user.
sbatch --wait "$work/job.sh" || true
compare
