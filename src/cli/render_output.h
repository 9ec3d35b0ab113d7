// SPDX-License-Identifier: Apache-2.0
#pragma once
// The outputs of a plan while its picture is rendered.
#include <memory>

#include "cli/output_plan.h"
#include "cli/render_hooks.h"

namespace glint::cli {

class RenderOutput {
  public:
    virtual ~RenderOutput() = default;
    RenderOutput(const RenderOutput&) = delete;
    RenderOutput& operator=(const RenderOutput&) = delete;

    /// Renders, by the hook if there is one. Throws Failure if what is rendered cannot be kept.
    virtual Result<Rendering> render(const World& world, RenderOptions options, const RenderHooks& hooks) = 0;

    /// Writes the files, and puts the picture into the rendering if it will be shown. Throws Failure. Returns
    /// the seconds that encoding took.
    virtual double write(Rendering& rendering) = 0;

  protected:
    RenderOutput() = default;
};

/// Opens the files that are written while tiles are rendered. The plan must outlive it. Null if --resume
/// finds the part complete, which is printed. Throws Failure.
std::unique_ptr<RenderOutput> open_output(const OutputPlan& plan);

}  // namespace glint::cli
