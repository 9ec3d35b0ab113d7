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

/// What --aov asks for, found out before the work begins.
class LayerFiles {
  public:
    /// aov: names with commas, or `all`; none: no layers. In an OpenEXR file they are its parts; beside a PNG
    /// or PPM `castle.png` they are `castle.normal.png` and so on. Throws Failure.
    LayerFiles(const std::optional<std::string>& aov, const std::string& picture, FileFormat format,
               bool is_stream);

    const std::vector<Layer>& wanted() const { return wanted_; }
    /// Of the picture and the layers.
    double bytes_a_pixel() const;
    /// Writes what has files of its own.
    void write(const std::vector<LayerImage>& layers, const EncodeOptions& encoding) const;

  private:
    std::vector<Layer> wanted_;
    std::vector<OutputFile> files_;  // one a layer, or none
};

}  // namespace glint::cli
