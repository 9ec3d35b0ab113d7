# SPDX-License-Identifier: Apache-2.0
"""Random scenes that use more of POV-Ray's language than shapes in a row: macros, loops, arrays, declared objects, groups in
groups, meshes with textures, all cameras, skies, and lights with a shape or an area."""
import random_povray

HELPERS = """#declare Steel = rgb <.137, .42, .557>; #declare Sand = color red .86 green .58 blue .44; #declare White = rgb 1;
#declare Veil = rgbt <.4, .6, .3, .5>; #declare Shiny = finish { specular 1 roughness .001 } #declare Dull = finish { specular .5 roughness .15 }
#declare Bright = finish { ambient 1 diffuse 0 } #declare Glossy = finish { phong 1 phong_size 120 reflection { .05 .2 } }
#macro Ball(At, R, Col) sphere { At, R pigment { Col } finish { Plain } } #end
#macro Stick(A, B, R, T) #if (vlength(B - A) > 1e-4) cylinder { A, B, R open texture { T } } #end #end
#macro Grow(N, By) #declare N = N + By; #end
#macro Tower(N, At) #if (N > 0) box { At - .15*N/3, At + .15*N/3 } Tower(N - 1, At + .3*y) #end #end
#declare Wave = function(s) { .4*sin(3*s) + .2*s };
"""


class PovLanguage(random_povray.Pov):
    def some(self, share, text):
        return text if self.rng.random() < share else ""

    def color(self):
        rng, number = self.rng, self.number
        kind = rng.random()
        if kind < 0.15:
            return "color " + rng.choice(("Steel", "Sand", "White", "White*.4", "Steel*.5 + .2", "Veil"))
        if kind < 0.25:
            return f"color red {number(0, 1)} green {number(0, 1)}"
        return super().color()

    def pigment(self):
        kind = self.rng.random()
        if kind < 0.1:
            return f"pigment {{ {self.color()} transmit {self.number(0.1, 0.9)} }}"
        if kind < 0.2:
            return f"pigment {{ {self.color()} filter {self.number(0.1, 0.9)} }}"
        return super().pigment()

    def finish(self):
        rng, number = self.rng, self.number
        kind = rng.random()
        if kind < 0.15:
            return "finish { Plain " + self.some(0.5, f"ambient {number(0, 0.4)}") + " }"
        if kind < 0.3:
            return "finish { " + rng.choice(("Shiny", "Dull", "Bright", "Glossy")) + " }"
        if kind < 0.4:
            return f"finish {{ diffuse {number(0, 0.9)}, {number(0, 0.9)} emission {number(0, 0.3)} ambient 0 }}"
        if kind < 0.5:
            return f"finish {{ metallic {number(0, 1)} specular {number(0.1, 0.9)} roughness {number(0.005, 0.1)} " \
                f"reflection {{ {number(0, 0.2)} {number(0.2, 0.8)} falloff {number(0.5, 3)} metallic {number(0, 1)} }} }}"
        if kind < 0.55:
            return f"finish {{ ambient {self.color()} diffuse albedo {number(0.2, 0.8)} phong albedo {number(0.2, 0.5)} }}"
        return super().finish()

    def texture(self):
        under = self.some(0.05, f"texture {{ pigment {{ {self.color()} }} }} ")
        return under + f"texture {{ pigment {{ {self.color()} }} {self.finish()} }}"

    def transform(self):
        number = self.number
        return self.rng.choice((
            "", f" rotate {self.vector((-40, -40, -40), (40, 40, 40))}", f" translate {self.vector((-1, -.5, -1), (1, .5, 1))}",
            f" scale {number(0.6, 1.4)} rotate {number(-50, 50)}*z", f" scale <{number(-1.4, -0.6)}, 1, {number(0.6, 1.4)}>",
            f" transform {{ rotate {number(-90, 90)}*y translate <0, {number(-0.5, 0.5)}, 0> }}", " transform { Leaning }",
            f" matrix <1, {number(-.3, .3)}, 0, {number(-.3, .3)}, 1, 0, 0, 0, {number(0.7, 1.3)}, 0, {number(0, 0.5)}, 0>"))

    def mesh(self):
        """A bent sheet of 5 x 4 corners, with normals, with a texture for each face or neither."""
        rng = self.rng
        bend, phase, slope = rng.uniform(0.1, 0.5), rng.uniform(0, 6), rng.uniform(-0.3, 0.3)
        at = [(0.6 * i - 1.2, 0.5 * j - 0.6, bend * ((i - 2) ** 2 / 4) + slope * j + 0.1 * phase) for j in range(4) for i in range(5)]
        normals = [(2 * bend * ((i - 2) / 2) / 1.2, slope / 0.5, -1) for _ in range(4) for i in range(5)]
        faces = [(5 * j + i + a, 5 * j + i + b, 5 * j + i + c) for j in range(3) for i in range(4) for a, b, c in ((0, 1, 5), (1, 6, 5))]

        def write(rows):
            return f"{len(rows)}, " + ", ".join("<" + ", ".join(f"{v:.4g}" for v in row) + ">" for row in rows)

        smooth, textured = rng.random() < 0.6, rng.random() < 0.5
        if rng.random() < 0.2:
            body = "".join(f"triangle {{ <{at[a]}>, <{at[b]}>, <{at[c]}> }} ".replace("<(", "<").replace(")>", ">") for a, b, c in faces)
            return f"mesh {{ {body} {self.texture()}{self.clip()}{self.transform()} }}\n"
        text = "mesh2 { vertex_vectors { " + write(at) + " } "
        text += "normal_vectors { " + write(normals) + " } " if smooth else ""
        if textured:
            text += "texture_list { 3, " + " ".join(f"texture {{ pigment {{ {self.color()} }} }}" for _ in range(3)) + " } "
        which = [f", {rng.randrange(3)}" if textured else "" for _ in faces]
        text += f"face_indices {{ {len(faces)}, " + ", ".join(f"<{a}, {b}, {c}>{i}" for (a, b, c), i in zip(faces, which)) + " } "
        return text + ("" if textured else self.texture()) + self.clip() + self.transform() + " }\n"

    def clip(self):
        return self.some(0.3, self.rng.choice((
            f" clipped_by {{ plane {{ {self.vector((-1, -1, 0), (1, 1, 0.5))}, {self.number(-0.2, 0.4)} }} }}",
            f" clipped_by {{ box {{ <{self.number(-1, -0.2)}, -0.4, -3>, <{self.number(0.3, 1)}, 0.5, 3> }} }}")))

    def group(self, depth=0):
        parts = []
        for _ in range(self.rng.randint(2, 3)):
            nested = depth < 2 and self.rng.random() < 0.3
            parts.append(self.group(depth + 1) if nested else self.plain())
        more = self.some(0.3, " no_shadow") + self.some(0.2, " hollow") + self.some(0.2, " bounded_by { sphere { 0, 9 } }")
        return f"union {{ {' '.join(parts)} {self.texture()}{self.transform()}{more} }}\n"

    def plain(self):
        """A shape, often without a texture."""
        rng = self.rng
        body = rng.choice((f"sphere {{ {self.place()}, {self.number(0.2, 0.6)}", f"box {{ {self.place()}, {self.place()}",
                           f"cylinder {{ {self.place()}, {self.place()}, {self.number(0.05, 0.3)}",
                           f"cone {{ {self.place()}, {self.number(0.1, 0.5)}, {self.place()}, {self.number(0, 0.3)}"))
        return body + self.some(0.4, " " + self.texture()) + self.transform() + " }"

    def loop(self):
        rng, number = self.rng, self.number
        return rng.choice((
            f"#for (I, -2, 2, {rng.choice(('1', '.5'))}) Ball(<I, Wave(I) + {number(0, 1)}, {number(0, 2)}>, {number(0.1, 0.3)}, "
            "rgb <.5 + I/5, .4, mod(abs(I)*7, 3)/3>) #end\n",
            f"#declare N = 0; #while (N < 6) Stick(vrotate(x*{number(0.5, 2)}, y*60*N), <0, 1.5, {number(0, 1)}>, .06, Shade) "
            "Grow(N, 1) #end\n",
            "#declare Places = array[3] { " + ", ".join(self.place() for _ in range(3)) + " }\n"
            f"#for (I, 0, dimension_size(Places, 1) - 1) sphere {{ Places[I], {number(0.2, 0.5)} texture {{ Shade }} "
            f"#switch (I) #case (1) no_shadow #break #range (2, 9) scale <1, {number(0.7, 1.1)}, 1> #end }} #end\n",
            f"union {{ Tower({rng.randint(2, 5)}, {self.place()}) texture {{ Shade }} }}\n",
            f"#declare S = seed({rng.randint(1, 9999)}); #for (I, 1, 9) sphere {{ <4*rand(S) - 2, 2*rand(S), 3*rand(S)>, .1 + .2*rand(S) "
            "pigment { rgb <rand(S), rand(S), rand(S)> } } #end\n",
            f"#macro Ring(N) #local A = 0; #while (A < 2*pi) sphere {{ <cos(A), .5, sin(A)>*{number(0.6, 1.4)}, .15 }} #local A = A + 2*pi/N; "
            f"#end #end union {{ Ring({rng.randint(3, 12)}) {self.texture()}{self.transform()} }}\n",
            f"#if (strcmp(concat(\"a\", str({rng.randint(1, 9)}, 0, 0)), \"a5\") < 0) {self.plain()} #else {self.plain()} #end\n"))

    def polygon(self):
        """Of 3 to 7 corners around its center."""
        corners = sorted(self.rng.uniform(0, 360) for _ in range(self.rng.randint(3, 7)))
        size = self.number(0.5, 1.2)
        points = ", ".join(f"vrotate(x*{size}, {angle:.1f}*z)" for angle in corners + corners[:1])
        return f"polygon {{ {len(corners) + 1}, {points} {self.texture()} rotate {self.vector((-40, -40, 0), (40, 40, 0))} translate {self.place()} }}\n"

    def shape(self):
        rng = self.rng
        kind = rng.random()
        if kind < 0.2:
            return self.group()
        if kind < 0.4:
            return self.loop()
        if kind < 0.55:
            return self.mesh()
        if kind < 0.62:
            return self.polygon()
        if kind < 0.67:
            return f"sphere {{ {self.place()}, {self.number(0.3, 0.8)} pigment {{ rgbt 1 }} finish {{ ambient 0 diffuse 0 }} " \
                f"interior {{ ior {self.number(1.1, 1.8)} }} }}\n"
        if kind < 0.77:
            name = f"Thing{rng.randrange(10 ** 6)}"
            uses = "".join(f"object {{ {name}{self.transform()}{self.some(0.3, ' ' + self.texture())} }}\n" for _ in range(2))
            return f"#declare {name} = {self.group()}" + uses
        return super().shape()

    def light(self):
        rng, number = self.rng, self.number
        at = self.vector((-6, 3, -8), (6, 8, -3))
        kind = rng.random()
        if kind < 0.15:
            n, m = rng.randint(1, 5), rng.randint(1, 5)
            return f"light_source {{ {at}, rgb {number(0.4, 0.9)} area_light {number(0.3, 2)}*x, {number(0.3, 2)}*z, {n}, {m} " \
                f"{self.some(0.6, f'adaptive {rng.randint(0, 2)}')} }}\n"
        if kind < 0.25:
            shown = self.vector((-2, 0.5, 0), (2, 2, 3))
            return f"light_source {{ {shown}, {self.color()} looks_like {{ sphere {{ 0, {number(0.1, 0.4)} pigment {{ {self.color()} }} " \
                "finish { ambient 1 diffuse 0 } } } }\n"
        if kind < 0.35:
            return f"light_source {{ 0, {self.color()} spotlight radius {number(5, 20)} falloff {number(20, 40)} tightness {number(0, 20)} " \
                f"point_at <0, -4, 5> translate {at} }}\n"
        if kind < 0.42:
            return f"light_source {{ {at} {self.color()} fade_distance {number(3, 12)} fade_power {rng.choice('123')} shadowless }}\n"
        return super().light()

    def camera(self):
        rng, number = self.rng, self.number
        at = self.vector((-2, 0, -7), (2, 3, -5))
        return rng.choice((
            f"location {at} look_at <0, .5, 0> right x*image_width/image_height angle {number(30, 80)}",
            f"location {at} direction {number(0.8, 2)}*z up y right 4/3*x look_at {self.vector((-.5, 0, 0), (.5, 1, 1))}",
            f"location {at} sky {self.vector((-.6, 1, 0), (.6, 1, .5))} look_at <0, .5, 0> right -4/3*x",
            f"location <0, 0, -6> direction 1.3*z right <1.33, 0, 0> up <0, 1, 0> rotate {self.vector((0, -30, -10), (25, 30, 10))}",
            f"perspective location {at} right {number(1, 1.6)}*x up {number(0.8, 1.2)}*y angle 50 look_at <0, .5, 0> translate {number(-.5, .5)}*y",
            f"orthographic location {at} direction z right {number(4, 8)}*x up {number(4, 6)}*y look_at <0, .5, 0>",
            f"orthographic angle {number(30, 60)} location {at} look_at <0, .5, 0> right x*4/3"))

    def sky(self):
        rng, number = self.rng, self.number
        kind = rng.random()
        if kind < 0.25:
            return f"sky_sphere {{ pigment {{ gradient y color_map {{ [0 {self.color()}] [1 {self.color()}] }} scale 2 translate -1 }} }}\n"
        if kind < 0.35:
            return f"sky_sphere {{ pigment {{ {self.color()} }} }}\n"
        return f"background {{ {self.color()}{self.some(0.2, ' transmit ' + number(0, 1))} }}\n"

    def text(self):
        rng, number = self.rng, self.number
        head = rng.choice(("#version 3.6;\n", "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n", "", "#version 3.7;\n",
                           "#version 3.6;\nglobal_settings { assumed_gamma 2.2 }\n"))
        text = head + HELPERS
        if rng.random() < 0.4:
            text += f"global_settings {{ {self.some(0.5, f'ambient_light {number(0, 2)} ')}{self.some(0.5, f'max_trace_level {rng.randint(1, 9)} ')}" \
                f"{self.some(0.3, f'adc_bailout {number(0, 0.1)}')} }}\n"
        text += f"#declare Plain = finish {{ ambient {number(0, 0.3)} diffuse {number(0.3, 0.8)} phong {number(0, 0.6)} }};\n"
        text += f"#declare Shade = texture {{ {self.pigment()} {self.finish()} }};\n"
        text += f"#declare Leaning = transform {{ rotate {number(-40, 40)}*z translate {number(-0.5, 0.5)}*x }};\n"
        text += self.some(0.3, f"#default {{ {rng.choice((self.finish(), f'pigment {{ {self.color()} }}', f'texture {{ {self.finish()} }}'))} }}\n")
        text += f"camera {{ {self.camera()} }}\n" + self.sky() + "".join(self.light() for _ in range(rng.randint(1, 3)))
        text += self.some(0.5, f"plane {{ y, -1 pigment {{ {self.color()} }} {self.finish()} }}\n")
        for _ in range(rng.choice((0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2))):
            text += f"fog {{ fog_type 1 distance {number(5, 40)} {self.color()}{self.some(0.3, ' transmit ' + number(0, 0.5))} }}\n"
        return text + "".join(self.shape() for _ in range(rng.randint(2, 6)))
