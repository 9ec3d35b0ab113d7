// SPDX-License-Identifier: Apache-2.0
#pragma once
// The layers of a picture, and where they are written.
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/journal_picture.h"
#include "cli/output_file.h"
#include "glint/glint.h"

namespace glint::cli {

/// Adds --aov.
void add_layer_argument(CLI::App& command, std::optional<std::string>& aov);

/// The layers of --aov: names separated by commas, or `all`; none: no layers. Before the scene is known
/// (null), each light is no_light. Throws Failure.
std::vector<Layer> parse_layers(const std::optional<std::string>& aov, const Scene* scene);

/// The files of layers; checked before rendering begins.
class LayerFiles {
  public:
    /// In an OpenEXR file layers are parts of the file; with a PNG or PPM `castle.png` they are the files
    /// `castle.normal.png`, `castle.light-2.png` and so on. Throws Failure.
    LayerFiles(std::vector<Layer> wanted, const std::string& picture, FileFormat format, bool is_stream);

    const std::vector<Layer>& wanted() const { return wanted_; }
    /// Bytes per pixel of the picture and the layers together.
    double bytes_a_pixel() const;
    /// Writes the layers that have files of their own; those of journals are on the disk when it returns.
    void write(const std::vector<LayerImage>& layers, const EncodeOptions& encoding) const;
    void write(const JournalPicture& picture, const EncodeOptions& encoding) const;

  private:
    const std::vector<Layer> wanted_;
    std::vector<OutputFile> files_;  // one per layer, or none
};

}  // namespace glint::cli
