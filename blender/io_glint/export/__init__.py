# SPDX-License-Identifier: Apache-2.0
"""Scenes of Blender as text. No module here imports bpy: they work on the objects that they are given."""
