// SPDX-License-Identifier: Apache-2.0
// glint-tachyon: takes the place of `tachyon`. docs/tachyon.md.
#include "cli/drop_in.h"

int main(int count, char** values) {
    return glint::cli::run_drop_in(glint::cli::k_tachyon_program, count, values);
}
