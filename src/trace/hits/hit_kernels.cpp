// SPDX-License-Identifier: Apache-2.0
// nearest_hit and any_hit for every instruction set. They are separate from kernels.cpp so that both files
// compile in parallel.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/hits/hit_kernels.cpp"
#include <hwy/foreach_target.h>  // must precede the other includes

#include "trace/hits/hit_kernels-inl.h"
