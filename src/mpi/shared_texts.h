// SPDX-License-Identifier: Apache-2.0
#pragma once
// The scene's texts: rank 0 reads the files and gives their bytes to the others, which may be on machines
// that do not have the files.
#include <exception>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cli/input_file.h"

namespace glint::mpi {

/// Rank 0: reads files and keeps their bytes until it gives them to the others.
class RecordingReader : public cli::TextReader {
  public:
    std::optional<cli::InputFile> open(const std::string& path, const cli::FileReach& reach,
                                       std::string& why) override;
    /// Gives the others all that was read.
    void give();
    /// Tells the others that there is nothing to render. False if they have been given the texts already.
    bool give_up();

  private:
    std::vector<std::pair<std::string, std::string>> texts_;
    bool given_ = false;
};

/// Rank 0 has nothing to render, and has said why.
class GivenUp : public std::exception {};

/// The others: waits for what rank 0 has read. Throws GivenUp.
class GivenReader : public cli::TextReader {
  public:
    std::optional<cli::InputFile> open(const std::string& path, const cli::FileReach& reach,
                                       std::string& why) override;
    /// For a process that ends before it has opened a text: whether rank 0 gives up, too. Waits for it.
    bool is_given_up();

  private:
    void take();
    std::map<std::string, std::string> texts_;
    bool taken_ = false, given_up_ = false;
};

}  // namespace glint::mpi
