# SPDX-License-Identifier: Apache-2.0
# docs/adding_a_light.md, "A field of a material": light that a surface emits.

# 1. The member, and its row.
add_line(include/glint/scene.h after "    Color specular{0, 0, 0};          ///< k_s\n"
  "    Color glow{0, 0, 0};              ///< light that the surface gives off\n")
add_line(src/scene/material_fields.h before "    {\"shininess\", \"shininess\", \"shininess\","
  "    {\"glow\", \"glow\", \"glow\", color_field(&Material::glow, k_tint, ColorUse::coefficient),
     \"light that the surface gives off\"},\n")
# 2. What the kernels load.
add_line(src/world/world.h replace "    k_material_values = 22,\n" "    k_glow = 22,\n    k_material_values = 25,\n")
add_line(src/world/shading.cpp after "    *row++ = m.shininess, *row++ = m.mirror, *row++ = m.transmission, *row++ = m.ior;\n"
  "    *row++ = m.glow.r, *row++ = m.glow.g, *row++ = m.glow.b;\n")
# 3. Its formula: in the ambient layer.
add_line(src/trace/film-inl.h replace "    return material.color(k_ambient) * lanes_of(world.ambient);"
  "    return material.color(k_ambient) * lanes_of(world.ambient) + material.color(k_glow);")
