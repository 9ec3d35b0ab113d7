#pragma once
// Where `glint grade` writes, so that it loses nothing that it reads.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/output_file.h"

namespace glint::cli {

/// As the user named them; empty: not asked for.
struct GradeOutputNames {
    std::string csv, json, sheet;
};

/// Where the results go besides standard output, found out before the work begins.
class GradeOutputs {
  public:
    /// Throws Failure as OutputFile does, and of usage if two would be one file or if the next run would take
    /// one for a picture of `folder`.
    GradeOutputs(const GradeOutputNames& names, const std::string& folder);
    GradeOutputs(const GradeOutputs&) = delete;
    GradeOutputs& operator=(const GradeOutputs&) = delete;

    /// Throws Failure of usage if one of them would overwrite one of these files.
    void spare(std::span<const std::string> inputs) const;

    std::optional<OutputFile> csv, json, sheet;
    bool table;  ///< for people, on standard output, where no file goes there

  private:
    struct Named {
        std::string option, path;
        const OutputFile* output;
    };
    std::vector<Named> files_;  // with names of their own
};

}  // namespace glint::cli
