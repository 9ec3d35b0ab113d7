#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders random scenes of what glint reads with POV-Ray or Tachyon and with glint, and compares the pixels.

    tests/peers/random_scenes.py GLINT [--count N] [--seed S] [--program povray|tachyon] [--within D]

The same seed gives the same scenes. A scene of which less than 99% of the pixels are within D (2) of 255 is printed, with
glint's warnings; one without a warning is a failure. The failed scenes and their pictures stay in build/peers/random."""
import argparse
import pathlib
import random
import shutil
import subprocess
import sys

import run

SIZE = 160, 120
SHARE = 0.99


class Pov:
    """A scene in POV-Ray's language."""
    program, name = "povray", "peer.pov"

    def __init__(self, rng):
        self.rng = rng

    def number(self, least, most):
        return f"{self.rng.uniform(least, most):.3f}"

    def vector(self, least, most):
        return "<" + ", ".join(self.number(a, b) for a, b in zip(least, most)) + ">"

    def place(self):
        return self.vector((-2.5, -0.5, -1), (2.5, 2, 3))

    def color(self):
        return "rgb " + self.vector((0, 0, 0), (1, 1, 1))

    def pigment(self):
        rng = self.rng
        if rng.random() < 0.2:
            kind = rng.choice(("rgbt", "rgbf"))
            return f"pigment {{ {kind} <{self.number(0, 1)}, {self.number(0, 1)}, {self.number(0, 1)}, {self.number(0.1, 0.9)}> }}"
        return f"pigment {{ {self.color()} }}"

    def finish(self):
        rng = self.rng
        items = [f"ambient {self.number(0, 0.4)}", f"diffuse {self.number(0.2, 0.9)}"]
        if rng.random() < 0.5:
            items.append(f"phong {self.number(0.1, 1)} phong_size {self.number(5, 80)}")
        if rng.random() < 0.3:
            items.append(f"specular {self.number(0.1, 0.8)} roughness {self.number(0.005, 0.1)}")
        if rng.random() < 0.2:
            items.append("metallic")
        if rng.random() < 0.15:
            items.append(f"brilliance {self.number(0.5, 4)}")
        if rng.random() < 0.25:
            items.append(rng.choice((f"reflection {self.number(0.1, 0.6)}",
                                     f"reflection {{ {self.number(0, 0.2)}, {self.number(0.3, 0.8)} }}")))
        return "finish { " + " ".join(items) + " }"

    def shape(self):
        rng = self.rng
        kind = rng.choice(("sphere", "sphere", "cylinder", "cone", "box", "disc", "triangle", "smooth_triangle", "mesh2"))
        place = self.place
        if kind == "sphere":
            body = f"{place()}, {self.number(0.2, 0.9)}"
        elif kind == "cylinder":
            body = f"{place()}, {place()}, {self.number(0.1, 0.5)}" + rng.choice(("", " open"))
        elif kind == "cone":
            body = f"{place()}, {self.number(0.2, 0.7)}, {place()}, {self.number(0, 0.15)}" + rng.choice(("", " open"))
        elif kind in ("box", "triangle"):
            body = ", ".join(place() for _ in range(2 if kind == "box" else 3))
        elif kind == "disc":
            body = f"{place()}, {self.vector((-1, 0.1, -1), (1, 1, 1))}, {self.number(0.3, 1)}"
        elif kind == "smooth_triangle":
            body = ", ".join(f"{place()}, {self.vector((-0.4, -0.4, -1), (0.4, 0.4, -0.6))}" for _ in range(3))
        else:
            body = f"vertex_vectors {{ 4, {', '.join(place() for _ in range(4))} }} face_indices {{ 2, <0, 1, 2>, <1, 2, 3> }}"
        more = ""
        if rng.random() < 0.3:
            more += rng.choice((f" rotate <0, {self.number(-40, 40)}, {self.number(-20, 20)}>",
                                f" scale <1, {self.number(0.5, 1.5)}, 1>", f" translate {self.number(-0.5, 0.5)}*x"))
        if rng.random() < 0.1:
            more += " no_shadow"
        return f"{kind} {{ {body} {self.pigment()} {self.finish()}{more} }}\n"

    def light(self):
        rng = self.rng
        at = self.vector((-6, 3, -8), (6, 8, -3))
        kind = rng.choice(("", "", " parallel point_at 0", " shadowless", " spotlight point_at <0, 0.5, 0> radius 12 falloff 25",
                           " fade_distance 6 fade_power 2"))
        if "parallel" in kind:
            at = self.vector((-40, 30, -60), (40, 60, -40))
        return f"light_source {{ {at}, rgb {self.number(0.3, 0.9)}{kind} }}\n"

    def text(self):
        rng = self.rng
        head = rng.choice(("#version 3.6;\n", "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n", "#version 3.7;\n"))
        look = f"location <{self.number(-1, 1)}, {self.number(0.5, 2)}, -6> look_at <0, 0.5, 0>"
        camera = rng.choice((look, look + f" angle {self.number(35, 70)}", look + " right x*4/3 angle 50",
                             "orthographic " + look, "orthographic " + look + " angle 50"))
        text = head + f"camera {{ {camera} }}\nbackground {{ {self.color()} }}\n"
        text += "".join(self.light() for _ in range(rng.randint(1, 3)))
        if rng.random() < 0.5:
            text += f"plane {{ y, -1 pigment {{ {self.color()} }} {self.finish()} }}\n"
        if rng.random() < 0.15:
            text += f"fog {{ distance {self.number(5, 25)} {self.color()} }}\n"
        return text + "".join(self.shape() for _ in range(rng.randint(2, 9)))


class Dat:
    """A scene of Tachyon."""
    program, name = "tachyon", "peer.dat"

    def __init__(self, rng):
        self.rng = rng

    def number(self, least, most):
        return f"{self.rng.uniform(least, most):.3f}"

    def numbers(self, least, most):
        return " ".join(self.number(a, b) for a, b in zip(least, most))

    def place(self):
        return self.numbers((-2.5, -0.5, -1), (2.5, 2, 3))

    def color(self):
        return self.numbers((0, 0, 0), (1, 1, 1))

    def texture(self):
        rng = self.rng
        opacity = self.number(0.2, 0.9) if rng.random() < 0.25 else "1"
        mirror = self.number(0.1, 0.6) if rng.random() < 0.25 else "0"
        outline = f"Outline {self.number(0.2, 0.9)} Outline_Width {self.number(0.1, 0.6)} " if rng.random() < 0.1 else ""
        phong = f"Phong {rng.choice(('Plastic', 'Metal'))} {self.number(0.1, 0.9)} Phong_size {self.number(5, 60)} " \
            if rng.random() < 0.6 else ""
        return f"Texture Ambient {self.number(0, 0.4)} Diffuse {self.number(0.2, 0.9)} Specular {mirror} Opacity {opacity} " \
            f"{outline}{phong}Color {self.color()} TexFunc 0\n"

    def shape(self):
        place = self.place
        kind = self.rng.choice(("Sphere", "Sphere", "FCylinder", "Tri", "STri", "Ring", "PolyCylinder"))
        if kind == "Sphere":
            body = f"Center {place()} Rad {self.number(0.2, 0.9)}"
        elif kind == "FCylinder":
            body = f"Base {place()} Apex {place()} Rad {self.number(0.1, 0.5)}"
        elif kind == "Tri":
            body = f"V0 {place()} V1 {place()} V2 {place()}"
        elif kind == "STri":
            normal = "N0 {0} N1 {0} N2 {0}".format("0 0 -1")
            body = f"V0 {place()} V1 {place()} V2 {place()} {normal}"
        elif kind == "Ring":
            body = f"Center {place()} Normal {self.numbers((-1, 0.1, -1), (1, 1, 1))} Inner 0.0 Outer {self.number(0.3, 1)}"
        else:
            body = f"Points 3 {place()} {place()} {place()} Rad {self.number(0.1, 0.3)}"
        return f"{kind} {body} {self.texture()}"

    def light(self):
        rng = self.rng
        at = self.numbers((-6, 3, -8), (6, 8, -3))
        if rng.random() < 0.3:
            return f"Directional_Light Direction {self.numbers((-1, -1, 0.5), (1, -0.3, 1))} Color {self.color()}\n"
        fade = rng.choice(("", f"Attenuation Constant 1 Linear {self.number(0, 0.1)} Quadratic {self.number(0, 0.01)} "))
        return f"Light Center {at} Rad 0.1 {fade}Color {self.color()}\n"

    def text(self):
        rng = self.rng
        projection, zoom = rng.choice((("", "1.2"), ("Projection Orthographic ", "0.2")))
        modes = rng.choice(("Full", "Full", "Medium")) + rng.choice(("", " Trans_VMD", " Shadow_Filter_Off", " Trans_Max_Surfaces 2"))
        text = f"Begin_Scene\nResolution {SIZE[0]} {SIZE[1]}\nShader_Mode {modes} End_Shader_Mode\n"
        text += f"Camera {projection}Zoom {zoom} Aspectratio 1 Antialiasing 0 Raydepth {rng.randint(2, 8)} " \
            f"Center {self.number(-1, 1)} {self.number(0.5, 2)} -6 Viewdir 0 -0.1 1 Updir 0 1 0 End_Camera\n"
        text += f"Background {self.color()}\n" + "".join(self.light() for _ in range(rng.randint(1, 3)))
        if rng.random() < 0.5:
            text += f"Plane Center 0 -1 0 Normal 0 1 0 {self.texture()}"
        if rng.random() < 0.2:
            text += f"Fog {rng.choice(('Linear', 'Exp', 'Exp2'))} Start 2 End 14 Density {self.number(0.05, 0.2)} Color {self.color()}\n"
        return text + "".join(self.shape() for _ in range(rng.randint(2, 9))) + "End_Scene\n"


def render(folder, scene, glint):
    """The pictures of both programs, and glint's messages."""
    width, height = map(str, SIZE)
    if scene.program == "povray":
        run.run(folder, "povray", "+Ipeer.pov", "+Opeer.ppm", "+FP", "+W" + width, "+H" + height, "-A", "-D", "-P")
    else:
        run.run(folder, "tachyon", "peer.dat", "-numthreads", "1", "-format", "PPM", "-o", "peer.ppm")
    command = [str(glint), "render", scene.name, "--format", scene.program, "-s", f"{width}x{height}", "-o", "own.ppm"]
    own = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120)
    if own.returncode != 0:
        raise RuntimeError(own.stderr)
    warnings = [line for line in own.stderr.splitlines() if "warning: " in line]
    return run.read_ppm(folder / "peer.ppm")[2], run.read_ppm(folder / "own.ppm")[2], warnings


def compare(peer, own, within):
    differences = [max(abs(peer[i + c] - own[i + c]) for c in range(3)) for i in range(0, len(peer), 3)]
    return sum(d <= within for d in differences) / len(differences), max(differences)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("glint", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--program", choices=("povray", "tachyon"))
    parser.add_argument("--within", type=int, default=2)
    arguments = parser.parse_args()
    glint = arguments.glint.resolve()
    top = pathlib.Path(__file__).resolve().parents[2] / "build" / "peers" / "random"
    counts = {"alike": 0, "warned of": 0, "different": 0, "failed": 0}
    kinds = [kind for kind in (Pov, Dat) if arguments.program in (None, kind.program) and shutil.which(kind.program)]
    for number in range(arguments.count if kinds else 0):
        seed = arguments.seed * 100000 + number
        scene = kinds[number % len(kinds)](random.Random(seed))
        name = f"{scene.program}_{seed}"
        folder = top / name
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        (folder / scene.name).write_text(scene.text())
        try:
            peer, own, warnings = render(folder, scene, glint)
            share, most = compare(peer, own, arguments.within)
        except (OSError, RuntimeError, ValueError, subprocess.TimeoutExpired) as error:
            counts["failed"] += 1
            print(f"{name}: FAILED: {error}", flush=True)
            continue
        if share >= SHARE:
            counts["alike"] += 1
            shutil.rmtree(folder)
            continue
        counts["warned of" if warnings else "different"] += 1
        print(f"{name}: {100 * share:.2f}% within {arguments.within}, at most {most}; {' '.join(warnings) or 'no warning'}", flush=True)
    print(", ".join(f"{count} {kind}" for kind, count in counts.items()))
    return 1 if counts["different"] or counts["failed"] or not kinds else 0


if __name__ == "__main__":
    sys.exit(main())
