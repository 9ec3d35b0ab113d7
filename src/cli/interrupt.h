// SPDX-License-Identifier: Apache-2.0
#pragma once
// Ctrl-C and similar signals: the program ends at once and leaves no incomplete file behind.
#include <string>

namespace glint::cli {

/// Makes SIGINT, SIGTERM and SIGHUP remove the unfinished file and then end the program, as they do by
/// default (shells report 130, 143 and 129). Signals of failed writes become errors of the writing
/// calls.
void handle_signals();

/// A file that a signal removes during the lifetime of this object. At most four at a time; what exceeds this
/// is not removed.
class UnfinishedFile {
  public:
    explicit UnfinishedFile(const std::string& path);
    ~UnfinishedFile();
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;

  private:
    int slot_ = -1;
};

/// What the signal handler prints after "interrupted"; at most 200 bytes.
void set_interrupt_advice(const std::string& advice);

/// Tells the signal handler whether there is a progress bar to erase.
void set_progress_shown(bool shown);

}  // namespace glint::cli
