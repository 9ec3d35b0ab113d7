// SPDX-License-Identifier: Apache-2.0
#include "cli/render_target.h"

#include <fmt/format.h>

#include "base/text.h"
#include "cli/failure.h"
#include "cli/interrupt.h"
#include "cli/print_error.h"
#include "cli/streamed_render.h"
#include "cli/text.h"

namespace glint::cli {
namespace {

// Pictures of more bytes are not kept in memory as a whole.
constexpr double k_max_memory = 256.0 * (1 << 20);

std::string default_output(const std::string& scene_file, const std::optional<Part>& part) {
    const std::string name = scene_file == "-" ? "picture" : stem(scene_file);
    return part ? fmt::format("{}.{}-of-{}.tiles", name, part->number, part->parts) : name + ".png";
}

}  // namespace

RenderTarget::RenderTarget(const RenderArguments& arguments)
    : arguments_(arguments),
      part_(parse_part(arguments.part)),
      path_(arguments.output.empty() ? default_output(arguments.scene.files.front(), part_)
                                     : arguments.output) {
    if (part_) {
        tiles_.emplace(tiles_output(path_, arguments.show));
        return;
    }
    picture_.emplace(path_, arguments.numbers, arguments.threads, arguments.show);
    if (arguments.resume && picture_->is_stream())
        throw Failure(k_usage, "--resume keeps a journal beside the picture: name a file with --output");
}

void RenderTarget::set_layers(const std::vector<Layer>& layers) {
    if (picture_) picture_->set_layers(layers);
}

void RenderTarget::set_alpha() {
    if (picture_) picture_->set_alpha();
}

void RenderTarget::set_rule(const ByteRule& rule) {
    if (picture_) picture_->set_rule(rule);
}

bool RenderTarget::is_in_strips(const Crop& picture) const {
    if (tiles_) return true;
    if (arguments_.show || arguments_.keeps_size || picture_->is_stream()) return false;
    return arguments_.resume || picture_->memory(picture.width, picture.height) > k_max_memory;
}

void RenderTarget::check_memory(const Crop& picture) const {
    if (!is_in_strips(picture)) picture_->check_memory(picture.width, picture.height);
}

bool RenderTarget::needs_header(const Crop& picture) const {
    return tiles_ || arguments_.resume || (is_in_strips(picture) && picture_->has_layers());
}

void RenderTarget::open_journal(const JournalHeader& header) {
    if (!arguments_.resume) {
        journal_ = JournalFile::begin(tiles_ ? tiles_->target() : picture_->target(), header);
        return;
    }
    const std::string path = path_ + ".journal";
    journal_ = JournalFile::resume(path, header);
    const std::size_t there = journal_->expected() - journal_->missing().size();
    if (there > 0 && !arguments_.quiet)
        print_error("going on with {}: {} of {} tiles are there\n", path, with_commas(there),
                    with_commas(journal_->expected()));
    set_interrupt_advice("; the same command goes on from here");
}

bool RenderTarget::begin(const Crop& picture, JournalHeader& header, bool has_hooks) {
    size_ = picture;
    const bool in_strips = is_in_strips(picture);
    if (part_) header.part = part_->number, header.parts = part_->parts;
    if (tiles_ && arguments_.resume && has_all_tiles(tiles_->target(), header)) {
        if (!arguments_.quiet) print_error("{}  is complete\n", path_);
        return false;
    }
    // Tiles of other processes come in any order, and a file of layers has them one after the other.
    const bool out_of_order = in_strips && (has_hooks || picture_->has_layers());
    if (tiles_ || arguments_.resume || out_of_order) {
        open_journal(header);
    } else if (in_strips) {
        strips_ = picture_->begin_strips(picture.width, picture.height);
    }
    return true;
}

Result<Rendering> RenderTarget::render(const World& world, RenderOptions options, const JournalHeader& header,
                                       const RenderHooks& hooks) {
    if (hooks.render) return hooks.render(world, std::move(options), header, journal_.get());
    if (journal_) return render_missing(world, std::move(options), *journal_);
    if (strips_) return render_strips(world, std::move(options), size_, *strips_);
    return glint::render(world, options);
}

double RenderTarget::write(Rendering& rendering) {
    if (strips_) {
        strips_->finish(false);
        return 0;
    }
    if (!journal_) return picture_->write(rendering);
    if (tiles_) {
        journal_->move_to(tiles_->target());
        set_interrupt_advice({});
        return 0;
    }
    std::vector<JournalInput> inputs;
    inputs.push_back(journal_->read());
    const JournalPicture tiles(inputs);
    if (tiles.count_present() < journal_->expected())
        throw Failure(k_bad_input, fmt::format("the journal of {} has been changed", glint::quoted(path_)));
    const double seconds = picture_->write(tiles);
    if (arguments_.show) rendering.image = tiles.image();
    journal_->remove();
    set_interrupt_advice({});
    return seconds;
}

std::string RenderTarget::size_text() const {
    return tiles_ ? counted(journal_->expected(), "tile") : fmt::format("{}x{}", size_.width, size_.height);
}

}  // namespace glint::cli
