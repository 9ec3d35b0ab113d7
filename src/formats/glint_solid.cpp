// SPDX-License-Identifier: Apache-2.0
#include "formats/glint_solid.h"

#include <fmt/format.h>

#include <utility>

namespace glint {
namespace {

// The parts have no names and places of their own.
void forget_texts_from(ItemTexts& texts, std::size_t first) {
    if (texts.places.size() > first) texts.places.resize(first);
    while (!texts.names.empty() && (texts.names.end() - 1)->first >= first)
        texts.names.erase((texts.names.end() - 1)->first);
}

}  // namespace

void close_glint_solid(GlintText& t, const Token& word, GlintSolid& solid, const GlintItem& item) {
    Scene& scene = t.scene;
    const std::size_t first = solid.first_shape, count = scene.shapes.size() - first;
    if (count == 0) {
        // After an error, the shape may be what was not read.
        if (!t.reading.diagnostics.any_errors())
            t.p.error(word, fmt::format("expected a shape in the block {}", quoted(t.p.text(word))));
        return;
    }
    if (solid.operation == SolidOperation::inverse && count > 1) {
        t.p.error(word, fmt::format("expected one shape in the block `inverse`, found {}", count));
        return;
    }
    for (std::size_t i = first; i < scene.shape_colors.size(); ++i) {
        if (!scene.shape_colors[i].is_set()) continue;
        t.p.error(word, "a shape in a solid has no `shape_color`: write `color`, or give it to the solid");
        return;
    }
    GlintContext own = solid.around;
    if (const auto map = compose_maps(std::nullopt, item.map))
        own = {k_none, k_none, compose_maps(solid.around.map, map)};
    const std::uint32_t transform = transform_index(scene, own);
    const std::uint32_t base = item.material != k_none ? item.material : solid.around.material;
    const std::uint32_t material = t.materials.changed(t, word, base, item.keys, true);
    forget_texts_from(scene.shape_texts, first);
    const std::uint32_t index =
        combine_last(scene, solid.operation, static_cast<std::uint32_t>(first), material, transform);
    scene.set_shape_color(index, solid.color);
    note(scene.shape_texts, index, source_place(t.text, word), std::move(solid.name));
}

}  // namespace glint
