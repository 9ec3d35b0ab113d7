// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where a render goes: a picture, or the tiles of a part; and the journal that either needs.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/journal_file.h"
#include "cli/parts.h"
#include "cli/picture_output.h"
#include "cli/render_arguments.h"
#include "cli/render_hooks.h"

namespace glint::cli {

class RenderTarget {
  public:
    /// Throws Failure if nothing can be written there. The arguments must outlive this.
    explicit RenderTarget(const RenderArguments& arguments);
    /// The layers that are rendered, none by default. Throws Failure.
    void set_layers(const std::vector<Layer>& layers);
    /// The picture has an alpha channel: the last layer that is rendered. Throws Failure.
    void set_alpha();
    void set_rule(const ByteRule& rule);

    const std::string& path() const { return path_; }
    ByteRule rule() const { return picture_->rule(); }
    /// Throws Failure if this machine has not the memory for a picture that will be in memory as a whole.
    void check_memory(const Crop& picture) const;

    /// Whether begin() needs the journal's header.
    bool needs_header(const Crop& picture) const;

    /// Opens the journal, if one is needed. `picture`: what is rendered; the header's part is set here.
    /// False if the part is complete already. Throws Failure.
    bool begin(const Crop& picture, JournalHeader& header, bool has_hooks);

    /// Renders by the hook, or to the journal, to the file, or to memory, as begin() chose. Throws Failure.
    Result<Rendering> render(const World& world, RenderOptions options, const JournalHeader& header,
                             const RenderHooks& hooks);

    /// Writes the files, and puts the picture into the rendering if it will be shown. Throws Failure. Returns
    /// the seconds that encoding took.
    double write(Rendering& rendering);

    /// "640x480" or "20 tiles".
    std::string size_text() const;

  private:
    bool is_in_strips(const Crop& picture) const;
    void open_journal(const JournalHeader& header);

    const RenderArguments& arguments_;
    const std::optional<Part> part_;
    const std::string path_;
    std::optional<PictureOutput> picture_;
    std::optional<OutputFile> tiles_;
    Crop size_;
    std::unique_ptr<JournalFile> journal_;
    std::unique_ptr<StripFile> strips_;
};

}  // namespace glint::cli
