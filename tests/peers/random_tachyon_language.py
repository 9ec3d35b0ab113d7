# SPDX-License-Identifier: Apache-2.0
"""Random scenes that use more of Tachyon's language: named textures, arrays of vertices, spot lights, skies, all modes and
frames of the picture."""
import math

import random_tachyon


class DatLanguage(random_tachyon.Dat):
    names = ()

    def unit(self, least=(-1, -1, -1), most=(1, 1, 1)):
        while True:
            v = [self.rng.uniform(a, b) for a, b in zip(least, most)]
            length = math.sqrt(sum(c * c for c in v))
            if length > 0.2:
                return " ".join(f"{c / length:.6f}" for c in v)

    def body(self):
        rng, number = self.rng, self.number
        opacity = number(0.2, 0.9) if rng.random() < 0.25 else "1"
        raster = "TransMode R3D " if rng.random() < 0.1 else ""
        outline = f"Outline {number(0.2, 0.9)} Outline_Width {number(0.1, 0.6)} " if rng.random() < 0.15 else ""
        phong = f"Phong {rng.choice(('Plastic', 'Metal'))} {number(0, 1)} Phong_size {number(1, 60)} " if rng.random() < 0.7 else ""
        return f"Ambient {number(0, 0.4)} Diffuse {number(0.2, 0.9)} Specular {rng.choice(('0', '0.0', number(0, .6)))} " \
            f"Opacity {opacity} {raster}{outline}{phong}"

    def texture(self):
        if self.names and self.rng.random() < 0.5:
            return self.rng.choice(self.names) + "\n"
        return f"Texture {self.body()}Color {self.color()} TexFunc 0\n"

    def array(self):
        rng = self.rng
        bend = rng.uniform(0.1, 0.5)
        shift = [rng.uniform(-1, 1) for _ in range(3)]
        at = [(0.6 * i - 1.2 + shift[0], 0.5 * j + shift[1], bend * ((i - 2) ** 2 / 4) + shift[2]) for j in range(3) for i in range(5)]
        normals = []
        for _ in range(3):
            for i in range(5):
                slope = bend * (i - 2) / 2 / 0.6
                normals.append((slope / math.hypot(slope, 1), 0, -1 / math.hypot(slope, 1)))

        def rows(values):
            return "\n".join(" ".join(f"{c:.6f}" for c in v) for v in values)

        text = f"VertexArray Numverts {len(at)}\nCoords\n{rows(at)}\nNormals\n{rows(normals)}\n"
        if rng.random() < 0.3:
            color = self.color()
            text += "Colors\n" + "\n".join(color for _ in at) + "\n"
        text += f"Texture {self.body()}Color {self.color()} TexFunc 0\n"
        if rng.random() < 0.5:
            faces = [(5 * j + i + a, 5 * j + i + b, 5 * j + i + c) for j in range(2) for i in range(4) for a, b, c in ((0, 1, 5), (1, 6, 5))]
            text += f"TriMesh {len(faces)}\n" + " ".join(" ".join(map(str, f)) for f in faces) + "\n"
        else:
            for j in range(2):
                strip = [k for i in range(5) for k in (5 * j + i, 5 * j + 5 + i)]
                text += f"TriStrip {len(strip)} " + " ".join(map(str, strip)) + "\n"
        return text + "End_VertexArray\n"

    def shape(self):
        rng, place = self.rng, self.place
        kind = rng.random()
        if kind < 0.2:
            return self.array()
        if kind < 0.3:
            return f"Ring Center {place()} Normal {self.numbers((-1, 0.1, -1), (1, 1, 1))} Inner {self.number(0.1, 0.3)} " \
                f"Outer {self.number(0.4, 1)} {self.texture()}"
        if kind < 0.4:
            corner, size = [rng.uniform(a, b) for a, b in ((-2, 1), (-0.5, 1), (-1, 2))], rng.uniform(0.2, 0.9)
            most = " ".join(f"{c + size:.3f}" for c in corner)
            return f"Box Min {' '.join(f'{c:.3f}' for c in corner)} Max {most} {self.texture()}"
        if kind < 0.5:
            normals = " ".join(f"N{i} {self.unit((-0.5, -0.5, -1), (0.5, 0.5, -0.6))}" for i in range(3))
            corners = f"V0 {place()} V1 {place()} V2 {place()} {normals}"
            if rng.random() < 0.5:
                color = self.color()
                return f"VCSTri {corners} C0 {color} C1 {color} C2 {color} {self.body()}VCST\n"
            return f"STri {corners} {self.texture()}"
        if kind < 0.6:
            count = rng.randint(2, 6)
            return f"PolyCylinder Points {count} {' '.join(place() for _ in range(count))} Rad {self.number(0.05, 0.3)} {self.texture()}"
        return super().shape()

    def light(self):
        rng, number = self.rng, self.number
        if rng.random() < 0.3:
            fade = rng.choice(("", f"Attenuation Constant {number(0.5, 1)} Linear {number(0, .1)} Quadratic {number(0, .01)} "))
            return f"SpotLight Center {self.numbers((-4, 3, -8), (4, 8, -3))} Rad {number(0, .2)} Direction {self.numbers((-.5, -1, .5), (.5, -.6, 1))} " \
                f"Falloff_Start {number(5, 25)} Falloff_End {number(26, 60)} {fade}Color {self.color()}\n"
        if rng.random() < 0.2:
            return f"Light Center {self.place()} Rad {number(0.05, 0.3)} Color {self.color()}\n"
        return super().light()

    def camera(self):
        rng, number = self.rng, self.number
        frame = ""
        projection, zoom = rng.choice((("", number(0.8, 2)), ("Projection Perspective ", "1.3"), ("Projection Orthographic ", number(0.15, 0.3))))
        if rng.random() < 0.2:
            frame = f"Frustum {number(-.6, -.4)} {number(.4, .6)} {number(-.4, -.3)} {number(.3, .4)} " if "Ortho" not in projection \
                else f"Frustum {number(-4, -2)} {number(2, 4)} {number(-3, -2)} {number(2, 3)} "
        return f"Camera {projection}Zoom {zoom} Aspectratio {rng.choice(('1', '1.0', number(0.8, 1.3)))} Antialiasing 0 Raydepth " \
            f"{rng.randint(1, 12)} Center {number(-2, 2)} {number(0, 3)} -6 Viewdir {number(-.2, .2)} {number(-.3, 0)} 1 " \
            f"Updir {number(-.4, .4)} 1 0 {frame}End_Camera\n"

    def modes(self):
        rng = self.rng
        if rng.random() < 0.15:
            return ""
        depth = rng.choice(("Full", "Full", "Full", "Full", "Medium", "Medium", "Low", "Lowest"))
        more = rng.choice(("", " Trans_Orig", " Trans_VMD", " Trans_Raster3D")) + rng.choice(("", " Shadow_Filter_On", " Shadow_Filter_Off"))
        more += rng.choice(("", "", f" Trans_Max_Surfaces {rng.randint(1, 5)}")) + rng.choice(("", "", " Fog_VMD"))
        return f"Shader_Mode {depth}{more} End_Shader_Mode\n"

    def sky(self):
        if self.rng.random() < 0.3:
            bottom = self.rng.uniform(-1, 0)
            return f"Background {self.color()}\nBackground_Gradient {self.rng.choice(('Sky_Sphere', 'Sky_Ortho_Plane'))} Updir {self.numbers((-.3, 1, -.3), (.3, 1, .3))} " \
                f"TopVal {bottom + self.rng.uniform(.3, 2):.3f} BottomVal {bottom:.3f} TopColor {self.color()} BottomColor {self.color()}\n"
        if self.rng.random() < 0.1:
            return ""
        return f"Background {self.color()}\n"

    def text(self):
        rng, number = self.rng, self.number
        text = "# a random scene\nBEGIN_SCENE\nResolution {0} {1}\n".format(*random_tachyon.SIZE) + self.modes() + self.camera() + self.sky()
        names = [f"Tex{i}" for i in range(rng.randint(0, 3))]
        for name in names:
            text += f"TexDef {name} {self.body()}Color {self.color()} TexFunc 0\n"
        if names and rng.random() < 0.5:
            text += f"TexAlias other {names[0]}\n"
            names.append("other")
        self.names = names
        text += "".join(self.light() for _ in range(rng.randint(0, 4)))
        if rng.random() < 0.5:
            text += f"Plane Center 0 -1 0 Normal {self.numbers((-.1, 1, -.1), (.1, 1, .1))} {self.texture()}"
        if rng.random() < 0.3:
            text += f"Fog {rng.choice(('Linear', 'Exp', 'Exp2', 'Off'))} Start {number(0, 4)} End {number(8, 16)} Density {number(0.05, 0.2)} Color {self.color()}\n"
        return text + "".join(self.shape() for _ in range(rng.randint(2, 9))) + "End_Scene\n"
