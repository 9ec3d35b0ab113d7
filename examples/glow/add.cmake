# SPDX-License-Identifier: Apache-2.0
# docs/adding_a_light.md, "A field of a material": light that a surface emits.

# 1. The member, and its row, in the part of the list that is the second table.
add_line(include/glint/scene.h before "    double brilliance = 1;"
  "    Color glow{0, 0, 0};  ///< light that the surface gives off\n")
add_line(src/scene/material_fields.h before "    {\"brilliance\", \"brilliance\", \"brilliance\","
  "    {\"glow\", \"glow\", \"glow\", color_field(&Material::glow, k_tint, ColorUse::coefficient),
     \"light that the surface gives off\"},\n")
# 2. Its formula: in the ambient layer.
add_line(src/trace/film/film-inl.h replace "    return material.color(k_ambient) * lanes_of(world.ambient);"
  "    const Vector3<Doubles> ambient = material.color(k_ambient) * lanes_of(world.ambient);
    if (!world.uses<&Material::glow>()) return ambient;
    return ambient + ExtendedLanes(material).color<&Material::glow>();")
