// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/colors.h"

#include "math/elementary.h"
#include "math/number.h"
#include "math/srgb.h"

namespace glint::gltf_export {

double greatest(Color color) { return number::max(color.r, number::max(color.g, color.b)); }

double ColorRule::linear(double channel) const {
    const double corrected = rule_.gamma == 1 ? channel : pow(channel, rule_.gamma);
    return rule_.transfer == Transfer::srgb ? corrected : srgb_decode(corrected);
}

Color ColorRule::linear(Color color) const {
    if (keeps_colors()) return color;
    const double size = number::max(greatest(color), 1.0);
    return Color{linear(color.r / size), linear(color.g / size), linear(color.b / size)} * size;
}

Material ColorRule::linear(Material material) const {
    for (Color Material::*const member :
         {&Material::color, &Material::ambient, &Material::diffuse, &Material::specular, &Material::emission,
          &Material::mirror_tint, &Material::transmission_tint})
        material.*member = linear(material.*member);
    return material;
}

}  // namespace glint::gltf_export
