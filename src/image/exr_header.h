// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "image/decoders.h"

namespace glint {

/// OpenEXR takes the memory that a header asks for before it looks whether the file is that long, and by some
/// types it goes on elsewhere than the attribute's length says. So the lengths, the picture's size and the
/// number of tiles are looked at first. Throws Undecodable, if the library is not to see this file. bytes: a
/// file of more than 8.
void check_exr_header(ByteSpan bytes, const DecodeOptions& options);

}  // namespace glint
