// SPDX-License-Identifier: Apache-2.0
#pragma once
// A picture and its layers as files: checked before the work begins, written when it is done.
#include <memory>
#include <string>
#include <vector>

#include "cli/layer_files.h"
#include "cli/output_file.h"
#include "cli/picture_arguments.h"
#include "output/strip_writer.h"

namespace glint::cli {

/// The file of a picture, as the arguments name it.
struct PictureDestination {
    std::string path;  ///< the value of --output
    OutputFile file;
    NumberArguments numbers;
    FileFormat format;
};

/// Throws Failure if the picture cannot be written there. shows: it goes to the terminal, too.
PictureDestination picture_destination(const std::string& path, const NumberArguments& numbers, bool shows);

/// What is written.
struct PictureContents {
    Crop area;                  ///< in the whole picture
    std::vector<Layer> layers;  ///< that are rendered
    bool has_alpha = false;     ///< the picture has an alpha channel: the last of the layers
    ByteRule rule;              ///< the scene's, as far as the arguments do not say otherwise
};

/// The picture of a journal.
PictureContents contents_of(const JournalHeader& header);

class PictureOutput {
  public:
    /// The layers but alpha are written with the picture. Throws Failure as LayerFiles(), and if the format
    /// has no alpha.
    PictureOutput(const PictureDestination& destination, const PictureContents& contents, int threads);

    bool has_alpha() const { return alpha_; }
    ByteRule rule() const { return encoding_.rule(); }
    bool is_stream() const { return output_.is_stream(); }
    /// The regular file of the picture, with links followed.
    const std::string& target() const { return output_.target(); }
    bool has_layers() const { return !layers_.wanted().empty(); }
    /// Bytes of the picture and its layers in memory.
    double memory() const;
    /// Throws Failure if this machine has not that memory.
    void check_memory() const;

    /// Encodes and writes. Throws Failure. Returns the seconds that encoding the picture took.
    double write(const Rendering& rendering) const;
    /// The same from journals, with little memory. The files are on the disk when this returns.
    double write(const JournalPicture& picture) const;
    /// The picture, without layers, which is written strip by strip.
    std::unique_ptr<StripWriter> begin_strips() const;

  private:
    double bytes_a_pixel() const;
    std::vector<float> picture_rows(const JournalPicture& picture, std::int32_t strip,
                                    std::span<const float> rgb) const;

    const OutputFile output_;
    const Crop area_;
    const bool alpha_;
    const EncodeOptions encoding_;
    const LayerFiles layers_;
};

/// Moves the layer alpha to the end of the list, or adds it there.
void put_alpha_last(std::vector<Layer>& layers);

/// True for a path with an ending of k_picture_endings.
bool is_picture_path(const std::string& path);

}  // namespace glint::cli
