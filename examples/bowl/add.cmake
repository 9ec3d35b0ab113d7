# SPDX-License-Identifier: Apache-2.0
# docs/adding_a_shape.md.

# 1. The parameters, and the line in the list of kinds.
file(READ ${CMAKE_CURRENT_LIST_DIR}/bowl.h parameters)
add_line(include/glint/shapes.h before "inline constexpr std::uint32_t k_max_polygon_vertices" "${parameters}\n")
add_line(include/glint/shapes.h after "    X(Sphere, sphere)                  \\\n" "    X(Bowl, bowl) \\\n")
# 2. The file in geometry/, and the line that includes it.
file(COPY ${CMAKE_CURRENT_LIST_DIR}/bowl-inl.h DESTINATION ${glint}/src/geometry)
add_line(src/geometry/kinds-inl.h after "#include \"geometry/box-inl.h\"\n" "#include \"geometry/bowl-inl.h\"\n")
