// SPDX-License-Identifier: Apache-2.0
// What the numbers of a log mean: rows, units, signs.
#include <algorithm>
#include <cstdlib>
#include <optional>

#include "diagnose/infer_labels.h"
#include "diagnose/observe.h"

namespace glint {
namespace {

struct Score {
    std::size_t agree = 0, all = 0;
};

// How many values of these quantities are as they should be, by the present rules.
Score score(const LogModel& model, std::initializer_list<Quantity> quantities) {
    Score result;
    for_each_place(model, [&](const ObservedPlace& place) {
        if (std::find(quantities.begin(), quantities.end(), place.quantity) == quantities.end()) return true;
        const Maybe yours = logged_at(model, place), expected = expected_at(model, place, {});
        if (!yours || !expected) return true;
        ++result.all;
        if (is_same(place.quantity, *yours, *expected)) ++result.agree;
        return result.all < k_most_places;
    });
    return result;
}

// How far the camera rays of the log are from those of the explanations, in pixels that are not near the
// middle row, where both ways of counting are nearly the same. Nothing: the log does not have them.
std::optional<double> distance_of_rays(const LogModel& model) {
    const bool is_parallel = model.scene.camera.projection == Projection::orthographic;
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t p = 0; p < model.log.pixels.size() && count < k_most_places; ++p) {
        const LoggedPixel& pixel = model.log.pixels[p];
        const PixelReference& reference = model.references[p];
        if (!reference.explanation || std::abs(2 * pixel.y - (model.scene.settings.height - 1)) < 8) continue;
        for (std::size_t r = 0; r < pixel.rays.size(); ++r) {
            if (pixel.rays[r].parent >= 0 || reference.ray[r] < 0) continue;
            const ExplainedRay& ray = reference.explanation->rays[static_cast<std::size_t>(reference.ray[r])];
            const auto logged = pixel.rays[r].vector(is_parallel ? Quantity::origin : Quantity::direction);
            if (!logged || !is_finite(*logged)) continue;
            sum += is_parallel ? length(*logged - ApproxVec(ray.origin)).v
                               : length(unit(*logged) - unit(ApproxVec(ray.direction))).v;
            ++count;
        }
    }
    return count > 0 ? std::optional(sum) : std::nullopt;
}

// Pixels whose camera ray hits the point, or that have the bytes, of the explanation. Not those that are
// black.
std::size_t count_near(const LogModel& model) {
    std::size_t near = 0;
    for (std::size_t p = 0; p < std::min(model.log.pixels.size(), k_most_places); ++p) {
        const LoggedPixel& pixel = model.log.pixels[p];
        const PixelReference& reference = model.references[p];
        if (!reference.explanation) continue;
        const float* v = reference.explanation->value;
        const ApproxVec own(Color{255.0 * v[0], 255.0 * v[1], 255.0 * v[2]});
        if (const auto bytes = pixel.vector(Quantity::bytes);
            bytes && length(own).v > 12 && length(*bytes - own).v < 6)
            ++near;
        for (std::size_t r = 0; r < pixel.rays.size(); ++r) {
            if (pixel.rays[r].parent >= 0 || reference.ray[r] < 0) continue;
            const ExplainedRay& ray = reference.explanation->rays[static_cast<std::size_t>(reference.ray[r])];
            const auto point = pixel.rays[r].vector(Quantity::point);
            if (point && ray.hit &&
                length(*point - ApproxVec(ray.hit->point)).v < 1e-3 * (1 + length(*point).v))
                ++near;
        }
    }
    return near;
}

void infer_rows(LogModel& model, int threads) {
    if (model.log.rows_from_bottom) return;
    const std::optional<double> distance = distance_of_rays(model);
    const std::size_t near = count_near(model);
    const auto turn = [&] {
        model.rules.rows_from_bottom = !model.rules.rows_from_bottom;
        model.explain_pixels(threads);
    };
    turn();
    const std::optional<double> turned = distance_of_rays(model);
    const bool is_turned = distance && turned ? *turned < 0.5 * *distance
                                              : count_near(model) > near + model.log.pixels.size() / 10 + 1;
    if (!is_turned) turn();
}

void infer_unit_of_t(LogModel& model) {
    const Score as_it_is = score(model, {Quantity::t, Quantity::point});
    model.rules.has_unit_t = true;
    const Score other = score(model, {Quantity::t, Quantity::point});
    model.rules.has_unit_t = other.agree > as_it_is.agree;
}

// Whether the log's own products of two vectors have the sign that they have without a turn, where it has
// both.
int sign_of_products(const LogModel& model, Quantity turned, Quantity other, Quantity product) {
    int as_it_is = 0, reversed = 0;
    for (const LoggedPixel& pixel : model.log.pixels)
        for (const LoggedRay& ray : pixel.rays)
            for (const LoggedLight& light : ray.lights) {
                const auto find = [&](Quantity q) {
                    return info_of(q).of == QuantityOf::light ? light.vector(q) : ray.vector(q);
                };
                const auto a = find(turned), b = find(other), c = find(product);
                if (!a || !b || !c || std::fabs(c->x.v) < 1e-2) continue;
                const Approx cosine = dot(unit(*a), unit(*b));
                if (agree(c->x, cosine, 1e-3)) ++as_it_is;
                if (agree(c->x, -cosine, 1e-3)) ++reversed;
            }
    if (as_it_is + reversed < 3) return 0;
    return 10 * as_it_is >= 9 * (as_it_is + reversed)   ? 1
           : 10 * reversed >= 9 * (as_it_is + reversed) ? -1
                                                        : 0;
}

// N may be logged before it is turned towards the ray: N.L shows which N is used.
void infer_turned_normals(LogModel& model) {
    int turned = 0, as_it_is = 0;
    for_each_place(model, [&](const ObservedPlace& place) {
        if (place.quantity != Quantity::n_l) return true;
        const RayModel ray(model, place.pixel, place.ray);
        const Maybe n = ray.logged(Quantity::normal), expected = ray.expected(Quantity::normal),
                    l = ray.used_light(place.light), n_l = ray.logged(Quantity::n_l, place.light);
        if (!n || !expected || !l || !n_l || n_l->x.v == 0 || !is_same(Quantity::normal, -*n, *expected))
            return true;
        const Approx own = dot(unit(*n), unit(*l));
        if (std::fabs(own.v) < 1e-3) return true;
        if (agree(n_l->x, own, 1e-5)) ++as_it_is;
        if (agree(n_l->x, -own, 1e-5)) ++turned;
        return turned + as_it_is < 400;
    });
    model.rules.turns_normals = turned > as_it_is;
}

// A sign is a convention if what follows is computed as if it were not reversed, or if nothing follows.
void infer_sign(LogModel& model, double& sign, Quantity quantity, std::initializer_list<Quantity> after) {
    const Score as_it_is = score(model, {quantity});
    if (as_it_is.all < 3 || 2 * as_it_is.agree > as_it_is.all) return;
    const Score then = score(model, after);
    const double before = sign;
    sign = -before;
    const Score reversed = score(model, {quantity}), then_reversed = score(model, after);
    const bool is_reversed = reversed.agree * 10 >= reversed.all * 9;
    if (!is_reversed || then_reversed.agree < then.agree ||
        (then_reversed.all > 0 && then_reversed.agree == then.agree && then.agree == 0))
        sign = before;
}

void infer_white(LogModel& model) {
    const auto& declared = model.log.white;
    std::vector<Quantity> undecided;
    std::size_t to_255 = 0, to_1 = 0;  // quantities
    for (int i = 0; i < k_quantities; ++i) {
        const auto quantity = static_cast<Quantity>(i);
        if (info_of(quantity).kind != QuantityKind::color || quantity == Quantity::bytes ||
            quantity == Quantity::weight)
            continue;
        double& white = model.rules.white[static_cast<std::size_t>(i)];
        if (declared) {
            white = *declared;
            continue;
        }
        std::vector<double> values;
        const auto add = [&](const LoggedValues& of) {
            if (const LoggedValue* value = of.find(quantity)) {
                const Vec3 v = value->value.value();
                const double most = std::max({v.x, v.y, v.z});
                if (most > 0 && std::isfinite(most)) values.push_back(most);
            }
        };
        for (const LoggedPixel& pixel : model.log.pixels) {
            add(pixel);
            for (const LoggedRay& ray : pixel.rays) {
                add(ray);
                for (const LoggedLight& light : ray.lights) add(light);
            }
            if (values.size() > 4 * k_most_places) break;
        }
        if (values.empty()) continue;
        const auto large = std::count_if(values.begin(), values.end(), [](double v) { return v > 3; });
        const Score as_it_is = score(model, {quantity});
        if (as_it_is.agree == as_it_is.all) {
            if (as_it_is.agree > 0) ++to_1;
            continue;
        }
        white = 255;
        const Score scaled = score(model, {quantity});
        const bool is_mostly_large = 2 * static_cast<std::size_t>(large) > values.size();
        if (scaled.agree == 0 && as_it_is.agree == 0) undecided.push_back(quantity);
        if (scaled.agree < as_it_is.agree || (scaled.agree == as_it_is.agree && !is_mostly_large)) white = 1;
        if (scaled.agree != as_it_is.agree) ++(white == 255 ? to_255 : to_1);
    }
    // A quantity that is wrong by either scale has that of the others.
    if (to_255 == to_1) return;
    for (const Quantity quantity : undecided)
        model.rules.white[static_cast<std::size_t>(quantity)] = to_255 > to_1 ? 255 : 1;
}

}  // namespace

void infer_rules(LogModel& model, int threads) {
    model.rules.shape_of.assign(model.log.shape_labels.size(), k_none);
    model.rules.light_of.assign(model.log.light_labels.size(), k_none);
    infer_rows(model, threads);
    infer_shapes(model);
    infer_unit_of_t(model);
    infer_lights(model);
    // L reversed, and N.L nevertheless right, and so on.
    if (sign_of_products(model, Quantity::to_light, Quantity::normal, Quantity::n_l) < 0) {
        // Or N is reversed.
        const Score right = score(model, {Quantity::to_light});
        if (2 * right.agree < right.all) model.rules.light_sign = -1;
    }
    infer_turned_normals(model);
    if (sign_of_products(model, Quantity::reflected, Quantity::view, Quantity::r_v) < 0) {
        const Score right = score(model, {Quantity::view});
        (2 * right.agree >= right.all ? model.rules.reflected_sign : model.rules.view_sign) = -1;
    }
    infer_sign(model, model.rules.view_sign, Quantity::view, {Quantity::r_v, Quantity::n_h});
    infer_sign(model, model.rules.light_sign, Quantity::to_light, {Quantity::n_l, Quantity::diffuse});
    infer_sign(model, model.rules.reflected_sign, Quantity::reflected, {Quantity::r_v, Quantity::power});
    infer_white(model);
    const Score relative = score(model, {Quantity::weight});
    if (relative.agree < relative.all) {
        model.rules.weight_is_product = true;
        const Score product = score(model, {Quantity::weight});
        model.rules.weight_is_product = product.agree > relative.agree;
    }
}

}  // namespace glint
