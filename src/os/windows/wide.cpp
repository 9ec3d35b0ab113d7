// SPDX-License-Identifier: Apache-2.0
#include "os/windows/wide.h"

#include <io.h>
#include <windows.h>

#include <algorithm>
#include <cerrno>

namespace glint::os {

std::wstring to_wide(std::string_view text) {
    std::wstring wide(text.size(), L'\0');
    const int count = MultiByteToWideChar(CP_UTF8, 0, text.data(), static_cast<int>(text.size()), wide.data(),
                                          static_cast<int>(wide.size()));
    wide.resize(static_cast<std::size_t>(std::max(count, 0)));
    return wide;
}

std::string to_utf8(std::wstring_view text) {
    std::string bytes(3 * text.size(), '\0');
    const int count = WideCharToMultiByte(CP_UTF8, 0, text.data(), static_cast<int>(text.size()),
                                          bytes.data(), static_cast<int>(bytes.size()), nullptr, nullptr);
    bytes.resize(static_cast<std::size_t>(std::max(count, 0)));
    return bytes;
}

std::wstring system_path(std::string_view path) {
    if (path == "/dev/null") return L"NUL";
    const std::wstring wide = to_wide(path);
    constexpr std::size_t longest = 240;  // a folder's path must leave room for a name of 12 characters
    std::wstring whole(GetFullPathNameW(wide.c_str(), 0, nullptr, nullptr), L'\0');
    whole.resize(GetFullPathNameW(wide.c_str(), static_cast<DWORD>(whole.size()), whole.data(), nullptr));
    return whole.size() < longest || whole.starts_with(L"\\\\") ? wide : L"\\\\?\\" + whole;
}

void* handle_of(int descriptor) { return reinterpret_cast<void*>(_get_osfhandle(descriptor)); }

void set_errno() {
    switch (GetLastError()) {
        case ERROR_FILE_NOT_FOUND:
        case ERROR_PATH_NOT_FOUND:
        case ERROR_INVALID_NAME:
        case ERROR_INVALID_DRIVE:
        case ERROR_BAD_NETPATH:
            errno = ENOENT;
            break;
        case ERROR_FILE_EXISTS:
        case ERROR_ALREADY_EXISTS:
            errno = EEXIST;
            break;
        case ERROR_ACCESS_DENIED:
        case ERROR_SHARING_VIOLATION:
        case ERROR_WRITE_PROTECT:
            errno = EACCES;
            break;
        case ERROR_LOCK_VIOLATION:
        case ERROR_IO_PENDING:
            errno = EWOULDBLOCK;
            break;
        case ERROR_TOO_MANY_OPEN_FILES:
            errno = EMFILE;
            break;
        case ERROR_DISK_FULL:
        case ERROR_HANDLE_DISK_FULL:
            errno = ENOSPC;
            break;
        case ERROR_BROKEN_PIPE:
        case ERROR_NO_DATA:
            errno = EPIPE;
            break;
        case ERROR_NOT_ENOUGH_MEMORY:
        case ERROR_OUTOFMEMORY:
            errno = ENOMEM;
            break;
        default:
            errno = EIO;
    }
}

}  // namespace glint::os
