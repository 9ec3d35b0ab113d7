#include "inspect/draw_picture.h"

namespace glint {

RenderResult draw_picture(const Scene& scene, int threads, const std::atomic<bool>* cancel) {
    const PrepareResult prepared = prepare(scene, threads);
    if (!prepared.world) {
        RenderResult result;
        result.error = "the scene cannot be drawn";
        return result;
    }
    RenderOptions options;
    options.threads = threads;
    options.cancel = cancel;
    return render(*prepared.world, options);
}

}  // namespace glint
