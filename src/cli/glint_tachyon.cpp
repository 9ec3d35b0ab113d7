// SPDX-License-Identifier: Apache-2.0
// glint-tachyon: takes the place of `tachyon`. docs/tachyon.md.
#include "cli/drop_in.h"

namespace {

constexpr auto k_help =
    R"(glint-tachyon renders Tachyon's scenes (.dat) with glint, and takes Tachyon's flags.

Usage: glint-tachyon MODEL.dat [FLAGS]

  -o FILE                     the picture; default: outfile.tga
  -format TARGA|PNG|PPM|PPM48 default: TARGA
  -res X Y                    the size in pixels; default: the scene's
  -aasamples N                N samples besides the first, as a regular grid of at least as many
  -numthreads N               default: one per processor
  -raydepth N
  -fullshade -mediumshade -lowshade -lowestshade
  -shade_blinn -shade_phong -shade_nullphong
  -trans_orig -trans_vmd -trans_raster3d -trans_max_surfaces N
  -shadow_filter_on -shadow_filter_off
  -fog_radial -fog_vmd
  -rescale_lights S -auto_skylight S -add_skylight S -skylight_samples N
  -nosave                     renders, and writes nothing

Exit codes: 0: done; 255: the command line, the scene or a file is not valid; the message says why.
)";

}  // namespace

int main(int count, char** values) {
    return glint::cli::run_drop_in({"glint-tachyon", k_help, 255, glint::cli::tachyon_drop_in}, count,
                                   values);
}
