# SPDX-License-Identifier: Apache-2.0
"""Random scenes of Tachyon."""

SIZE = 160, 120


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
