// SPDX-License-Identifier: Apache-2.0
// `average`: the mean of pigments, by weights. It is drawn as layers, of which the k-th lets as much of those
// below be seen as their weights are of the sum up to it.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/texture_parser.h"
#include "glint/texture.h"

namespace glint::povray {
namespace {

constexpr std::size_t k_max_pigments = 256;  // POV-Ray's limit

bool is_picture(const WeightedPigment& part) {
    return part.pigment.under || (part.pigment.image && part.pigment.image->image);
}

}  // namespace

// transforms and pigment_map { [weight pigment] ... }, after the word
void TextureParser::read_average(Pigment& pigment, std::optional<Affine>& map) {
    CountedVector<WeightedPigment> parts;
    bool is_known = true;
    while (!failed() && !peek().is('}') && !peek().is(']')) {
        if (read_transform_item(map)) continue;
        const Token item = take();
        if (item.kind != TokenKind::word || text_of(item) != "pigment_map" || !peek().is('{')) {
            is_known = false;
            skip_rest();
            break;
        }
        expect('{');
        while (!failed() && !accept('}')) {
            const Token at = peek();
            if (!at.is('[')) {  // a named map
                is_known = false;
                skip_rest();
                expect('}');
                break;
            }
            take();
            WeightedPigment part{1, default_texture().pigment};
            if (peek().word() != Word::k_function) part.weight = number();  // POV-Ray has it without a weight
            accept(',');
            read_pigment_items(part.pigment, ']');
            accept(',');
            parts.push_back(std::move(part));
            if (parts.size() > k_max_pigments)
                error(at, fmt::format("expected at most {} pigments", k_max_pigments));
        }
    }
    if (!failed() && is_known) average(pigment, parts);
}

// The pigment stays `missing` if it cannot be drawn.
void TextureParser::average(Pigment& pigment, const CountedVector<WeightedPigment>& all) {
    CountedVector<WeightedPigment> parts;
    std::copy_if(all.begin(), all.end(), std::back_inserter(parts),
                 [](const WeightedPigment& part) { return part.weight != 0; });
    // A picture has its own opacity: it can only be the lowest.
    std::stable_partition(parts.begin(), parts.end(), is_picture);
    const bool is_drawn =
        !parts.empty() && std::count_if(parts.begin(), parts.end(), is_picture) <= 1 &&
        std::all_of(parts.begin(), parts.end(), [](const WeightedPigment& part) {
            const auto& missing = part.pigment.missing;
            return part.weight > 0 && lets_nothing_through(part.pigment) && (!missing || part.pigment.image);
        });
    if (!is_drawn) return;
    pigment = parts.front().pigment;
    std::optional<Missing> missing = pigment.missing;
    double sum = parts.front().weight;
    for (std::size_t k = 1; k < parts.size(); ++k) {
        Pigment top = parts[k].pigment;
        if (top.missing) missing = top.missing;
        sum += parts[k].weight;
        const double share = parts[k].weight / sum;
        if (!top.image && !pigment.image && !pigment.under) {
            for (std::size_t c = 0; c < 3; ++c) pigment.color[c] += (top.color[c] - pigment.color[c]) * share;
            continue;
        }
        if (top.image) {
            auto image = make_counted<glint::Texture>(*top.image);
            for (TextureColor& entry : image->color_map) entry.alpha *= share;
            top.image = std::move(image);
        } else {
            top.color[4] = 1 - share;
        }
        top.pattern = nullptr;
        top.under = make_counted<const Pigment>(std::move(pigment));
        top.image_number = ++images_;
        pigment = std::move(top);
    }
    pigment.gradient = nullptr;
    pigment.missing = missing;
}

}  // namespace glint::povray
