// SPDX-License-Identifier: Apache-2.0
// nearest_hit and any_hit for every instruction set. Apart from kernels.cpp so that the two compile side by
// side.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/hit_kernels.cpp"
#include <hwy/foreach_target.h>  // must come before what follows

#include "trace/hit_kernels-inl.h"
