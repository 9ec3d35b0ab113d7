// SPDX-License-Identifier: Apache-2.0
// glint-core.wasm, which the page starts with, is linked from the same objects as glint.wasm, but with these
// functions in place of solids, faults, fog on the ground and outside of objects, formats/povray, the readers
// of CSC 473's, Tachyon's and .nff scenes, of .obj, .stl and glTF, compare, check, diagnose and the decoders
// of textures: almost half of the file. They are all that others call of these, so the linker takes nothing
// else of them. A call that needs one cannot be answered: glint_left_out() then says so, and the page repeats
// it with glint.wasm.
#include <cstdint>

#include "explain/solid_crossings.h"
#include "formats/csc473.h"
#include "formats/glint_solid.h"
#include "formats/mesh_file.h"
#include "formats/povray/standard_includes.h"
#include "formats/registry.h"
#include "glint/check.h"
#include "glint/compare.h"
#include "glint/diagnose.h"
#include "image/texture_image.h"
#include "scene/closed_mesh.h"
#include "scene/solid_steps.h"
#include "scene/validate_solid.h"
#include "trace/hits/hit_rule-inl.h"
#include "trace/hits/intersect-inl.h"
#include "trace/lighting/direct_lighting-inl.h"
#include "trace/lighting/ground_fog.h"
#include "wasm/api.h"
#include "world/appearance/fade.h"
#include "world/appearance/interiors.h"
#include "world/geometry/pack_solid.h"

namespace {

bool is_left_out = false;

glint::Status leave_out() {
    is_left_out = true;
    return {glint::ErrorCode::invalid_argument, "it needs glint.wasm: this file leaves it out", {}};
}

}  // namespace

namespace glint {

// Texts with solids end here: the rest is what others call.
void close_glint_solid(GlintText&, const Token&, GlintSolid&, const GlintItem&) { leave_out(); }
bool encloses_space(const Scene&, const Shape&) { return false; }
std::optional<std::uint32_t> find_open_triangle(const MeshData&) { return {}; }
bool is_inside_out(const MeshData&) { return false; }
std::string mistake_in_steps(const SolidTree&) { return {}; }
SolidSteps::SolidSteps(const SolidTree& tree) : tree_(tree) {}
std::vector<std::size_t> SolidSteps::parts(std::size_t) const { return {}; }
PackedSolid pack_solid(const Primitives&, const PrimitiveSolid&, std::span<const std::uint32_t>,
                       std::uint32_t, std::span<PackedOperand>) {
    leave_out();
    return {};
}
void HWY_NAMESPACE::ShapeTests::solids_leaf(const ShapeClass&, const RayPacket&, std::uint64_t, std::uint32_t,
                                            std::uint32_t) {}
void HWY_NAMESPACE::operand_intervals(const PackedGeometry&, std::uint32_t, Vec3, Vec3,
                                      std::vector<double>&) {}
void find_solid_crossings(const Scene&, const WorldParts&, const Kernels&, Explanation&) {}

// No world has a fault here: only compare and diagnose make them.
void HWY_NAMESPACE::put_faulty_hits(const WorldParts&, const RayBatch&, HitBatch&) {}
void HWY_NAMESPACE::sample_light_with_fault(const WorldParts&, const PreparedLight&, const LightRules&,
                                            const SurfaceBatch&, LightSampleBatch&, ShadowRayBatch&) {}
void HWY_NAMESPACE::add_light_with_fault(const WorldParts&, const PreparedLight&, const LightRules&,
                                         const SurfaceBatch&, const LightSampleBatch&, const HighlightBatch&,
                                         RadianceBatch&) {}

double fog_along(FogLine, double, double) {
    leave_out();
    return 0;
}
double caustics_at(const WorldParts&, SurfaceId, Vec3, Vec3) {
    leave_out();
    return 1;
}
Color fade_at(const WorldParts&, SurfaceId, Vec3, Vec3, double) {
    leave_out();
    return {1, 1, 1};
}
void find_interiors(WorldParts&) { leave_out(); }
std::uint32_t camera_interiors_at(const WorldParts&, Vec3) { return 0; }

void set_povray_defaults(Scene&) {}

void read_povray(LoadState& reading, const ReadText& text) {
    reading.diagnostics.error(text.place, 0, 0, leave_out().message);
}

void set_csc473_defaults(Scene&) {}

void read_csc473(LoadState& reading, const ReadText& text) {
    reading.diagnostics.error(text.place, 0, 0, leave_out().message);
}

std::optional<Diagnostic> first_csc473_error(const SceneText&) {
    leave_out();
    return {};
}

void set_nff_defaults(Scene&) {}

void read_nff(LoadState& reading, const ReadText& text) {
    reading.diagnostics.error(text.place, 0, 0, leave_out().message);
}

void read_stl(LoadState& reading, const ReadText& text) {
    reading.diagnostics.error(text.place, 0, 0, leave_out().message);
}
std::shared_ptr<const MeshData> read_stl_mesh(LoadState& reading, InputText where) {
    reading.diagnostics.error(where, 0, 0, leave_out().message);
    return nullptr;
}

void read_obj(LoadState& reading, const ReadText& text) {
    reading.diagnostics.error(text.place, 0, 0, leave_out().message);
}
std::shared_ptr<const MeshData> read_obj_mesh(LoadState& reading, InputText where) {
    reading.diagnostics.error(where, 0, 0, leave_out().message);
    return nullptr;
}

void set_tachyon_defaults(Scene&) {}

void read_tachyon(LoadState& reading, const ReadText& text) {
    reading.diagnostics.error(text.place, 0, 0, leave_out().message);
}

void finish_tachyon(LoadState&) {}

void set_gltf_defaults(Scene&) {}

void read_gltf(LoadState& reading, const ReadText& text) {
    reading.diagnostics.error(text.place, 0, 0, leave_out().message);
}

povray::StandardInclude povray::standard_include(std::string_view) {
    leave_out();
    return {};
}

Result<CauseReport> find_causes(const Image&, const Image&, const Scene*, const CauseOptions&) {
    return leave_out();
}

Result<std::vector<Finding>> check(const Scene&, const CheckOptions&) { return leave_out(); }

Result<Diagnosis> diagnose(const Scene&, const World&, std::string_view, const DiagnoseOptions&) {
    return leave_out();
}

Result<TextureImage> decode_texture(std::span<const std::uint8_t>, const DecodeOptions&) {
    return leave_out();
}

Result<std::string> diagnosis_json(const Diagnosis&, const Scene&) { return leave_out(); }

}  // namespace glint

std::int32_t glint_left_out() { return is_left_out ? 1 : 0; }
