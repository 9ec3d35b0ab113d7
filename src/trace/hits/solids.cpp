// SPDX-License-Identifier: Apache-2.0
// Rays and solids for every instruction set. They are separate from hit_kernels.cpp so that glint-core.wasm
// can be linked without them (src/wasm/left_out.cpp).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/hits/solids.cpp"
#include <hwy/foreach_target.h>  // must precede the other includes

#include "trace/hits/solids-inl.h"
