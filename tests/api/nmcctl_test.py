#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""nmcctl at the built-in simulator or at nmcsim, by itself and through a line that another nmcctl serves.

usage: nmcctl_test.py NMCCTL NMCSIM
"""
import json
import os
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

sys.path[1:1] = [str(Path(__file__).resolve().parents[2] / folder) for folder in ("core/python", "tests/support")]
import inparallel  # noqa: E402
from nmcpanel import Panel  # noqa: E402

SIMULATOR = sys.argv.pop()
PROGRAM = sys.argv.pop()
# Counts by which a servo that holds a position moves to and fro within its friction (core/bus/standstill.h).
STILL = 4
GAINS = "kp=200 kd=2000 ki=20 il=200 ol=255 cl=0 el=8000 sr=1"
DONE, REFUSED, BAD_ARGUMENTS, NOT_REACHED, NO_CONTROL, NOT_CARRIED_OUT, INTERRUPTED = 0, 1, 2, 3, 4, 5, 130
CONTROL_LOST = "Control was lost: motors were stopped, the user took over, or the chain was disconnected. Run the command again.\n"


class Place:
    """A folder for files and sockets, and nmcctl, which knows no other."""

    def __init__(self):
        self._folder = tempfile.TemporaryDirectory()
        self.close = self._folder.cleanup
        self.folder = Path(self._folder.name)
        self._environment = {**os.environ, "LC_ALL": "C.UTF-8"}
        for name in ("XDG_RUNTIME_DIR", "XDG_CONFIG_HOME", "XDG_DATA_HOME"):
            self._environment[name] = str(self.folder / name)
            (self.folder / name).mkdir(0o700)
        self.socket = self.folder / "XDG_RUNTIME_DIR" / "nmcpanel" / "simulator.sock"

    def file(self, name, text=""):
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return str(path)

    def start(self, *words, **options):
        return subprocess.Popen([PROGRAM, *words], env=self._environment, **options)

    def ctl(self, *words, text=None):
        """Exit code, output, problems."""
        done = subprocess.run([PROGRAM, *words], env=self._environment, input=text, capture_output=True, text=True,
                              check=False)
        return done.returncode, done.stdout, done.stderr

    def check_refuses(self, test, *cases):
        for words, sentence in cases:
            with test.subTest(words):
                code, out, problems = self.ctl(*words)
                test.assertEqual((code, out), (BAD_ARGUMENTS, ""), problems)
                test.assertIn(sentence, problems)


class AtItsOwnLine(unittest.TestCase):
    def setUp(self):
        self.place = Place()
        self.addCleanup(self.place.close)

    MACHINE = """{"format": "nmc-panel-machine", "version": 1, "axes": [{"name": "X",
        "unit": {"kind": "millimetres", "counts_per_unit": 100}, "travel": {"highest_counts": 2000},
        "gains": {"Kp": 200, "Kd": 2000, "Ki": 20, "IL": 200, "OL": 255, "CL": 0, "EL_counts": 8000, "SR": 1}}]}"""

    def test_reads(self):
        code, out, _ = self.place.ctl("--simulator=servo,step,io", "list")
        self.assertEqual(code, DONE)
        rows = [row.split("\t") for row in out.splitlines()]
        self.assertEqual([row[2] for row in rows], ["servo", "stepper", "io"])
        self.assertEqual([row[4] for row in rows], ["0 counts", "0 steps", "-"])
        code, out, _ = self.place.ctl("--simulator=servo,io", "state", "--json")
        servo, io = json.loads(out)["modules"]
        self.assertEqual((code, servo["position"]), (DONE, 0))
        self.assertEqual([pin["input"] for pin in io["pins"]], [True] * 12)
        self.assertNotIn(None, [pin["high"] for pin in io["pins"]], "it waits until each module has reported")

    def test_shows_that_a_module_has_no_gains_or_none_that_are_known(self):
        code, out, _ = self.place.ctl("--simulator=servo,step,io", "-", text="gains 1\ngains 2\ngains 3\n")
        self.assertEqual((code, [row.split(":")[0] for row in out.splitlines()]), (DONE, ["not known", "none", "none"]))

    def test_carries_out_a_script_until_a_command_fails(self):
        script = f"# ready\ngains 1 --set {GAINS}\n\nenable 1\nmove 1 500\nmove-by 1 -200 --velocity=2\nmove 1 9e9\nmove 1 0\n"
        code, out, problems = self.place.ctl("--simulator=servo", "-", text=script)
        self.assertEqual(code, REFUSED, problems)
        places = [float(row.split()[1]) for row in out.splitlines()]
        self.assertEqual(len(places), 4, "what each command ended with")
        self.assertAlmostEqual(places[2], 500, delta=STILL)
        self.assertAlmostEqual(places[3], 300, delta=STILL)

    def test_does_nothing_if_there_is_no_command_in_a_script(self):
        for script in ("", "# nothing\n\n"):
            self.assertEqual(self.place.ctl("--simulator=servo", "-", text=script), (DONE, "", ""))

    def test_refuses_arguments(self):
        self.place.check_refuses(
            self, (("dance",), 'no command "dance"'), (("--simulator=frog", "list"), "frog"),
            (("--baud", "7", "list"), "baud rate"), (("serve",), "--port"),
            (("--read-only", "list"), "--port"), (("--baud", "19200", "list"), "--port"),
            (("--socket", "/none.sock", "--simulator=servo", "list"), "--socket"), ((), "command is missing"),
            (("--port", "", "list"), "empty"), (("--socket", "", "list"), "empty"),
            (("--simulator=servo", "--port", "/dev/none", "list"), "--port"),
            (("--simulator=servo", "--machine", "", "list"), "empty"),
            (("--simulator=servo", "record", str(self.place.folder)), str(self.place.folder)),
            (("--simulator=servo", "--machine", "/none.json", "list"), "There is no file /none.json."),
            (("--simulator=servo", "--machine", self.place.file("bad.json", "{"), "list"), "bad.json"))

    def test_says_what_cannot_be_reached(self):
        for words in (("list",), ("--socket", "/none.sock", "list"), ("--port", "/dev/none", "list")):
            code, out, problems = self.place.ctl(*words)
            self.assertEqual((code, out), (NOT_REACHED, ""), words)
            self.assertTrue(problems.strip().endswith("."), problems)

    def test_ends_where_it_cannot_let_anybody_in(self):
        self.place.socket.parent.symlink_to(self.place.folder)
        for command in ("serve", "list"):
            with self.subTest(command):
                code, out, problems = self.place.ctl("--simulator=servo", command)
                self.assertEqual((code, out), (NOT_REACHED, ""))
                self.assertIn("Other programs cannot connect.", problems)

    def test_knows_names_units_and_limits_from_the_machine_file(self):
        machine = self.place.file("bench.json", self.MACHINE)
        script = f"gains X --set {GAINS}\nenable X\nmove X 2.5mm\nmove X 3deg\n"
        code, out, problems = self.place.ctl("--simulator=servo", "--machine", machine, "-", text=script)
        self.assertEqual(code, BAD_ARGUMENTS, "degrees")
        self.assertIn("mm", problems)
        self.assertIn("limits of X are not in force", problems)
        name, place = out.splitlines()[-1].split("\t")
        self.assertEqual((name, place.split()[1]), ("X", "mm"))
        self.assertAlmostEqual(float(place.split()[0]), 2.5, delta=0.03)
        code, _, problems = self.place.ctl("--simulator=servo", "--machine", machine, "-",
                                     text="gains X --set\nenable X\nset-home X\nmove X 21mm\n")
        self.assertEqual(code, REFUSED, "beyond the travel limit")
        self.assertNotIn("not in force", problems)

    def test_a_search_that_ends_with_the_motor_off_has_found_home(self):
        machine = self.place.file("off.json", """{"format": "nmc-panel-machine", "version": 1, "axes": [{"name": "X",
            "homing": {"on_limit1": false, "on_limit2": false, "on_index": true, "on_position_error": false,
                       "on_current_limit": false, "on_home_switch": false, "then_index": false, "reverse": false,
                       "velocity_counts_per_tick": 0.5, "acceleration_counts_per_tick2": 0.01, "stop": "motor off",
                       "travel_limit_counts": 5000, "time_limit_s": 30, "go_to_home": false, "make_zero": false}}]}""")
        code, out, problems = self.place.ctl("--simulator=servo", "--machine", machine, "-",
                                             text=f"gains X --set {GAINS}\nenable X\nhome X --wait\nstate X\n")
        self.assertEqual(code, DONE, problems)
        self.assertIn("X", out)

    def test_takes_a_number_for_the_number_of_an_axis_whatever_others_are_called(self):
        machine = self.place.file("odd.json", """{"format": "nmc-panel-machine", "version": 1, "axes": [
            {"name": "2", "unit": {"kind": "millimetres", "counts_per_unit": 100}},
            {"name": "B", "unit": {"kind": "degrees", "counts_per_unit": 10}}, {"name": "B"}]}""")
        script = f"gains 2 --set {GAINS}\nenable 2\nmove 2 5deg\nstate B\n"
        code, out, problems = self.place.ctl("--simulator=servo,servo,servo", "--machine", machine, "-", text=script)
        self.assertEqual(code, BAD_ARGUMENTS, "two axes are called B")
        self.assertIn("Several axes have this name.", problems)
        self.assertAlmostEqual(float(out.splitlines()[-1].split("\t")[1].split()[0]), 5, delta=0.3)

    def test_records_what_the_scope_can_open_until_it_is_interrupted(self):
        path = Path(self.place.file("record.csv"))

        def rows():
            return [line.split(",") for line in path.read_text(encoding="utf-8").splitlines() if line[:1].isdigit()]

        recording = self.place.start("--simulator=servo,step", "record", str(path))
        while {row[0] for row in rows()} != {"1", "2"}:
            self.assertIsNone(recording.poll())
            time.sleep(0.02)
        recording.send_signal(signal.SIGINT)
        self.assertEqual(recording.wait(), DONE)
        lines = path.read_text(encoding="utf-8").splitlines()
        self.assertEqual(lines[0], "# NMC Panel recording 1")
        self.assertIn("# module 2 type: 3 (PIC-STEP)", lines)
        self.assertEqual({row[0] for row in rows()}, {"1", "2"})
        times = [float(row[1]) for row in rows() if row[0] == "1"]
        self.assertEqual(times, sorted(times))

    def test_says_that_its_output_could_not_be_written(self):
        for command in ("list", "watch"):
            with self.subTest(command), open("/dev/full", "w", encoding="utf-8") as full:
                program = self.place.start("--simulator=servo", command, stdout=full, stderr=subprocess.PIPE, text=True)
                _, problems = program.communicate()
                self.assertEqual(program.returncode, NOT_CARRIED_OUT, problems)
                self.assertEqual(problems.count("The output could not be written."), 1, problems)

    def test_ends_when_its_port_has_gone(self):
        with subprocess.Popen([SIMULATOR, "--chain", "servo"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              text=True) as sim:
            terminal = sim.stdout.readline().removeprefix("ready ").strip()
            watching = self.place.start("--port", terminal, "watch", stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        text=True)
            self.assertTrue(watching.stdout.readline(), "it has begun")
            sim.kill()
        _, problems = watching.communicate()
        self.assertEqual(watching.returncode, NOT_REACHED, problems)
        self.assertIn("The line is gone.", problems)

    def test_may_be_interrupted_while_it_closes_its_line(self):
        listing = self.place.start("--simulator=servo", "list", stdout=subprocess.PIPE, text=True)
        self.assertIn("servo", listing.stdout.readline())
        listing.send_signal(signal.SIGINT)
        listing.stdout.close()
        self.assertIn(listing.wait(), (DONE, -signal.SIGINT), "the signal may come behind all it does")

    def test_lists_every_method_but_those_without_use(self):
        code, out, _ = self.place.ctl("--help")
        self.assertEqual(code, DONE)
        commands = {row.split()[0] for row in out.splitlines() if row.startswith("  ") and row[2:3].isalpha()}
        page = (Path(__file__).resolve().parents[2] / "docs" / "api.md").read_text(encoding="utf-8")
        methods = {row.split("`")[1] for row in page.splitlines() if row.startswith("| `") and "| read |" not in row
                   and row.count("|") == 5 and "-320" not in row}
        self.assertIn("move_by", methods)
        renamed = {"set_gains": "gains", "start_sequence": "run-sequence"}
        self.assertLessEqual({renamed.get(name, name.replace("_", "-")) for name in methods}, commands)


class PanelAsWritten(threading.Thread):
    """One that accepts everything but what it is to refuse, for one program, and keeps what that has requested.

    It sends the news of a method ahead of each answer to it, so that they have arrived when that has.
    """
    AXIS = {"number": 1, "name": "", "type": "servo", "version": 4, "unit": "counts", "velocity_unit": "counts/tick",
            "counts_per_unit": 1, "gains": None, "travel_limits_in_force": True, "on": True, "position": 0,
            "state": "Holding", "analog": [], "pins": []}
    RESULTS = {"hello": {"protocol": "1.0", "program": "test", "asks_user": False}, "request_control": {"granted": True},
               "state": {**AXIS, "port": "none", "simulated": True, "modules": [AXIS, {**AXIS, "number": 2}]}, "wait": AXIS}

    def __init__(self, test, refusals=None, news=None):
        super().__init__()
        self.place = Place()
        test.addCleanup(self.place.close)
        self.refusals = refusals or {}  #: method: reasons of its calls in turn, the last of all later ones
        self.news = news or {}
        self.requests = []  #: method and parameters

    def run(self):
        self.connection, _ = self.listener.accept()
        with self.connection, self.connection.makefile("rwb") as lines:
            for line in lines:
                request = json.loads(line)
                self.requests.append((request["method"], request["params"]))
                self.answer(lines, request)

    def answer(self, lines, request):
        method = request["method"]
        reasons = self.refusals.get(method, [None])
        reason = reasons.pop(0) if len(reasons) > 1 else reasons[0]
        for name, parameters in self.news.get(method, ()):
            self.send(lines, {"method": name, "params": parameters})
        what = ({"error": {"code": -32000, "message": "Bad news.", "data": {"reason": reason}}} if reason else
                {"result": self.RESULTS.get(method, {"accepted": True})})
        self.send(lines, {"id": request["id"], **what})

    def send(self, lines, message):
        lines.write(json.dumps({"jsonrpc": "2.0", **message}).encode() + b"\n")
        lines.flush()

    def ctl(self, *words, text=None):
        path = str(self.place.folder / "written.sock")
        with socket.socket(socket.AF_UNIX) as self.listener:
            self.listener.bind(path)
            self.listener.listen()
            self.start()
            result = self.place.ctl("--socket", path, *words, text=text)
            self.join()
        return result

    def parameters_of(self, method):
        return [parameters for name, parameters in self.requests if name == method]


class PanelThatInterrupts(PanelAsWritten):
    """One that interrupts a program that calls this method with this parameter, instead of answering it."""

    def __init__(self, test, method, parameter):
        super().__init__(test)
        self.method, self.parameter = method, parameter

    def answer(self, lines, request):
        if request["method"] != self.method or self.parameter not in request["params"]:
            return super().answer(lines, request)
        program, _, _ = struct.unpack("3i", self.connection.getsockopt(
            socket.SOL_SOCKET, socket.SO_PEERCRED, struct.calcsize("3i")))
        return os.kill(program, signal.SIGINT)


class PanelThatQuits(PanelAsWritten):
    """One that goes away instead of answering a call of this method."""

    def __init__(self, test, method):
        super().__init__(test)
        self.method = method

    def answer(self, lines, request):
        if request["method"] != self.method:
            return super().answer(lines, request)
        return self.connection.shutdown(socket.SHUT_RDWR)


class PanelThatCannotRead(PanelThatQuits):
    """One that does so because it cannot read that call, and says so."""

    def answer(self, lines, request):
        if request["method"] == self.method:
            self.send(lines, {"id": None, "error": {"code": -32700, "message": "Bad news.",
                                                    "data": {"reason": "LineTooLong"}}})
        return super().answer(lines, request)


class PanelThatHesitates(PanelAsWritten):
    """One whose user takes a while to let a program move motors."""

    def answer(self, lines, request):
        if request["method"] == "request_control":
            time.sleep(0.6)
        super().answer(lines, request)


class AtAPanelThatAnswersAsWritten(unittest.TestCase):
    def test_what_was_begun_was_not_refused(self):
        for reason in ("NotSettled", "NotCarriedOut", "Unresponsive"):
            with self.subTest(reason):
                self.assertEqual(PanelAsWritten(self, {"wait": [reason]}).ctl("move", "1", "500", "--wait"),
                                 (NOT_CARRIED_OUT, "", "Bad news.\n"))

    def test_tells_a_user_that_control_was_lost_and_not_what_a_program_would_call(self):
        self.assertEqual(PanelAsWritten(self, {"set_gains": ["NoControl"]}).ctl("gains", "1", "--set", "kp=1"),
                         (NO_CONTROL, "", CONTROL_LOST))

    def test_says_that_the_user_is_asked_only_while_that_is_so(self):
        asked = "The panel asks its user whether this program may move motors.\n"
        for kind, answer, expected in (
                (PanelAsWritten, {"granted": True}, (DONE, "", "")),
                (PanelAsWritten, {"granted": False, "reason": "InUse"},
                 (NO_CONTROL, "", "Another program may move motors.\n")),
                (PanelAsWritten, {"granted": False, "reason": "Asking"},
                 (NO_CONTROL, "",
                  "The user is being asked about another request. Run the command again after that.\n")),
                (PanelThatHesitates, {"granted": True}, (DONE, "", asked)),
                (PanelThatHesitates, {"granted": False, "reason": "Refused"},
                 (NO_CONTROL, "", asked + "The user has refused.\n"))):
            with self.subTest(answer, kind=kind.__name__):
                panel = kind(self)
                panel.RESULTS = {**panel.RESULTS, "request_control": answer,
                                 "hello": {**panel.RESULTS["hello"], "asks_user": True}}
                code, out, err = panel.ctl("enable", "1")
                # On a busy computer, an answer may come late enough to be announced.
                self.assertEqual((code, out, err if asked in expected[2] else err.replace(asked, "")), expected)

    def test_asks_nobody_about_an_axis_that_does_not_exist(self):
        for words in (("move", "9", "5"), ("enable", "9"), ("jog", "9", "1", "5")):
            with self.subTest(words):
                panel = PanelAsWritten(self, {"state": ["AxisUnknown"]})
                self.assertEqual(panel.ctl(*words), (BAD_ARGUMENTS, "", "Bad news.\n"))
                self.assertEqual(panel.parameters_of("request_control"), [])

    def test_a_stop_is_carried_out_although_it_cancels_what_was_begun(self):
        panel = PanelAsWritten(self, {"wait": ["NotCarriedOut"]})
        self.assertEqual(panel.ctl("-", text="move 1 500\nstop --wait\nlist\n")[0], DONE)
        self.assertEqual(panel.requests[-1][0], "state", "it goes on")
        for words, reason, expected in ((("stop", "--wait"), "Unresponsive", NOT_CARRIED_OUT),
                                        (("stop", "1", "--wait"), "NotCarriedOut", NOT_CARRIED_OUT)):
            with self.subTest(words):
                self.assertEqual(PanelAsWritten(self, {"wait": [reason]}).ctl(*words), (expected, "", "Bad news.\n"))

    def test_a_jog_that_has_begun_was_not_refused(self):
        for reasons, expected in ((["ServoOff"], REFUSED), ([None, "ServoOff"], NOT_CARRIED_OUT),
                                  ([None, None, "NoControl"], NOT_CARRIED_OUT), ([None, "NotConnected"], NOT_REACHED),
                                  ([None, "AxisUnknown"], NOT_CARRIED_OUT), ([None, "FieldWrong"], NOT_CARRIED_OUT)):
            with self.subTest(reasons):
                panel = PanelAsWritten(self, {"jog": list(reasons)})
                lost = reasons[-1] == "NoControl"
                self.assertEqual(panel.ctl("jog", "1", "0.5", "3600"),
                                 (expected, "", CONTROL_LOST if lost else "Bad news.\n"))
                self.assertEqual(len(panel.parameters_of("jog")), len(reasons))

    def test_jogs_for_a_while_and_stops_its_axis(self):
        # How often depends on the time that this computer gives it.
        panel = PanelAsWritten(self)
        code, _, problems = panel.ctl("jog", "1", "0.5", "0.4")
        self.assertEqual((code, problems), (DONE, ""))
        jogs = panel.parameters_of("jog")
        self.assertEqual(jogs, len(jogs) * [{"axis": 1, "velocity": 0.5}])
        self.assertEqual(panel.parameters_of("stop"), [{"axis": 1}])
        methods = [method for method, _ in panel.requests]
        self.assertNotIn("jog", methods[methods.index("stop"):])

    def test_jogs_from_when_the_user_has_agreed(self):
        panel = PanelThatHesitates(self)
        self.assertEqual(panel.ctl("jog", "1", "0.5", "0.2")[0], DONE)
        self.assertNotEqual(panel.parameters_of("jog"), [])

    def test_tells_one_who_waits_for_somebody_elses_motor_how_that_ended(self):
        for reason, expected in (("NotSettled", NOT_CARRIED_OUT), ("NotCarriedOut", NOT_CARRIED_OUT),
                                 ("Unresponsive", REFUSED), ("AxisUnknown", BAD_ARGUMENTS)):
            with self.subTest(reason):
                self.assertEqual(PanelAsWritten(self, {"wait": [reason]}).ctl("wait", "1"),
                                 (expected, "", "Bad news.\n"))

    def test_takes_velocities_of_an_axis_in_counts_per_tick_only(self):
        panel = PanelAsWritten(self)
        words = ("move", "1", "500counts", "--velocity", "1.5counts/tick", "--acceleration", "0.01counts/tick2")
        self.assertEqual(panel.ctl(*words), (DONE, "", ""))
        self.assertEqual(panel.parameters_of("move"), [{"axis": 1, "to": 500, "velocity": 1.5, "acceleration": 0.01}])
        for words in (("jog", "1", "20counts/s", "1"), ("move", "1", "5", "--velocity", "20counts/s"),
                      ("move", "1", "5", "--acceleration=20counts/s2")):
            with self.subTest(words):
                panel = PanelAsWritten(self)
                code, _, problems = panel.ctl(*words)
                self.assertEqual(code, BAD_ARGUMENTS)
                self.assertIn("counts/tick", problems)
                self.assertNotIn(words[0], [method for method, _ in panel.requests])

    def test_takes_velocities_of_an_axis_whose_own_unit_is_called_counts_per_second(self):
        panel = PanelAsWritten(self)
        panel.RESULTS = {**panel.RESULTS, "state": {**panel.AXIS, "velocity_unit": "counts/s"}}
        words = ("move", "1", "5counts", "--velocity", "20counts/s", "--acceleration", "30counts/s2")
        self.assertEqual(panel.ctl(*words), (DONE, "", ""))
        self.assertEqual(panel.parameters_of("move"), [{"axis": 1, "to": 5, "velocity": 20, "acceleration": 30}])


    def test_asks_for_control_again_once_it_is_lost(self):
        lost = ("control_lost", {"reason": "Somebody has stopped the motors."})
        for news in ({}, {"stop": (lost,)}, {"state": (lost,)}):
            with self.subTest(news):
                panel = PanelAsWritten(self, news=news)
                self.assertEqual(panel.ctl("-", text="enable 1\nstop\nstate 1\nenable 1\n")[0], DONE)
                self.assertEqual([method for method, _ in panel.requests if method not in ("hello", "state")],
                                 ["request_control", "enable", "stop", "request_control", "enable", "request_control"],
                                 "the last one lets the motor move on")

    def test_asks_nobody_to_let_a_motor_move_on_that_was_stopped(self):
        lost = ("control_lost", {"reason": "Somebody has stopped the motors."})
        for script, news, expected in (("enable 1\nstop\n", {}, DONE),
                                       ("enable 1\nstate 1\n", {"state": (lost,)}, NOT_CARRIED_OUT)):
            with self.subTest(script):
                panel = PanelAsWritten(self, news=news)
                self.assertEqual(panel.ctl("-", text=script)[0], expected)
                self.assertEqual(panel.parameters_of("request_control"), [{}])

    def test_says_that_what_it_left_running_is_stopped_because_control_is_lost(self):
        lost = ("control_lost", {"reason": "The user has commanded a motor."})
        for method, script, expected in (
                ("wait", "move 1 500\nmove 2 5 --wait\n", NOT_CARRIED_OUT), ("wait", "move 1 500\nwait\n", DONE),
                ("wait", "run-sequence A\nmove 1 500 --wait\n", NOT_CARRIED_OUT),
                ("wait", "move 1 500\nrun-sequence A --wait\n", DONE),
                ("state", "move 1 500\nwait 1\nstate 1\n", DONE), ("state", "move 1 500\nstop 1\n", DONE),
                ("state", "enable 1\nmove 1 500 --wait\n", DONE),
                ("state", "gains X --set kp=1\nmove X 500 --wait\n", DONE),
                ("state", "move 1 500\nwait 2\nstate 1\n", NOT_CARRIED_OUT),
                ("state", "move 1 500\nwait 1\nmove 1 0\nstate 1\n", NOT_CARRIED_OUT)):
            with self.subTest(script):
                code, _, problems = PanelAsWritten(self, news={method: (lost,)}).ctl("-", text=script)
                self.assertEqual(code, expected)
                self.assertEqual("Control is lost" in problems, expected != DONE, problems)

    def test_says_so_if_it_is_interrupted_before_it_lets_a_motor_move_on(self):
        self.assertEqual(PanelThatInterrupts(self, "request_control", "on_disconnect").ctl("move", "1", "500"),
                         (INTERRUPTED, "", "Interrupted.\n"))

    def test_requests_nothing_if_it_is_interrupted_before_the_panel_has_answered(self):
        panel = PanelThatInterrupts(self, "hello", "program")
        code, out, problems = panel.ctl("move", "1", "500")
        self.assertEqual((code, out), (INTERRUPTED, ""))
        self.assertTrue(problems.endswith(": Interrupted.\n"), problems)
        self.assertEqual([method for method, _ in panel.requests], ["hello"])

    def test_says_that_the_panel_has_gone_whenever_it_does(self):
        for method in ("hello", "state", "request_control", "move", "wait"):
            with self.subTest(method):
                code, out, problems = PanelThatQuits(self, method).ctl("move", "1", "500", "--wait")
                self.assertEqual((code, out), (NOT_REACHED, ""))
                self.assertTrue(problems.endswith("The panel has gone.\n"), problems)

    def test_says_why_the_panel_cuts_it_off(self):
        panel = PanelThatCannotRead(self, "start_sequence")
        self.assertEqual(panel.ctl("run-sequence", "none"), (REFUSED, "", "Bad news.\n"))

    def test_sends_gains_by_their_names_only(self):
        names = ("kp", "kd", "ki", "il", "ol", "cl", "el", "sr", "db", "sm")
        panel = PanelAsWritten(self)
        self.assertEqual(panel.ctl("gains", "1", "--set", *(f"{name.upper()}=1" for name in names)), (DONE, "", ""))
        self.assertEqual(panel.parameters_of("set_gains"), [{"axis": 1, **dict.fromkeys(names, 1)}])
        for word in ("kpp=120", "axis=2", "=5"):
            with self.subTest(word):
                panel = PanelAsWritten(self)
                code, _, problems = panel.ctl("gains", "1", "--set", "kd=900", word)
                self.assertEqual((code, panel.parameters_of("set_gains")), (BAD_ARGUMENTS, []))
                self.assertIn(f'no gain "{word.split("=")[0]}"', problems)

    def test_records_samples_only_and_is_sent_none_afterwards(self):
        row = [0.5, 100, None, None, 8, 0, 51, False, None]
        panel = PanelAsWritten(self, news={"subscribe": (
            ("control_lost", {"reason": "Somebody has stopped the motors."}), ("event", {"text": "Something"}),
            ("samples", {"missed": 0, "modules": [{"axis": 1, "rows": [row]}, {"axis": 2, "rows": [row, row]}]}))})
        path = panel.place.file("record.csv")
        code, out, problems = panel.ctl("-", text=f"record {path} --seconds 0\nlist\n")
        self.assertEqual((code, len(out.splitlines()), problems), (DONE, 2, ""))
        lines = Path(path).read_text(encoding="utf-8").splitlines()
        self.assertEqual([line[0] for line in lines if line[0].isdigit()], ["1", "2", "2"])
        self.assertEqual(panel.parameters_of("subscribe"), [{"samples": True}, {}])

    def test_records_no_samples_of_another_chain(self):
        def samples(axis, seconds):
            return "samples", {"missed": 0, "modules": [
                {"axis": axis, "rows": [[seconds, 100, None, None, 8, 0, 51, False, None]]}]}

        for other in (samples(1, 0.0), samples(3, 7.5)):
            with self.subTest(other):
                panel = PanelAsWritten(self, news={"subscribe": (samples(1, 7.0), other)})
                path = panel.place.file("record.csv")
                code, _, problems = panel.ctl("record", path, "--seconds", "60")
                self.assertEqual(code, NOT_CARRIED_OUT)
                self.assertIn("Another chain", problems)
                lines = Path(path).read_text(encoding="utf-8").splitlines()
                self.assertEqual([line.split(",")[:2] for line in lines if line[0].isdigit()], [["1", "0.000000000"]])

    def test_watches_several_axes_of_one_name(self):
        axes = [{**PanelAsWritten.AXIS, "name": "B", "number": number, "position": 10 * number} for number in (1, 2)]
        panel = PanelAsWritten(self, news={"subscribe": 3 * (("state", {"modules": axes}),)})
        code, out, problems = panel.ctl("watch", "--seconds", "0")
        self.assertEqual((code, problems), (DONE, ""))
        self.assertEqual(out.splitlines(), ["B\t10 counts\tHolding", "B\t20 counts\tHolding"])
        self.assertEqual(panel.parameters_of("subscribe"), [{"state": True, "events": True}, {}])


class AServedLine(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = Place()
        cls.addClassCleanup(cls.place.close)
        cls.server = cls.place.start("--simulator=servo,io", "serve", stderr=subprocess.DEVNULL)
        cls.addClassCleanup(cls.server.wait)
        cls.addClassCleanup(cls.server.terminate)
        while not cls.place.socket.exists() and cls.server.poll() is None:
            time.sleep(0.02)

    def setUp(self):
        self.panel = Panel(self.place.socket, program="test")
        self.addCleanup(self.panel.close)
        while self.panel.state()["phase"] != "connected":
            time.sleep(0.02)
        self.assertEqual(self.place.ctl("stop", "--wait")[0], DONE)
        self.assertEqual(self.place.ctl("gains", "1", "--set", *GAINS.split(), "--wait")[0], DONE)
        self.assertEqual(self.place.ctl("enable", "1", "--wait")[0], DONE)

    def axis(self):
        return self.panel.axis(1).state()

    def begin(self, *words):
        moving = self.place.start(*words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while not self.axis()["moving"] and moving.poll() is None:
            time.sleep(0.02)
        return moving


class ThroughAServedLine(AServedLine):
    def test_refuses_arguments(self):
        self.place.check_refuses(
            self, (("move", "1"), "missing"), (("move", "1", "far"), "not a number"), (("move", "1", "5mm"), "counts"),
            (("move", "1", "5", "6"), "too much"), (("move", "1", "5", "--fast"), "--fast"),
            (("move", "Y", "5"), "no such axis"), (("gains", "1", "--set", "kp=99999"), "kp"),
            (("gains", "1", "--get", "--set", "kp=1"), "either"),
            (("run-sequence", "none"), "no sequence"), (("set-output", "2", "1", "maybe"), "maybe"),
            (("watch", "--seconds", "x"), "seconds"))

    def test_takes_the_socket_from_where_it_is_called(self):
        listing = self.place.start("--socket", self.place.socket.name, "list", cwd=self.place.socket.parent,
                                   stdout=subprocess.DEVNULL)
        self.assertEqual(listing.wait(), DONE)

    def test_passes_over_the_socket_of_a_panel_that_crashed(self):
        left = self.place.socket.with_name("crashed.sock")
        with socket.socket(socket.AF_UNIX) as crashed:
            crashed.bind(str(left))
        self.addCleanup(left.unlink)
        self.assertEqual(self.place.ctl("list")[0], DONE)

    def test_leaves_running_what_nobody_waits_for(self):
        begin = self.axis()["position"]
        code, out, problems = self.place.ctl("move-by", "1", "100000000")
        self.assertEqual((code, out, problems), (DONE, "", ""), "nobody is asked, so nothing is said of it")
        while (place := self.axis()["position"]) < begin + 10:
            time.sleep(0.02)
        self.panel.axis(1).call("stop")
        rest = self.panel.axis(1).wait()
        self.assertGreater(rest["position"], place, "it went on after nmcctl had ended")
        self.assertLess(rest["position"], begin + 90_000_000)

    def test_stops_what_it_waits_for_when_interrupted(self):
        moving = self.begin("move", "1", "100000000", "--wait")
        moving.send_signal(signal.SIGINT)
        self.assertEqual(moving.wait(), INTERRUPTED)
        self.assertLess(self.panel.axis(1).wait()["position"], 90_000_000)

    def test_learns_that_somebody_stopped_its_motor(self):
        moving = self.begin("move", "1", "1000000", "--wait")
        self.assertEqual(self.place.ctl("move", "1", "0")[0], NO_CONTROL, "another one has it")
        self.assertEqual(self.place.ctl("stop")[0], DONE)
        self.assertEqual(moving.wait(), NOT_CARRIED_OUT)

    def test_shows_changes(self):
        watching = self.place.start("watch", stdout=subprocess.PIPE, text=True)
        self.assertIn("Holding", watching.stdout.readline())
        self.assertEqual(self.place.ctl("move", "1", "300", "--wait")[0], DONE)
        for line in watching.stdout:
            if line.startswith("1\t") and abs(float(line.split()[1]) - 300) < 5:
                break
        watching.send_signal(signal.SIGINT)
        watching.stdout.close()
        self.assertEqual(watching.wait(), INTERRUPTED)


class AServedLineThatIsLost(AServedLine):
    def test_ends_with_the_line(self):
        moving = self.begin("move", "1", "1000000", "--wait")
        self.server.terminate()
        self.assertEqual(self.server.wait(), DONE)
        self.assertIn(moving.wait(), (NOT_REACHED, NOT_CARRIED_OUT, REFUSED))


if __name__ == "__main__":
    inparallel.main()
