// SPDX-License-Identifier: Apache-2.0
#pragma once
// A picture and its layers as files: checked before the work begins, written when it is done.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/layer_files.h"
#include "cli/output_file.h"
#include "cli/picture_arguments.h"
#include "cli/strip_file.h"

namespace glint::cli {

class PictureOutput {
  public:
    /// `path`: the value of --output. Throws Failure if the picture cannot be written there.
    PictureOutput(const std::string& path, const NumberArguments& numbers, int threads, bool shows);
    /// The layers that are written with the picture, none by default. Throws Failure as LayerFiles().
    void set_layers(const std::vector<Layer>& layers);
    /// Gives the picture an alpha channel: the last of the layers that were rendered. It is then not written
    /// as a layer. Throws Failure if the format has no alpha.
    void set_alpha();
    bool has_alpha() const { return alpha_; }
    /// The scene's rule, as far as the arguments do not say otherwise.
    void set_rule(const ByteRule& rule);

    ByteRule rule() const { return encoding_.rule(); }
    bool is_stream() const { return output_.is_stream(); }
    /// The regular file of the picture, with links followed.
    const std::string& target() const { return output_.target(); }
    bool has_layers() const { return !layers_.wanted().empty(); }
    /// Bytes of the picture and its layers in memory.
    double memory(std::int32_t width, std::int32_t height) const;
    /// Throws Failure if this machine has not that memory.
    void check_memory(std::int32_t width, std::int32_t height) const;

    /// Encodes and writes. Throws Failure. Returns the seconds that encoding the picture took.
    double write(const Rendering& rendering) const;
    /// The same from journals, with little memory. The files are on the disk when this returns.
    double write(const JournalPicture& picture) const;
    /// The picture, without layers, which is written strip by strip.
    std::unique_ptr<StripFile> begin_strips(std::int32_t width, std::int32_t height) const;

  private:
    double bytes_a_pixel() const;
    std::vector<float> picture_rows(const JournalPicture& picture, std::int32_t strip,
                                    std::span<const float> rgb) const;

    const std::string path_;
    const NumberArguments numbers_;
    OutputFile output_;
    EncodeOptions encoding_;
    LayerFiles layers_;
    bool alpha_ = false;
};

/// Whether the picture of a journal has an alpha channel.
bool has_alpha(const JournalHeader& header);
/// The rule of the scene of a journal.
ByteRule rule_of(const JournalHeader& header);
/// Moves the layer alpha to the end of the list, or adds it there.
void put_alpha_last(std::vector<Layer>& layers);

/// True for a path that ends in .png, .ppm, .tga or .exr.
bool is_picture_path(const std::string& path);

}  // namespace glint::cli
