// SPDX-License-Identifier: Apache-2.0
// image_map: a picture as a pigment.
#include <fmt/format.h>

#include "formats/povray/texture_parser.h"
#include "formats/texture_file.h"
#include "math/transform.h"

namespace glint::povray {

// Moves the pigment's image. With `uv_mapping`, only transforms in the block that has it apply, to u and v:
// the callers leave out the others.
void TextureParser::transform_image(Pigment& pigment, const std::optional<Affine>& step) {
    if (step && pigment.under) {
        auto under = make_counted<Pigment>(*pigment.under);
        transform_image(*under, step);
        pigment.under = std::move(under);
        pigment.image_number = ++images_;
    }
    if (!step || !(pigment.image || pigment.pattern)) return;
    pigment.map = pigment.map ? compose(*step, *pigment.map) : *step;
    if (pigment.image) pigment.image_number = ++images_;
}

// { items }, after `image_map`
void TextureParser::read_image_map(Pigment& pigment, const Token& at) {
    ImageItems items;
    pigment.pattern = nullptr;
    pigment.under = nullptr;
    if (!expect('{')) return;
    while (!failed() && !accept('}')) {
        if (!accept(',')) read_image_item(at, items);
    }
    if (failed()) return;
    const auto refuse = [&](const Missing& why) {
        pigment.image = nullptr;
        pigment.missing = why;
    };
    if (items.missing && items.missing->name == "image_map") return refuse(*items.missing);
    if (items.name.empty()) return error(at, "expected the name of a picture's file in `image_map`");
    glint::Texture texture;
    texture.image = open_image(items, texture);
    if (!texture.image) return refuse({"image_map", "without its picture", call_place(at)});
    texture.mapping = items.map_type == 1   ? TextureMapping::spherical
                      : items.map_type == 2 ? TextureMapping::cylindrical
                                            : TextureMapping::planar;
    texture.filter = items.interpolate == 0   ? TextureFilter::nearest
                     : items.interpolate == 4 ? TextureFilter::distance
                                              : TextureFilter::bilinear;
    if (items.is_once) texture.wrap_u = texture.wrap_v = TextureWrap::clip;
    if (!items.missing && texture.image->has_alpha && (items.filter != 0 || items.transmit != 0))
        items.missing = {"filter, transmit", "of a picture with alpha", call_place(at)};
    pigment.color = {1, 1, 1, items.filter, items.transmit};
    pigment.missing = items.missing;
    pigment.gradient = nullptr;
    pigment.image = make_counted<const glint::Texture>(std::move(texture));
    pigment.map.reset();
    pigment.image_number = ++images_;
}

void TextureParser::read_image_item(const Token& at, ImageItems& items) {
    const Token item = peek();
    if (begins_string(item)) {
        items.name_at = item;
        items.name = std::string(*string());
        return;
    }
    const auto is_refused = [&](std::string_view name, std::string_view why) {
        items.missing = {name, why, call_place(at)};
    };
    const auto read_all = [&](double& to) {  // all NUMBER, or INDEX NUMBER of a palette
        const bool is_all = peek().kind == TokenKind::word && text_of(peek()) == "all";
        if (is_all) {
            take();
        } else {
            number();
            accept(',');
            is_refused("filter, transmit", "of one color of a palette");
        }
        const double value = number();
        if (is_all) to = value;
    };
    if (accept(Word::k_filter)) return read_all(items.filter);
    if (accept(Word::k_transmit)) return read_all(items.transmit);
    if (item.kind != TokenKind::word) {
        is_refused("image_map", "of an old kind");
        return skip_rest_of_block();
    }
    const std::string_view word = text_of(take());
    if (word == "gamma") {
        ImageCurve curve;
        curve.is_srgb = accept(Word::k_srgb);
        const Token number_at = peek();
        if (!curve.is_srgb) curve.power = number();
        if (!failed() && !(curve.power >= 0.01 && curve.power <= 100))
            error(number_at, "expected a gamma from 0.01 to 100");
        items.curve = curve;
    } else if (word == "map_type") {
        const double type = number();
        items.map_type = type == 1 || type == 2 ? static_cast<int>(type) : 0;
        if (type != items.map_type) is_refused("image_map", "of this map_type");
    } else if (word == "interpolate") {
        const double method = number();
        items.interpolate = method == 0 ? 0 : method == 4 ? 4 : 2;
        if (method != items.interpolate) is_refused("interpolate", "other than 2 and 4: it is drawn as 2");
    } else if (word == "once") {
        items.is_once = true;
    } else if (word == "premultiplied") {
        if (flag()) is_refused("premultiplied", "alpha");
    } else if (word == "function" || word == "pattern") {
        is_refused("image_map", "of a function");
        skip_rest_of_block();
    }
    // Other words are the types of files, which say it themselves, `use_color` and the like.
}

// The picture, with what its words are. Null, with a warning, without one.
std::shared_ptr<const TextureImage> TextureParser::open_image(const ImageItems& items,
                                                              glint::Texture& texture) {
    LoadState& state = reading();
    const Token at = call_place(items.name_at);
    const ReadText from{state.texts[at.text], at.text, true};
    glint::Token place;
    place.offset = at.offset, place.length = text_of(at).size();
    auto image = texture_image_of_file(state, from, place, items.name, texture.file,
                                       "the surfaces have the color of the pigment without it");
    if (!image) return nullptr;
    const bool is_new = version_.value_or(0) >= 3.7;
    const ImageCurve of_scene{is_gamma_srgb_, is_gamma_srgb_ ? 1 : gamma_.value_or(1)};
    std::optional<ImageCurve> of_file = items.curve;
    if (!of_file && (is_new || gamma_)) {
        for (std::size_t i = 0; i < state.scene.files.size() && !of_file; ++i)
            if (state.scene.files[i] == texture.file) of_file = png_curve(state.texts[i].text);
    }
    if (!of_file) of_file = is_new ? ImageCurve{true, 1} : of_scene;
    texture.encoding = TextureEncoding::linear;
    if (*of_file == of_scene) return image;
    if (of_scene == ImageCurve{} && of_file->is_srgb) {
        texture.encoding = TextureEncoding::srgb;
        return image;
    }
    texture.file.clear();
    for (const GradedImage& known : graded_) {
        if (known.from == image && known.of_file == *of_file && known.of_scene == of_scene) return known.to;
    }
    const std::uint64_t bytes = std::uint64_t{image->width} * image->height * image->channels() * 2;
    if (!has_room(bytes, items.name_at)) return nullptr;
    state.memory.add(bytes);
    auto made = std::make_shared<const TextureImage>(with_curve(*image, *of_file, of_scene));
    graded_.push_back({image, made, *of_file, of_scene});
    return made;
}

}  // namespace glint::povray
