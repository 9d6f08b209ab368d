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
  if [ $status = 0 ] || [ $status = 3 ]; then  # 3: a result with findings
    results=$((results + 1))
  elif [ $status -le 2 ] && tail -n 1 err | grep -q '[.?]$'; then
    sentences=$((sentences + 1))
  elif [ "$limit" = time ] && [[ $status = 137 || $status = 152 ]]; then
    sentences=$((sentences + 1))  # the limit itself ends the program
  else
    faults=$((faults + 1))
    printf '%s: status %s: %s\n%s\n' "$limit" "$status" "$*" "$(tail -n 3 out err)"
  fi
}

with() { (ulimit "$1" "$2" && shift 2 && exec timeout -s KILL 600 "$@"); }
with_threads() {
  local user=()
  # Limits of processes do not apply to root.
  [ "$(id -u)" != 0 ] || user=(setpriv --reuid=65534 --regid=65534 --clear-groups)
  timeout -s KILL 600 "${user[@]}" prlimit --nproc="$1" "${@:2}"
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

cat >box.obj <<'END'
o box
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
END

# new_input <seeds>: for the verb fracture
new_input() {
  awk -v seeds="$1" -v random="$RANDOM" 'BEGIN {
    srand(random)
    printf "{\"outline\": [[0, 0], [2, 0], [2, 1], [0, 1]], \"depth\": 0.1, \"seeds\": ["
    for (k = 0; k < seeds; ++k) printf "%s[%.9f, %.9f]", k ? ", " : "", 2 * rand(), rand()
    print "]}"
  }' >input.json
}

# limited <command>...: under one random limit
limited() {
  case $((RANDOM % 6)) in
    0 | 1) attempt memory with -v $((300000 + RANDOM * 82)) "$@" ;;
    2) attempt threads with_threads $((1 + RANDOM % 4)) "$@" ;;
    3) attempt descriptors with -n $((4 + RANDOM % 12)) "$@" ;;
    4) attempt disk with -f $((1 + RANDOM % 63)) "$@" ;;
    5) attempt time with -t $((1 + RANDOM % 2)) "$@" ;;
  esac
}

# The editor needs some hundred MB and some descriptors to start.
limited_editor() {
  local steps=("$programs/editor-steps" project.rubble box.obj)
  attempt memory with -v $((500000 + RANDOM * 76)) "${steps[@]}"
  case $((RANDOM % 4)) in
    0) attempt threads with_threads $((1 + RANDOM % 6)) "${steps[@]}" ;;
    1) attempt descriptors with -n $((16 + RANDOM % 48)) "${steps[@]}" ;;
    2) attempt disk with -f $((1 + RANDOM % 63)) "${steps[@]}" ;;
    3) attempt time with -t $((1 + RANDOM % 3)) "${steps[@]}" ;;
  esac
}

cli=$programs/rubble-cli
# What once ended with a signal, or never.
new_project 60000 0
attempt memory with -v 1100000 "$cli" render project.rubble --out wall.png --samples 1
if [ -x "$programs/editor-steps" ]; then
  steps=("$programs/editor-steps" project.rubble box.obj)
  new_project 50 0
  attempt threads with_threads 4 "${steps[@]}"
  attempt memory with -v 524092 "${steps[@]}"
  attempt disk with -f 1 "${steps[@]}"
  new_project 20000 0
  attempt memory with -v 580000 "${steps[@]}"
fi
for ((project = 0; project < projects; ++project)); do
  seeds=$((RANDOM % 10 == 0 ? 20000 + RANDOM * 2 : 2 + RANDOM % 5000))
  new_input $seeds
  new_project $seeds $((RANDOM % 3 == 0 ? 2 + RANDOM % 4 : 0))
  verbs=("check project.rubble" "export project.rubble --out packs --overwrite" "draw project.rubble --out wall.svg"
    "simulate project.rubble --steps 1 --record wall.replay" "strength project.rubble" "diff project.rubble project.rubble"
    "materials" "new other$project.rubble" "render project.rubble --out wall.png --samples 1"
    "sheet project.rubble --asset wall --variants 2 --out sheet.png"
    "video project.rubble video$project --steps 1 --samples 1" "test project.rubble" "replay wall.replay"
    "seeds box.obj --into project.rubble --asset wall" "import box.obj --into project.rubble" "fracture input.json")
  [ $seeds -gt 1000 ] || verbs+=("audit project.rubble")
  for verb in "${verbs[@]}"; do
    read -ra words <<<"$verb"
    limited "$cli" "${words[@]}"
    rm -rf "video$project" "other$project.rubble"
  done
  [ ! -x "$programs/editor-steps" ] || limited_editor
done
printf '%s projects, %s runs: %s results, %s sentences, %s faults\n' "$projects" $runs $results $sentences $faults
[ $faults = 0 ]
