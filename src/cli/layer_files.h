// SPDX-License-Identifier: Apache-2.0
#pragma once
// The layers of a picture, and where they are written.
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/output_file.h"
#include "glint/glint.h"

namespace glint::cli {

/// Adds --aov.
void add_layer_argument(CLI::App& command, std::optional<std::string>& aov);

/// The layers that --aov asks for; checked before rendering begins.
class LayerFiles {
  public:
    /// aov: layer names separated by commas, or `all`; none: no layers. In an OpenEXR file they are parts of
    /// the file; with a PNG or PPM `castle.png` they are the files `castle.normal.png` and so on. Throws
    /// Failure.
    LayerFiles(const std::optional<std::string>& aov, const std::string& picture, FileFormat format,
               bool is_stream);

    const std::vector<Layer>& wanted() const { return wanted_; }
    /// Bytes per pixel of the picture and the layers together.
    double bytes_a_pixel() const;
    /// Writes the layers that have files of their own.
    void write(const std::vector<LayerImage>& layers, const EncodeOptions& encoding) const;

  private:
    std::vector<Layer> wanted_;
    std::vector<OutputFile> files_;  // one per layer, or none
};

}  // namespace glint::cli
