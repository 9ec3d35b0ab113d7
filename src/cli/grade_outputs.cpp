#include "cli/grade_outputs.h"

#include <fmt/format.h>

#include <filesystem>

#include "cli/draw.h"
#include "cli/failure.h"
#include "cli/submissions.h"

namespace glint::cli {
namespace {

namespace fs = std::filesystem;

// With links followed, as far as the path exists.
fs::path whole(const std::string& path) {
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    fs::path found = fs::weakly_canonical(absolute, error);
    return error ? absolute.lexically_normal() : found;
}

// Where list_pictures looks: in the folder and in its folders.
bool is_handed_in(const std::string& path, const std::string& folder) {
    const fs::path in = whole(path).parent_path();
    return is_picture_name(path) && (in == whole(folder) || in.parent_path() == whole(folder));
}

}  // namespace

GradeOutputs::GradeOutputs(const GradeOutputNames& names, const std::string& folder) {
    if (!names.csv.empty()) csv.emplace(names.csv);
    if (!names.json.empty()) json.emplace(names.json);
    if (!names.sheet.empty()) sheet.emplace(png_output("--sheet", names.sheet));
    int taken = 0;
    for (const auto* file : {&csv, &json, &sheet}) taken += *file && (*file)->is_standard_output();
    if (taken > 1) throw Failure(k_usage, "only one of --csv, --json and --sheet can go to standard output");
    table = taken == 0;
    if (csv && !csv->is_stream()) files_.push_back({"--csv", names.csv, &*csv});
    if (json && !json->is_stream()) files_.push_back({"--json", names.json, &*json});
    if (sheet && !sheet->is_stream()) files_.push_back({"--sheet", names.sheet, &*sheet});
    for (std::size_t i = 0; i < files_.size(); ++i) {
        const Named& file = files_[i];
        for (std::size_t k = 0; k < i; ++k) {
            if (whole(files_[k].path) == whole(file.path))
                throw Failure(k_usage,
                              fmt::format("{} and {} are one file, '{}': choose another for one of them",
                                          files_[k].option, file.option, file.path));
        }
        if (is_handed_in(file.path, folder))
            throw Failure(k_usage, fmt::format("{} '{}' is in '{}', where the next run would take it for "
                                               "handed in: write it into a folder outside",
                                               file.option, file.path, folder));
    }
}

void GradeOutputs::spare(std::span<const std::string> inputs) const {
    for (const Named& file : files_) {
        if (file.output->replaces(inputs))
            throw Failure(k_usage, fmt::format("{} '{}' would overwrite what is read: choose another file",
                                               file.option, file.path));
    }
}

}  // namespace glint::cli
