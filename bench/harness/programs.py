# SPDX-License-Identifier: Apache-2.0
"""The programs that are measured, and how."""
import json
import os
import re
import subprocess
import sys
import tempfile
import time


def measure(command):
    """Runs a command: its output, seconds from start to end, and the most memory it had, in bytes.

    The memory is measured by GNU time, because the kernel's figure for a child of Python includes Python's own memory.
    """
    with tempfile.NamedTemporaryFile('r') as kilobytes:
        start = time.perf_counter()
        process = subprocess.run(['/usr/bin/time', '-q', '-f', '%M', '-o', kilobytes.name, *command], text=True,
                                 stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                 errors='replace')
        seconds = time.perf_counter() - start
        if process.returncode != 0:
            sys.exit(f'tools/bench: {" ".join(command)}\nended with {process.returncode}:\n{process.stdout[-2000:]}')
        return process.stdout, seconds, int(kilobytes.read()) * 1024


def found(pattern, output, program):
    match = re.search(pattern, output)
    if not match:
        sys.exit(f'tools/bench: no line {pattern!r} in what {program} printed:\n{output[-2000:]}')
    return float(match.group(1))


class Glint:
    """glint itself, with the best instruction set or a given one; or another build of it."""
    format = 'nff'

    def __init__(self, isa=None, threads=None, before=None):
        self.isa, self.threads, self.before = isa, threads, before
        self.name = ('before' if before else f'glint {isa}' if isa else f'glint, {threads} threads' if threads
                     else 'glint')

    def run(self, scene, o):
        stats = os.path.join(o.out, 'stats.json')
        command = [self.before or os.path.join(o.out, 'glint'), 'render', '-q', scene, '-s', f'{o.size}x{o.size}',
                   '--reflections', '5', '-t', str(self.threads or o.threads), '--stats', stats, '-o', os.path.join(o.out, 'a.png')]
        _, process, memory = measure(command + (['--isa', self.isa] if self.isa else []))
        with open(stats) as file:
            told = json.load(file)
        return {'trace': told['trace_s'], 'process': process, 'memory': memory, 'load': told['load_s'],
                'prepare': told['prepare_s'], 'rays': sum(told['rays'].values())}

    def prepared_bytes(self, scene, o):
        """The memory of the prepared scene, hierarchy included."""
        output, _, _ = measure([os.path.join(o.out, 'glint'), 'info', '--json', scene])
        return json.loads(output)['memory_bytes']['total']


class PovRay:
    name, format = 'POV-Ray', 'pov'

    def run(self, scene, o):
        output, process, memory = measure(
            ['povray', f'+I{scene}', '+O' + os.path.join(o.out, 'b.png'), f'+W{o.size}', f'+H{o.size}', '-D', '-A',
             f'+WT{o.threads}', 'File_Gamma=1.0', 'Output_File_Type=N8'])
        return {'trace': found(r'Trace Time:.*\(([0-9.]+) seconds\)', output, self.name), 'process': process,
                'memory': memory}


class Tachyon:
    name, format = 'Tachyon', 'tachyon'

    def run(self, scene, o):
        output, process, memory = measure(
            ['tachyon', scene, '-res', str(o.size), str(o.size), '-numthreads', str(o.threads), '-fullshade',
             '-shade_phong', '-shadow_filter_off', '-format', 'PNG', '-o', os.path.join(o.out, 'c.png')])
        return {'trace': found(r'Ray Tracing Time:\s*([0-9.]+) seconds', output, self.name), 'process': process,
                'memory': memory}


class Floor:
    """The same rays traced by Embree, without shading."""
    name, format = 'floor', 'nff'

    def run(self, scene, o):
        output, process, memory = measure(
            [os.path.join(o.out, 'bench', 'floor_embree'), scene, str(o.size), str(o.threads)])
        told = json.loads(output)
        return {'trace': told['seconds'], 'process': None, 'memory': None, 'rays': told['rays'],
                'classes': told['classes']}


class RegisterLoop:
    """Arithmetic in registers: the possible speedup by threads on this machine. It reads no scene."""
    format = 'nff'

    def __init__(self, threads):
        self.threads, self.name = threads, f'register loop, {threads} threads'

    def run(self, scene, o):
        output, process, memory = measure([os.path.join(o.out, 'bench', 'register_loop'), str(self.threads)])
        return {'trace': float(output), 'process': process, 'memory': memory}
