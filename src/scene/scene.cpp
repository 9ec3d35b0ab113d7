// SPDX-License-Identifier: Apache-2.0
#include "glint/scene.h"

#include "scene/texture_fields.h"

namespace glint {

std::string_view ItemTexts::name(std::uint32_t index) const {
    const auto at = names.find(index);
    return at == names.end() ? std::string_view() : std::string_view(at->second);
}

SourcePlace ItemTexts::place(std::uint32_t index) const {
    return index < places.size() ? places[index] : SourcePlace{};
}

std::string_view to_string(ShapeKind kind) {
    switch (kind) {
#define GLINT_KIND(Type, word) \
    case ShapeKind::word:      \
        return #word;
        GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
    }
    return "unknown shape";
}

std::string_view to_string(SolidOperation operation) {
    switch (operation) {
        case SolidOperation::operand:
            return "operand";
        case SolidOperation::merge:
            return "merge";
        case SolidOperation::unite:
            return "union";
        case SolidOperation::intersection:
            return "intersection";
        case SolidOperation::difference:
            return "difference";
        case SolidOperation::inverse:
            return "inverse";
        case SolidOperation::clip:
            return "clip";
    }
    return "unknown operation";
}

std::string_view to_string(LightKind kind) {
    switch (kind) {
        case LightKind::ambient:
            return "ambient";
        case LightKind::point:
            return "point";
        case LightKind::directional:
            return "directional";
        case LightKind::spot:
            return "spot";
        case LightKind::parallelogram:
            return "parallelogram";
        case LightKind::disc:
            return "disc";
        case LightKind::sphere:
            return "sphere";
    }
    return "unknown light";
}

std::string_view to_string(FogKind kind) {
    switch (kind) {
        case FogKind::linear:
            return "linear";
        case FogKind::exp:
            return "exp";
        case FogKind::exp2:
            return "exp2";
    }
    return "unknown fog";
}

std::string_view to_string(OcclusionMethod method) {
    switch (method) {
        case OcclusionMethod::hashed:
            return "hashed";
        case OcclusionMethod::fixed:
            return "fixed";
    }
    return "unknown method";
}

namespace {

template <class Choice, std::size_t n>
std::string_view word_of(Choice choice, const std::string_view (&words)[n]) {
    const auto number = static_cast<std::size_t>(choice);
    return number < n ? words[number] : "unknown";
}

}  // namespace

std::string_view to_string(TextureWrap wrap) { return word_of(wrap, k_wrap_words); }
std::string_view to_string(TextureFilter filter) { return word_of(filter, k_filter_words); }
std::string_view to_string(TextureMix mix) { return word_of(mix, k_mix_words); }
std::string_view to_string(TextureEncoding encoding) { return word_of(encoding, k_encoding_words); }
std::string_view to_string(TextureAlpha alpha) { return word_of(alpha, k_alpha_words); }
std::string_view to_string(TextureMapping mapping) { return word_of(mapping, k_mapping_words); }

std::string_view to_string(GradientKind kind) {
    switch (kind) {
        case GradientKind::sphere:
            return "sphere";
        case GradientKind::plane:
            return "plane";
    }
    return "unknown gradient";
}

}  // namespace glint
