# Sourced by the scripts that drive the built editor through the mouse and keyboard of a separate X server. Its settings and
# files are in $folder, which is removed when the script ends; $editor is its process id after `start_editor`.
folder=$(mktemp -d)
export HOME=$folder XDG_CONFIG_HOME=$folder/config XDG_DATA_HOME=$folder/data LIBGL_ALWAYS_SOFTWARE=1
mkdir -p "$folder/config/Rubble"
printf '[preferences]\ntheme=light\n' >"$folder/config/Rubble/Rubble.conf"

# start_editor <program> [project]: starts the editor, after a window manager before the first one.
manager=
start_editor() {
  until_true has_manager || fail 'no window manager is running'
  "$@" &
  editor=$!
  trap "kill $manager $editor 2>/dev/null || true; rm -rf '$folder'" EXIT
}
# has_manager: whether the window manager answers; starts it if it is not running.
has_manager() {
  { [ -n "$manager" ] && kill -0 "$manager"; } || { openbox >/dev/null 2>&1 & manager=$!; return 1; }
  xdotool get_desktop
}
# fail <message>: saves a screenshot to $RUBBLE_FAILURE_PICTURE and exits.
fail() {
  import -window root "${RUBBLE_FAILURE_PICTURE:-$folder/failure.png}" 2>/dev/null || true
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}
# until_true <command>...: waits until the command succeeds, for $patience seconds: far longer than it takes on a machine
# ten times slower.
patience=180
until_true() {
  local end=$((SECONDS + patience))
  while ! "$@" >/dev/null 2>&1; do
    [ $SECONDS -lt $end ] || return 1
    sleep 0.2  # between two looks
  done
}
# window_of <pattern>: prints the last visible window whose title matches.
window_of() { xdotool search --onlyvisible --name "$1" 2>/dev/null | tail -1; }
has_title() { [ -n "$(window_of "$1")" ]; }
# is_active <pattern>: whether the window with the keyboard focus has a title that matches.
is_active() { xdotool getactivewindow getwindowname 2>/dev/null | grep -qE "$1"; }
# activate <pattern>: gives the window the keyboard focus; it may be replaced by another while it opens.
activate() {
  window=$(window_of "$1")
  [ -n "$window" ] || return 1
  [ "$(xdotool getactivewindow)" = "$window" ] || { xdotool windowactivate "$window"; return 1; }
  [ "$window" = "$(window_of "$1")" ]
}
# focus_window <pattern>: waits for the window, focuses it, and sets $window, X, Y, WIDTH and HEIGHT.
focus_window() {
  until_true has_title "$1" || fail "no window has a title that matches $1"
  until_true activate "$1" || fail 'the window does not accept the focus'
  until_still picture || fail 'the window keeps changing'
  eval "$(xdotool getwindowgeometry --shell "$window")"
}
# picture: prints the pixels of the window.
picture() { import -window "$window" rgb:-; }
# until_still <command>...: waits until the command prints the same pixels at several looks.
until_still() {
  looks=0
  : >"$folder/last.pixels"
  until_true is_still "$@"
}
is_still() {
  "$@" >"$folder/now.pixels"
  if cmp -s "$folder/now.pixels" "$folder/last.pixels"; then looks=$((looks + 1)); else looks=0; fi
  mv "$folder/now.pixels" "$folder/last.pixels"
  [ $looks -ge 5 ]
}

# without_identity FILE: a project without its identity, which the first save gives it.
without_identity() { grep -v '^  "identity": ' "$1"; }
