#!/usr/bin/env bash
# Runs every verb of rubble-cli, and the editor, on projects of random size where the machine has too little of something:
# address space, threads, descriptors, room on the disk, processor time. Each run must end with a result or a sentence.
#
#   limits.sh <folder of the programs> [projects] [seed]
set -euo pipefail
programs=$(cd "$1" && pwd)
projects=${2:-200}
RANDOM=${3:-1}
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
cd "$place"
export HOME=$place XDG_RUNTIME_DIR=$place QT_QPA_PLATFORM=offscreen LC_ALL=C.UTF-8
runs=0 results=0 sentences=0 faults=0

# attempt <name of the limit> <command>...: judges how a command ends; the first word may be a function
attempt() {
  local limit=$1 status=0
  shift
  "$@" >out 2>err || status=$?
  runs=$((runs + 1))
  if [ $status = 0 ]; then
    results=$((results + 1))
  elif [ $status -le 2 ] && tail -n 1 err | grep -q '[.]$'; then
    sentences=$((sentences + 1))
  elif [ "$limit" = time ] && [[ $status = 137 || $status = 152 ]]; then
    sentences=$((sentences + 1))  # the limit itself ends the program
  else
    faults=$((faults + 1))
    printf '%s: status %s: %s\n%s\n' "$limit" "$status" "${*: -6}" "$(tail -n 3 err)"
  fi
}

with() { (ulimit "$1" "$2" && shift 2 && exec timeout -s KILL 120 "$@"); }
with_threads() {
  local user=()
  # Limits of processes do not apply to root.
  [ "$(id -u)" != 0 ] || user=(setpriv --reuid=65534 --regid=65534 --clear-groups)
  timeout -s KILL 120 "${user[@]}" prlimit --nproc="$1" "${@:2}"
}

# The editor bakes the project until it is closed, and must still run then.
editor() {
  local status=0
  (ulimit "$1" "$2" && exec timeout 3 "$programs/rubble" project.rubble) || status=$?
  [ $status = 124 ] || return $status
}

# new_project <seeds> <seeds of the second level>
new_project() {
  rm -f project.rubble
  "$programs/rubble-cli" new project.rubble >/dev/null
  local levels='"levels": []'
  [ "$2" = 0 ] || levels='"levels": [{"minimumVolume": 0, "pattern": [{"id": 9, "on": true, "randomSeed": 5,
    "kind": "uniform", "parameters": {"count": '$2', "domain": "outline"}, "overrides": []}]}]'
  sed -i "s/\"count\": [0-9]*/\"count\": $1/; s/\"nextId\": [0-9]*/\"nextId\": 20/" project.rubble
  awk -v levels="$levels" '{ sub(/"levels": \[\]/, levels); print }' project.rubble >changed && mv changed project.rubble
  chmod a+rwx . && chmod a+r project.rubble
}

cli=$programs/rubble-cli
for ((project = 0; project < projects; ++project)); do
  seeds=$((RANDOM % 10 == 0 ? 20000 + RANDOM * 4 : 2 + RANDOM % 5000))
  new_project $seeds $((RANDOM % 3 == 0 ? 2 + RANDOM % 4 : 0))
  verbs=("check project.rubble" "export project.rubble --out packs --overwrite" "draw project.rubble --out wall.svg"
    "simulate project.rubble --steps 1 --record wall.replay" "strength project.rubble" "diff project.rubble project.rubble"
    "materials" "new other$project.rubble" "render project.rubble --out wall.png --samples 1"
    "sheet project.rubble --asset wall --variants 2 --out sheet.png"
    "film project.rubble film$project --steps 1 --samples 1" "test project.rubble" "replay wall.replay"
    "seeds $cli" "import project.rubble --into project.rubble")
  [ $seeds -gt 1000 ] || verbs+=("audit project.rubble")
  for verb in "${verbs[@]}"; do
    read -ra words <<<"$verb"
    case $((RANDOM % 5)) in
      0 | 1) attempt memory with -v $((300000 + RANDOM * 82)) "$cli" "${words[@]}" ;;
      2) attempt threads with_threads $((1 + RANDOM % 4)) "$cli" "${words[@]}" ;;
      3) attempt descriptors with -n $((4 + RANDOM % 12)) "$cli" "${words[@]}" ;;
      4) attempt disk with -f $((RANDOM % 64)) "$cli" "${words[@]}" ;;
    esac
    rm -rf "film$project" "other$project.rubble"
  done
  attempt time with -t 1 "$cli" check project.rubble
  [ ! -x "$programs/rubble" ] || attempt editor editor -v $((500000 + RANDOM * 76))
done
printf '%s projects, %s runs: %s results, %s sentences, %s faults\n' "$projects" $runs $results $sentences $faults
[ $faults = 0 ]
