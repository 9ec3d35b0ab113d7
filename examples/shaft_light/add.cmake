# SPDX-License-Identifier: Apache-2.0
# docs/adding_a_light.md: a directional light that is limited to a cylinder.

# 1. The kind, its members, and its answers.
add_line(include/glint/scene.h replace
  "enum class LightKind : std::uint8_t { ambient, point, directional, spot, parallelogram, disc, sphere };\ninline constexpr int k_light_kinds = 7;"
  "enum class LightKind : std::uint8_t { ambient, point, directional, spot, parallelogram, disc, sphere, shaft };\ninline constexpr int k_light_kinds = 8;")
add_line(include/glint/scene.h after "    Attenuation attenuation{};      ///< lights with a position\n"
  "    Vec3 center{};                  ///< shafts: a point on the axis, which is parallel to to_light
    double shaft_radius = 1;        ///< shafts: of the cylinder around the axis, > 0\n")
add_line(include/glint/scene.h before "            case LightKind::directional:\n" "            case LightKind::shaft:\n")
add_line(include/glint/scene.h before "    constexpr bool has_specular_color() const"
  "    constexpr bool is_shaft() const { return kind == LightKind::shaft; }\n")
# 2. Its name.
add_line(src/scene/scene.cpp before "        case LightKind::directional:\n"
  "        case LightKind::shaft:\n            return \"shaft\";\n")
# 3. Its fields.
add_line(src/scene/light_fields.h before "    {\"attenuation\", \"attenuation\", \"attenuation\","
  "    {.key = \"center\",
     .name = \"center\",
     .label = \"center\",
     .member = point_field(&Light::center),
     .description = \"a point on the axis\",
     .applies = &Light::is_shaft,
     .required = true},
    {\"shaft_radius\", \"shaft_radius\", \"shaft radius\", number_field(&Light::shaft_radius, k_length), \"of the cylinder around the axis\",
     &Light::is_shaft},\n")
# 4. Its formula.
add_line(src/trace/lighting/direct_lighting-inl.h before "    const auto faces"
  "    if (light.is_shaft()) {
        const Vector3<Doubles> from_center = load_vector3(surfaces.point, i) - lanes_of(light.center);
        const Doubles along = dot(from_center, to_light) / distance;
        const auto inside = dot(from_center, from_center) - along * along <=
                            Doubles(light.shaft_radius * light.shaft_radius);
        f_att = select(inside, f_att, Doubles(0));
        lit = lit && inside;
    }\n")
