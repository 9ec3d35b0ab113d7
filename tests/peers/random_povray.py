# SPDX-License-Identifier: Apache-2.0
"""Random scenes in POV-Ray's language: shapes in a row, their textures and lights."""


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
