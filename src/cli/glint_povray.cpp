// SPDX-License-Identifier: Apache-2.0
// glint-povray: takes the place of `povray`. docs/povray.md.
#include "cli/drop_in.h"

namespace {

constexpr auto k_help =
    R"(glint-povray renders scenes in POV-Ray's language with glint, and takes POV-Ray's options.

Usage: glint-povray [+Iscene.pov | scene.pov] [OPTIONS] [FILE.ini[section]] [Key=Value ...]

  +Ifile +Ofile               scene and picture; +O- is standard output; default: the scene's name with .png
  +Wn +Hn                     the size in pixels
  +FN[8|16] +FT +FP[8|16] +FE PNG (default), TGA, PPM, OpenEXR
  +An +Rn -A                  anti-aliasing: threshold (0.3) and depth (3)
  +Qn                         quality 0 to 11
  +WTn                        threads
  +UA                         alpha
  -D -P -V +L ...             accepted; -V prints only errors

Options are read from povray.ini (the variable POVINI names it; this folder, ~/.povray/3.7, /etc/povray/3.7)
first, as povray reads them.
Exit codes: 0: done; 1: the command line, the scene or a file is not valid; the message says why.
)";

}  // namespace

int main(int count, char** values) {
    return glint::cli::run_drop_in({"glint-povray", k_help, 1, glint::cli::povray_drop_in}, count, values);
}
