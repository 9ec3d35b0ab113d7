# SPDX-License-Identifier: Apache-2.0
"""Closed meshes, prisms, texts and lathes as parts of solids, and what they clip."""
from solids import BLUE, BOX, CLEAR, GLASS, MIRROR, RED, SHINE, TURN, cut, solids

# Of any winding: POV-Ray turns normals to the ray.
OCTAHEDRON = ("vertex_vectors { 6, <1.1, 0, 0>, <-1.1, 0, 0>, <0, 1.1, 0>, <0, -1.1, 0>, <0, 0, 1.1>, <0, 0, -1.1> } "
              "face_indices { 8, <0, 2, 4>, <2, 1, 4>, <1, 3, 4>, <0, 3, 4>, <2, 0, 5>, <1, 2, 5>, <1, 3, 5>, <0, 3, 5> } "
              "inside_vector <0.3, 1, 0.2>")


def octahedron(items, normals=""):
    return f"mesh2 {{ {OCTAHEDRON.replace('face_indices', normals + ' face_indices')} {items} translate 0.8*y }}"


TETRAHEDRON = ("mesh { triangle { <-1, 0, -1>, <1, 0, -1>, <0, 0, 1> } triangle { <-1, 0, -1>, <0, 1.6, 0>, <1, 0, -1> } "
               "triangle { <1, 0, -1>, <0, 0, 1>, <0, 1.6, 0> } triangle { <0, 0, 1>, <-1, 0, -1>, <0, 1.6, 0> } inside_vector x ")
RING = ("<-0.7, -0.7>, <0.7, -0.7>, <0.7, 0.7>, <0.1, 0.2>, <-0.7, 0.7>, <-0.7, -0.7>, "
        "<-0.2, -0.3>, <0.2, -0.3>, <0.2, 0>, <-0.2, 0>, <-0.2, -0.3>")
CURVE = "7, <0.8, 0>, <0, 0.8>, <-0.8, 0>, <0, -0.6>, <0.8, 0>, <0, 0.8>, <-0.8, 0>"
SMOOTH = "normal_vectors { 6, x, -x, y, -y, z, -z }"

RULES = [
    solids("mesh_cuts", cut(octahedron(BLUE), TURN)),
    solids("mesh_is_cut", f"difference {{ {octahedron(RED)} cylinder {{ <0, 0.9, -2>, <0, 0.9, 2>, 0.4 {BLUE} }} {TURN} }}\n"),
    solids("mesh_common", f"intersection {{ {TETRAHEDRON} {RED} }} sphere {{ <0, 0.5, 0>, 0.7 {BLUE} }} {TURN} }}\n"),
    solids("mesh_smooth", cut(octahedron(SHINE, SMOOTH), TURN)),
    solids("mesh_two", cut(f"union {{ {octahedron('scale 0.8')} {TETRAHEDRON} translate <0, 0.1, -0.6> }} {BLUE} }}", TURN)),
    solids("mesh_inverse", f"intersection {{ {BOX} {RED} }} {octahedron('inverse ' + BLUE)} {TURN} }}\n"),
    solids("mesh_clear", f"merge {{ {octahedron('scale <1.2, 0.7, 1>')} sphere {{ <0.5, 0.9, 0>, 0.6 }} {CLEAR} {TURN} }}\n"),
    solids("mesh_mirror", cut(octahedron(MIRROR), TURN, MIRROR)),
    solids("mesh_glass", f"difference {{ sphere {{ <0, 0.8, 0>, 1.1 {GLASS} }} {octahedron('scale 0.6 translate 0.3*y')} }}\n"
           "cylinder { <-3, 0.4, 2>, <3, 0.9, 2>, 0.3 pigment { rgb <1, 0, 0> } }\n"),
    solids("mesh_clips", f"sphere {{ <0, 0.8, 0>, 1 {RED} clipped_by {{ {octahedron('rotate 20*y')} }} }}\n"),
    solids("mesh_clipped", octahedron(RED + " clipped_by { sphere { <0.4, 0.3, -0.4>, 0.9 } }")),
    solids("mesh_shadow", cut(octahedron(BLUE), "rotate 60*y"),
           light="light_source { <5, 3, -2>, rgb 1 }\nlight_source { <-6, 4, -3>, rgb 0.5 }\n"),
    solids("prism_cuts", cut(f"prism {{ linear_spline -2, 2, 11, {RING} rotate -90*x translate 0.8*y {BLUE} }}", TURN)),
    solids("prism_is_cut", f"intersection {{ prism {{ cubic_spline 0, 1.6, {CURVE} {RED} }} plane {{ <-1, 1, -0.5>, 0.9 {BLUE} }} {TURN} }}\n"),
    solids("prism_cone", f"difference {{ prism {{ conic_sweep linear_spline 0, 1.6, 6, <-0.8, -0.8>, <0.8, -0.8>, <0.9, 0.5>, <0, 0.2>, <-0.8, 0.8>, <-0.8, -0.8> {RED} }}\n"
           f"sphere {{ <0, 1.6, -0.9>, 0.7 {BLUE} }} rotate -15*x translate 0.2*y }}\n"),
    solids("lathe_is_cut", f"difference {{ lathe {{ linear_spline 6, <0, 0>, <0.9, 0>, <0.4, 0.8>, <0.8, 1.1>, <0.5, 1.7>, <0, 1.7> {RED} }} box {{ <0, -1, -2>, <2, 2, 2> {BLUE} }} {TURN} }}\n"),
    solids("lathe_ring", f"intersection {{ lathe {{ linear_spline 5, <0.5, 0.1>, <1, 0.4>, <0.8, 1.4>, <0.6, 1.2>, <0.5, 0.1> {RED} }} plane {{ <0.3, 0, 1>, 0.1 {BLUE} }} {TURN} }}\n"),
    solids("lathe_cuts", cut(f"lathe {{ cubic_spline 8, <-1, -0.3>, <0, -0.2>, <0.7, 0.2>, <0.3, 0.8>, <0.7, 1.3>, <0.3, 1.7>, <0, 1.8>, <-1, 1.9> {BLUE} rotate 30*x }}", TURN)),
    solids("lathe_bezier", f"difference {{ lathe {{ bezier_spline 8, <0, 0>, <1.2, 0>, <1.2, 0.9>, <0.6, 1.1>, <0.6, 1.1>, <0.2, 1.3>, <0.6, 1.8>, <0, 1.8> {RED} }}\n"
           f"cylinder {{ <0, 0.5, -2>, <0, 0.5, 2>, 0.3 {BLUE} }} {TURN} }}\n"),
    solids("lathe_inverse", f"intersection {{ box {{ <-0.9, 0, -0.9>, <0.9, 1.6, 0.9> {BLUE} }} lathe {{ cubic_spline 8, <-1, -0.3>, <0, -0.2>, <0.7, 0.2>, <0.3, 0.8>, <0.7, 1.3>, <0.3, 1.7>, <0, 1.8>, <-1, 1.9> {RED} translate -0.8*z inverse }} {TURN} }}\n"),
    solids("lathe_clipped", f"lathe {{ linear_spline 4, <0, 0>, <0.9, 0.3>, <0.6, 1.6>, <0, 1.6> {RED} clipped_by {{ sphere {{ <0.3, 0.7, -0.6>, 0.9 }} }} {TURN} }}\n"),
    solids("lathe_merge", f"merge {{ lathe {{ linear_spline 6, <0, 0>, <1, 0.2>, <0.4, 0.9>, <0.9, 1.4>, <0.6, 1.7>, <0, 1.75> }} sphere {{ <0.7, 1, -0.4>, 0.6 }} {CLEAR} }}\n"),
    solids("text_cuts", f"difference {{ {BOX} {RED} scale <1.4, 1, 1> }} text {{ ttf \"timrom.ttf\" \"R&8o\" 1, 0 scale <0.9, 1.2, 1> translate <-1.1, 0.3, -1.5> {BLUE} }} rotate 15*y }}\n"),
]
