// SPDX-License-Identifier: Apache-2.0
// The memory that a load holds.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/memory_limit.h"
#include "formats/load_state.h"

namespace glint {
namespace {

constexpr std::uint64_t k_mib = 1u << 20;

template <class T> std::uint64_t bytes_of(const std::vector<T>& list) {
    return list.capacity() == 0 ? 0 : MemoryBudget::list_bytes(list.capacity(), sizeof(T));
}

// Names are counted by note(). Without the meshes.
std::uint64_t bytes_of(const Scene& scene) {
    std::uint64_t bytes = bytes_of(scene.lights) + bytes_of(scene.materials) + bytes_of(scene.transforms) +
                          bytes_of(scene.polygon_vertices) + bytes_of(scene.textures) +
                          bytes_of(scene.solids) + bytes_of(scene.meshes) + bytes_of(scene.shapes) +
                          bytes_of(scene.shape_colors) + bytes_of(scene.light_texts.places) +
                          bytes_of(scene.material_texts.places) + bytes_of(scene.shape_texts.places);
#define GLINT_KIND(Type, word) bytes += bytes_of(scene.get<Type>());
    GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
    for (const SolidTree& solid : scene.solids) bytes += bytes_of(solid.operands) + bytes_of(solid.steps);
    return bytes;
}

std::uint64_t bytes_of(const MeshData& mesh) {
    std::uint64_t bytes = sizeof(MeshData) + bytes_of(mesh.single_positions) + bytes_of(mesh.positions) +
                          bytes_of(mesh.triangles);
    for (const CornerValues* values : {&mesh.normals, &mesh.colors, &mesh.texture_coordinates})
        bytes += bytes_of(values->values) + bytes_of(values->corners);
    return bytes;
}

}  // namespace

std::uint64_t default_max_memory(std::uint64_t text_bytes) {
    text_bytes = std::min(text_bytes, std::uint64_t{1} << 48);  // no text is longer, and no product overflows
#if defined(__wasm__)
    return std::min(384 * k_mib + 64 * text_bytes, 768 * k_mib);  // of 2 GiB in all
#else
    return 2048 * k_mib + 256 * text_bytes;
#endif
}

LoadMemory::LoadMemory(const LoadOptions& options, std::uint64_t text_bytes)
    : MemoryBudget(options.max_memory != 0 ? options.max_memory : default_max_memory(text_bytes)),
      is_default_(options.max_memory == 0),
      text_bytes_(text_bytes) {}

void LoadMemory::add_text(std::uint64_t bytes) {
    text_bytes_ += bytes;
    if (is_default_) set_limit(default_max_memory(text_bytes_));
    add(bytes);
}

void LoadMemory::count(const Scene& scene) {
    remove(scene_bytes_);
    // Each mesh is looked at once: there may be many.
    for (; counted_meshes_ < scene.meshes.size(); ++counted_meshes_) {
        const auto& mesh = scene.meshes[counted_meshes_];
        if (mesh != growing_) {
            mesh_bytes_ += bytes_of(*mesh);
        } else {
            is_growing_passed_ = true;
        }
    }
    scene_bytes_ = bytes_of(scene) + mesh_bytes_ + (growing_ ? bytes_of(*growing_) : 0);
    add(scene_bytes_);
}

void LoadMemory::set_growing(std::shared_ptr<const MeshData> mesh) {
    if (is_growing_passed_) mesh_bytes_ += bytes_of(*growing_);
    is_growing_passed_ = false;
    growing_ = std::move(mesh);
}

std::string LoadMemory::message() const {
    return fmt::format(
        "reading the scene takes more than {} of memory, {}: max_memory (--max-memory) raises it",
        memory_text(limit()),
        is_default_ ? fmt::format("the default for {} bytes of text", text_bytes_)
                    : std::string("the limit that was given"));
}

bool LoadState::is_within_memory(InputText where, std::size_t offset, std::size_t length) {
    memory.count(scene);
    return !memory.is_exceeded() || report_memory(where, offset, length);
}

bool LoadState::has_room(std::uint64_t bytes, InputText where, std::size_t offset, std::size_t length) {
    return memory.has_room(bytes) || report_memory(where, offset, length);
}

bool LoadState::report_memory(InputText where, std::size_t offset, std::size_t length) {
    if (!is_memory_reported && !diagnostics.full()) {
        diagnostics.error(where, offset, length, memory.message());
        is_memory_reported = true;
    }
    return false;
}

std::uint16_t LoadState::add_text(const std::string& path, std::string text) {
    const auto number = static_cast<std::uint16_t>(texts.size());
    memory.add_text(text.size());
    includes.texts.push_back({path, std::move(text)});
    includes.files.emplace(path, number);
    texts.push_back({includes.texts.back().name, includes.texts.back().text});
    scene.files.push_back(path);
    return number;
}

}  // namespace glint
