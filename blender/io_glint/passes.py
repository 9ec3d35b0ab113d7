# SPDX-License-Identifier: Apache-2.0
"""glint's layers as Blender's render passes: pure tables and lists."""
import bisect
import itertools

# layer of glint: (name of Blender's pass, its channels, the layer's channels, kind)
PASSES = {
    "depth": ("Depth", "Z", ("Z",), "VALUE"),
    "normal": ("Normal", "XYZ", ("X", "Y", "Z"), "VECTOR"),
    "position": ("Position", "XYZ", ("X", "Y", "Z"), "VECTOR"),
    "object": ("IndexOB", "X", ("I",), "VALUE"),
    "material": ("IndexMA", "X", ("I",), "VALUE"),
    "albedo": ("DiffCol", "RGB", ("R", "G", "B"), "COLOR"),
    "background": ("Env", "RGB", ("R", "G", "B"), "COLOR"),
    "ambient": ("glint ambient", "RGB", ("R", "G", "B"), "COLOR"),
    "diffuse": ("glint diffuse", "RGB", ("R", "G", "B"), "COLOR"),
    "specular": ("glint specular", "RGB", ("R", "G", "B"), "COLOR"),
    "reflection": ("glint reflection", "RGB", ("R", "G", "B"), "COLOR"),
    "transmission": ("glint transmission", "RGB", ("R", "G", "B"), "COLOR"),
    "shadow": ("glint shadow", "X", ("Y",), "VALUE"),
}
# The check boxes of Blender's own passes; the others are glint's, in view_layer.glint.
BUILT_IN = {"depth": "use_pass_z", "normal": "use_pass_normal", "position": "use_pass_position",
            "object": "use_pass_object_index", "material": "use_pass_material_index",
            "albedo": "use_pass_diffuse_color", "background": "use_pass_environment"}
OWN = tuple(layer for layer in PASSES if layer not in BUILT_IN)
COMBINED = "combined"  # glint's picture with its alpha, which is no layer
CHANNELS = {COMBINED: ("R", "G", "B", "A"), **{layer: channels for layer, (_, _, channels, _) in PASSES.items()}}
FAR = 1e10  # Blender's depth where nothing is hit


def wanted(view_layer):
    """The layers that a view layer asks for, in glint's names."""
    own = getattr(view_layer, "glint", None)
    return [layer for layer in PASSES
            if getattr(view_layer, BUILT_IN.get(layer, ""), False) or getattr(own, layer, False)]


def converted(part, layer, written, crop):
    """Replaces glint's depths and numbers by Blender's: depths along the view's axis, pass indices.

    written: the SceneText."""
    for name, values in part.channels.items():
        if layer == "depth":
            lengths = written.view.ray_lengths(crop)
            part.channels[name] = [min(v / length, FAR) for v, length in zip(values, lengths)]
        elif layer == "object":
            part.channels[name] = _indices(values, *zip(*written.object_indices)) if written.object_indices else values
        elif layer == "material":
            known = written.material_indices
            part.channels[name] = [known[int(v) - 1] if 0 < v <= len(known) else 0 for v in values]
    return part


def _indices(numbers, counts, indices):
    """The index of each shape's object; shapes are numbered from 1, 0 is none."""
    ends = list(itertools.accumulate(counts))
    return [indices[bisect.bisect_left(ends, int(v))] if 0 < v <= ends[-1] else 0 for v in numbers]


def pixels(part, layer):
    """A part as Blender's pass.rect takes it: for each pixel its channels, rows from the bottom."""
    columns = []
    for name in CHANNELS[layer]:
        column = part.channels[name]
        flipped = []
        for row in range(part.height - 1, -1, -1):
            flipped.extend(column[row * part.width:(row + 1) * part.width])
        columns.append(flipped)
    return list(zip(*columns))
