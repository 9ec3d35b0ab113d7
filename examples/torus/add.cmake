# SPDX-License-Identifier: Apache-2.0
# docs/adding_a_shape.md.

# 1. The parameters, and the line in the list of kinds.
file(READ ${CMAKE_CURRENT_LIST_DIR}/torus.h parameters)
add_line(include/glint/shapes.h before "inline constexpr std::uint32_t k_max_polygon_vertices" "${parameters}\n")
add_line(include/glint/shapes.h after "    X(Sphere, sphere)                  \\\n" "    X(Torus, torus) \\\n")
# 2. The file in geometry/, and the line that includes it.
file(COPY ${CMAKE_CURRENT_LIST_DIR}/torus-inl.h DESTINATION ${glint}/src/geometry)
add_line(src/geometry/kinds-inl.h after "#include \"geometry/sphere-inl.h\"\n" "#include \"geometry/torus-inl.h\"\n")
