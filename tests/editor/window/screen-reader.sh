#!/usr/bin/env bash
# Reads the built editor as a screen reader does, over a bus of its own: see screen-reader.py.
#
#   screen-reader.sh RUBBLE PROJECT      (run by ctest under xvfb-run, with a window manager)
set -euo pipefail
here=$(dirname "${BASH_SOURCE[0]}")
if [ -z "${RUBBLE_ON_BUS:-}" ]; then
  RUBBLE_ON_BUS=1 exec dbus-run-session -- "${BASH_SOURCE[0]}" "$@"
fi
source "$here/desktop.sh"
export QT_LINUX_ACCESSIBILITY_ALWAYS_ON=1 GTK_MODULES= NO_AT_BRIDGE=0
cp "$2" "$folder/wall.rubble"
start_editor "$1" "$folder/wall.rubble"
focus_window '^wall\.rubble'
/usr/bin/python3 "$here/screen-reader.py" "$editor" Project Inspector Fragments History Strength Problems Messages || fail 'the editor cannot be read'
