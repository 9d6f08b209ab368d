#!/usr/bin/env bash
# Drives the built editor as a user does: opens a project, places a seed, saves, undoes, saves, and quits.
#
#   outside.sh RUBBLE PROJECT      (run by ctest under xvfb-run, with a window manager)
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/desktop.sh"
cp "$2" "$folder/wall.rubble"
cp "$2" "$folder/before.rubble"
is_as_before() { cmp -s <(without_identity "$folder/before.rubble") <(without_identity "$folder/wall.rubble"); }
is_other() { ! is_as_before; }

start_editor "$1" "$folder/wall.rubble"
focus_window '^wall\.rubble'
[ -e "$folder/.wall.rubble.lock" ] || fail 'the open project is not locked'

picture >"$folder/before.pixels"
differs() { ! picture | cmp -s - "$folder/before.pixels"; }
xdotool key alt+n  # the tool that places seeds
# A third of the way across and down is the canvas, whatever the docks are.
xdotool mousemove $((X + WIDTH * 36 / 100)) $((Y + HEIGHT * 30 / 100)) click 1
until_true has_title '^wall\.rubble\* – Rubble' || fail 'a click on the canvas changed nothing'
until_true differs || fail 'the window did not change'
xdotool key ctrl+s
until_true is_other || fail 'Ctrl+S wrote nothing'
xdotool key ctrl+z
until_true has_title '^wall\.rubble\* – Rubble' || fail 'Ctrl+Z changed nothing'
xdotool key ctrl+s
until_true is_as_before || fail 'undone and saved, the file differs from the original'
xdotool key ctrl+q
until_true bash -c "! kill -0 $editor" || fail 'Ctrl+Q did not end the program'
wait "$editor" || fail "the program ended with exit code $?"
[ ! -e "$folder/.wall.rubble.lock" ] || fail 'a lock was left behind'
[ -z "$(ls "$folder/data/Rubble/Rubble/backups" 2>/dev/null)" ] || fail 'a backup was left behind'
