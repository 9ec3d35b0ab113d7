#pragma once
// A scene's picture, for what holds pictures against each other.
#include <atomic>

#include "glint/render.h"

namespace glint {

/// prepare() and render(). Without an image and without an error it was cancelled.
RenderResult draw_picture(const Scene& scene, int threads, const std::atomic<bool>* cancel = nullptr);

}  // namespace glint
