// SPDX-License-Identifier: Apache-2.0
#include "cli/log_feedback.h"

#include "cli/diagnosis_text.h"
#include "cli/input_file.h"
#include "cli/text.h"
#include "world/prepare.h"

namespace glint::cli {

std::vector<LogFeedback> diagnose_logs(const Scene& scene, const std::vector<Submission>& submissions,
                                       const std::string& pattern, int threads) {
    const Result<World> world = prepare(scene);
    std::vector<LogFeedback> logs;
    for (const Submission& submission : submissions) {
        LogFeedback& log = logs.emplace_back();
        FoundFile found = find_file(submission, pattern);
        log.error = world ? found.error : world.message;
        log.file = found.path;
        if (!log.error.empty()) continue;
        const auto text = InputFile::open(log.file, log.error);
        if (!text) continue;
        DiagnoseOptions options;
        options.name = file_name(log.file);
        options.threads = threads;
        options.max_rows = 0;
        Result<Diagnosis> diagnosis = diagnose(scene, *world, text->text(), options);
        if (!diagnosis) {
            log.error = diagnosis.message;
        } else {
            log.diagnosis = *std::move(diagnosis);
        }
    }
    return logs;
}

std::string log_text(const LogFeedback& log, bool with_cause) {
    if (log.diagnosis)
        return std::string(file_name(log.file)) + ": " + feedback_text(*log.diagnosis, with_cause);
    return log.error;
}

}  // namespace glint::cli
