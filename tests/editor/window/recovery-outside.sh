#!/usr/bin/env bash
# Kills the built editor with unsaved changes, and restores the backup in both ways: opening the file again, and from the
# start page. The project is whole all the time, and the backup is there until the restored project is saved.
#
#   recovery-outside.sh RUBBLE PROJECT [bytes|long]      (run by ctest under xvfb-run, with a window manager)
#
# The project has a name that is not UTF-8 (bytes), or one as long as file systems take (long).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/desktop.sh"
name=wall.rubble title='^wall\.rubble'
case ${3-} in
  bytes) name=$'h\xff.rubble' title='^h\\xff\.rubble' ;;
  long) name=$(printf 'x%.0s' {1..248}).rubble title='^x+.+x\.rubble' ;;
esac
printf 'autosaveSeconds=1\n' >>"$folder/config/Rubble/Rubble.conf"
cp "$2" "$folder/$name"
cp "$2" "$folder/before.rubble"
backups=$folder/data/Rubble/Rubble/backups
has_backup() { [ -n "$(ls "$backups"/*.rubble 2>/dev/null)" ]; }
has_no_backup() { ! has_backup; }
is_as_before() { cmp -s "$folder/before.rubble" "$folder/$name"; }
is_other() { ! is_as_before; }
kill_editor() {
  kill -9 $editor
  wait $editor 2>/dev/null || true
  is_as_before || fail 'the project was changed though it was not saved'
  has_backup || fail 'there is no backup'
}
# restore: answers the question about the backup and waits for the restored project.
restore() {
  focus_window '^Rubble$'
  xdotool key Return
  focus_window "$title\\*"
  has_backup || fail 'the backup was removed before the restored project was saved'
}

start_editor "$1" "$folder/$name"
focus_window "$title"
xdotool key alt+n  # the tool that places seeds
xdotool mousemove $((X + WIDTH * 36 / 100)) $((Y + HEIGHT * 30 / 100)) click 1
until_true has_title "$title\\*" || fail 'a click on the canvas changed nothing'
until_true has_backup || fail 'no backup was written'
cp "$backups"/*.rubble "$folder/backup.rubble"
kill_editor
start_editor "$1" "$folder/$name"
restore
kill_editor
start_editor "$1"
restore
locks() { find "$folder" -maxdepth 1 -name '.*.lock' | grep -c . || true; }
[ "$(locks)" = 1 ] || fail 'the restored project is not locked'
xdotool key ctrl+s
until_true is_other || fail 'Ctrl+S wrote nothing'
cmp <(without_identity "$folder/backup.rubble") <(without_identity "$folder/$name") || fail 'the saved project is not the one that was edited'
until_true has_no_backup || fail 'the backup was left behind'
xdotool key ctrl+q
until_true bash -c "! kill -0 $editor" || fail 'Ctrl+Q did not end the program'
wait "$editor" || fail "the program ended with exit code $?"
[ "$(locks)" = 0 ] || fail 'a lock was left behind'
[ -z "$(ls "$backups")" ] || fail 'files were left behind in the folder of the backups'
