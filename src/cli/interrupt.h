// SPDX-License-Identifier: Apache-2.0
#pragma once
// Ctrl-C and its like: the program ends at once, wherever it is, and leaves no half file behind.
#include <string>

namespace glint::cli {

/// Makes SIGINT, SIGTERM and SIGHUP remove the unfinished file and then end the program, as they do by
/// default (a shell calls that 130, 143 and 129), and turns the signals of failed writes into errors of the
/// writing calls.
void handle_signals();

/// The file that an interruption removes, while this lives.
class UnfinishedFile {
  public:
    explicit UnfinishedFile(const std::string& path);
    ~UnfinishedFile();
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;
};

/// Whether an interruption has a progress bar to erase.
void set_progress_shown(bool shown);

}  // namespace glint::cli
