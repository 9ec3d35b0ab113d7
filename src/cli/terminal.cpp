// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace glint::cli {

bool is_terminal(int descriptor) { return ::isatty(descriptor) == 1; }

bool can_redraw(int descriptor) {
    const char* kind = std::getenv("TERM");
    return is_terminal(descriptor) && kind != nullptr && *kind != '\0' && std::string_view(kind) != "dumb";
}

int terminal_columns(int descriptor) {
    winsize size{};
    int columns = 0;
    if (::ioctl(descriptor, TIOCGWINSZ, &size) == 0) columns = size.ws_col;
    if (columns <= 0) {
        const char* wanted = std::getenv("COLUMNS");
        columns = wanted != nullptr ? std::atoi(wanted) : 0;
    }
    return columns <= 0 ? 80 : std::min(columns, 4096);
}

}  // namespace glint::cli
