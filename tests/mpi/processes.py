# SPDX-License-Identifier: Apache-2.0
"""Jobs of several processes: to find the processes by a variable of the environment that the job was started with."""
import os
import pathlib
import random
import subprocess


def start_marked(command, **options):
    """Starts a command; returns its process, and the environment variable NAME=VALUE that only its processes have."""
    name, value = "GLINT_TEST", f"{random.getrandbits(64):x}"
    return subprocess.Popen(command, env=dict(os.environ, **{name: value}), **options), f"{name}={value}"


def processes_with(*variables):
    """The ids and programs of the processes that have these environment variables: NAME=VALUE."""
    for entry in pathlib.Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            environment = (entry / "environ").read_bytes().split(b"\0")
            program = (entry / "exe").resolve()
        except OSError:  # it has ended, or is another user's
            continue
        if all(variable.encode() in environment for variable in variables):
            yield int(entry.name), program


def parents_of(program, *variables):
    """The ids of the parents of the processes that run a program and have these environment variables."""
    parents = set()
    for process, its_program in processes_with(*variables):
        if its_program == pathlib.Path(program):
            try:
                status = pathlib.Path(f"/proc/{process}/status").read_text()
            except OSError:
                continue
            parents.add(int(status.split("PPid:")[1].split()[0]))
    return parents
