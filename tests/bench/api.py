#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What other programs cost the panel, and how fast they are answered: without any, with one that calls, and with 100 that
have subscribed to everything, ten of which do not read. The stop of a program is in scripts/bench stop."""
import json
import multiprocessing
import os
import selectors
import socket
import statistics
import sys
import tempfile
import time
from pathlib import Path

import bus

CALLS = 2000
CLIENTS, STALLED = 100, 10
MODULES = 32
# After it has found the chain, the panel builds the pages of all modules, one after another. That is not what programs cost.
SETTLING = 20  # s


class Client:
    def __init__(self):
        (path,) = Path(os.environ["XDG_RUNTIME_DIR"], "nmcpanel").glob("*.sock")
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(str(path))
        self.lines = self.socket.makefile("rb")
        self.call("hello", protocol="1.0", program="bench")

    def call(self, method, **parameters):
        self.socket.sendall(json.dumps({"id": 1, "method": method, "params": parameters}).encode() + b"\n")
        while b'"id":1' not in self.lines.readline():
            pass


def gui_seconds(panel):
    """CPU time of the panel's main thread."""
    fields = Path(f"/proc/{panel.pid}/task/{panel.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def subscribe(count, ready, over):
    """Subscribers, some of which do not read. A process of its own: as a thread, it would keep the one that calls waiting
    for Python's lock."""
    clients = [Client() for _ in range(count)]
    readers = selectors.DefaultSelector()
    for i, client in enumerate(clients):
        client.call("subscribe", state=True, samples=True, events=True)
        if i >= STALLED:
            readers.register(client.socket, selectors.EVENT_READ)
    ready.set()
    while not over.wait(0.02):
        for key, _ in readers.select(0):
            key.fileobj.recv(1 << 20)


class Load:
    """What the programs do while the wire is measured; the figures are in `said`."""

    def __init__(self, clients, calls):
        self.clients, self.calls, self.said = clients, calls, ""

    def __call__(self, panel):
        time.sleep(SETTLING)
        ready, over = multiprocessing.Event(), multiprocessing.Event()
        subscribers = multiprocessing.Process(target=subscribe, args=(self.clients, ready, over))
        subscribers.start()
        ready.wait()
        began, cpu = time.monotonic(), gui_seconds(panel)
        times = []
        if self.calls:
            caller = Client()
            for _ in range(CALLS):
                start = time.perf_counter()
                caller.call("state")
                times.append(1e3 * (time.perf_counter() - start))
        else:
            time.sleep(bus.SECONDS)
        share = (gui_seconds(panel) - cpu) / (time.monotonic() - began)
        over.set()
        subscribers.join()
        self.said = f"GUI {100 * share:.1f} % of a core"
        if times:
            self.said += f", a call p50 {statistics.median(times):.2f} p99 {statistics.quantiles(times, n=100)[98]:.2f} ms"


def main():
    programs = sys.argv[1]
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    with tempfile.TemporaryDirectory() as folder:
        for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_RUNTIME_DIR"):
            os.environ[name] = os.path.join(folder, name)
            os.mkdir(os.environ[name], 0o700)
        for baud in (19200, 115200):
            share = bus.simplest(programs, baud, MODULES)[1]
            print(f"api: {baud} Bd, {MODULES} modules, the simplest host alone: {share:.3f} of the wire's limit", flush=True)
            for what, load in (("no program", Load(0, False)), ("one that calls", Load(0, True)),
                               (f"{CLIENTS} subscribed", Load(CLIENTS, False)),
                               (f"{CLIENTS} subscribed and one calls", Load(CLIENTS, True))):
                _, wire, violations = bus.measure(programs, baud, MODULES, ["--serve"], load)
                print(f"api: {baud} Bd, {MODULES} modules, {what}: {wire:.3f} of the wire's limit, {load.said}"
                      + (f", {len(violations)} VIOLATIONS" if violations else ""), flush=True)


main()
