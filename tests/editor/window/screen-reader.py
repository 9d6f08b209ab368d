#!/usr/bin/python3
"""Reads the windows of the editor over AT-SPI, as a screen reader does.

screen-reader.py PID DOCK...: fails unless the program has an accessible tree in which every control that takes the
focus has a name, each dock is there, and the canvas has children with names and places. Prints what it found.
"""
import sys
import time

import gi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi  # noqa: E402

PATIENCE = 180  # s: far longer than it takes on a machine ten times slower
MOST_CHILDREN = 40  # of a list or a table that are read
CONTROLS = {
    Atspi.Role.PUSH_BUTTON, Atspi.Role.TOGGLE_BUTTON, Atspi.Role.CHECK_BOX, Atspi.Role.RADIO_BUTTON,
    Atspi.Role.COMBO_BOX, Atspi.Role.SPIN_BUTTON, Atspi.Role.SLIDER, Atspi.Role.TEXT, Atspi.Role.MENU_ITEM,
    Atspi.Role.PAGE_TAB, Atspi.Role.TABLE, Atspi.Role.TREE, Atspi.Role.LIST,
}


def fail(message):
    print(f"screen-reader.py: {message}", file=sys.stderr)
    sys.exit(1)


def program(pid):
    desktop = Atspi.get_desktop(0)
    for index in range(desktop.get_child_count()):
        application = desktop.get_child_at_index(index)
        if application and application.get_process_id() == pid and application.get_child_count() > 0:
            return application
    return None


def is_shown(node):
    return node.get_state_set().contains(Atspi.StateType.SHOWING)


def walk(node, path, visit):
    visit(node, path)
    for index in range(min(node.get_child_count(), MOST_CHILDREN)):
        child = node.get_child_at_index(index)
        if child:
            walk(child, path + [child.get_name() or child.get_role_name()], visit)


class Reading:
    def __init__(self, root):
        self.controls = 0
        self.nameless = []
        self.names = set()
        self.canvas = None
        walk(root, [], self.visit)

    def visit(self, node, path):
        name = node.get_name() or ""
        self.names.add(name)
        if name == "Pattern canvas":
            self.canvas = node
        if node.get_role() in CONTROLS and is_shown(node):
            self.controls += 1
            if not name:
                self.nameless.append(" ▸ ".join(path))

    def fragments(self):
        """Those children of the canvas that have a name and lie on it."""
        count = self.canvas.get_child_count() if self.canvas else 0
        children = [self.canvas.get_child_at_index(index) for index in range(count)]
        place = self.canvas.get_extents(Atspi.CoordType.SCREEN) if self.canvas else None
        found = 0
        for child in filter(None, children):
            box = child.get_extents(Atspi.CoordType.SCREEN)
            inside = place.x <= box.x + box.width / 2 <= place.x + place.width
            inside = inside and place.y <= box.y + box.height / 2 <= place.y + place.height
            found += 1 if child.get_name() and inside and box.width > 0 else 0
        return found


def main():
    pid, docks = int(sys.argv[1]), sys.argv[2:]
    end = time.monotonic() + PATIENCE
    reading, missing = None, docks
    while time.monotonic() < end:
        application = program(pid)
        if application:
            reading = Reading(application)
            missing = [dock for dock in docks if dock not in reading.names]
            if not missing and reading.fragments() > 0:
                break
        time.sleep(0.2)  # between two readings
    if not reading:
        fail("the editor is not on the accessibility bus")
    if missing:
        fail(f"not found: {', '.join(missing)}")
    if reading.fragments() == 0:
        fail("the canvas has no fragments")
    if reading.nameless:
        fail("controls without a name: " + "; ".join(reading.nameless))
    print(f"{reading.controls} controls with a name, {reading.fragments()} fragments on the canvas")


main()
