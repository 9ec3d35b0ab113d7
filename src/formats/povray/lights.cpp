// SPDX-License-Identifier: Apache-2.0
// light_source.
#include <fmt/format.h>
#include <algorithm>
#include "formats/povray/object_parser.h"

namespace glint::povray {

Object ObjectParser::read_light(const Token& word) {
    Object object;
    object.kind = ObjectKind::light;
    object.at = word;
    auto held = make_counted<LightSource>();
    LightSource& source = *held;
    source.light.inner_angle = 30;
    source.light.outer_angle = 45;
    if (!expect('{')) return object;
    if (const Token name = peek(); begins_object(name) && !Names::is_reserved(name.name)) {
        const ObjectPart declared = object_of(take());  // another light, to be changed
        if (!failed() && declared->kind != ObjectKind::light) {
            error(name, fmt::format("expected a light, found {}", describe(name)));
        }
        if (failed()) return object;
        *held = *declared->light;
        object = *declared;
    } else {
        source.light.position = vector();
        accept(',');
        const std::array<double, 5> c = color(true);
        source.light.color = source.light.specular_color = {c[0], c[1], c[2]};
    }
    while (!failed() && !accept('}')) {
        if (accept(',') || read_transform_item(object.map)) continue;
        const Token item = take();
        switch (item.word()) {
            case Word::k_spotlight:
                source.light.kind = LightKind::spot;
                break;
            case Word::k_parallel:
                source.is_parallel = true;
                break;
            case Word::k_point_at:
                source.point_at = vector();
                break;
            case Word::k_radius:
                source.light.inner_angle = number();
                break;
            case Word::k_falloff:
                source.light.outer_angle = number();
                break;
            case Word::k_tightness:
                source.light.tightness = number();
                break;
            case Word::k_fade_distance:
                source.light.fade_distance = number();
                break;
            case Word::k_fade_power:
                source.light.fade_power = number();
                break;
            case Word::k_shadowless:
                source.light.casts_shadows = !flag();
                break;
            case Word::k_photons:
                skip_block();
                break;
            case Word::k_media_attenuation:
                if (flag()) source.media_attenuation = call_place(item);
                break;
            case Word::k_media_interaction:
                flag();
                break;
            case Word::k_area_light:
                source.is_area = true;
                source.light.side_u = vector();
                accept(',');
                source.light.side_v = vector();
                accept(',');
                source.light.samples_u = sample_count();
                accept(',');
                source.light.samples_v = sample_count();
                break;
            case Word::k_adaptive:
                source.light.adaptive =
                    static_cast<std::int32_t>(std::clamp(number(), 0.0, 1.0 * k_all_levels));
                break;
            case Word::k_jitter:
                source.light.jitter = true;
                break;
            case Word::k_circular:
                source.light.circular = true;
                break;
            case Word::k_orient:  // circular, too (measured)
                source.light.circular = source.light.oriented = true;
                break;
            case Word::k_area_illumination:
                if (flag()) source.missing.add(missing(item, "area_illumination"));
                break;
            case Word::k_cylinder:
                source.missing.add({"cylinder", "a kind of light", call_place(item), true});
                break;
            case Word::k_looks_like:
                read_looks_like(object);
                break;
            case Word::k_projected_through:
                source.missing.add(missing(item, "projected_through"));
                skip_block();
                break;
            default: {
                const bool is_color = begins_color(item) && item.word() != Word::k_filter;
                if (!is_color) {
                    error(item, fmt::format("expected an item of a light or `}}`, found {}{}", describe(item),
                                            what_is(item)));
                }
            }
        }
    }
    object.light = std::move(held);
    return object;
}

// The number of samples along a side of an area light.
std::int32_t ObjectParser::sample_count() {
    const Token at = peek();
    const double count = number();
    if (!failed() && !(count >= 1 && count <= k_max_light_samples)) {
        error(at, fmt::format("expected a number of samples from 1 to {}", k_max_light_samples));
    }
    return failed() ? 1 : static_cast<std::int32_t>(count);
}

// { object }: moved to the light; it casts no shadow.
void ObjectParser::read_looks_like(Object& light) {
    if (!expect('{')) return;
    if (!begins_object(peek())) return expected("an object");
    Object look = read_object();
    read_modifiers(look);
    look.is_no_shadow = true;
    light.count = 1 + look.count;
    light.parts =
        make_counted<const CountedVector<ObjectPart>>(1, make_counted<const Object>(std::move(look)));
}

}  // namespace glint::povray
