// SPDX-License-Identifier: Apache-2.0
#include "cli/render_output.h"

#include <fmt/format.h>

#include <utility>

#include "base/text.h"
#include "cli/failure.h"
#include "cli/interrupt.h"
#include "cli/journal_file.h"
#include "cli/journal_picture.h"
#include "cli/print_error.h"
#include "cli/text.h"
#include "cli/whole_picture.h"
#include "output/memory_sink.h"
#include "output/strip_sink.h"

namespace glint::cli {
namespace {

class MemoryOutput : public RenderOutput {
  public:
    explicit MemoryOutput(const OutputPlan& plan) : plan_(plan) {}

    Result<Rendering> render(const World& world, RenderOptions options, const RenderHooks& hooks) override {
        if (!hooks.render) return glint::render(world, options);
        MemorySink sink(plan_.header, options.threads);
        Result<Rendering> result = hooks.render(world, std::move(options), plan_.header, &sink);
        if (result) sink.move_to(*result);
        return result;
    }

    double write(Rendering& rendering) override {
        if (plan_.written != plan_.area) put_in_whole(rendering, plan_.written, plan_.area);
        return plan_.picture->write(rendering);
    }

  private:
    const OutputPlan& plan_;
};

class StripOutput : public RenderOutput {
  public:
    explicit StripOutput(const OutputPlan& plan) : plan_(plan), writer_(plan.picture->begin_strips()) {}

    Result<Rendering> render(const World& world, RenderOptions options, const RenderHooks&) override {
        sink_.emplace(plan_.area, options.threads, plan_.picture->has_alpha(), *writer_);
        return render_into(*sink_, world, std::move(options));
    }

    double write(Rendering&) override {
        sink_->finish();
        return 0;
    }

  private:
    const OutputPlan& plan_;
    const std::unique_ptr<StripWriter> writer_;
    std::optional<StripSink> sink_;
};

class JournalOutput : public RenderOutput {
  public:
    explicit JournalOutput(const OutputPlan& plan)
        : plan_(plan),
          journal_(open_journal(plan)),
          sink_(plan.header, journal_->missing(), journal_->work(), *journal_) {}

    Result<Rendering> render(const World& world, RenderOptions options, const RenderHooks& hooks) override {
        if (hooks.render) return hooks.render(world, std::move(options), plan_.header, &sink_);
        return render_into(sink_, world, std::move(options));
    }

    double write(Rendering& rendering) override {
        const double seconds = plan_.tiles ? move_tiles() : write_picture(rendering);
        set_interrupt_advice({});
        return seconds;
    }

  private:
    static std::unique_ptr<JournalFile> open_journal(const OutputPlan& plan) {
        const std::string& path = plan.kept_journal;
        if (path.empty())
            return JournalFile::begin(plan.tiles ? plan.tiles->target() : plan.picture->target(),
                                      plan.header);
        auto journal = JournalFile::resume(path, plan.header);
        const TileWork work = journal->work();
        const std::size_t there = work.expected - work.missing;
        if (there > 0 && !plan.is_quiet)
            print_error("going on with {}: {} of {} tiles are there\n", path, with_commas(there),
                        with_commas(work.expected));
        set_interrupt_advice("; the same command goes on from here");
        return journal;
    }

    double move_tiles() {
        journal_->move_to(plan_.tiles->target());
        return 0;
    }

    double write_picture(Rendering& rendering) {
        const double seconds = write_tiles(rendering);
        journal_->remove();  // no input maps it any more, which Windows requires
        return seconds;
    }

    double write_tiles(Rendering& rendering) {
        std::vector<JournalInput> inputs;
        inputs.push_back(journal_->read());
        const JournalPicture tiles(inputs);
        if (tiles.count_present() < sink_.work().expected)
            throw Failure(k_bad_input,
                          fmt::format("the journal of {} has been changed", glint::quoted(plan_.path)));
        const double seconds = plan_.picture->write(tiles);
        if (plan_.is_shown) rendering.image = tiles.image();
        return seconds;
    }

    const OutputPlan& plan_;
    const std::unique_ptr<JournalFile> journal_;
    JournalSink sink_;
};

}  // namespace

std::unique_ptr<RenderOutput> open_output(const OutputPlan& plan) {
    if (plan.tiles && !plan.kept_journal.empty() && has_all_tiles(plan.tiles->target(), plan.header)) {
        if (!plan.is_quiet) print_error("{}  is complete\n", plan.path);
        return nullptr;
    }
    switch (plan.store) {
        case TileStore::memory:
            return std::make_unique<MemoryOutput>(plan);
        case TileStore::strips:
            return std::make_unique<StripOutput>(plan);
        case TileStore::journal:
            break;
    }
    return std::make_unique<JournalOutput>(plan);
}

}  // namespace glint::cli
