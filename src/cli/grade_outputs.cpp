// SPDX-License-Identifier: Apache-2.0
#include "cli/grade_outputs.h"

#include <fmt/format.h>

#include <filesystem>
#include <tuple>

#include "cli/failure.h"
#include "cli/overwriting.h"
#include "cli/render_or_fail.h"
#include "cli/submissions.h"

namespace glint::cli {
namespace {

namespace fs = std::filesystem;

// Where list_pictures looks: in the folder and in its folders.
bool is_handed_in(const std::string& path, const std::string& folder) {
    const fs::path in = followed(path).parent_path(), where = followed(folder);
    return is_picture_name(path) && (in == where || in.parent_path() == where);
}

}  // namespace

GradeOutputs::GradeOutputs(const GradeOutputNames& names, const std::string& folder) {
    if (!names.csv.empty()) csv.emplace("--csv", names.csv);
    if (!names.json.empty()) json.emplace("--json", names.json);
    if (!names.gradescope.empty()) gradescope.emplace("--gradescope", names.gradescope);
    if (!names.prairielearn.empty()) prairielearn.emplace("--prairielearn", names.prairielearn);
    if (!names.summary.empty()) summary.emplace("--summary", names.summary);
    if (!names.sheet.empty()) sheet.emplace(png_output("--sheet", names.sheet));
    table = true;
    for (const auto& [option, path, file] : {std::tuple("--csv", &names.csv, &csv),
                                             {"--json", &names.json, &json},
                                             {"--gradescope", &names.gradescope, &gradescope},
                                             {"--prairielearn", &names.prairielearn, &prairielearn},
                                             {"--summary", &names.summary, &summary},
                                             {"--sheet", &names.sheet, &sheet}}) {
        if (!*file) continue;
        if ((*file)->is_standard_output()) table = false;
        if (!(*file)->is_stream() && is_handed_in(*path, folder))
            throw Failure(k_usage, fmt::format("{} '{}' is in '{}', where the next run would take it for "
                                               "handed in: write it into a folder outside",
                                               option, *path, folder));
    }
}

}  // namespace glint::cli
