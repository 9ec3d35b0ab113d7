// SPDX-License-Identifier: Apache-2.0
#include "os/process.h"

#include <fcntl.h>
#include <io.h>
#include <windows.h>
// After windows.h, which they need.
#include <psapi.h>
#include <shellapi.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include "os/files.h"
#include "os/windows/wide.h"

namespace glint::os {
namespace {

int (*clean_up_at_end)(Ending) = nullptr;

constexpr unsigned k_ended_by_interrupt = 130, k_ended_by_closing = 143,
                   k_broken_pipe = 141;  // as on other systems

// Windows calls it on a thread of its own. Returning TRUE would leave the program running.
BOOL WINAPI end_at_once(DWORD event) {
    const bool is_interrupt = event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT;
    clean_up_at_end(is_interrupt ? Ending::interrupt : Ending::other);
    TerminateProcess(GetCurrentProcess(), is_interrupt ? k_ended_by_interrupt : k_ended_by_closing);
    return TRUE;
}

// Consoles of Windows 10 and later.
bool obeys_escapes(int descriptor) {
    DWORD mode = 0;
    const HANDLE handle = handle_of(descriptor);
    return GetConsoleMode(handle, &mode) && SetConsoleMode(handle, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
}

}  // namespace

std::vector<std::string> arguments(int count, char** values) {
    std::vector<std::string> texts;
    int words = 0;
    if (LPWSTR* const wide = CommandLineToArgvW(GetCommandLineW(), &words)) {
        for (int i = 0; i < words; ++i) texts.push_back(to_utf8(wide[i]));
        LocalFree(wide);
    } else {
        texts.assign(values, values + count);
    }
    for (std::string& text : texts) std::replace(text.begin(), text.end(), '\\', '/');
    return texts;
}

std::string name_of_program(std::string file) {
    std::transform(file.begin(), file.end(), file.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
    if (file.ends_with(".exe")) file.resize(file.size() - 4);
    return file;
}

void prepare_streams() {
    for (std::FILE* const stream : {stdin, stdout, stderr}) _setmode(_fileno(stream), _O_BINARY);
    static const UINT users_page = GetConsoleOutputCP();
    SetConsoleOutputCP(CP_UTF8);
    std::atexit([] { SetConsoleOutputCP(users_page); });
    for (const int descriptor : {k_standard_output, k_standard_error}) obeys_escapes(descriptor);
}

bool is_terminal(int descriptor) {
    DWORD mode = 0;
    return GetConsoleMode(handle_of(descriptor), &mode) != FALSE;
}

bool can_redraw(int descriptor) { return obeys_escapes(descriptor); }

int terminal_columns(int descriptor) {
    CONSOLE_SCREEN_BUFFER_INFO about;
    if (!GetConsoleScreenBufferInfo(handle_of(descriptor), &about)) return 80;
    return about.srWindow.Right - about.srWindow.Left + 1;
}

void on_ending(int (*clean_up)(Ending)) {
    clean_up_at_end = clean_up;
    SetConsoleCtrlHandler(end_at_once, TRUE);
}

// Nothing else makes writing to a pipe fail with EINVAL, which the C library makes of all that it does not
// know.
bool reader_is_gone(int error) {
    return (error == 0 || error == EINVAL || error == EPIPE) &&
           GetFileType(handle_of(k_standard_output)) == FILE_TYPE_PIPE;
}

void end_by_broken_pipe() { std::_Exit(k_broken_pipe); }

std::uint64_t peak_memory() {
    PROCESS_MEMORY_COUNTERS counters{};
    counters.cb = sizeof counters;
    return K32GetProcessMemoryInfo(GetCurrentProcess(), &counters, sizeof counters)
               ? counters.PeakWorkingSetSize
               : 0;
}

double physical_memory() {
    MEMORYSTATUSEX status{};
    status.dwLength = sizeof status;
    return GlobalMemoryStatusEx(&status) ? static_cast<double>(status.ullTotalPhys) : 0;
}

std::filesystem::path program() {
    std::wstring path(32768, L'\0');
    path.resize(GetModuleFileNameW(nullptr, path.data(), static_cast<DWORD>(path.size())));
    return path;
}

}  // namespace glint::os
