# SPDX-License-Identifier: MIT
"""Use a chain of NMC motor modules through NMC Panel, while the panel has the serial port.

    with Panel(program="scan.py") as panel:
        panel.request_control()
        x = panel.axis("X")
        x.enable()
        x.move(12.5)
        print(x.position)

The panel must let programs in (menu Chain, or nmcpanel --serve). Values are in the unit of the axis, velocities in that
per second; those of an axis in counts are in counts per tick of its servo, which is about 1950 counts per second at servo
rate 1. A call that the panel refuses raises Refused. Not for use by several threads at once.
"""
from __future__ import annotations

import json
import os
import pwd
import socket
import stat
import sys
import time
from collections import deque
from contextlib import suppress
from pathlib import Path
from typing import Any, Iterator, NamedTuple

__all__ = ["Axis", "ControlLost", "NotCarriedOut", "Panel", "PanelError", "Refused", "Sample"]

PROTOCOL = "1.0"
KEPT_NOTIFICATIONS = 10_000
REFUSED = -32000  #: code of a call that was understood
NO_PANEL = "the program that answers is not NMC Panel"


class PanelError(Exception):
    """The panel cannot be reached, or has gone away."""


class Refused(Exception):
    """The panel refused a call, with the sentence that its window would show."""

    def __init__(self, message: str, code: int, reason: str) -> None:
        super().__init__(message)
        self.code = code
        self.reason = reason  #: such as "NeedsStop"; docs/api.md lists them


class ControlLost(Refused):
    """This program may not move motors, or no longer."""


class NotCarriedOut(Refused):
    """What was begun has not ended as requested: by a stop, a fault or another command. The motor may have moved."""


class Sample(NamedTuple):
    """One status reply of a module; what is not known is None."""

    axis: int  #: number of the module, from 1
    time: float  #: s
    position: int  #: counts; of a PIC-I/O the counter, as last reported
    error: float | None  #: position error in counts; of a PIC-I/O the byte of its A/D 2
    velocity: float | None  #: counts per second; of a PIC-I/O the byte of its A/D 3
    status: int  #: the status byte; of a PIC-I/O the levels of IO1 (1) to IO8 (128)
    aux: int  #: auxiliary status or inputs, as last reported; of a PIC-I/O the levels of IO9 (1) to IO12 (8)
    analog: int | None = None  #: the A/D byte, as last reported; of a PIC-I/O that of A/D 1
    gap: bool = False  #: replies of this module are missing before this one, or this program was too slow for them
    counted: bool | None = None  #: of a PIC-I/O: this reply had the counter


def sockets() -> list[Path]:
    """Where panels let programs in; what a panel left behind when it crashed is passed over."""
    runtime = next(filter(_is_private, _runtime_folders()), None)
    paths = sorted(Path(runtime, "nmcpanel").glob("*.sock")) if runtime else []
    return [path for path in paths if _is_served(path)]


def _runtime_folders() -> Iterator[str]:
    """Where Qt, and so the panel, looks for a folder that is this user's alone."""
    yield os.environ.get("XDG_RUNTIME_DIR", "")
    try:
        user = pwd.getpwuid(os.geteuid()).pw_name
    except KeyError:
        user = ""
    yield f"{os.environ.get('TMPDIR') or '/tmp'}/runtime-{user}"


def _is_private(folder: str) -> bool:
    with suppress(OSError):
        status = os.lstat(folder)
        return status.st_uid == os.geteuid() and status.st_mode & ~0o7000 == stat.S_IFDIR | 0o700
    return False


def _is_served(path: Path) -> bool:
    with socket.socket(socket.AF_UNIX) as probe:
        return probe.connect_ex(os.fspath(path)) == 0


class Panel:
    """A connection to the panel at `path`, or to the only one there is."""

    def __init__(self, path: str | os.PathLike[str] | None = None, program: str | None = None) -> None:
        if path is None:
            found = sockets()
            if len(found) != 1:
                raise PanelError("no panel lets programs in" if not found else
                                 "several panels let programs in; give the path of one: " + ", ".join(map(str, found)))
            path = found[0]
        self._socket = socket.socket(socket.AF_UNIX)
        try:
            self._socket.connect(os.fspath(path))
        except OSError as error:
            self._socket.close()
            raise PanelError(f"{path}: {error.strerror or error}") from error
        self._lines = self._socket.makefile("r", encoding="utf-8")
        self._last_id = 0
        self._notifications: deque[dict[str, Any]] = deque()
        self._dropped = 0  #: samples, before the next that are handed out
        self._sampling = 0  #: iterators of samples() that have begun and not ended
        name = program or Path(sys.argv[0]).name or "python"
        try:
            self.about: dict[str, Any] = self.call("hello", protocol=PROTOCOL, program=name)
        except BaseException:
            self.close()
            raise

    def __enter__(self) -> Panel:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Motors that this program has moved are stopped, unless it asked for "finish"."""
        self._lines.close()
        self._socket.close()

    def call(self, method: str, **parameters: Any) -> Any:
        """Calls any method (docs/api.md); parameters that are None are left out."""
        self._last_id += 1
        request = {"jsonrpc": "2.0", "id": self._last_id, "method": method,
                   "params": {name: value for name, value in parameters.items() if value is not None}}
        try:
            text = json.dumps(request, allow_nan=False)
        except ValueError as error:  # JSON has no such number, so the panel could not say to which call it answers
            raise ValueError(f"{method}: all numbers must be finite: {request['params']}") from error
        self._send(text)
        while True:
            line = self._read()
            if "method" in line:
                self._keep(line)
            elif line.get("id") in (self._last_id, None):  # None: the panel could not read the line
                if "error" in line:
                    error = line["error"]
                    try:
                        message, code, reason = error["message"], error["code"], error["data"]["reason"]
                    except (KeyError, TypeError) as lacking:
                        raise PanelError(NO_PANEL) from lacking
                    begun = method == "wait" and code == REFUSED
                    kind = ControlLost if reason == "NoControl" else NotCarriedOut if begun else Refused
                    raise kind(message, code, reason)
                return line["result"]

    def _keep(self, line: dict[str, Any]) -> None:
        """For notifications(). While too many wait, the oldest of those go of which the panel drops some itself."""
        self._notifications.append(line)
        if len(self._notifications) <= KEPT_NOTIFICATIONS:
            return
        oldest = next((old for old in self._notifications if old["method"] in ("samples", "state")), None)
        if oldest is None:
            return
        self._notifications.remove(oldest)
        if oldest["method"] == "samples":
            self._dropped += oldest["params"]["missed"] + sum(len(each["rows"]) for each in oldest["params"]["modules"])

    def _send(self, text: str) -> None:
        try:
            self._socket.sendall(text.encode() + b"\n")
        except OSError as error:
            raise PanelError("the panel has gone away") from error

    def _read(self) -> dict[str, Any]:
        try:
            line = self._lines.readline()
        except (OSError, UnicodeDecodeError) as error:  # the latter if it has gone within a character
            raise PanelError("the panel has gone away") from error
        if not line.endswith("\n"):
            raise PanelError("the panel has gone away")
        try:
            answer = json.loads(line)
        except ValueError as error:
            raise PanelError(NO_PANEL) from error
        if not isinstance(answer, dict):
            raise PanelError(NO_PANEL)
        return answer

    # ---- the chain ----

    def state(self) -> dict[str, Any]:
        return self.call("state")

    def axis(self, axis: str | int) -> Axis:
        """An axis by its name, or by its number from 1."""
        return Axis(self, axis)

    def stop(self) -> None:
        """STOP ALL; always possible. It cancels what is commanded before wait() returns.

        wait() then raises NotCarriedOut if moves of this program were cut short, but only once all motors are at rest;
        with the reason Unresponsive, a module that does not answer has not confirmed the stop.
        """
        self.call("stop")

    def request_control(self, on_disconnect: str = "stop") -> None:
        """Asks the user for the right to move motors, and waits for the answer."""
        answer = self.call("request_control", on_disconnect=on_disconnect)
        if not answer["granted"]:
            why = {"Refused": "the user has refused", "InUse": "another program has control",
                   "Asking": "the user is being asked about another request"}
            raise ControlLost(why.get(answer.get("reason"), "control was refused, or another program has it"), -32001,
                              "NoControl")

    def release_control(self) -> None:
        self.call("release_control")

    def start_sequence(self, name: str, wait: bool = True) -> None:
        self.call("start_sequence", name=name)
        if wait:
            self.wait()

    def go_to_point(self, name: str, wait: bool = True) -> None:
        self.call("go_to_point", name=name)
        if wait:
            self.wait()

    def wait(self) -> dict[str, Any]:
        """Waits until all axes are at rest and no sequence runs; returns the state then.

        Set an arrival tolerance for an axis that must be at its goal then; without one, it may rest anywhere.
        """
        return self.call("wait")

    # ---- what arrives unasked ----

    def notifications(self) -> Iterator[dict[str, Any]]:
        """What was subscribed to, as it arrives; without end.

        What arrives during a call waits. If that is too much, samples and states are dropped; the samples are "missed".
        """
        while True:
            line = self._notifications.popleft() if self._notifications else self._read()
            if line.get("method") == "samples":
                line["params"]["missed"] += self._dropped
                self._dropped = 0
            if "method" in line:
                yield line

    def samples(self) -> Iterator[Sample]:
        """Every status reply of every module from now on, as it arrives; without end.

        The panel sends them until the iterator ends, which it does when a loop over it is left.
        """
        self.call("subscribe", samples=True)
        if self._sampling == 0:  # what waits then was sent to an iterator that has ended
            self._notifications = deque(line for line in self._notifications if line["method"] != "samples")
            self._dropped = 0
        self._sampling += 1
        gaps = 0  # how often this program was too slow
        told: dict[int, int] = {}  # how many of them the samples of an axis have shown
        try:
            for line in self.notifications():
                if line["method"] == "samples":
                    gaps += line["params"]["missed"] > 0
                    for module in line["params"]["modules"]:
                        axis = module["axis"]
                        for row in module["rows"]:
                            sample = Sample(axis, *row[:len(Sample._fields) - 1])
                            gap = told.get(axis, 0) != gaps
                            told[axis] = gaps
                            yield sample._replace(gap=True) if gap else sample
        finally:
            self._sampling -= 1
            if self._sampling == 0:
                with suppress(PanelError):
                    # Without an id, so that there is no answer: a call may be waiting for its own just now.
                    self._send('{"jsonrpc": "2.0", "method": "subscribe"}')


class Axis:
    """One axis of a panel."""

    def __init__(self, panel: Panel, axis: str | int) -> None:
        self._panel = panel
        self._axis = axis

    def call(self, method: str, **parameters: Any) -> Any:
        return self._panel.call(method, axis=self._axis, **parameters)

    def state(self) -> dict[str, Any]:
        return self.call("state")

    @property
    def position(self) -> float | None:
        return self.state()["position"]

    def wait(self) -> dict[str, Any]:
        """Waits until the axis is at rest; returns its state then.

        Set an arrival tolerance if it must be at its goal then; without one, it may rest anywhere.
        """
        return self.call("wait")

    def _do(self, wait: bool, method: str, **parameters: Any) -> None:
        self.call(method, **parameters)
        if wait:
            self.wait()

    def enable(self, wait: bool = True) -> None:
        self._do(wait, "enable")

    def motor_off(self, wait: bool = True) -> None:
        self._do(wait, "motor_off")

    def stop(self, wait: bool = True) -> None:
        self._do(wait, "stop")

    def move(self, to: float, velocity: float | None = None, acceleration: float | None = None,
             wait: bool = True) -> None:
        self._do(wait, "move", to=to, velocity=velocity, acceleration=acceleration)

    def move_by(self, by: float, velocity: float | None = None, acceleration: float | None = None,
                wait: bool = True) -> None:
        self._do(wait, "move_by", by=by, velocity=velocity, acceleration=acceleration)

    def jog(self, velocity: float, seconds: float) -> None:
        """Moves for that long, and stops by itself if this program does. Max jog speed of the axis limits it."""
        until = time.monotonic() + seconds
        begun = False
        while time.monotonic() < until:
            try:
                self.call("jog", velocity=velocity)
            except Refused as error:
                if not begun or isinstance(error, ControlLost):
                    raise
                raise NotCarriedOut(str(error), error.code, error.reason) from error
            begun = True
            time.sleep(0.03)
        self.stop()

    def go_home(self, wait: bool = True) -> None:
        self._do(wait, "go_home")

    def home(self, wait: bool = True) -> None:
        self._do(wait, "home")

    def zero(self, wait: bool = True) -> None:
        self._do(wait, "zero")

    def set_gains(self, wait: bool = True, *, kp: int | None = None, kd: int | None = None, ki: int | None = None,
                  il: int | None = None, ol: int | None = None, cl: int | None = None, el: int | None = None,
                  sr: int | None = None, db: int | None = None, sm: int | None = None) -> None:
        """What is left out stays as it is."""
        self._do(wait, "set_gains", kp=kp, kd=kd, ki=ki, il=il, ol=ol, cl=cl, el=el, sr=sr, db=db, sm=sm)
