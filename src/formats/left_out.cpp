// SPDX-License-Identifier: Apache-2.0
// What LoadOptions::skip_unsupported leaves out.
#include <fmt/format.h>

#include <algorithm>

#include "formats/load_state.h"

namespace glint {

void LeftOut::add(std::string_view kind, InputText where, std::size_t offset, std::size_t length) {
    auto at = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& k) { return k.name == kind; });
    if (at == kinds_.end()) {
        kinds_.push_back({std::string(kind), where, offset, length, 0});
        at = kinds_.end() - 1;
    }
    if (at->count < UINT32_MAX) ++at->count;
}

void LeftOut::report(Diagnostics& diagnostics) const {
    for (const Kind& kind : kinds_) {
        Diagnostic d = make_diagnostic(
            Severity::warning, kind.where, kind.offset, kind.length,
            fmt::format("left out {} that glint does not render: {}",
                        kind.count == 1 ? std::string("1 object") : fmt::format("{} objects", kind.count),
                        kind.name));
        d.left_out = kind.count;
        diagnostics.add(std::move(d));
    }
}

}  // namespace glint
