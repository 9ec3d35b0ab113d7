// SPDX-License-Identifier: Apache-2.0
// Lights to those of the Scene.
#include <algorithm>

#include "formats/povray/scene_builder.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::povray {

void SceneBuilder::place_light(const Object& object, const Inherited& own) {
    const LightSource& source = *object.light;
    report(source.missing);
    Light light = source.light;
    Vec3 point_at = source.point_at;
    if (own.map) {
        light.position = transform_point(*own.map, light.position);
        point_at = transform_point(*own.map, point_at);
    }
    // Lights without shadows give no highlights (POV-Ray, measured).
    if (!light.casts_shadows) light.specular_color = {0, 0, 0};
    const Vec3 axis = point_at - light.position;
    const bool has_axis = !(axis == Vec3{0, 0, 0});
    if (source.is_parallel) {
        if (light.is_spot()) report({"spotlight", "that is parallel", stream_.call_place(object.at)});
        light.kind = LightKind::directional;
        light.to_light = has_axis ? -axis : Vec3{0, 0, -1};
        if (light.fade_distance > 0 && light.fade_power > 0)
            report({"fade_distance", "of a parallel light", stream_.call_place(object.at)});
        light.fade_distance = light.fade_power = 0;
        if (light.casts_shadows) {
            parallel_lights_.push_back(
                {light.position, normalize(light.to_light), stream_.call_place(object.at)});
        }
    } else if (light.is_spot()) {
        light.axis = has_axis ? axis : Vec3{0, 0, 1};
        // POV-Ray takes the cosines of both.
        light.inner_angle = std::min(number::abs(light.inner_angle), 180.0);
        // A radius beyond the falloff counts.
        light.outer_angle =
            std::clamp(number::abs(light.outer_angle), std::max(light.inner_angle, 1e-6), 180.0);
    }
    if (source.media_attenuation) media_attenuation_ = source.media_attenuation;
    if (source.is_area) {
        if (light.has_position()) {
            const LightKind kind = light.kind;
            light.cone = light.is_spot();
            light.kind = LightKind::parallelogram;
            if (own.map) {
                light.side_u = transform_vector(*own.map, light.side_u);
                light.side_v = transform_vector(*own.map, light.side_v);
            }
            // A side with one sample has no length in POV-Ray.
            if (light.samples_u == 1 && light.samples_v == 1) light.kind = kind;
            if (light.is_area() && light.jitter && light.casts_shadows)
                jittered_.push_back({scene_.lights.size(), stream_.call_place(object.at)});
        } else {
            report({"area_light", "of a parallel light", stream_.call_place(object.at)});
        }
    }
    light.fade_distance = std::max(light.fade_distance, 0.0);
    light.fade_power = std::max(light.fade_power, 0.0);
    note(scene_.light_texts, scene_.lights.size(), stream_.place_of(stream_.call_place(object.at)));
    scene_.lights.push_back(light);
    place_look(object, own);
}

// looks_like.
void SceneBuilder::place_look(const Object& object, const Inherited& own) {
    if (!object.parts) return;
    Inherited look = own;
    const Affine to_light = translation(object.light->light.position);
    const Affine map = own.map ? compose(*own.map, to_light) : to_light;
    look.map = &map;
    for (const ObjectPart& part : *object.parts) place(*part, look);
}

}  // namespace glint::povray
