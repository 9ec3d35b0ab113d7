// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/losses.h"

#include <fmt/format.h>

#include <algorithm>

namespace glint::gltf_export {

void Losses::add(std::string_view kind, std::string_view done) {
    auto at = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& k) { return k.name == kind; });
    if (at == kinds_.end()) at = kinds_.insert(at, {kind, done, 0});
    if (at->count < UINT32_MAX) ++at->count;
}

std::vector<Diagnostic> Losses::warnings(const std::string& file) const {
    std::vector<Diagnostic> list;
    for (const Kind& kind : kinds_) {
        Diagnostic d;
        d.severity = Severity::warning;
        d.file = file;
        d.message = fmt::format("glTF has no {}: {}{}", kind.name, kind.done,
                                kind.count > 1 ? fmt::format(" ({})", kind.count) : std::string());
        list.push_back(std::move(d));
    }
    return list;
}

}  // namespace glint::gltf_export
