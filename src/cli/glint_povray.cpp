// SPDX-License-Identifier: Apache-2.0
// glint-povray: takes the place of `povray`. docs/povray.md.
#include "cli/drop_in.h"

int main(int count, char** values) {
    return glint::cli::run_drop_in(glint::cli::k_povray_program, count, values);
}
