# SPDX-License-Identifier: Apache-2.0
"""The scenes: the Standard Procedural Databases, written by bench/spd."""
import os
import re
import subprocess

SCENES = ('balls', 'tetra', 'gears', 'mount', 'rings', 'tree', 'lattice', 'teapot')
FLAKES = {'flake3': 3, 'flake4': 4, 'flake5': 5, 'flake6': 6, 'flake7': 7}  # 820 to 5,380,840 spheres


def spheres(flake):
    """The number of spheres of a flake: 1 + 9 + ... + 9^size."""
    return (9 ** (FLAKES[flake] + 1) - 1) // 8


def generate(o):
    """Writes the missing scene files; returns {(scene, format): path}."""
    make_spd = os.path.join(o.out, 'bench', 'spd', 'make_spd')
    os.makedirs(os.path.join(o.out, 'scenes'), exist_ok=True)
    paths = {}
    for scene in o.scenes:
        for format in sorted({p.format for p in o.programs}):
            path = os.path.join(o.out, 'scenes', f'{scene}.{format}')
            paths[scene, format] = path
            if os.path.exists(path) and os.path.getmtime(path) > os.path.getmtime(make_spd):
                continue
            name, size = ('balls', FLAKES[scene]) if scene in FLAKES else (scene, None)
            if size is None:
                usage = subprocess.run([make_spd], stderr=subprocess.PIPE, text=True).stderr
                size = int(re.search(rf'^  {name} .*default (\d+)$', usage, re.M).group(1))
            with open(path + '.part', 'w') as file:
                subprocess.run([make_spd, name, str(size), format], stdout=file, check=True)
            os.replace(path + '.part', path)
    return paths
