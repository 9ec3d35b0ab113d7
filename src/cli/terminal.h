// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace glint::cli {

/// True if the descriptor is a terminal.
bool is_terminal(int descriptor);

/// True if the descriptor is a terminal that can erase and rewrite its last line ($TERM is not
/// "dumb").
bool can_redraw(int descriptor);

/// The columns of the terminal; else $COLUMNS, else 80. 1 to 4096.
int terminal_columns(int descriptor);

}  // namespace glint::cli
