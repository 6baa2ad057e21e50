#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""nmcctl at a simulated chain behind real device servers: ser2net (raw and RFC 2217) and socat. usage: network_test.py PROGRAMS"""
import contextlib
import json
import os
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

sys.path.insert(1, str(Path(__file__).resolve().parents[1] / "support"))
import inparallel  # noqa: E402

PROGRAMS = Path(sys.argv.pop())
GAINS = "gains 1 --set kp=200 kd=2000 ki=20 il=200 ol=255 cl=0 el=8000 sr=1\n"
DONE, NOT_REACHED = 0, 3


def as_a_device_of_its_own():
    """In the field, no other program holds a device server up. nmcsim and nmcctl see to that themselves."""
    with contextlib.suppress(PermissionError):
        os.sched_setscheduler(0, os.SCHED_RR, os.sched_param(os.sched_get_priority_min(os.SCHED_RR)))


class DeviceServers(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.environment = {**os.environ, "LC_ALL": "C.UTF-8"}
        for name in ("XDG_RUNTIME_DIR", "XDG_CONFIG_HOME", "XDG_DATA_HOME"):
            self.environment[name] = str(self.folder / name)
            (self.folder / name).mkdir(0o700)
        self.port = self.own_port()
        self.chain = self.start(PROGRAMS / "nmcsim", "--chain", "servo,step", stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                text=True, bufsize=1)
        self.terminal = self.chain.stdout.readline().split()[1]

    def own_port(self):
        """One that the system gives to nobody else, because it is bound; a server that shares it may listen there."""
        holder = socket.socket()
        self.addCleanup(holder.close)
        holder.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        holder.bind(("127.0.0.1", 0))
        return holder.getsockname()[1]

    def start(self, *command, **options):
        process = subprocess.Popen([str(word) for word in command], env=self.environment, **options)
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        process.kill()
        process.wait()
        for pipe in (process.stdin, process.stdout, process.stderr):
            if pipe is not None:
                pipe.close()

    def serve(self, accepter):
        config = self.folder / "ser2net.yaml"
        config.write_text(f"connection: &nmc\n  accepter: {accepter},127.0.0.1,{self.port}\n"
                          f"  connector: serialdev,{self.terminal},19200n81,local\n", encoding="utf-8")
        return self.listening(self.start("/usr/sbin/ser2net", "-n", "-d", "-c", config, "-P", self.folder / "pid",
                                         stderr=subprocess.DEVNULL, preexec_fn=as_a_device_of_its_own))

    def listening(self, server):
        listens = f":{self.port:04X} 00000000:0000 0A"
        while listens not in Path("/proc/net/tcp").read_text(encoding="utf-8"):
            self.assertIsNone(server.poll(), "the device server has ended")
            time.sleep(0.02)
        return server

    def ctl(self, protocol, *words, text=None):
        done = subprocess.run([PROGRAMS / "nmcctl", "--port", f"{protocol}://127.0.0.1:{self.port}", *words], input=text,
                              env=self.environment, capture_output=True, text=True, check=False)
        return done.returncode, done.stdout, done.stderr

    def ask(self, line):
        self.chain.stdin.write(line + "\n")
        return json.loads(self.chain.stdout.readline())

    def check_moves(self, protocol, *options):
        code, out, problems = self.ctl(protocol, *options, "list")
        self.assertEqual(code, DONE, problems)
        self.assertEqual([row.split("\t")[2] for row in out.splitlines()], ["servo", "stepper"])
        code, out, problems = self.ctl(protocol, *options, "-", text=GAINS + "enable 1\nmove 1 500\n")
        self.assertEqual(code, DONE, problems)
        self.assertAlmostEqual(self.ask("state 1")["position"], 500, delta=3)

    def test_rfc2217_sets_the_rate(self):
        self.serve("telnet(rfc2217),tcp")
        self.check_moves("rfc2217", "--baud", "115200")
        self.assertEqual(self.ask("state 1")["baud"], round(1.25e6 / 11))  # DS-V 5.1, Set Baud Rate

    def test_raw_stays_at_the_rate_of_the_server(self):
        self.serve("tcp")
        self.check_moves("tcp", "--baud", "115200")
        self.assertEqual(self.ask("state 1")["baud"], round(1.25e6 / 64))

    def test_raw_through_socat(self):
        self.listening(self.start("socat", f"TCP-LISTEN:{self.port},bind=127.0.0.1,reuseaddr,fork",
                                  f"FILE:{self.terminal},raw,echo=0,b19200", preexec_fn=as_a_device_of_its_own))
        self.check_moves("tcp")

    def test_a_raw_server_is_no_rfc2217_server(self):
        self.serve("tcp")
        code, _, problems = self.ctl("rfc2217", "list")
        self.assertEqual(code, NOT_REACHED)
        self.assertIn("does not let the serial port be controlled", problems)

    def begin_moving(self, protocol):
        moving = self.start(PROGRAMS / "nmcctl", "--port", f"{protocol}://127.0.0.1:{self.port}", "-", stdin=subprocess.PIPE,
                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        moving.stdin.write(GAINS + "enable 1\nmove 1 1000000\n")
        moving.stdin.close()
        while self.ask("state 1")["position"] < 100 and moving.poll() is None:
            time.sleep(0.05)
        return moving

    def test_a_server_that_ends_is_a_lost_line(self):
        server = self.serve("telnet(rfc2217),tcp")
        moving = self.begin_moving("rfc2217")
        server.kill()
        problems = moving.stderr.read()
        self.assertEqual(moving.wait(), NOT_REACHED, problems)
        self.assertIn("is lost", problems)

    def test_the_guardian_stops_motors_through_it(self):
        for protocol, accepter in (("rfc2217", "telnet(rfc2217),tcp"), ("tcp", "tcp")):
            with self.subTest(protocol):
                server = self.serve(accepter)
                self.begin_moving(protocol).kill()
                while self.ask("state 1")["command_velocity"] != 0:
                    time.sleep(0.05)
                self.end(server)
                self.port = self.own_port()
                self.ask("power-cycle 1")

    def test_says_what_is_not_there(self):
        for name, sentence in ((f"tcp://127.0.0.1:{self.port}", "Nothing accepts connections"),
                               ("tcp://no.such.host.invalid:1", "was not found"), ("tcp://bench", "tcp://HOST:PORT")):
            done = subprocess.run([PROGRAMS / "nmcctl", "--port", name, "list"], env=self.environment,
                                  capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, NOT_REACHED)
            self.assertIn(sentence, done.stderr)


if __name__ == "__main__":
    inparallel.main()
