#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python client at a real panel on the built-in simulator. usage: python_test.py NMCPANEL"""
import asyncio
import itertools
import json
import math
import os
import pwd
import socket
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import unittest.mock
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "core" / "python"))
from nmcpanel import ControlLost, NotCarriedOut, Panel, PanelError, Refused, sockets  # noqa: E402

PROGRAM = sys.argv.pop()
# Counts by which a servo that holds a position moves to and fro within its friction (core/bus/standstill.h).
STILL = 4
GAINS = {"kp": 200, "kd": 2000, "ki": 20, "il": 200, "ol": 255, "cl": 0, "el": 8000, "sr": 1}


class PanelWithoutASocket(Panel):
    """One whose calls take a while, as those of a real one do; notes those that are made during another one."""

    def __init__(self, program):
        self.about = {"program": program}
        self.in_use = threading.Lock()
        self.jogging = threading.Event()
        self.methods, self.at_once = [], []

    def call(self, method, **parameters):
        alone = self.in_use.acquire(blocking=False)
        self.methods.append(method)
        if not alone:
            self.at_once.append(method)
        if method == "jog":
            self.jogging.set()
            time.sleep(0.05)
        if alone:
            self.in_use.release()
        return {"granted": True, "position": 0.0}

    def close(self):
        self.methods.append("close")


class PanelAsWritten(threading.Thread):
    """One for one program, which sends what `answers` returns for each request, up to None, at which it quits.

    A text is sent as it is.
    """

    def __init__(self, test, answers):
        super().__init__(daemon=True)
        folder = tempfile.TemporaryDirectory()
        test.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "written.sock")
        self.answers = answers
        self.requests = []
        self.listener = socket.socket(socket.AF_UNIX)
        self.listener.bind(self.path)
        self.listener.listen()
        self.start()

    def run(self):
        with self.listener:
            connection, _ = self.listener.accept()
        # As bytes: a text file that is written to forgets what it has read ahead, such as the next request.
        with connection, connection.makefile("rwb") as lines:
            for line in lines:
                self.requests.append(json.loads(line))
                for answer in self.answers(self.requests[-1]):
                    if answer is None:
                        return
                    text = answer if isinstance(answer, str) else json.dumps({"jsonrpc": "2.0", **answer}) + "\n"
                    lines.write(text.encode(errors="surrogateescape"))
                lines.flush()


def refusal(reason, code=-32000):
    return {"error": {"code": code, "message": "Bad news.", "data": {"reason": reason}}}


class WithoutAPanel(unittest.TestCase):
    def test_keeps_no_connection_to_a_panel_that_refuses_it(self):
        panels = []

        class KeptPanel(Panel):
            def __init__(self, path):
                panels.append(self)
                super().__init__(path)

        written = PanelAsWritten(self, lambda request: [{"id": request["id"], **refusal("OtherProtocol", -32002)}])
        with self.assertRaises(Refused) as caught:
            KeptPanel(written.path)
        self.assertEqual((str(caught.exception), caught.exception.reason), ("Bad news.", "OtherProtocol"))
        self.assertEqual(panels[0]._socket.fileno(), -1, "it is closed")

    def test_says_that_the_panel_has_gone_within_a_line_or_a_character(self):
        for part in ('{"jsonrpc": "2.0", "id": 1, "resu', '{"jsonrpc": "2.0", "id": 1, "result": "\udcc2'):
            with self.subTest(part), self.assertRaises(PanelError):
                Panel(PanelAsWritten(self, lambda _, part=part: [part, None]).path)

    def test_says_that_another_service_is_no_panel(self):
        for answer in ({"id": 1, "error": {"code": -32601, "message": "Method not found"}}, {"id": 1, "error": "no"},
                       "[]\n", "220 mail.example.org ESMTP\n"):
            with self.subTest(answer), self.assertRaises(PanelError) as caught:
                Panel(PanelAsWritten(self, lambda _, answer=answer: [answer]).path)
            self.assertEqual(str(caught.exception), "the program that answers is not NMC Panel")

    def test_is_told_why_a_panel_cuts_it_off(self):
        def answers(request):
            if request["method"] == "hello":
                return [{"id": request["id"], "result": {}}]
            return [{"id": None, **refusal("LineTooLong", -32700)}, None]

        with Panel(PanelAsWritten(self, answers).path) as panel, self.assertRaises(Refused) as caught:
            panel.start_sequence(70_000 * "x")
        self.assertEqual(caught.exception.reason, "LineTooLong")

    def test_a_jog_that_has_begun_was_not_refused(self):
        for reasons, expected in ((["ServoOff"], Refused), ([None, "ServoOff"], NotCarriedOut),
                                  ([None, "NoControl"], ControlLost)):
            def answers(request, reasons=reasons):
                reason = reasons.pop(0) if request["method"] == "jog" else None
                return [{"id": request["id"], **(refusal(reason) if reason else {"result": {}})}]

            with self.subTest(reasons), Panel(PanelAsWritten(self, answers).path) as panel:
                with self.assertRaises(Refused) as caught:
                    panel.axis(1).jog(0.5, 3600)
                self.assertIs(type(caught.exception), expected)
                self.assertEqual(str(caught.exception), "Bad news.")

    def test_ends_a_subscription_with_its_iterator(self):
        times = itertools.count()
        subscribed = False

        def samples():
            if not subscribed:
                return []
            row = [next(times), 0, None, None, 0, 0, 0, False, None]
            return [{"method": "samples", "params": {"missed": 0, "modules": [{"axis": 1, "rows": [row]}]}}]

        def answers(request):
            nonlocal subscribed
            late = samples()
            if request["method"] == "subscribe":
                subscribed = "samples" in request.get("params", {})
            answer = [{"id": request["id"], "result": {}}] if "id" in request else []
            return [*late, *answer, *samples()]

        written = PanelAsWritten(self, answers)
        with Panel(written.path) as panel:
            for expected in (0, 2):
                # One more is on its way when the iterator ends.
                self.assertEqual([sample.time for sample in itertools.islice(panel.samples(), 1)], [expected])
                panel.state()
        written.join()
        self.assertEqual([request.get("params") for request in written.requests if request["method"] == "subscribe"],
                         [{"samples": True}, None, {"samples": True}, None])

    def test_shows_for_each_axis_where_it_was_too_slow(self):
        def samples(missed, *axes):
            rows = 2 * [[0, 0, None, None, 0, 0, 0, False, None]]
            return {"method": "samples",
                    "params": {"missed": missed, "modules": [{"axis": axis, "rows": rows} for axis in axes]}}

        def answers(request):
            if "id" not in request:
                return []
            begun = request["method"] == "subscribe"
            return [{"id": request["id"], "result": {}},
                    *([samples(0, 1, 2), samples(7, 1), samples(0, 1, 2)] if begun else [])]

        with Panel(PanelAsWritten(self, answers).path) as panel:
            gaps = [(sample.axis, sample.gap) for sample in itertools.islice(panel.samples(), 10)]
        self.assertEqual(gaps, [(1, False), (1, False), (2, False), (2, False), (1, True), (1, False),
                                (1, False), (1, False), (2, True), (2, False)])

    def test_drops_no_event_where_too_much_arrives_during_a_call(self):
        def samples(time, missed):
            rows = [[time, 0, None, None, 0, 0, 0, False, None]]
            return {"method": "samples", "params": {"missed": missed, "modules": [{"axis": 1, "rows": rows}]}}

        event, state, lost = ({"method": method, "params": {}} for method in ("event", "state", "control_lost"))

        def answers(request):
            begun = request["method"] == "state"
            return [*([event, samples(1, 0), state, samples(2, 5), samples(3, 0), lost] if begun else []),
                    {"id": request["id"], "result": {}}]

        with unittest.mock.patch("nmcpanel.KEPT_NOTIFICATIONS", 3), Panel(PanelAsWritten(self, answers).path) as panel:
            panel.state()
            lines = list(itertools.islice(panel.notifications(), 3))
        # The samples 1 and 2, and the five that the panel had dropped between them.
        self.assertEqual(lines, [{"jsonrpc": "2.0", **line} for line in (event, samples(3, 7), lost)])

    def test_finds_the_sockets_where_qt_has_them(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            own, given = folder / f"runtime-{pwd.getpwuid(os.geteuid()).pw_name}", folder / "given"
            for runtime in (own, given):
                (runtime / "nmcpanel").mkdir(parents=True)
                runtime.chmod(0o700)
                listener = socket.socket(socket.AF_UNIX)
                self.addCleanup(listener.close)
                listener.bind(str(runtime / "nmcpanel" / "one.sock"))
                listener.listen()
            (folder / "link").symlink_to(given)
            for runtime, expected in (("", own), (given, given), (folder / "none", own), (folder / "link", own)):
                environment = {"XDG_RUNTIME_DIR": str(runtime), "TMPDIR": name, "LOGNAME": "somebody"}
                with self.subTest(runtime), unittest.mock.patch.dict(os.environ, environment):
                    self.assertEqual(sockets(), [expected / "nmcpanel" / "one.sock"])
            given.chmod(0o755)
            with unittest.mock.patch.dict(os.environ, {"XDG_RUNTIME_DIR": str(given), "TMPDIR": name}):
                self.assertEqual(sockets(), [own / "nmcpanel" / "one.sock"], "others may enter the one that is given")
            own.chmod(0o755)
            with unittest.mock.patch.dict(os.environ, {"XDG_RUNTIME_DIR": "", "TMPDIR": name}):
                self.assertEqual(sockets(), [], "it may be anybody's")

    def test_says_what_is_wrong_with_a_path(self):
        for path, problem in (("/none.sock", "No such file"), ("/" + 200 * "x", "too long")):
            with self.assertRaises(PanelError) as caught:
                Panel(path)
            self.assertIn(problem, str(caught.exception))

    def test_an_axis_jogs_again_and_again_and_then_stops(self):
        panel = PanelWithoutASocket("test")
        clock = unittest.mock.Mock(**{"monotonic.side_effect": (0.0, 0.0, 0.04, 0.08, 0.12)})
        with unittest.mock.patch("nmcpanel.time", clock):
            panel.axis(1).jog(-0.5, 0.1)
        self.assertEqual(panel.methods, ["jog", "jog", "jog", "stop", "wait"])

    def test_the_centrifuge_stops_only_after_its_jog_when_it_is_interrupted(self):
        sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "docs" / "examples"))
        import centrifuge

        async def interrupted():
            device = centrifuge.Centrifuge("X")
            await device.setup()
            spinning = asyncio.create_task(device.spin(60, 0.5))
            await asyncio.to_thread(device.panel.jogging.wait)
            spinning.cancel()  # as asyncio does at Ctrl+C
            await device.stop()
            return device.panel

        with unittest.mock.patch.object(centrifuge, "Panel", PanelWithoutASocket):
            panel = asyncio.run(interrupted())
        self.assertEqual(panel.at_once, [])
        self.assertEqual(panel.methods[-1], "close")
        self.assertIn("stop", panel.methods)
        self.assertNotIn("jog", panel.methods[panel.methods.index("stop"):])


class Client(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        for name in ("XDG_RUNTIME_DIR", "XDG_CONFIG_HOME", "XDG_DATA_HOME"):
            os.environ[name] = os.path.join(cls.folder.name, name)
            os.mkdir(os.environ[name], 0o700)
        os.environ.update(QT_QPA_PLATFORM="offscreen", LANG="C.UTF-8")
        cls.panel = subprocess.Popen([PROGRAM, "--serve=control", "--simulator", "servo,servo"],
                                     stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        while not sockets() and cls.panel.poll() is None:
            time.sleep(0.05)
        with Panel() as panel:
            while panel.state()["phase"] != "connected":
                time.sleep(0.05)

    @classmethod
    def tearDownClass(cls):
        cls.panel.terminate()
        cls.panel.wait()
        cls.folder.cleanup()

    def test_moves_and_reads(self):
        with Panel(program="test") as panel:
            panel.request_control()
            axis = panel.axis(1)
            axis.set_gains(**GAINS)
            with self.assertRaises(TypeError):
                axis.set_gains(kpp=3)
            axis.enable()
            axis.move(400)
            self.assertAlmostEqual(axis.position, 400, delta=STILL)
            axis.move_by(-150, velocity=2)
            self.assertAlmostEqual(axis.position, 250, delta=STILL)
            for sample in itertools.islice(panel.samples(), 50):
                self.assertIn(sample.axis, (1, 2))
            axis.move(100_000_000, wait=False)
            with Panel() as other:
                other.stop()
            with self.assertRaises(NotCarriedOut):
                axis.wait()
            axis.motor_off()
            self.assertFalse(axis.state()["on"])

    def test_is_refused_in_words(self):
        with Panel() as panel, Panel(program="another") as other:
            with self.assertRaises(ControlLost):
                panel.axis(1).enable()
            panel.request_control()
            with self.assertRaisesRegex(ControlLost, "another program has control"):
                other.request_control()
            with self.assertRaises(Refused) as caught:
                panel.axis(2).move(1)
            self.assertEqual(caught.exception.reason, "ServoOff")
            self.assertTrue(str(caught.exception).endswith("."))
            with self.assertRaises(Refused) as caught:
                panel.axis("nobody").enable()
            self.assertEqual(caught.exception.reason, "AxisUnknown")
            with self.assertRaises(Refused) as caught:
                panel.axis("nobody").wait()
            self.assertNotIsInstance(caught.exception, NotCarriedOut, "nothing was begun")
            for number in (math.nan, math.inf):
                with self.assertRaises(ValueError) as caught:
                    panel.axis(2).move(number)
                self.assertIn("move", str(caught.exception))
            self.assertEqual(panel.state()["phase"], "connected", "nothing was sent of it")
            other.stop()
            other.wait()  # or the stop cancels what comes next
            with self.assertRaises(ControlLost):
                panel.axis(2).enable()

    def test_runs_the_examples(self):
        with Panel(program="test") as panel:
            panel.request_control()
            for axis in (panel.axis(1), panel.axis(2)):
                axis.set_gains(**GAINS)
                axis.enable()
        record = Path(self.folder.name, "scan.csv")
        self.example("raster_scan.py", "1", "2", "40", "2", record)
        rows = [[float(cell) for cell in row.split(",")] for row in record.read_text().splitlines()[1:]]
        self.assertEqual([row[:2] for row in rows], [[0, 0], [40, 0], [40, 40], [0, 40]])
        for x, y, x_measured, y_measured in rows:
            self.assertAlmostEqual(x_measured, x, delta=STILL)
            self.assertAlmostEqual(y_measured, y, delta=STILL)
        said = self.example("repeatability.py", "1", "100", "50", "2")
        self.assertEqual(len(said.splitlines()), 3, said)
        # Jogs once: where this computer gives it no time for 250 ms between two, the motor stops, and it is refused.
        self.assertIn("turns", self.example("centrifuge.py", "1", "60", "0.02"))

    def example(self, name, *words):
        source = Path(__file__).resolve().parents[2]
        return subprocess.run([sys.executable, source / "docs/examples" / name, *words], check=True, text=True,
                              stdout=subprocess.PIPE, env={**os.environ, "PYTHONPATH": str(source / "core/python")}).stdout

    def test_passes_over_the_socket_of_a_panel_that_crashed(self):
        (served,) = sockets()
        left = served.with_name("crashed.sock")
        with socket.socket(socket.AF_UNIX) as crashed:
            crashed.bind(str(left))
        self.assertEqual(sockets(), [served])
        with Panel() as panel:
            self.assertEqual(panel.state()["phase"], "connected")
        left.unlink()

    def test_says_where_there_is_no_panel(self):
        with self.assertRaises(PanelError):
            Panel(Path(self.folder.name, "nmcpanel", "none.sock"))


if __name__ == "__main__":
    unittest.main()
