// SPDX-License-Identifier: Apache-2.0
#include "cli/output_plan.h"

#include <fmt/format.h>

#include <utility>

#include "cli/failure.h"
#include "cli/journal_header.h"
#include "cli/text.h"
#include "journal/journal.h"

namespace glint::cli {
namespace {

// Pictures of more bytes are not kept in memory as a whole. Strips take less time from about here on, because
// the system clears less memory (measured: 13% of 2048x2048 pixels of few rays each). A journal costs more.
constexpr double k_max_memory_without_strips = 16.0 * (1 << 20);
constexpr double k_max_memory_without_journal = 256.0 * (1 << 20);

std::string default_output(const std::string& scene_file, const std::optional<Part>& part) {
    const std::string name = scene_file == "-" ? "picture" : stem(scene_file);
    return part ? fmt::format("{}.{}-of-{}.tiles", name, part->number, part->parts) : name + ".png";
}

TileStore store_of(const RenderArguments& arguments, const PictureOutput& picture, bool is_distributed) {
    if (arguments.resume && !arguments.keeps_size) return TileStore::journal;
    if (arguments.show || arguments.keeps_size || picture.is_stream()) return TileStore::memory;
    // Tiles of other processes come in any order, and a file of layers has them one after the other.
    const bool can_be_strips = !is_distributed && !picture.has_layers();
    if (picture.memory() <= (can_be_strips ? k_max_memory_without_strips : k_max_memory_without_journal))
        return TileStore::memory;
    return can_be_strips ? TileStore::strips : TileStore::journal;
}

}  // namespace

OutputRequest request_output(const RenderArguments& arguments) {
    OutputRequest request;
    request.part = parse_part(arguments.part);
    request.path = arguments.output.empty() ? default_output(arguments.scene.files.front(), request.part)
                                            : arguments.output;
    if (request.part) {
        request.tiles = tiles_output(request.path, arguments.show);
    } else {
        request.picture = picture_destination(request.path, arguments.numbers, arguments.show);
        if (arguments.resume && request.picture->file.is_stream())
            throw Failure(k_usage, "--resume keeps a journal beside the picture: name a file with --output");
    }
    if (!arguments.stats.empty()) request.stats.emplace("--stats", arguments.stats);
    return request;
}

OutputPlan plan_output(OutputRequest request, const RenderArguments& arguments, const LoadedScene& loaded,
                       const Crop& area, const std::vector<Layer>& layers, bool is_distributed) {
    OutputPlan plan;
    plan.path = request.path;
    plan.tiles = std::move(request.tiles);
    plan.stats = std::move(request.stats);
    const RenderSettings& settings = loaded.scene->settings;
    plan.area = area;
    plan.written = arguments.keeps_size ? Crop{settings.width, settings.height} : area;
    plan.is_shown = arguments.show;
    plan.is_quiet = arguments.quiet;
    if (arguments.resume) plan.kept_journal = plan.path + ".journal";
    if (request.picture) {
        const PictureContents contents{plan.written, layers, settings.alpha,
                                       loaded.scene->conventions.byte_rule()};
        plan.picture.emplace(*request.picture, contents, arguments.threads);
    }
    plan.store = plan.picture ? store_of(arguments, *plan.picture, is_distributed) : TileStore::journal;
    // Pictures are shown from memory.
    if (plan.store == TileStore::memory || plan.is_shown) plan.picture->check_memory();
    if (plan.store == TileStore::journal || is_distributed) {
        plan.header = journal_header(arguments.scene, loaded, area, layers);
        if (request.part) plan.header.part = request.part->number, plan.header.parts = request.part->parts;
    }
    return plan;
}

std::string OutputPlan::size_text() const {
    return tiles ? counted(tiles_of_part(header).size(), "tile")
                 : fmt::format("{}x{}", written.width, written.height);
}

}  // namespace glint::cli
