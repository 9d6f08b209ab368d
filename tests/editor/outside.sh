#!/usr/bin/env bash
# Drives the built editor as a user does, from outside, by mouse and keys of an X server of its own:
# opens a project, places a seed, saves, takes it back, saves, and quits.
#
#   outside.sh RUBBLE PROJECT      (run by ctest under xvfb-run, with a window manager)
set -euo pipefail
rubble=$1
folder=$(mktemp -d)
export HOME=$folder XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data LIBGL_ALWAYS_SOFTWARE=1
mkdir -p "$folder/config/Rubble"
printf '[preferences]\ntheme=light\n' >"$folder/config/Rubble/Rubble.conf"
cp "$2" "$folder/wall.rubble"
cp "$2" "$folder/before.rubble"

openbox >/dev/null 2>&1 &
manager=$!
"$rubble" "$folder/wall.rubble" &
editor=$!
trap 'kill $manager $editor 2>/dev/null || true; rm -rf "$folder"' EXIT

fail() {
  import -window root "${RUBBLE_FAILURE_PICTURE:-$folder/failure.png}" 2>/dev/null || true
  printf 'outside.sh: %s\n' "$*" >&2
  exit 1
}
# until <seconds> <command>...: waits for it to succeed
until_true() {
  local end=$((SECONDS + $1))
  shift
  while ! "$@" >/dev/null 2>&1; do
    [ $SECONDS -lt $end ] || return 1
    sleep 0.2
  done
}
is_as_before() { cmp -s "$folder/before.rubble" "$folder/wall.rubble"; }
is_other() { ! is_as_before; }
has_title() { xdotool search --onlyvisible --name "^$1" | grep -q .; }
# The editor's window, once it is the same for a second: it may be made anew while it opens.
settled_window() {
  local window= now= tries
  for tries in $(seq 60); do
    now=$(xdotool search --onlyvisible --name '^wall\.rubble' 2>/dev/null | tail -1) || now=
    [ -z "$now" ] || [ "$now" != "$window" ] || { echo "$now"; return; }
    window=$now
    sleep 1
  done
  return 1
}

until_true 60 has_title 'wall\.rubble – Rubble' || fail "no window with the project's name came up"
window=$(settled_window) || fail 'the window does not settle'
xdotool windowactivate --sync "$window" || fail 'the window does not take the focus'
[ -e "$folder/.wall.rubble.lock" ] || fail 'the open project is not locked'

eval "$(xdotool getwindowgeometry --shell "$window")"
before=$(import -window "$window" rgb:- | md5sum)
# A third of the way across and down, the canvas is there whatever the docks are.
xdotool mousemove $((X + WIDTH * 36 / 100)) $((Y + HEIGHT * 30 / 100)) click 1
until_true 20 has_title 'wall\.rubble\* – Rubble' || fail 'a click on the canvas changed nothing'
sleep 1
[ "$(import -window "$window" rgb:- | md5sum)" != "$before" ] || fail 'the window looks as it did'
xdotool key ctrl+s
until_true 20 is_other || fail 'Ctrl+S wrote nothing'
xdotool key ctrl+z
until_true 20 has_title 'wall\.rubble\* – Rubble' || fail 'Ctrl+Z changed nothing'
xdotool key ctrl+s
until_true 20 is_as_before || fail 'undone and saved, the file is not the bytes it was'
xdotool key ctrl+q
until_true 20 bash -c "! kill -0 $editor" || fail 'Ctrl+Q did not end the program'
wait "$editor" || fail "the program ended with exit code $?"
[ ! -e "$folder/.wall.rubble.lock" ] || fail 'a lock was left behind'
[ -z "$(ls "$folder/data/Rubble/Rubble/backups" 2>/dev/null)" ] || fail 'a backup was left behind'
