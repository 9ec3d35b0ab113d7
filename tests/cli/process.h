// SPDX-License-Identifier: Apache-2.0
#pragma once
// Runs the real command as a user would: in its own folder, with its outputs captured.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace glint::test {

struct Finished {
    int code = -1;  ///< exit code; 1000 + the signal's number if one ended it
    std::string out, err;
};

/// The command of the build; GLINT_TEST_COMMAND names another, as one for Windows that wine runs
/// (tests/windows).
inline std::string tested_command() {
    const char* other = std::getenv("GLINT_TEST_COMMAND");
    return other != nullptr ? other : GLINT_COMMAND;
}

struct RunOptions {
    std::string input;            ///< standard input
    long largest_file = -1;       ///< bytes that a file may grow to: a full disk
    std::string output_path;      ///< standard output goes to this file instead
    std::string error_path{};     ///< standard error goes to this file instead
    bool reader_is_gone = false;  ///< nobody reads the pipe that is standard output
    long most_memory = -1;        ///< bytes of address space
    std::string program = tested_command();
};

/// A temporary folder; the destructor removes it.
class Folder {
  public:
    Folder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "glint_cli_XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    const std::string& path() const { return path_; }
    std::string path(const std::string& name) const { return path_ + "/" + name; }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
    }
    std::string read(const std::string& name) const {
        std::ifstream in(path(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    }
    bool has(const std::string& name) const { return std::filesystem::exists(path(name)); }
    /// Files in it, hidden ones too.
    long count() const {
        return std::distance(std::filesystem::directory_iterator(path_),
                             std::filesystem::directory_iterator());
    }

  private:
    std::string path_;
};

/// A started command.
class Process {
  public:
    Process(const Folder& folder, const std::vector<std::string>& arguments, const RunOptions& options = {}) {
        int in[2], out[2], err[2];
        if (::pipe(in) != 0 || ::pipe(out) != 0 || ::pipe(err) != 0) std::abort();
        std::vector<char*> argv{const_cast<char*>(options.program.c_str())};
        for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
        argv.push_back(nullptr);
        if (options.reader_is_gone) ::close(out[0]);
        id_ = ::fork();
        if (id_ == 0) {
            if (!options.output_path.empty()) {
                out[1] = ::open(options.output_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
            }
            if (!options.error_path.empty()) err[1] = ::open(options.error_path.c_str(), O_WRONLY);
            ::dup2(in[0], 0);
            ::dup2(out[1], 1);
            ::dup2(err[1], 2);
            for (int fd = 3; fd < 64; ++fd) ::close(fd);
            if (::chdir(folder.path().c_str()) != 0) ::_exit(99);
            if (options.largest_file >= 0) {
                const auto most = static_cast<rlim_t>(options.largest_file);
                const rlimit limit{most, most};
                ::setrlimit(RLIMIT_FSIZE, &limit);
            }
            if (options.most_memory >= 0) {
                const auto most = static_cast<rlim_t>(options.most_memory);
                const rlimit limit{most, most};
                ::setrlimit(RLIMIT_AS, &limit);
            }
            ::execv(options.program.c_str(), argv.data());
            ::_exit(99);
        }
        ::close(in[0]);
        ::close(out[1]);
        ::close(err[1]);
        in_ = in[1];
        out_ = options.reader_is_gone ? -1 : out[0];
        err_ = err[0];
        input_ = options.input;
    }

    int id() const { return id_; }

    /// Writes to standard input and reads both outputs to their ends.
    Finished finish() {
        Finished result;
        ::signal(SIGPIPE, SIG_IGN);
        std::size_t fed = 0;
        if (input_.empty()) close_input();
        bool open[2] = {out_ >= 0, true};
        while (open[0] || open[1]) {
            pollfd files[3] = {
                {open[0] ? out_ : -1, POLLIN, 0}, {open[1] ? err_ : -1, POLLIN, 0}, {in_, POLLOUT, 0}};
            ::poll(files, 3, -1);
            for (int i = 0; i < 2; ++i) {
                if (files[i].revents == 0) continue;
                char buffer[65536];
                const ssize_t count = ::read(files[i].fd, buffer, sizeof buffer);
                if (count <= 0) {
                    open[i] = false;
                } else {
                    (i == 0 ? result.out : result.err).append(buffer, static_cast<std::size_t>(count));
                }
            }
            if (in_ >= 0 && files[2].revents != 0) {
                const std::size_t step = std::min<std::size_t>(input_.size() - fed, 4096);
                const ssize_t count = ::write(in_, input_.data() + fed, step);
                if (count > 0) fed += static_cast<std::size_t>(count);
                if (count <= 0 || fed == input_.size()) close_input();
            }
        }
        close_input();
        int status = 0;
        ::waitpid(id_, &status, 0);
        result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
        if (out_ >= 0) ::close(out_);
        ::close(err_);
        return result;
    }

  private:
    void close_input() {
        if (in_ >= 0) ::close(in_);
        in_ = -1;
    }
    pid_t id_ = -1;
    int in_ = -1, out_ = -1, err_ = -1;
    std::string input_;
};

inline Finished run(const Folder& folder, const std::vector<std::string>& arguments,
                    const RunOptions& options = {}) {
    return Process(folder, arguments, options).finish();
}

inline RunOptions with_input(std::string text) { return {std::move(text), -1, {}}; }
inline RunOptions with_full_disk(long bytes) { return {{}, bytes, {}}; }
inline RunOptions with_output_to(std::string path) { return {{}, -1, std::move(path)}; }

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// One red sphere under two lights.
inline const char* const k_scene =
    R"(sphere { center = (0, 0, 4)  radius = 1  color = (255, 0, 0)  specular = 500  reflective = 0.2 }
light { type = ambient  intensity = 0.2 }
light { type = point  intensity = 0.8  position = (2, 1, 0) }
)";

}  // namespace glint::test
