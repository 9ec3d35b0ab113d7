# SPDX-License-Identifier: Apache-2.0
# docs/adding_a_light.md, "A term of an explanation": N·V of a hit.

# 1. The member.
add_line(include/glint/explain.h before "    bool behind = false; "
  "    double n_v = 0;                   ///< N·V\n")
# 2. The stage that records it.
add_line(src/trace/record-inl.h after "    hit.to_eye = vec3_at(surfaces.to_eye, i);\n"
  "    hit.n_v = dot(hit.normal, hit.to_eye);\n")
# 3. Its row.
add_line(src/explain/terms.h before "    {\"normal_turned\", &ExplainedHit::turned,"
  "    {.name = \"n_v\", .member = &ExplainedHit::n_v, .description = \"N·V\", .label = \"N·V\"},\n")
