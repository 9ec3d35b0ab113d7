# SPDX-License-Identifier: Apache-2.0
"""The glint command: where it is, what it says, and a run of it that can be watched and stopped. Pure Python."""
import os
import platform
import re
import shutil
import signal
import stat
import subprocess
import sys
import threading

NOT_FOUND = ("The glint command was not found. Install the add-on's zip for Linux or Windows, which has it; or take it from a "
             "release of glint, and set its path in Edit > Preferences > Add-ons > glint, or put it into PATH")
# Where the add-on's zip for a platform has its program (blender/package.py).
PROGRAMS = {("linux", "x86_64"): "program/bin/glint", ("win32", "amd64"): "program/glint.exe"}
OLDEST = (0, 3)  # the version whose language the add-on writes
_ESCAPE = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")
_PERCENT = re.compile(r"(\d{1,3})%")
_NO_WINDOW = getattr(subprocess, "CREATE_NO_WINDOW", 0)  # Windows would open a console


def _can_run(path):
    return os.path.isfile(path) and os.access(path, os.X_OK)


def own_program():
    """Where the add-on has glint for this machine, whether it is there or not; None for a machine that no zip is for."""
    name = PROGRAMS.get((sys.platform, platform.machine().lower()))
    return os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), name)) if name else None


def _usable_own_program():
    """own_program() if it can be run. Blender unpacks a zip without the permission to run files, so it is given here."""
    path = own_program()
    if path is None or not os.path.isfile(path):
        return None
    if not os.access(path, os.X_OK):
        try:
            mode = stat.S_IMODE(os.stat(path).st_mode)
            os.chmod(path, mode | (mode & 0o444) >> 2)
        except OSError:
            return None
    return path if os.access(path, os.X_OK) else None


def find(preference=""):
    """The path of glint: the preference, else the add-on's own, else PATH, else $GLINT. None if there is none that can be run."""
    if preference:
        path = os.path.expanduser(preference)
        return path if _can_run(path) else None
    found = _usable_own_program() or shutil.which("glint")
    if found:
        return found
    path = os.environ.get("GLINT", "")
    return path if path and _can_run(path) else None


def version(path):
    """What `glint --version` prints, on one line. Raises OSError if it cannot be run or is not glint."""
    try:
        run = subprocess.run([path, "--version"], capture_output=True, text=True, timeout=10, check=False,
                             creationflags=_NO_WINDOW)
    except subprocess.TimeoutExpired:
        raise OSError(f"{path} --version did not end within 10 s") from None
    line = run.stdout.strip().splitlines()[0] if run.stdout.strip() else ""
    if run.returncode or "glint" not in line:
        raise OSError(f"{path} is not glint: it answered '{line or run.stderr.strip()[:80]}'")
    return line


def not_found_text(preference):
    """What to say if find() has found nothing."""
    if preference:
        return (f"The glint command of the preferences, {preference}, is no program that can be run (Edit > Preferences > "
                "Add-ons > glint)")
    path = own_program()
    if path is not None and os.path.isfile(path):
        return f"The glint command of the add-on, {path}, cannot be run: this file may not be made executable"
    return NOT_FOUND


_checked = {}  # (path, time of change): the fault, or None


def version_fault(path):
    """Why this glint is too old or none; None if it can be used. It is asked once, and again when the file has changed."""
    try:
        key = path, os.stat(path).st_mtime_ns
        if key not in _checked:
            line = version(path)
            found = re.search(r"(\d+)\.(\d+)", line)
            is_old = found is not None and tuple(map(int, found.groups())) < OLDEST
            _checked[key] = (f"{path} is {line}: this add-on needs version {'.'.join(map(str, OLDEST))} or later"
                             if is_old else None)
        return _checked[key]
    except OSError as error:
        return str(error)


def exit_text(code):
    """How a run ended that printed no error."""
    if code < 0:
        try:
            return f"glint was ended by the signal {signal.Signals(-code).name}"
        except ValueError:
            return f"glint was ended by the signal {-code}"
    return f"glint ended with exit code {code}"


class Run:
    """One run of glint. Messages are read by a thread, so that a full pipe stops nothing."""

    def __init__(self, arguments):
        self.progress = 0.0  # 0 to 1
        self._messages = []
        self._reading, writing = _terminal()
        environment = dict(os.environ, TERM="xterm", COLUMNS="80", NO_COLOR="1")
        try:
            # pylint: disable=consider-using-with
            self._process = subprocess.Popen(arguments, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                             stderr=writing, env=environment, creationflags=_NO_WINDOW)
        except OSError:
            os.close(self._reading)
            raise
        finally:
            os.close(writing)
        self._thread = threading.Thread(target=self._read, daemon=True)
        self._thread.start()

    def _read(self):
        rest = b""
        while True:
            try:
                data = os.read(self._reading, 65536)
            except OSError:  # a terminal's other end is closed
                data = b""
            *lines, rest = re.split(rb"[\r\n]+", rest + data)
            for line in lines if data else [*lines, rest]:
                self._take(_ESCAPE.sub("", line.decode("utf-8", "replace")).strip())
            if not data:
                break
        os.close(self._reading)

    def _take(self, line):
        if line.startswith(("[", "glint:")) and _PERCENT.search(line):
            self.progress = min(1.0, int(_PERCENT.search(line)[1]) / 100)
        elif line:
            self._messages.append(line)

    def poll(self, seconds):
        """Waits at most so long; the exit code, or None while it runs."""
        try:
            return self._process.wait(seconds)
        except subprocess.TimeoutExpired:
            return None

    def stop(self):
        """Ends the run, by force if it does not listen."""
        self._process.terminate()
        try:
            self._process.wait(5)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._thread.join(5)

    def messages(self):
        """All lines it printed except progress; call it when the run has ended."""
        self._thread.join(5)
        return list(self._messages)


def _terminal():
    """(reading end, writing end) of a pseudo-terminal, for which glint shows its progress often; of a pipe elsewhere."""
    try:
        return os.openpty()
    except (AttributeError, OSError):
        return os.pipe()


def diagnostics(messages):
    """(errors, warnings) among glint's lines, without the excerpts below them."""
    errors = [m for m in messages if re.search(r"(^|: )error: ", m)]
    warnings = [m for m in messages if re.search(r"(^|: )warning: ", m)]
    return errors, warnings
