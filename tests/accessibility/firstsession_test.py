#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The first session as assistive technology has it: the real program on a display of its own, led by accessible names,
roles and states alone, with the desktop's registry (AT-SPI) between.

usage: firstsession_test.py NMCPANEL

Debian's own Python, which has the registry's bindings. Nothing here judges time: what is waited for has MINUTES.
"""
import os
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

MINUTES = 120  # s
INNER = "NMC_ON_THE_DISPLAY"


def start_display():
    """The number of an X server without anything on it, and its process."""
    reader, writer = os.pipe()
    # Without -noreset, it starts anew when its last client leaves, and refuses whoever connects meanwhile.
    server = subprocess.Popen(["Xvfb", "-displayfd", str(writer), "-screen", "0", "1600x1200x24", "-nolisten", "tcp",
                               "-noreset"],
                              pass_fds=[writer], stderr=subprocess.DEVNULL)
    os.close(writer)
    with os.fdopen(reader) as said:
        return said.readline().strip(), server


def on_a_display_of_its_own():
    """This test again, as somebody's first login: an empty home, a session bus, a display."""
    number, server = start_display()
    with tempfile.TemporaryDirectory(prefix="nmc-accessible-") as home:
        environment = {"HOME": home, "XDG_RUNTIME_DIR": home, "PATH": "/usr/bin:/bin", "LANG": "C.UTF-8",
                       "DISPLAY": f":{number}", "QT_QPA_PLATFORM": "xcb", "QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1",
                       "DBUS_SYSTEM_BUS_ADDRESS": "unix:path=/nowhere", INNER: "1"}
        try:
            return subprocess.call(["dbus-run-session", "--", "/usr/bin/python3", __file__, *sys.argv[1:]],
                                   env=environment)
        finally:
            server.terminate()
            server.wait()


if INNER in os.environ:
    import gi
    gi.require_version("Atspi", "2.0")
    from gi.repository import Atspi, GLib
    LEAVES = {Atspi.Role.LABEL, Atspi.Role.PUSH_BUTTON, Atspi.Role.CHECK_BOX, Atspi.Role.TEXT}


class FirstSession(unittest.TestCase):
    def setUp(self):
        Atspi.init()
        self.heard = []  # names that changed: all that Qt 6.4 tells of news
        self.listener = Atspi.EventListener.new(lambda event: self.heard.append(event.source.get_name()))
        self.listener.register("object:property-change:accessible-name")
        self.panel = subprocess.Popen([PROGRAM])
        self.addCleanup(self.end)
        self.window = self.wait_for("the program's window", self.look_for_window)

    def end(self):
        self.listener.deregister("object:property-change:accessible-name")
        self.panel.kill()
        self.panel.wait()

    # ---- waiting ----

    def wait_for(self, what, look):
        """What `look` finds, as soon as it finds something."""
        until = time.monotonic() + MINUTES
        context = GLib.MainContext.default()
        while time.monotonic() < until:
            while context.iteration(False):
                pass
            self.assertIsNone(self.panel.poll(), "the program has ended")
            try:
                if found := look():
                    return found
            except GLib.Error:
                pass  # it went while it was looked at
            time.sleep(0.05)  # leaves the machine to the program
        raise AssertionError(f"waited in vain for {what}")

    def look_for_window(self):
        desktop = Atspi.get_desktop(0)
        for i in range(desktop.get_child_count()):
            program = desktop.get_child_at_index(i)
            if program is not None and program.get_process_id() == self.panel.pid and program.get_child_count() > 0:
                program.set_cache_mask(Atspi.Cache.NONE)
                return program
        return None

    # ---- who is there ----

    def named(self, name, role, node=None):
        """The first in sight whose name begins so. Each question is a round trip to the program, which takes long on a
        busy machine, so neither what is out of sight nor what has no children is walked through."""
        node = node or self.window
        for i in range(node.get_child_count()):
            child = node.get_child_at_index(i)
            if child is None or not self.has(child, "SHOWING"):
                continue
            its_role = child.get_role()
            if its_role == role and child.get_name().startswith(name):
                return child
            if its_role not in LEAVES and (found := self.named(name, role, child)):
                return found
        return None

    @staticmethod
    def has(node, state):
        return node.get_state_set().contains(getattr(Atspi.StateType, state))

    def find(self, name, role):
        return self.wait_for(f"{role.value_nick} {name!r}", lambda: self.named(name, role))

    def button(self, name):
        """Once it can be pressed."""
        found = self.find(name, Atspi.Role.PUSH_BUTTON)
        self.wait_for(f"{name!r} to be enabled", lambda: self.has(found, "ENABLED"))
        return found

    # ---- what is done ----

    def press(self, button):
        self.assertTrue(button.get_action_iface().do_action(0))

    def position(self, head):
        return self.wait_for("a position", lambda: self.named("Position ", Atspi.Role.LABEL, head)).get_name()

    # ---- the session ----

    def test_is_walked_by_names_and_roles_alone(self):
        simulator = self.button("Start the simulator")
        self.assertIn("no hardware", simulator.get_description())
        self.press(simulator)

        steps = self.find("First steps", Atspi.Role.PANEL)
        self.assertIn("Step 1 of 4", steps.get_description())
        self.press(self.button("Starting values"))
        self.press(self.button("Apply gains"))

        jog = self.find("Hold to move forward", Atspi.Role.PUSH_BUTTON)
        self.assertFalse(self.has(jog, "ENABLED"))
        self.assertTrue(jog.get_description(), "the reason why not")
        enable = self.button("Enable servo")
        self.press(enable)
        self.wait_for("the servo", lambda: not self.has(enable, "ENABLED") and "already on" in enable.get_description())

        head = self.find("State of the selected module", Atspi.Role.FRAME)
        before = self.position(head)
        self.button("Hold to move forward")  # enabled now
        self.press(self.button("Run forward"))
        self.wait_for("another position", lambda: self.position(head) != before)
        self.wait_for("the first steps to be gone", lambda: not self.named("First steps", Atspi.Role.PANEL))
        self.press(self.button("STOP ALL"))
        self.wait_for("what the stop came to", lambda: [words for words in self.heard if " stopped" in words])
        self.wait_for("the motor at rest", lambda: self.named("Holding", Atspi.Role.LABEL))

    def test_tells_what_is_checked(self):
        box = self.find("Active only", Atspi.Role.CHECK_BOX)
        self.assertFalse(self.has(box, "CHECKED"))
        self.press(box)
        self.wait_for("the check mark", lambda: self.has(box, "CHECKED"))

    def test_tells_why_a_control_is_disabled(self):
        disconnect = self.find("Disconnect", Atspi.Role.PUSH_BUTTON)
        self.assertFalse(self.has(disconnect, "ENABLED"))
        self.assertEqual(disconnect.get_description(), "No port is open.")


if __name__ == "__main__":
    if INNER not in os.environ:
        sys.exit(on_a_display_of_its_own())
    PROGRAM = Path(sys.argv.pop(1)).resolve()
    unittest.main(verbosity=2)
