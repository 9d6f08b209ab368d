# Sourced by the scripts that drive the built editor through the mouse and keyboard of a separate X server. Its settings and
# files are in $folder, which is removed when the script ends; $editor is its process id after `start_editor`.
folder=$(mktemp -d)
export HOME=$folder XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data LIBGL_ALWAYS_SOFTWARE=1
mkdir -p "$folder/config/Rubble"
printf '[preferences]\ntheme=light\n' >"$folder/config/Rubble/Rubble.conf"

# start_editor <program> [project]: starts the editor, and a window manager before the first one.
manager=
start_editor() {
  [ -n "$manager" ] || { openbox >/dev/null 2>&1 & manager=$!; }
  "$@" &
  editor=$!
  trap "kill $manager $editor 2>/dev/null || true; rm -rf '$folder'" EXIT
}
# fail <message>: saves a screenshot to $RUBBLE_FAILURE_PICTURE and exits.
fail() {
  import -window root "${RUBBLE_FAILURE_PICTURE:-$folder/failure.png}" 2>/dev/null || true
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}
# until_true <seconds> <command>...: waits until the command succeeds.
until_true() {
  local end=$((SECONDS + $1))
  shift
  while ! "$@" >/dev/null 2>&1; do
    [ $SECONDS -lt $end ] || return 1
    sleep 0.2
  done
}
# window_of <pattern>: prints the last visible window whose title matches.
window_of() { xdotool search --onlyvisible --name "$1" 2>/dev/null | tail -1; }
has_title() { [ -n "$(window_of "$1")" ]; }
# settled_window <pattern>: prints that window once it is the same for a second; it may be recreated while it opens.
settled_window() {
  local window= now= tries
  for tries in $(seq 60); do
    now=$(window_of "$1") || now=
    [ -z "$now" ] || [ "$now" != "$window" ] || { echo "$now"; return; }
    window=$now
    sleep 1
  done
  return 1
}
# focus_window <pattern>: waits for the window, focuses it, and sets $window, X, Y, WIDTH and HEIGHT.
focus_window() {
  until_true 60 has_title "$1" || fail "no window has a title that matches $1"
  window=$(settled_window "$1") || fail 'the window keeps changing'
  xdotool windowactivate --sync "$window" || fail 'the window does not accept the focus'
  eval "$(xdotool getwindowgeometry --shell "$window")"
}
