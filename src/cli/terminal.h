#pragma once

namespace glint::cli {

/// True if the descriptor is a terminal.
bool is_terminal(int descriptor);

/// Columns of the terminal behind standard output, else of $COLUMNS, else 80; 1 to 4096.
int terminal_columns();

}  // namespace glint::cli
