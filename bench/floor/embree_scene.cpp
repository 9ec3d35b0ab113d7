// SPDX-License-Identifier: Apache-2.0
#include "embree_scene.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>

#include "glint/shapes.h"
#include "math/transform.h"
#include "world/geometry/triangulate.h"

namespace glint_floor {

using namespace glint;

namespace {

void stop(const char* why) {
    std::fprintf(stderr, "embree: %s\n", why);
    std::exit(1);
}

float* vertex_buffer(RTCGeometry geometry, RTCFormat format, std::size_t floats, std::size_t count) {
    void* buffer =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, format, floats * sizeof(float), count);
    if (!buffer) stop("out of memory");
    return static_cast<float*>(buffer);
}

unsigned* index_buffer(RTCGeometry geometry, RTCFormat format, std::size_t each, std::size_t count) {
    void* buffer =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, format, each * sizeof(unsigned), count);
    if (!buffer) stop("out of memory");
    return static_cast<unsigned*>(buffer);
}

void put(float*& out, Vec3 v) {
    *out++ = static_cast<float>(v.x);
    *out++ = static_cast<float>(v.y);
    *out++ = static_cast<float>(v.z);
}

void put(float*& out, Vec3 v, double radius) {
    put(out, v);
    *out++ = static_cast<float>(radius);
}

}  // namespace

EmbreeScene::EmbreeScene(const Scene& scene, int threads) {
    device_ = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
    if (!device_) stop("Embree gives no device");
    scene_ = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    add_rounds(scene);
    add_triangles(scene);
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) stop("Embree cannot build the scene");
}

EmbreeScene::~EmbreeScene() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

void EmbreeScene::attach(RTCGeometry geometry) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
}

void EmbreeScene::add_rounds(const Scene& scene) {
    std::vector<std::uint32_t> spheres, cones;
    for (const Shape& shape : scene.shapes) {
        if (shape.transform != k_none && shape.kind != ShapeKind::mesh) stop("this scene has transforms");
        if (shape.kind == ShapeKind::sphere) spheres.push_back(shape.material);
        if (shape.kind == ShapeKind::cylinder || shape.kind == ShapeKind::cone)
            cones.push_back(shape.material);
    }
    if (!spheres.empty()) {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
        float* out = vertex_buffer(geometry, RTC_FORMAT_FLOAT4, 4, spheres.size());
        for (const Shape& shape : scene.shapes) {
            if (shape.kind != ShapeKind::sphere) continue;
            const Sphere& sphere = scene.get<Sphere>()[shape.index];
            put(out, sphere.center, sphere.radius);
        }
        attach(geometry);
        materials_.push_back(std::move(spheres));
    }
    if (!cones.empty()) {
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE);
        float* out = vertex_buffer(geometry, RTC_FORMAT_FLOAT4, 4, cones.size() * 2);
        for (const Shape& shape : scene.shapes) {
            if (shape.kind == ShapeKind::cylinder) {
                const Cylinder& c = scene.get<Cylinder>()[shape.index];
                put(out, c.from, c.radius);
                put(out, c.to, c.radius);
            } else if (shape.kind == ShapeKind::cone) {
                const Cone& c = scene.get<Cone>()[shape.index];
                put(out, c.from, c.from_radius);
                put(out, c.to, c.to_radius);
            }
        }
        unsigned* index = index_buffer(geometry, RTC_FORMAT_UINT, 1, cones.size());
        for (std::size_t i = 0; i < cones.size(); ++i) index[i] = static_cast<unsigned>(2 * i);
        attach(geometry);
        materials_.push_back(std::move(cones));
    }
}

void EmbreeScene::add_triangles(const Scene& scene) {
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> materials;
    for (const Shape& shape : scene.shapes) {
        switch (shape.kind) {
            case ShapeKind::triangle:
                triangles.push_back(scene.get<Triangle>()[shape.index]);
                break;
            case ShapeKind::smooth_triangle: {
                const SmoothTriangle& t = scene.get<SmoothTriangle>()[shape.index];
                triangles.push_back({{t.vertices[0], t.vertices[1], t.vertices[2]}});
                normals_.resize(3 * (triangles.size() - 1));
                normals_.insert(normals_.end(), t.normals, t.normals + 3);
                break;
            }
            case ShapeKind::polygon: {
                const Polygon& p = scene.get<Polygon>()[shape.index];
                triangulate(std::span(scene.polygon_vertices).subspan(p.first, p.count), triangles);
                break;
            }
            case ShapeKind::mesh:
                add_mesh(scene, shape, triangles);
                break;
            case ShapeKind::sphere:
            case ShapeKind::cylinder:
            case ShapeKind::cone:
                break;
            default:
                stop("this scene has shapes that are neither in .nff files nor meshes");
        }
        materials.resize(triangles.size(), shape.material);
    }
    normals_.resize(3 * triangles.size());
    if (triangles.empty()) return;
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    float* out = vertex_buffer(geometry, RTC_FORMAT_FLOAT3, 3, triangles.size() * 3);
    for (const Triangle& triangle : triangles)
        for (const Vec3& v : triangle.vertices) put(out, v);
    unsigned* index = index_buffer(geometry, RTC_FORMAT_UINT3, 3, triangles.size());
    for (std::size_t i = 0; i < triangles.size() * 3; ++i) index[i] = static_cast<unsigned>(i);
    attach(geometry);
    triangles_ = static_cast<unsigned>(materials_.size());
    flat_ = std::move(triangles);
    materials_.push_back(std::move(materials));
}

void EmbreeScene::add_mesh(const Scene& scene, const Shape& shape, std::vector<Triangle>& triangles) {
    const MeshData& mesh = *scene.meshes[scene.get<Mesh>()[shape.index].mesh];
    const bool is_placed = shape.transform != k_none;
    const Affine to_world = is_placed ? scene.transforms[shape.transform] : Affine{};
    const std::optional<Affine> to_object = inverse(to_world);
    if (!to_object) stop("a singular transform");
    normals_.resize(3 * triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        Triangle triangle;
        for (int k = 0; k < 3; ++k)
            triangle.vertices[k] = transform_point(to_world, mesh.position(mesh.triangles[i][k]));
        triangles.push_back(triangle);
        const auto normals = mesh.corner_normals(i);
        for (int k = 0; k < 3; ++k)
            normals_.push_back(normals ? transform_normal(*to_object, to_vec3((*normals)[k])) : Vec3{});
    }
}

double EmbreeScene::size() const {
    RTCBounds box;
    rtcGetSceneBounds(scene_, &box);
    return std::hypot(box.upper_x - box.lower_x, box.upper_y - box.lower_y, box.upper_z - box.lower_z);
}

bool EmbreeScene::nearest(Vec3 origin, Vec3 direction, Hit& hit) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit r{};
    r.ray.org_x = static_cast<float>(origin.x);
    r.ray.org_y = static_cast<float>(origin.y);
    r.ray.org_z = static_cast<float>(origin.z);
    r.ray.dir_x = static_cast<float>(direction.x);
    r.ray.dir_y = static_cast<float>(direction.y);
    r.ray.dir_z = static_cast<float>(direction.z);
    r.ray.tfar = INFINITY;
    r.ray.mask = ~0u;
    r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &r);
    if (r.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    hit.point = origin + direction * static_cast<double>(r.ray.tfar);
    hit.material = materials_[r.hit.geomID][r.hit.primID];
    hit.normal = {r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z};
    if (r.hit.geomID == triangles_) {
        const Vec3* n = &normals_[3 * std::size_t{r.hit.primID}];
        const Vec3* p = flat_[r.hit.primID].vertices;
        const Vec3 e1 = p[1] - p[0], e2 = p[2] - p[0], across = cross(direction, e2), s = origin - p[0];
        const Vec3 up = cross(s, e1);
        const double scale = 1 / dot(across, e1), u = dot(s, across) * scale, v = dot(direction, up) * scale;
        hit.point = origin + direction * (dot(e2, up) * scale);
        hit.normal = cross(e1, e2);
        const Vec3 mixed = n[0] * (1 - u - v) + n[1] * u + n[2] * v;
        if (dot(mixed, mixed) > 0) hit.normal = mixed;
    }
    hit.normal = hit.normal / std::sqrt(dot(hit.normal, hit.normal));
    return true;
}

}  // namespace glint_floor
