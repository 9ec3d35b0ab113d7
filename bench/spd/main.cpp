// SPDX-License-Identifier: Apache-2.0
// make_spd DATABASE [SIZE] [nff|pov|tachyon]: writes a Standard Procedural Database to standard output.
#include <cstdlib>
#include <string_view>

#include "databases.h"

namespace {

int usage() {
    std::fputs("usage: make_spd DATABASE [SIZE] [nff|pov|tachyon]\n", stderr);
    for (const spd::Database& d : spd::databases())
        std::fprintf(stderr, "  %-8s SIZE 1 to %d, default %d\n", d.name, d.max_size, d.default_size);
    return 2;
}

std::unique_ptr<spd::SceneWriter> make_writer(std::string_view format) {
    if (format == "nff") return spd::make_nff_writer(stdout);
    if (format == "pov") return spd::make_pov_writer(stdout);
    if (format == "tachyon") return spd::make_tachyon_writer(stdout);
    return nullptr;
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 2 || count > 4) return usage();
    for (const spd::Database& database : spd::databases()) {
        if (std::string_view(arguments[1]) != database.name) continue;
        const int size = count > 2 ? std::atoi(arguments[2]) : database.default_size;
        const auto writer = make_writer(count > 3 ? arguments[3] : "nff");
        if (!writer || size < 1 || size > database.max_size) return usage();
        database.write(*writer, size);
        writer->end();
        if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return 0;
        std::perror("make_spd: standard output");
        return 1;
    }
    return usage();
}
