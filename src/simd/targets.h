#pragma once
#include <hwy/targets.h>

#include <cstdint>

namespace glint {

/// The instruction sets that this machine's processor and system support, as Highway's target bits.
inline std::int64_t supported_targets() {
#if defined(__wasm__)
    return HWY_TARGETS;  // fixed when compiled
#else
    return hwy::SupportedTargets();
#endif
}

}  // namespace glint
