# SPDX-License-Identifier: Apache-2.0
"""Links of shader nodes, followed to where a value comes from: through reroutes, muted nodes and groups within groups."""
MAX_STEPS = 256


def origin(socket, path=()):
    """(socket, path) where the value of an input comes from: an output of a node, or an input that nothing is linked to.

    path: the group nodes around the input, and around what is found; the innermost is the last."""
    for _ in range(MAX_STEPS):
        if not socket.is_linked or socket.links[0].is_muted:
            break
        link = socket.links[0]
        node, output = link.from_node, link.from_socket
        if node.type == "REROUTE":
            socket = node.inputs[0]
        elif node.mute:
            passed = next((inner.from_socket for inner in node.internal_links if inner.to_socket == output), None)
            if passed is None:
                break
            socket = passed
        elif node.type == "GROUP":
            inner = _group_output(node.node_tree, output)
            if inner is None:
                break
            socket, path = inner, (*path, node)
        elif node.type == "GROUP_INPUT" and path:
            inner = _same(path[-1].inputs, output)
            if inner is None:  # the group has changed, and its node is not up to date
                break
            socket, path = inner, path[:-1]
        else:
            return output, path
    return socket, path


def _group_output(tree, output):
    """The input, inside a group, that its node passes on as that output; None for an empty group."""
    ends = [node for node in tree.nodes if node.type == "GROUP_OUTPUT"] if tree is not None else []
    active = next((node for node in ends if node.is_active_output), None)
    return _same(active.inputs, output) if active is not None else None


def _same(sockets, wanted):
    return next((socket for socket in sockets if socket.identifier == wanted.identifier), None)
