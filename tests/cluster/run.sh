#!/usr/bin/env bash
# A picture rendered in parts, as clusters run them, has the bits of one run: by a Slurm job array, by Open MPI's mpirun
# and by GNU parallel, in 1, 2, 3, 7 and 64 parts, with one part killed and made again. Real daemons, all on this machine.
#
#   tests/cluster/run.sh [RAYWALK]     the program; build/release/raywalk when left out
#
# Needs the packages slurm-wlm, munge, openmpi-bin and parallel; what is not installed is skipped. Slurm's daemons need root.
set -uo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
raywalk=$(realpath "${1:-$root/build/release/raywalk}")
work=$(mktemp -d)
daemons=()
key=
end() {
  if ((${#daemons[@]} > 0)); then
    kill "${daemons[@]}" 2>/dev/null
    wait "${daemons[@]}" 2>/dev/null
  fi
  rm -rf "$work" ${key:+"$key"}
}
trap end EXIT
trap 'exit 130' INT TERM
cd "$work" || exit 1

export RAYWALK=$raywalk SCENE=$root/scenes/cornell.toml
# As many samples as let the smallest part take longer than its killing.
export OPTIONS="--size 160x120 --spp 64 --threads 1 --quiet"
read -ra options <<<"$OPTIONS"
render=("$raywalk" render "$SCENE" "${options[@]}")
"${render[@]}" -o whole.pfm || exit 1
whole=$(sha256sum <whole.pfm)
failed=0

# judge HOW PARTS STATUS: whether the launcher ended well and only the second part is missing; renders that, merges, and
# compares.
judge() {
  local how=$1 parts=$2 status=$3 again=0 i
  if ((status != 0)); then
    printf '%-9s %2d parts: ENDED WITH %d\n' "$how" "$parts" "$status"
    failed=1
  fi
  for ((i = 1; i <= parts; ++i)); do
    [[ -f part.pfm.part-$i-of-$parts ]] && continue
    "${render[@]}" -o part.pfm --part "$i/$parts"
    again=$((again + 1))
    ((i == 2)) || { printf '%-9s %2d parts: NO PART %d\n' "$how" "$parts" "$i"; failed=1; }
  done
  if ((again != (parts > 1))); then
    printf '%-9s %2d parts, %d made again: ANOTHER NUMBER THAN WERE KILLED\n' "$how" "$parts" "$again"
    failed=1
  fi
  if "$raywalk" merge part.pfm.part-*-of-"$parts" -o merged.pfm && [[ $(sha256sum <merged.pfm) == "$whole" ]]; then
    printf '%-9s %2d parts, %d made again: the same bits\n' "$how" "$parts" "$again"
  else
    printf '%-9s %2d parts, %d made again: ANOTHER PICTURE\n' "$how" "$parts" "$again"
    failed=1
  fi
  rm -f part.pfm.part-* merged.pfm
}

# What each task runs: its part, from 1; the second one is killed while it renders, and fails where it ended before.
cat >task <<'TASK'
#!/usr/bin/env bash
part=$1 parts=$2
# shellcheck disable=SC2086
"$RAYWALK" render "$SCENE" $OPTIONS -o part.pfm --part "$part/$parts" &
program=$!
if ((part != 2)); then
  wait "$program"
  exit
fi
while read -r stat <"/proc/$program/stat"; do
  read -ra fields <<<"${stat##*) }"  # from the third on: its state, and as the fourteenth its ticks of processor time
  [[ ${fields[0]} == Z ]] && break
  [[ /proc/$program/exe -ef $RAYWALK ]] && ((fields[11] >= 2)) && break
  sleep 0.002
done
kill -KILL "$program"
wait "$program" 2>/dev/null
(($? == 128 + 9))
TASK
chmod +x task

if command -v parallel >/dev/null; then
  for parts in 1 2 3 7 64; do
    parallel --will-cite -j 2 ./task {} "$parts" ::: $(seq "$parts") 2>/dev/null
    judge parallel "$parts" $?
  done
else
  echo "skipped: GNU parallel is not installed"
fi

if command -v mpirun >/dev/null; then
  for parts in 1 2 3 7 64; do
    # Ranks count from 0.
    OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe -n "$parts" \
      bash -c './task $((OMPI_COMM_WORLD_RANK + 1)) "$OMPI_COMM_WORLD_SIZE"' 2>/dev/null
    judge mpirun "$parts" $?
  done
else
  echo "skipped: Open MPI is not installed"
fi

# begin_slurm: a cluster of this one machine; 0 when it takes jobs.
begin_slurm() {
  command -v slurmctld >/dev/null && command -v slurmd >/dev/null && ((EUID == 0)) || return 1
  if [[ ! -f /etc/munge/munge.key ]]; then
    key=/etc/munge/munge.key
    (umask 077; mkdir -p /etc/munge; head -c 1024 /dev/urandom >"$key"; chown -R munge: /etc/munge)
  fi
  if ! munge -n >/dev/null 2>&1; then
    mkdir -p /run/munge && chown munge: /run/munge
    runuser -u munge -- munged --foreground >munged.log 2>&1 &
    daemons+=($!)
    sleep 1
  fi
  local host
  host=$(hostname -s)
  cat >slurm.conf <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmctldPort=36817
SlurmdPort=36818
StateSaveLocation=$work/slurmctld
SlurmdSpoolDir=$work/slurmd
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
ReturnToService=2
MaxArraySize=1001
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
  export SLURM_CONF=$work/slurm.conf
  mkdir -p slurmctld slurmd
  slurmctld -D >slurmctld.log 2>&1 &
  daemons+=($!)
  slurmd -D >slurmd.log 2>&1 &
  daemons+=($!)
  local i
  for ((i = 0; i < 30; ++i)); do
    [[ $(sinfo -h -o %T 2>/dev/null) == idle ]] && return 0
    sleep 1
  done
  cat slurmctld.log slurmd.log >&2
  return 1
}

if ! command -v slurmctld >/dev/null; then
  echo "skipped: Slurm is not installed"
elif begin_slurm; then
  for parts in 1 2 3 7 64; do
    sbatch --quiet --wait --array="1-$parts" --output=/dev/null --chdir="$work" --export=ALL \
      --wrap './task "$SLURM_ARRAY_TASK_ID" "$SLURM_ARRAY_TASK_COUNT"'
    judge slurm "$parts" $?
  done
else
  echo "skipped: Slurm's daemons do not run here (they need root)"
  ((EUID != 0)) || failed=1
fi
exit "$failed"
