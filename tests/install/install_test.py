#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What "cmake --install" and "cpack -G DEB" bring onto a computer.

usage: install_test.py BUILD [TESTCASE[.test] ...]
"""
import os
import pty
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BUILD = Path(sys.argv.pop(1)).resolve()
SOURCE = Path(__file__).resolve().parents[2]
ID = "org.nmcpanel.NmcPanel"
SIDES = (16, 22, 24, 32, 48, 64, 128, 256)

INSTALLED = {
    "bin/nmcctl",
    "bin/nmcpanel",
    "bin/nmcsim",
    "lib/udev/rules.d/70-nmcpanel.rules",
    "libexec/nmcpanel/nmcguard",
    f"share/applications/{ID}.desktop",
    "share/bash-completion/completions/nmcctl",
    "share/bash-completion/completions/nmcpanel",
    "share/bash-completion/completions/nmcsim",
    "share/doc/nmcpanel/README.md",
    "share/doc/nmcpanel/changelog.gz",
    "share/doc/nmcpanel/copyright",
    f"share/icons/hicolor/scalable/apps/{ID}.svg",
    "share/man/man1/nmcctl.1.gz",
    "share/man/man1/nmcpanel.1.gz",
    "share/man/man1/nmcsim.1.gz",
    f"share/metainfo/{ID}.metainfo.xml",
} | {f"share/icons/hicolor/{side}x{side}/apps/{ID}.png" for side in SIDES} | {
    # README.md shows and names these as they lie beside it.
    f"share/doc/nmcpanel/{path.relative_to(SOURCE)}"
    for path in [*SOURCE.glob("docs/**/*"), *SOURCE.glob("resources/screenshot*.png")] if path.is_file()
}


def run(*command, **options):
    """What the command prints; its own words in the exception when it fails."""
    done = subprocess.run([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, encoding="utf-8", **options)
    if done.returncode != 0:
        raise AssertionError(f"{command} ended with {done.returncode}:\n{done.stdout}")
    return done.stdout


def files(root):
    return {str(path.relative_to(root)) for path in root.rglob("*") if not path.is_dir()}


class Folder(unittest.TestCase):
    """Tests with a folder of their own."""

    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="nmc-install-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)

    @staticmethod
    def install(root, *options):
        run("cmake", "--install", BUILD, *options, env={**os.environ, "DESTDIR": str(root)})

    def environment(self, language="C.UTF-8"):
        """Somebody's first login: nothing but a home, and it is empty."""
        home = tempfile.mkdtemp(dir=self.folder)
        os.chmod(home, 0o700)
        return {"HOME": home, "XDG_RUNTIME_DIR": home, "PATH": "/usr/bin:/bin", "LANG": language,
                "QT_QPA_PLATFORM": "offscreen", "QT_LOGGING_RULES": "nmc.start=true;nmc.link=true",
                "DBUS_SYSTEM_BUS_ADDRESS": "unix:path=/nowhere"}

    def start_to_first_paint(self, prefix, language, settings=""):
        """What the installed panel says of itself."""
        environment = self.environment(language)
        folder = Path(environment["HOME"]) / ".config/nmcpanel"
        folder.mkdir(parents=True)
        (folder / "NMC Panel.conf").write_text(settings)
        said = run(prefix / "bin/nmcpanel", "--simulator=servo", "--quit-after-first-paint", env=environment, cwd="/")
        match = re.search(r"^nmc\.start: version (.+), Qt .+ on (.+), style (.+), (.+), icon (.+), language (.*), "
                          r"Qt's (.*), manual of (\d+) pages$", said, re.MULTILINE)
        self.assertTrue(match, said)
        self.assertEqual(int(match[8]), len([*SOURCE.glob("docs/manual/*.md")]))
        return dict(zip(("version", "platform", "style", "colours", "icon", "language", "qt"), match.groups()))

    def check_german(self, prefix):
        said = self.start_to_first_paint(prefix, "de_DE.UTF-8")
        self.assertTrue(said.pop("qt").startswith("de"))  # de_DE in Debian 12
        self.assertEqual(said, {"version": self.version(prefix), "platform": "offscreen", "style": "fusion",
                                "colours": "light", "icon": "64x64", "language": "de"})
        self.assertIn("Diese Hilfe anzeigen.",
                      run(prefix / "bin/nmcpanel", "--help", env=self.environment("de_DE.UTF-8")))

    def check_english(self, prefix):
        said = self.start_to_first_paint(prefix, "en_GB.UTF-8")
        self.assertEqual((said["style"], said["icon"], said["language"], said["qt"]), ("fusion", "64x64", "", ""))
        self.assertIn("Show this help.",
                      run(prefix / "bin/nmcpanel", "--help", env=self.environment("en_GB.UTF-8")))

    def check_choice(self, prefix):
        """The language that was chosen, whatever the system speaks."""
        self.assertEqual(self.start_to_first_paint(prefix, "en_GB.UTF-8", "[General]\nlanguage=de\n")["language"], "de")
        self.assertEqual(self.start_to_first_paint(prefix, "de_DE.UTF-8", "[General]\nlanguage=en\n")["language"], "")

    def version(self, prefix):
        return run(prefix / "bin/nmcpanel", "--version", env=self.environment()).split()[-1]

    def check_guardian(self, prefix):
        """The panel on the terminal of nmcsim, both as installed, has its guardian from the same tree."""
        with subprocess.Popen([prefix / "bin/nmcsim", "--chain", "servo"], stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE, text=True) as sim:
            terminal = sim.stdout.readline().removeprefix("ready ").strip()
            with subprocess.Popen([prefix / "bin/nmcpanel", "--port", terminal], stderr=subprocess.PIPE, text=True,
                                  env=self.environment()) as panel:
                self.assertTrue(any("chain found" in line for line in panel.stderr))
                children = run("pgrep", "--parent", panel.pid).split()
                programs = {os.readlink(f"/proc/{child}/exe") for child in children}
                panel.terminate()
                panel.stderr.read()
            self.assertIn(str(prefix.resolve() / "libexec/nmcpanel/nmcguard"), programs)
            self.assertEqual(panel.returncode, 0)
            sim.communicate("quit\n")


class InstalledTree(Folder):
    """What lies there."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.root = cls.folder / "root"
        cls.install(cls.root, "--prefix", "/usr")
        cls.usr = cls.root / "usr"

    def test_has_every_file_and_no_other(self):
        self.assertEqual(files(self.root), {"usr/" + file for file in INSTALLED})

    def test_prefix_and_destination_are_honoured(self):
        self.install(self.folder / "staging", "--prefix", "/opt/nmc")
        self.assertEqual(files(self.folder / "staging"), {"opt/nmc/" + file for file in INSTALLED})
        self.install("", "--prefix", self.folder / "own")
        self.assertEqual(files(self.folder / "own"), INSTALLED)

    def test_desktop_file_is_valid_and_names_what_is_there(self):
        file = self.usr / f"share/applications/{ID}.desktop"
        self.assertEqual(run("desktop-file-validate", file), "")
        entries = dict(line.split("=", 1) for line in file.read_text().splitlines() if "=" in line)
        self.assertTrue((self.usr / "bin" / entries["Exec"].split()[0]).exists())
        self.assertTrue((self.usr / f"share/icons/hicolor/scalable/apps/{entries['Icon']}.svg").exists())

    def test_metainfo_is_valid(self):
        run("appstreamcli", "validate", "--no-net", self.usr / f"share/metainfo/{ID}.metainfo.xml")

    def test_icons_have_the_size_of_their_folder(self):
        for side in SIDES:
            picture = self.usr / f"share/icons/hicolor/{side}x{side}/apps/{ID}.png"
            self.assertIn(f"PNG image data, {side} x {side}, ", run("file", picture))

    def test_manual_pages_have_every_option_and_no_mistake(self):
        for program in ("nmcpanel", "nmcsim"):
            page = self.usr / f"share/man/man1/{program}.1.gz"
            self.assertEqual(run("man", "--warnings", "--encoding=UTF-8", "--troff-device=utf8", "--ditroff",
                                 "--local-file", page, env={**os.environ, "LC_ALL": "C.UTF-8"})
                             .count("warning"), 0)
            self.assertIn(f"{program} - ", run("lexgrog", page))
            text = run("man", "--local-file", page, env={"PATH": os.environ["PATH"], "LC_ALL": "C.UTF-8",
                                                         "MANWIDTH": "200"})
            options = re.findall(r"^ +(?:-\w, )?(--[\w-]+)", run(self.usr / "bin" / program, "--help",
                                                                 env=self.environment()), re.MULTILINE)
            self.assertGreater(len(options), 7)
            for option in options:
                self.assertRegex(text, rf"(?m)^ +(-\w, )?{option}\b")

    def test_udev_rules_are_of_keys_that_udev_knows(self):
        # "udevadm verify" came after Debian 12.
        key = (r'(ACTION|SUBSYSTEM|DRIVER|KERNEL|ATTRS?\{\w+\})(==|!=)"[^"]+"|ATTR\{latency_timer\}="1"|'
               r'TAG\+="uaccess"|ENV\{ID_MM_DEVICE_IGNORE\}="1"|GOTO="\w+"|LABEL="\w+"')
        rules = (self.usr / "lib/udev/rules.d/70-nmcpanel.rules").read_text()
        for line in rules.splitlines():
            if line and not line.startswith("#"):
                self.assertRegex(line, rf"^({key})(, ({key}))*$")
        self.assertEqual(set(re.findall(r'GOTO="(\w+)"', rules)), set(re.findall(r'LABEL="(\w+)"', rules)))
        for vendor in ("0403", "067b", "1a86", "10c4"):
            self.assertRegex(rules, rf'(?m)^ATTR{{idVendor}}=="{vendor}", .*ENV{{ID_MM_DEVICE_IGNORE}}="1"$')
        # Contour, 3Dconnexion and Logitech: jog wheels and 3-axis mice.
        for vendor in ("0b33|256f", "046d"):
            self.assertIn(f'SUBSYSTEM=="input", KERNEL=="event*", ATTRS{{idVendor}}=="{vendor}", ', rules)


class InstalledPrograms(Folder):
    def test_start_in_an_empty_home_and_wherever_the_tree_is_moved(self):
        self.install(self.folder / "root", "--prefix", "/usr")
        for name in ("nmcpanel", "nmcsim"):  # no path of the build is left in them
            self.assertNotRegex(run("readelf", "--dynamic", self.folder / "root/usr/bin" / name), "RPATH|RUNPATH")
        self.check_german(self.folder / "root/usr")
        self.check_english(self.folder / "root/usr")
        self.check_choice(self.folder / "root/usr")
        (self.folder / "root/usr").rename(self.folder / "elsewhere")
        self.check_german(self.folder / "elsewhere")
        self.check_guardian(self.folder / "elsewhere")


class Completion(Folder):
    """In an interactive bash that has bash-completion and what is installed."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.install(cls.folder, "--prefix", "/usr")
        (cls.folder / "terminal").symlink_to("/dev/null")

    def completed(self, line, key="\t"):
        """The words on the line after Tab; or after Meta-*, which puts all that is possible there."""
        startup = self.folder / "startup"
        usr = self.folder / "usr"
        startup.write_text(f"cd {self.folder}; PATH={usr}/bin:$PATH; XDG_DATA_DIRS={usr}/share\n"
                           ". /usr/share/bash-completion/bash_completion\nPS1=ready:\n")
        process, terminal = pty.fork()
        if process == 0:
            os.execve("/bin/bash", ["bash", "--rcfile", str(startup), "-i"],
                      {**self.environment(), "TERM": "dumb", "INPUTRC": "/dev/null"})
        said = read_until(terminal, "ready:")
        os.write(terminal, f"{line}{key}\x01echo line: \r".encode())
        said += read_until(terminal, "\nline: ") + read_until(terminal, "ready:")
        os.write(terminal, b"exit\r")
        read_until(terminal, None)
        os.close(terminal)
        os.waitpid(process, 0)
        return re.search(r"^line: (.*?)\s*$", said, re.MULTILINE)[1].split()

    def test_knows_chains_module_by_module(self):
        self.assertEqual(self.completed("nmcsim --chain st", "\x1b*"), "nmcsim --chain step step@1".split())
        self.assertEqual(self.completed("nmcsim --chain servo@1", "\x1b*"), "nmcsim --chain servo@1 servo@10".split())
        self.assertEqual(self.completed("nmcpanel --simulator servo@4,io,ste"),
                         "nmcpanel --simulator servo@4,io,step".split())
        self.assertEqual(self.completed("nmcpanel --simulator=servo,ste"), "nmcpanel --simulator=servo,step".split())

    def test_knows_every_option_of_the_help(self):
        self.assertEqual(self.completed("nmcpanel --b"), "nmcpanel --baud".split())
        self.assertEqual(self.completed("nmcpanel --", "\x1b*"),
                         "nmcpanel --baud --enable-faults --help --list-ports --port --read-only --serve "
                         "--simulator --version".split())
        self.assertEqual(self.completed("nmcsim --", "\x1b*"),
                         "nmcsim --chain --deaf-when-addr-in-rises --enable-faults --help --line-margin --link "
                         "--reset-dead-time --seed --speed --stepped --unpaced --version".split())

    def test_knows_the_commands_of_nmcctl(self):
        self.assertEqual(self.completed("nmcctl mo", "\x1b*"), "nmcctl motor-off move move-by".split())
        self.assertEqual(self.completed("nmcctl --so"), "nmcctl --socket".split())
        self.assertEqual(self.completed("nmcctl run-"), "nmcctl run-sequence".split())
        self.assertEqual(self.completed("nmcctl move run-"), "nmcctl move run-".split(), "it is no word of move")

    def test_knows_rates_files_and_ports(self):
        (self.folder / "mill.json").touch()
        self.assertEqual(self.completed("nmcpanel --baud 1", "\x1b*"), "nmcpanel --baud 115200 19200".split())
        self.assertEqual(self.completed("nmcpanel mi"), "nmcpanel mill.json".split())
        self.assertEqual(self.completed("nmcpanel --port term"), "nmcpanel --port terminal".split())
        listed = run(self.folder / "usr/bin/nmcpanel", "--list-ports", env=self.environment())
        ports = sorted(line.split("\t")[0] for line in listed.splitlines() if line)
        if ports:
            self.assertEqual(self.completed("nmcpanel --port /dev/tty", "\x1b*")[2:], ports)


def read_until(terminal, end):
    """What a terminal says up to `end`; without one, until nobody has it open."""
    said = ""
    while end is None or end not in said:
        try:
            said += os.read(terminal, 1 if end else 4096).decode(errors="replace").replace("\r", "")
        except OSError:
            if end is None:
                break
            raise
    return said


class Package(Folder):
    """The .deb in a root that is empty but for dpkg's own books."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run("cpack", "-G", "DEB", "-B", cls.folder / "deb", cwd=BUILD)
        run("cpack", "--config", "CPackPython.cmake", "-B", cls.folder / "deb", cwd=BUILD)
        (cls.deb,) = (cls.folder / "deb").glob("nmcpanel_*.deb")
        (cls.python,) = (cls.folder / "deb").glob("python3-nmcpanel_*_all.deb")

    def field(self, name):
        return run("dpkg-deb", "--field", self.deb, name).strip()

    def test_is_installed_started_and_removed_without_residue(self):
        root = self.folder / "root"
        books = root / "var/lib/dpkg"
        for folder in ("info", "updates", "triggers"):
            (books / folder).mkdir(parents=True)
        (books / "status").touch()
        dpkg = ["fakeroot", "dpkg", f"--root={root}", "--force-depends,bad-path", f"--log={self.folder}/log"]
        mine = lambda: {file for file in files(root) if not file.startswith("var/lib/dpkg/")}

        run(*dpkg, "--install", self.deb)
        self.assertEqual(mine(), {"usr/" + file for file in INSTALLED | {"share/doc/nmcpanel/changelog.Debian.gz"}})
        self.check_german(root / "usr")
        run(*dpkg, "--purge", "nmcpanel")
        self.assertEqual(mine(), set())
        self.assertEqual({str(path.relative_to(root)) for path in root.rglob("*")} -
                         {str(path.relative_to(root)) for path in books.rglob("*")},
                         {"var", "var/lib", "var/lib/dpkg"})

    def test_says_what_it_is_and_needs(self):
        version = run(BUILD / "bin/nmcsim", "--version").split()[1]
        self.assertEqual(self.field("Package"), "nmcpanel")
        self.assertEqual(self.field("Version"), f"{version}-1")
        self.assertEqual(self.field("Section"), "electronics")
        self.assertRegex(self.field("Maintainer"), r"^.+ <.+@.+>$")
        for library in ("libqt6widgets6", "libqt6svg6", "libqt6serialport6"):
            self.assertRegex(self.field("Depends"), rf"\b{re.escape(library)} \(>= ")
        for recommended in ("fonts-noto-cjk", "libsdl2-2.0-0", "qt6-translations-l10n", "qt6-wayland"):
            self.assertIn(recommended, self.field("Recommends"))

    def test_has_the_same_programs_without_debug_symbols(self):
        run("dpkg-deb", "--extract", self.deb, self.folder / "tree")
        for program in ("bin/nmcctl", "bin/nmcpanel", "bin/nmcsim", "libexec/nmcpanel/nmcguard"):
            self.assertNotIn(".debug_info", run("readelf", "--sections", "--wide", self.folder / "tree/usr" / program))

    def test_lintian_finds_no_error(self):
        for package in (self.deb, self.python):
            run("lintian", "--allow-root", "--fail-on", "error", package)

    def test_has_the_python_client_in_a_package_of_its_own(self):
        tree = self.folder / "python"
        run("dpkg-deb", "--extract", self.python, tree)
        documents = "usr/share/doc/python3-nmcpanel/"
        self.assertEqual(files(tree), {"usr/lib/python3/dist-packages/nmcpanel.py", documents + "copyright",
                                       documents + "changelog.Debian.gz"} |
                         {f"{documents}examples/{path.name}" for path in SOURCE.glob("docs/examples/*")})


class Wheel(Folder):
    def test_can_be_imported(self):
        run("cmake", "--build", BUILD, "--target", "wheel")
        version = run(BUILD / "bin/nmcsim", "--version").split()[1]
        wheel = BUILD / f"nmcpanel-{version}-py3-none-any.whl"
        self.assertIn("nmcpanel.Panel", run(sys.executable, "-c", "import nmcpanel; print(nmcpanel.Panel)",
                                            env={**os.environ, "PYTHONPATH": str(wheel)}))


if __name__ == "__main__":
    unittest.main(verbosity=2)
