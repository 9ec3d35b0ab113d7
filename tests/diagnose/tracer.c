// SPDX-License-Identifier: Apache-2.0
// A whole ray tracer for tests of `glint diagnose`, in single precision: the scene of room.glint, written by hand.
//     cc -std=c99 -O1 -o tracer tracer.c -lm && MISTAKE=half-not-unit GLINT_PIXELS=80,100 ./tracer 240 180 > picture.ppm
// MISTAKE: one of mistakes.json; without it, the picture is right. --list prints all that this tracer has.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../examples/trace_log/glint_log.h"

static const char* g_mistake = "";
#define WRONG(name) (*g_mistake != 0 && strcmp(g_mistake, name) == 0)

typedef struct { float x, y, z; } Vec;  // a point, a direction, or a color

static Vec vec(float x, float y, float z) { return (Vec){x, y, z}; }
static Vec add(Vec a, Vec b) { return vec(a.x + b.x, a.y + b.y, a.z + b.z); }
static Vec sub(Vec a, Vec b) { return vec(a.x - b.x, a.y - b.y, a.z - b.z); }
static Vec mul(Vec a, float f) { return vec(a.x * f, a.y * f, a.z * f); }
static Vec tint(Vec a, Vec b) { return vec(a.x * b.x, a.y * b.y, a.z * b.z); }
static float dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static Vec cross(Vec a, Vec b) { return vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x); }
static float length(Vec a) { return sqrtf(dot(a, a)); }
static Vec unit(Vec a) { return mul(a, 1 / length(a)); }
static void log_vector(const char* key, Vec v) { glint_vector(key, v.x, v.y, v.z); }

static const float k_pi = 3.14159265f, k_epsilon = 0.001f;
static const Vec k_white = {1, 1, 1}, k_background = {0.1f, 0.15f, 0.25f}, k_ambient_light = {0.3f, 0.3f, 0.35f};
static const Vec k_eye = {0.5f, 1.6f, 5}, k_target = {0, 0.9f, 0}, k_up = {0, 1, 0};
enum { k_limit = 4 };

typedef enum { PLANE, SPHERE, TRIANGLE } Kind;
typedef struct {
    const char* name;
    Kind kind;
    Vec a, b, c;  // plane: point, normal; sphere: center; triangle: its corners
    float radius;
    Vec color;
    float ambient, diffuse, specular, shininess, mirror, transmission, ior;
    Vec transmission_color;
} Shape;

static const Shape k_shapes[] = {
    {"floor", PLANE, {0, 0, 0}, {0, 1, 0}, {0, 0, 0}, 0, {0.6f, 0.55f, 0.5f}, 0.5f, 0.9f, 0.2f, 20, 0.1f, 0, 1, {1, 1, 1}},
    {"wall", PLANE, {0, 0, -3}, {0, 0, 1}, {0, 0, 0}, 0, {0.5f, 0.6f, 0.5f}, 0.5f, 0.9f, 0, 32, 0, 0, 1, {1, 1, 1}},
    {"matte", SPHERE, {-1.6f, 0.7f, -0.6f}, {0, 0, 0}, {0, 0, 0}, 0.7f, {0.9f, 0.3f, 0.2f}, 0.5f, 0.8f, 0.5f, 25, 0, 0, 1, {1, 1, 1}},
    {"chrome", SPHERE, {1.5f, 0.8f, -1.2f}, {0, 0, 0}, {0, 0, 0}, 0.8f, {0.8f, 0.8f, 0.9f}, 0.3f, 0.3f, 0.9f, 100, 0.7f, 0, 1, {1, 1, 1}},
    {"glass", SPHERE, {0.3f, 0.55f, 1.2f}, {0, 0, 0}, {0, 0, 0}, 0.55f, {0.9f, 1, 0.95f}, 0.2f, 0.2f, 0.8f, 150, 0, 0.9f, 1.5f, {0.8f, 1, 0.9f}},
    {"bubble", SPHERE, {-0.9f, 0.35f, 1.6f}, {0, 0, 0}, {0, 0, 0}, 0.35f, {1, 1, 1}, 0.1f, 0.1f, 0.5f, 60, 0, 0.9f, 0.7f, {1, 1, 1}},
    {"sail", TRIANGLE, {-2.6f, 0.1f, -2.2f}, {-1.4f, 2.4f, -2.3f}, {-0.4f, 0.1f, -2.4f}, 0, {0.2f, 0.4f, 0.9f}, 0.4f, 0.8f, 0.6f, 10, 0, 0, 1, {1, 1, 1}},
};
enum { k_shape_count = sizeof(k_shapes) / sizeof(k_shapes[0]) };

typedef struct {
    const char* name;
    Vec position, color;
    float c0, c1, c2;
    int is_spot;
    Vec target;
    float inner_degrees, outer_degrees;
} Light;

static const Light k_lights[] = {
    {"left", {-3, 3.5f, 2.5f}, {0.9f, 0.8f, 0.7f}, 0.2f, 0.05f, 0.03f, 0, {0, 0, 0}, 0, 0},
    {"lamp", {1, 2.5f, -2}, {0.4f, 0.6f, 0.9f}, 1, 0, 0.1f, 0, {0, 0, 0}, 0, 0},
    {"spot", {0.5f, 4, 2}, {1.6f, 1.5f, 1.2f}, 1, 0, 0, 1, {0.2f, 0, -0.5f}, 15, 25},
};
enum { k_light_count = sizeof(k_lights) / sizeof(k_lights[0]) };

// The least t above t_min, or infinity.
static float hit_shape(const Shape* s, Vec origin, Vec direction, float t_min) {
    if (s->kind == PLANE) {
        const float t = dot(sub(s->a, origin), s->b) / dot(direction, s->b);
        return t > t_min ? t : INFINITY;
    }
    if (s->kind == SPHERE) {
        const Vec from_center = sub(origin, s->a);
        const float b = dot(from_center, direction), c = dot(from_center, from_center) - s->radius * s->radius;
        const float square = b * b - c;
        if (square < 0) return INFINITY;
        const float root = sqrtf(square);
        if (-b - root > t_min && !WRONG("far-root")) return -b - root;
        return -b + root > t_min && !WRONG("near-root-only") ? -b + root : INFINITY;
    }
    const Vec ab = sub(s->b, s->a), ac = sub(s->c, s->a), p = cross(direction, ac);
    const float determinant = dot(ab, p);
    const Vec from_a = sub(origin, s->a), q = cross(from_a, ab);
    const float u = dot(from_a, p) / determinant, v = dot(direction, q) / determinant, t = dot(ac, q) / determinant;
    if (u < 0 || v < 0) return INFINITY;
    if (u + v > 1 && !(WRONG("triangle-is-quadrilateral") && u <= 1 && v <= 1)) return INFINITY;
    return t > t_min ? t : INFINITY;
}

static const Shape* closest(Vec origin, Vec direction, float t_min, float* t) {
    const Shape* best = NULL;
    *t = INFINITY;
    for (int i = 0; i < k_shape_count; ++i) {
        const float here = hit_shape(&k_shapes[i], origin, direction, t_min);
        if (here == INFINITY || (WRONG("first-hit") && best != NULL)) continue;
        if (here < *t || WRONG("last-hit")) *t = here, best = &k_shapes[i];
    }
    return best;
}

static int is_blocked(Vec origin, Vec to_light, float t_min, float t_max) {
    for (int i = 0; i < k_shape_count; ++i) {
        if (hit_shape(&k_shapes[i], origin, to_light, t_min) < t_max) return 1;
    }
    return 0;
}

static float attenuation_of(const Light* light, float d) {
    if (WRONG("attenuation-missing")) return 1;
    const float squared = WRONG("distance-not-squared") ? d : WRONG("distance-fourth-power") ? d * d * d * d : d * d;
    const float f = 1 / (light->c0 + light->c1 * d + light->c2 * squared);
    if (WRONG("attenuation-inverted")) return light->c0 + light->c1 * d + light->c2 * squared;
    return f < 1 || WRONG("attenuation-not-clamped") ? f : 1;
}

static float spot_of(const Light* light, Vec l) {
    if (!light->is_spot || WRONG("spot-ignored")) return 1;
    const float scale = k_pi / 180 * (WRONG("spot-angle-halved") ? 0.5f : 1);
    const Vec axis = unit(WRONG("spot-target-is-axis") ? light->target : sub(light->target, light->position));
    const float cosine = -dot(axis, l), inner = cosf(light->inner_degrees * scale), outer = cosf(light->outer_degrees * scale);
    if (cosine >= inner) return 1;
    if (cosine <= outer) return 0;
    const float s = (cosine - outer) / (inner - outer);
    return WRONG("spot-hard-edge") ? 1 : s * s * (3 - 2 * s);
}

static Vec light_of(const Shape* s, Vec p, Vec n, Vec v, Vec direction) {
    const Vec ambient = tint(mul(s->color, s->ambient), WRONG("ambient-missing") ? vec(0, 0, 0) : k_ambient_light);
    Vec sum = ambient;
    log_vector("ambient", ambient);
    for (int i = 0; i < k_light_count; ++i) {
        const Light* light = &k_lights[i];
        Vec to_light = sub(light->position, p), l = unit(to_light);
        if (WRONG("light-reversed")) l = mul(l, -1);
        if (WRONG("light-not-unit")) l = to_light;
        if (WRONG("light-position")) l = unit(light->position);
        if (WRONG("ambient-for-each-light")) sum = add(sum, ambient);
        const float d = length(to_light);
        float n_l = dot(n, l);
        if (WRONG("cosine-abs")) n_l = fabsf(n_l);
        Vec h = add(l, WRONG("half-from-direction") ? direction : v);
        if (!WRONG("half-not-unit")) h = unit(h);
        const float n_h = dot(n, h), exponent = s->shininess * (WRONG("exponent-times-4") ? 4 : 1);
        float power = 0;
        if (n_h > 0 && n_l > 0) power = powf(n_h, WRONG("exponent-missing") ? 1 : exponent);
        if (power > 0 && WRONG("exponent-as-factor")) power = exponent * n_h;
        const float attenuation = attenuation_of(light, d), spot = spot_of(light, l);
        const Vec start = WRONG("shadow-no-epsilon") ? p : add(p, mul(n, k_epsilon));
        const Vec from_start = sub(light->position, start);
        const float t_max = WRONG("shadow-without-limit") ? INFINITY : WRONG("shadow-within-one") ? 1 : length(from_start);
        int blocked = is_blocked(start, unit(from_start), 0, t_max);
        if (WRONG("no-shadows")) blocked = 0;
        if (WRONG("shadow-inverted")) blocked = !blocked;
        const float visible = blocked ? 0 : 1, factor = attenuation * spot;
        const float cosine = n_l > 0 || WRONG("cosine-not-clamped") ? n_l : 0;
        const Vec color = WRONG("light-color-missing") ? k_white : light->color;
        const Vec k_d = mul(WRONG("diffuse-color-missing") ? k_white : s->color, s->diffuse);
        const Vec diffuse = mul(tint(k_d, color), cosine * factor * visible);
        Vec specular = mul(tint(mul(s->color, s->specular), color), power * factor * (WRONG("specular-in-shadow") ? 1 : visible));
        if (WRONG("specular-times-cosine")) specular = mul(specular, cosine);
        sum = add(sum, add(diffuse, specular));
        glint_name("light", light->name);
        log_vector("L", l);
        glint_number("distance", d);
        glint_number("N.L", n_l);
        log_vector("H", h);
        glint_number("N.H", n_h);
        glint_number("power", power);
        glint_number("attenuation", attenuation);
        if (light->is_spot) glint_number("spot", spot);
        glint_ray("shadow");
        log_vector("origin", start);
        log_vector("direction", unit(from_start));
        glint_end();
        glint_flag("blocked", blocked);
        log_vector("diffuse", diffuse);
        log_vector("specular", specular);
    }
    if (WRONG("clamp-before-sum")) sum = vec(fminf(sum.x, 1), fminf(sum.y, 1), fminf(sum.z, 1));
    log_vector("local", sum);
    return sum;
}

static Vec reflected(Vec d, Vec n) {
    if (WRONG("mirror-direction-sign")) return sub(mul(n, 2 * dot(n, d)), d);
    if (WRONG("mirror-factor-2-missing")) return unit(sub(d, mul(n, dot(n, d))));
    return sub(d, mul(n, 2 * dot(n, d)));
}

static Vec trace(const char* kind, Vec origin, Vec direction, int depth, Vec weight);

// The light that glass and mirrors bring from other places.
static Vec secondary_light(const Shape* s, Vec p, Vec n, Vec d, int inside, int depth) {
    const float f = s->transmission;
    float mirror = (1 - f) * s->mirror;
    Vec sum = {0, 0, 0};
    if (WRONG("mirror-weight-missing") && mirror > 0) mirror = 1;
    if (f > 0) {
        const float cosine = -dot(n, d), r = (s->ior - 1) / (s->ior + 1), f0 = r * r;
        const float eta = (inside != 0) != WRONG("refraction-ratio-inverted") ? s->ior : 1 / s->ior;
        const float square = 1 - eta * eta * (1 - cosine * cosine);
        float fresnel = f0 + (1 - f0) * powf(1 - cosine, 5);
        if (WRONG("fresnel-missing")) fresnel = 0;
        if (square < 0 && !WRONG("total-reflection-ignored")) fresnel = 1;
        mirror += f * fresnel;
        const float through = f * (1 - fresnel);
        if (through > 0) {
            Vec t = sub(mul(add(d, mul(n, cosine)), eta), mul(n, sqrtf(square > 0 ? square : 0)));
            if (WRONG("refraction-normal-sign")) t = sub(mul(sub(d, mul(n, cosine)), eta), mul(n, sqrtf(square > 0 ? square : 0)));
            if (WRONG("refraction-straight")) t = d;
            const int untinted = inside && !WRONG("glass-tinted-twice");
            const Vec weight = mul(untinted || WRONG("glass-tint-missing") ? k_white : s->transmission_color, through);
            const float side = WRONG("glass-same-side") ? k_epsilon : WRONG("glass-no-epsilon") ? 0 : -k_epsilon;
            sum = add(sum, tint(trace("glass", add(p, mul(n, side)), unit(t), depth + 1, weight), weight));
        }
    }
    if (mirror > 0) {
        const Vec start = WRONG("mirror-no-epsilon") ? p : add(p, mul(n, k_epsilon));
        sum = add(sum, mul(trace("mirror", start, reflected(d, n), depth + 1, mul(k_white, mirror)), mirror));
    }
    return sum;
}

static Vec trace(const char* kind, Vec origin, Vec direction, int depth, Vec weight) {
    glint_ray(kind);
    log_vector("origin", origin);
    log_vector("direction", direction);
    if (depth > 0) log_vector("weight", weight);
    float t;
    const Shape* s = closest(origin, direction, WRONG("negative-t") ? -INFINITY : 0, &t);
    if (s == NULL) {
        glint_word("miss");
        log_vector("color", k_background);
        glint_end();
        return k_background;
    }
    const Vec p = add(origin, mul(direction, t));
    Vec n = s->b;
    if (s->kind == SPHERE) n = WRONG("normal-not-unit") ? sub(p, s->a) : WRONG("normal-is-point") ? unit(p) : mul(sub(p, s->a), 1 / s->radius);
    if (s->kind == TRIANGLE) n = unit(cross(sub(s->b, s->a), sub(s->c, s->a)));
    const int inside = dot(n, direction) > 0;
    if (inside && !WRONG("inside-not-flipped")) n = mul(n, -1);
    if (WRONG("normal-reversed")) n = mul(n, -1);
    Vec v = mul(direction, -1);
    if (WRONG("view-reversed")) v = direction;
    if (WRONG("view-not-unit")) v = sub(origin, p);
    if (WRONG("view-to-camera")) v = unit(sub(k_eye, p));
    glint_name("shape", s->name);
    glint_number("t", t);
    log_vector("P", p);
    log_vector("N", n);
    log_vector("V", v);
    if (s->kind == SPHERE) glint_flag("inside", inside);
    const Vec local = light_of(s, p, n, v, direction);
    Vec color = local;
    const int limit = k_limit + (WRONG("depth-more") ? 1 : WRONG("depth-less") ? -1 : 0);
    if (depth < limit) {
        float share = (1 - s->transmission) * (1 - s->mirror);
        if (WRONG("mirror-add")) share = 1;
        if (WRONG("blend-reversed") && s->mirror > 0) share = s->mirror;
        color = add(mul(local, share), secondary_light(s, p, n, direction, inside, depth));
    }
    log_vector("color", color);
    glint_end();
    return color;
}

static Vec direction_of(int x, int y, int width, int height) {
    const Vec forward = unit(sub(k_target, k_eye)), right = unit(cross(forward, k_up)), up = cross(right, forward);
    float angle = 55.0f / 2 * k_pi / 180;
    if (WRONG("fov-full-angle")) angle *= 2;
    if (WRONG("fov-in-degrees")) angle = 55.0f / 2;
    const float half = tanf(angle), in_pixel = WRONG("pixel-centre-missing") ? 0 : 0.5f;
    float sx = 2 * (x + in_pixel) / width - 1, sy = 1 - 2 * (y + in_pixel) / height;
    if (WRONG("pixel-over-last")) sx = 2.0f * x / (width - 1) - 1, sy = 1 - 2.0f * y / (height - 1);
    if (WRONG("integer-division")) sx = 2 * (x / width) - 1, sy = 1 - 2 * (y / height);
    if (WRONG("rows-flipped")) sy = -sy;
    if (WRONG("columns-mirrored")) sx = -sx;
    const float aspect = WRONG("aspect-ignored") ? 1 : WRONG("aspect-inverted") ? (float)width / height : (float)height / width;
    return unit(add(forward, add(mul(right, sx * half), mul(up, sy * half * aspect))));
}

static int byte_of(float v) {
    if (WRONG("clamp-missing")) return (int)rintf(255 * v) & 255;
    if (WRONG("tone-curve")) v = v / (1 + v);
    if (WRONG("tone-curve-exponential")) v = 1 - expf(-v);
    v = v < 0 || v != v ? 0 : v > 1 ? 1 : v;
    if (WRONG("gamma-2")) v = sqrtf(v);
    if (WRONG("gamma")) v = powf(v, 1 / 2.2f);
    if (WRONG("bytes-truncated")) return (int)(255 * v);
    if (WRONG("bytes-times-256")) return (int)(256 * v) & 255;
    return (int)rintf(255 * v);
}

// Prints the names in WRONG("...") of this file.
static int list_mistakes(void) {
    FILE* source = fopen(__FILE__, "r");
    char line[1024];
    if (source == NULL) return 1;
    while (fgets(line, sizeof(line), source) != NULL) {
        for (char* at = line; (at = strstr(at, "WRONG(\"")) != NULL;) {
            char* end = strchr(at += 7, '"');
            if (end != NULL && *at >= 'a' && *at <= 'z') printf("%.*s\n", (int)(end - at), at);
        }
    }
    return fclose(source);
}

int main(int argc, char** argv) {
    const int width = argc > 2 ? atoi(argv[1]) : 240, height = argc > 2 ? atoi(argv[2]) : 180;
    char size[40];
    if (argc == 2 && strcmp(argv[1], "--list") == 0) return list_mistakes();
    if (getenv("MISTAKE") != NULL) g_mistake = getenv("MISTAKE");
    snprintf(size, sizeof(size), "%d %d", width, height);
    glint_about("size", size);
    printf("P6\n%d %d\n255\n", width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            glint_pixel(x, y);
            const Vec color = trace("camera", k_eye, direction_of(x, y, width, height), 0, k_white);
            int r = byte_of(color.x), g = byte_of(color.y), b = byte_of(color.z);
            if (WRONG("colors-swapped")) {
                const int red = r;
                r = b, b = red;
            }
            log_vector("color", color);
            glint_vector("bytes", r, g, b);
            glint_pixel_end();
            putchar(r);
            putchar(g);
            putchar(b);
        }
    }
    return 0;
}
