# SPDX-License-Identifier: Apache-2.0
"""What a scene's settings add to F12: where its files are kept, and more arguments of `glint render`. Pure Python."""
import os
import re
import shlex

# A .blend may come from somebody else: it names no file that glint writes. The passes decide how the picture is read.
_BLENDERS = "the picture is Blender's"
_REFUSED = {"--output": _BLENDERS, "--size": _BLENDERS, "--crop": _BLENDERS, "--part": _BLENDERS, "--resume": _BLENDERS,
            "--stats": "a scene names no file that is written",
            "--aov": "choose the layers in View Layer Properties > Passes"}
_SHORT = re.compile(r"-[qh]*([os])")  # glint takes -qo FILE and -oFILE, too
_LONG = {"o": "--output", "s": "--size"}


class ArgumentsError(RuntimeError):
    """The text is for the user."""


def kept_name(scene, layer):
    """What the scene of a render is called where it is kept: SCENE.0001, with the view layer if there are more of them."""
    name = scene.name if len(scene.view_layers) == 1 else f"{scene.name}.{layer.name}"
    name = re.sub(r"[^\w.-]", "_", name)
    return f"{name}.{scene.frame_current:04d}"


def extra_arguments(text):
    """The arguments in a text with the quotes of a shell. Raises ArgumentsError."""
    parts = shlex.shlex(text, posix=True, punctuation_chars=False)
    parts.whitespace_split, parts.commenters = True, ""
    if os.name == "nt":
        parts.escape = ""  # paths have backslashes
    try:
        arguments = list(parts)
    except ValueError as error:
        raise ArgumentsError(f"Extra arguments: {error}") from None
    for argument in arguments:
        short = _SHORT.match(argument)
        name = _LONG[short[1]] if short else argument.split("=")[0]
        if name in _REFUSED:
            raise ArgumentsError(f"Extra arguments: {name} cannot be given: {_REFUSED[name]}")
    return arguments
