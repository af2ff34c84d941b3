#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# slurm.sh PIPEGS [CAMPAIGN [LOCAL]]: a campaign on Slurm, with a job and the controller killed and the node drained,
# keeps what GNU parallel keeps of it here, bit for bit, and measures nothing twice.
#
# Needs   root, slurmctld, slurmd, Slurm's clients, munge, GNU parallel; skipped (77) without one of them.
# Idea    Munge, controller and node are our own: started on this machine in a folder of theirs with ports of their own,
#         stopped and removed at the end. Without CAMPAIGN it is three small scenes x 3 views x 6 design points; LOCAL
#         is the folder of one that GNU parallel has run already.
# Prints  What it did and saw, and the seconds of each part.
set -uo pipefail
pipegs=$(realpath "$1") root=$(cd "$(dirname "$0")/../.." && pwd)
PATH=$PATH:/usr/sbin:/sbin
for tool in munged slurmctld slurmd sbatch scontrol squeue sinfo scancel parallel; do
  command -v $tool > /dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: Slurm's daemons start jobs as root only"; exit 77; }

work=$(mktemp -d)
chmod 711 "$work"
export SLURM_CONF=$work/slurm.conf
stop() {
  local daemon
  scancel --full --user=root > /dev/null 2>&1
  scontrol shutdown > /dev/null 2>&1 && sleep 2
  for daemon in slurmctld slurmd; do
    [ -s "$work/$daemon.pid" ] && kill -KILL "$(cat "$work/$daemon.pid")" 2> /dev/null
  done
  munged --stop --socket="$work/munge/socket" > /dev/null 2>&1
  rm -rf "$work"
}
trap stop EXIT
say() { echo "[$SECONDS s] $*"; }
fail() {
  say "FAILED: $*"
  tail -n 20 "$work"/log/*.log "$work"/slurm-*.out 2> /dev/null
  exit 1
}
# until_true SECONDS WHAT COMMAND...: waits for it.
until_true() {
  local end=$((SECONDS + $1)) what=$2
  shift 2
  until "$@"; do
    [ $SECONDS -lt $end ] || fail "waited in vain: $what"
    sleep 0.2
  done
}

# Slurm, all of it on this machine.
mkdir -m 711 "$work"/{state,spool,log,munge,local,cluster}
local=$(realpath "${3:-$work/local}")
dd if=/dev/urandom of="$work/munge/key" bs=32 count=1 status=none && chmod 400 "$work/munge/key"
host=$(hostname -s) port=$((20000 + $$ % 20000))
cat > "$SLURM_CONF" << END
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/log/slurmctld.log
SlurmdLogFile=$work/log/slurmd.log
SlurmctldPort=$port
SlurmdPort=$((port + 1))
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MpiDefault=none
AccountingStorageType=accounting_storage/none
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=1000 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
node_is() { [ "$(sinfo --noheader --format=%t 2> /dev/null)" = "$1" ]; }
munged --force --key-file="$work/munge/key" --socket="$work/munge/socket" --pid-file="$work/munge/pid" \
  --log-file="$work/munge/log" --seed-file="$work/munge/seed" || fail "munged does not start"
slurmctld -f "$SLURM_CONF" || fail "slurmctld does not start"
slurmd -f "$SLURM_CONF" || fail "slurmd does not start"
until_true 60 "the node is idle" node_is idle
say "$(scontrol --version) with $(nproc) processors is up"

# The campaign.
cd "$work" || exit 1
campaign=${2:+$(realpath "$2")}
if [ -z "$campaign" ]; then
  campaign=$work/campaign.json
  cat > "$campaign" << END
{"scenes": [{"name": "own", "size": "160x120", "views": [0, 1, 2]},
            {"name": "ply", "scene": "$root/verif/formats/own/source.ply", "size": "320x240", "orbit": 3,
             "views": [0, 1, 2]},
            {"name": "splat", "scene": "$root/verif/formats/own/scene.splat", "size": "320x240", "orbit": 3,
             "views": [0, 1, 2]}],
 "designs": ["baseline", "dpc", "dop", "late", "exact", "fast"]}
END
fi
kept() { find "$work/$1/points" -name '*.json' 2> /dev/null | wc -l; }
times() { find "$work/$1/points" -name '*.json' -printf '%f %T@\n' | sort; }
"$pipegs" campaign "$campaign" --out cluster > cluster/said.txt || fail "no lines"
points=$(wc -l < cluster/lines.txt) tasks=$(($(wc -l < cluster/lines.txt) / 3))
submit() { sbatch --parsable --array=1-$tasks "$root/sim/command/campaign/slurm_array.sh" "$work/cluster/lines.txt"; }
more_than() { [ "$(kept cluster)" -gt "$1" ]; }
none_left() { [ -z "$(squeue --noheader --array 2> /dev/null || echo '?')" ]; }
none_runs() { [ -z "$(squeue --noheader --states=R 2> /dev/null || echo '?')" ]; }
job=$(submit) || fail "not submitted"
say "$points points in the $tasks tasks of array $job"

# A point of it is killed.
killed() {
  victim=$(pgrep --full --newest "point .*--keep $work/cluster/points") && kill -KILL "$victim"
}
until_true 600 "three points are kept" more_than 2
until_true 60 "a point is killed" killed
say "killed process $victim, a point; $(kept cluster) kept"

# A whole task of it is killed: the script, and what it runs.
task_killed() {
  victim=$(squeue --noheader --states=R --array --format=%i | tail -n 1)
  [ -n "$victim" ] && scancel --signal=KILL --full "$victim"
}
until_true 60 "a task is killed" task_killed
say "killed task $victim; $(kept cluster) kept"

# The controller is killed: what runs goes on, and when it is back the rest comes.
kill -KILL "$(cat slurmctld.pid)" || fail "no controller to kill"
say "killed slurmctld; $(kept cluster) kept"
squeue > squeue.txt 2>&1 && fail "something answers for the controller"
sleep 3
slurmctld -f "$SLURM_CONF" || fail "slurmctld does not start again"
answers() { scontrol ping 2>&1 | grep -q UP; }
until_true 60 "the controller answers" answers
# What ended shortly before it was killed may still run in the state that it has saved. It asks the node what runs there
# within minutes by itself, and now when it is told to.
scontrol reconfigure || fail "not reconfigured"
none_left && fail "nothing is left to do"
before=$(kept cluster)
# Tasks that began behind its last save it begins again; the node refuses them as doubles, and Slurm drains it and holds
# the tasks. An operator gives both back.
given_back() {
  local task
  if scontrol show node "$host" | grep -q 'Reason=Duplicate jobid'; then
    scontrol update NodeName="$host" State=RESUME
    say "the node had been drained for doubles, and is back"
  fi
  squeue --noheader --array --format='%i %r' | awk '/[Hh]eld/ {print $1}' > held.txt
  while read -r task; do scontrol release "$task"; done < held.txt
}
goes_on() { given_back && more_than "$before"; }
until_true 600 "points are measured behind the controller's restart" goes_on
say "slurmctld is back, and goes on; $(kept cluster) kept"

# The node is drained: what runs ends, and nothing begins.
scontrol update NodeName="$host" State=DRAIN Reason=test || fail "not drained"
until_true 600 "what runs ends" none_runs
before=$(kept cluster)
sleep 5
[ "$(kept cluster)" = "$before" ] || fail "a drained node measures"
[ "$before" -lt "$points" ] || fail "it was drained when all was done"
say "drained; $before kept"
scontrol update NodeName="$host" State=RESUME || fail "not resumed"
ended() { given_back && none_left; }
until_true 3600 "the array ends" ended
say "the array has ended; $(kept cluster) of $points kept"
# What was killed is missing, unless Slurm has begun its task anew; one more result is lost to the disk.
rm "$(find "$work/cluster/points" -name '*.json' | sort | head -n 1)"
missing=$((points - $(kept cluster)))
"$pipegs" campaign "$campaign" --out cluster --merge > merge.txt 2> merge_err.txt
[ $? = 1 ] && grep -q "$missing points are missing, the first: " merge_err.txt || fail "nobody says what is missing"

# The same again: only what is missing is measured.
times cluster > before.txt
job=$(submit) || fail "not submitted again"
until_true 3600 "the second array ends" none_left
times cluster > after.txt
[ "$(comm -23 before.txt after.txt | wc -l)" = 0 ] || fail "a kept point was measured again"
[ "$(comm -13 before.txt after.txt | wc -l)" = "$missing" ] || fail "it did not measure what was missing"
say "array $job has measured the $missing points that were missing"
"$pipegs" campaign "$campaign" --out cluster --merge || fail "points are missing"

# Here, with GNU parallel.
start=$SECONDS
"$pipegs" campaign "$campaign" --out "$local" > local_said.txt || fail "no lines"
parallel --joblog "$local/joblog" --resume-failed < "$local/lines.txt" > local_out.txt || fail "GNU parallel"
"$pipegs" campaign "$campaign" --out "$local" --merge || fail "points are missing"
say "GNU parallel took $((SECONDS - start)) s"
for file in results.csv results.json; do
  cmp "$local/$file" "cluster/$file" || fail "Slurm and GNU parallel differ"
done
[ "$(wc -l < "$local/results.csv")" = $((points + 1)) ] || fail "not a row for each point"
say "results.csv and results.json of $points points are the same bytes"
