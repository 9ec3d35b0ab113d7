#include "cli/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace glint::cli {

bool is_terminal(int descriptor) { return ::isatty(descriptor) == 1; }

int terminal_columns() {
    winsize size{};
    int columns = 0;
    if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0) columns = size.ws_col;
    if (columns <= 0) {
        const char* wanted = std::getenv("COLUMNS");
        columns = wanted != nullptr ? std::atoi(wanted) : 0;
    }
    return columns <= 0 ? 80 : std::min(columns, 4096);
}

}  // namespace glint::cli
