// SPDX-License-Identifier: Apache-2.0
#include "os/files.h"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <regex>

#include "os/windows/wide.h"

namespace glint::os {
namespace {

class Handle {
  public:
    explicit Handle(HANDLE handle) : handle_(handle) {}
    ~Handle() {
        if (is_open()) CloseHandle(handle_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    bool is_open() const { return handle_ != INVALID_HANDLE_VALUE && handle_ != nullptr; }
    HANDLE get() const { return handle_; }

  private:
    HANDLE handle_;
};

// As on other systems, an open file can be renamed and removed.
constexpr DWORD k_shared = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

int open_file(const std::string& path, DWORD access, DWORD creation, int flags) {
    const HANDLE handle = CreateFileW(system_path(path).c_str(), access, k_shared, nullptr, creation,
                                      FILE_ATTRIBUTE_NORMAL, nullptr);
    if (handle == INVALID_HANDLE_VALUE) {
        set_errno();
        return -1;
    }
    const int descriptor =
        _open_osfhandle(reinterpret_cast<intptr_t>(handle), flags | _O_BINARY | _O_NOINHERIT);
    if (descriptor < 0) CloseHandle(handle);
    return descriptor;
}

constexpr FileInfo k_stream{.kind = FileKind::other};

FileInfo info(HANDLE handle) {
    BY_HANDLE_FILE_INFORMATION about;
    if (GetFileType(handle) != FILE_TYPE_DISK) return k_stream;
    if (!GetFileInformationByHandle(handle, &about)) {
        set_errno();
        return {};
    }
    const auto whole = [](DWORD high, DWORD low) { return std::uint64_t{high} << 32 | low; };
    return {.kind = (about.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0 ? FileKind::folder
                                                                             : FileKind::regular,
            .size = whole(about.nFileSizeHigh, about.nFileSizeLow),
            .identity = {about.dwVolumeSerialNumber, whole(about.nFileIndexHigh, about.nFileIndexLow)},
            .has_name = about.nNumberOfLinks > 0};
}

bool is_done(BOOL result) {
    if (!result) set_errno();
    return result != FALSE;
}

bool has_attribute(const std::string& path, DWORD attribute) {
    const DWORD attributes = GetFileAttributesW(system_path(path).c_str());
    if (attributes == INVALID_FILE_ATTRIBUTES) {
        set_errno();
        return false;
    }
    return (attributes & attribute) != 0;
}

}  // namespace

FileInfo info_of(const std::string& path) {
    const Handle file(CreateFileW(system_path(path).c_str(), 0, k_shared, nullptr, OPEN_EXISTING,
                                  FILE_FLAG_BACKUP_SEMANTICS, nullptr));
    if (file.is_open()) return info(file.get());
    set_errno();
    return {};
}

// wine does not know a file that is standard input as one; it can be read nevertheless.
FileInfo info_of(int descriptor) {
    const FileInfo about = info(handle_of(descriptor));
    return about.kind == FileKind::none && descriptor == k_standard_input ? k_stream : about;
}

int open_to_read(const std::string& path) {
    if (info_of(path).kind == FileKind::folder) {
        errno = EISDIR;
        return -1;
    }
    return open_file(path, GENERIC_READ, OPEN_EXISTING, _O_RDONLY);
}
int open_regular(const std::string& path) { return open_to_read(path); }
int open_to_write(const std::string& path) {
    return open_file(path, GENERIC_WRITE, OPEN_EXISTING, _O_WRONLY);
}
int open_new(const std::string& path) {
    return open_file(path, GENERIC_READ | GENERIC_WRITE | DELETE, CREATE_NEW, _O_RDWR);
}
int open_or_make(const std::string& path) {
    return open_file(path, GENERIC_READ | GENERIC_WRITE | DELETE, OPEN_ALWAYS, _O_RDWR);
}
bool close(int descriptor) { return _close(descriptor) == 0; }

constexpr std::size_t k_most_at_once = std::size_t{1} << 28;

std::ptrdiff_t read(int descriptor, char* to, std::size_t size) {
    return _read(descriptor, to, static_cast<unsigned>(std::min(size, k_most_at_once)));
}

bool write(int descriptor, const char* bytes, std::size_t size) {
    while (size > 0) {
        const int count = _write(descriptor, bytes, static_cast<unsigned>(std::min(size, k_most_at_once)));
        if (count < 0) {
            if (errno == EINVAL && GetFileType(handle_of(descriptor)) == FILE_TYPE_PIPE) errno = EPIPE;
            return false;
        }
        bytes += count;
        size -= static_cast<std::size_t>(count);
    }
    return true;
}

bool seek(int descriptor, std::uint64_t position) {
    return _lseeki64(descriptor, static_cast<std::int64_t>(position), SEEK_SET) >= 0;
}

bool resize(int descriptor, std::uint64_t size) {
    FILE_END_OF_FILE_INFO end{};
    end.EndOfFile.QuadPart = static_cast<LONGLONG>(size);
    return is_done(SetFileInformationByHandle(handle_of(descriptor), FileEndOfFileInfo, &end, sizeof end));
}

bool sync(int descriptor) { return is_done(FlushFileBuffers(handle_of(descriptor))); }
void sync_folder(const std::string&) {}

// A lock keeps others from reading what is locked, so it is of a byte that no file has.
bool lock(int descriptor) {
    OVERLAPPED place{};
    place.OffsetHigh = 0x40000000;
    return is_done(LockFileEx(handle_of(descriptor), LOCKFILE_EXCLUSIVE_LOCK | LOCKFILE_FAIL_IMMEDIATELY, 0,
                              1, 0, &place));
}

bool remove(const std::string& path) { return is_done(DeleteFileW(system_path(path).c_str())); }
// Windows has no signals; a thread of its own calls this.
bool remove_now(const char* path) { return remove(path); }

bool replace(const std::string& from, const std::string& to) {
    return is_done(
        MoveFileExW(system_path(from).c_str(), system_path(to).c_str(), MOVEFILE_REPLACE_EXISTING));
}

void copy_permissions(const std::string&, int) {}  // a new file has those of its folder

bool is_link(const std::string& path) { return has_attribute(path, FILE_ATTRIBUTE_REPARSE_POINT); }

bool exists(const std::string& path) {
    return GetFileAttributesW(system_path(path).c_str()) != INVALID_FILE_ATTRIBUTES;
}

bool is_writable(const std::string& path) {
    if (!has_attribute(path, FILE_ATTRIBUTE_READONLY)) return true;
    errno = EACCES;
    return false;
}

// The attribute of a folder says nothing about its files; making the file says it.
bool is_writable_folder(const std::string&) { return true; }

void* map(int descriptor, std::size_t) {
    const Handle mapping(CreateFileMappingW(handle_of(descriptor), nullptr, PAGE_READONLY, 0, 0, nullptr));
    return mapping.is_open() ? MapViewOfFile(mapping.get(), FILE_MAP_READ, 0, 0, 0) : nullptr;
}
void unmap(void* mapped, std::size_t) { UnmapViewOfFile(mapped); }
// Unlocking pages that are not locked takes them out of the working set.
void release(void* mapped, std::size_t size) { VirtualUnlock(mapped, size); }

std::filesystem::path to_path(std::string_view path) { return to_wide(path); }
std::string to_string(const std::filesystem::path& path) {
    std::wstring text = path.wstring();
    if (text.starts_with(L"\\\\?\\")) text.erase(0, 4);
    std::replace(text.begin(), text.end(), L'\\', L'/');
    return to_utf8(text);
}

// The C library's opendir() of a longer path reads another folder.
bool is_too_long(const std::string& folder) { return system_path(folder).starts_with(L"\\\\?\\"); }

// std::filesystem sees neither links nor junctions.
std::filesystem::path followed(const std::string& path) {
    const std::string given = path.empty() ? "." : path;
    const Handle file(CreateFileW(system_path(given).c_str(), 0, k_shared, nullptr, OPEN_EXISTING,
                                  FILE_FLAG_BACKUP_SEMANTICS, nullptr));
    if (file.is_open()) {
        std::wstring found(32768, L'\0');
        found.resize(GetFinalPathNameByHandleW(file.get(), found.data(), static_cast<DWORD>(found.size()),
                                               FILE_NAME_NORMALIZED));
        return to_path(to_string(std::filesystem::path(found)));
    }
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::absolute(to_path(given), error).lexically_normal();
    if (error || !whole.has_relative_path()) return {};
    const std::filesystem::path folder = followed(to_string(whole.parent_path()));
    return folder.empty() ? folder : folder / whole.filename();
}

bool matches(const std::string& name, const std::string& pattern) {
    std::string expression;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const char c = pattern[i];
        const std::size_t end = c == '[' ? pattern.find(']', i + 2) : std::string::npos;
        if (end != std::string::npos) {
            std::string set = pattern.substr(i, end - i + 1);
            if (set[1] == '!') set[1] = '^';
            expression += set;
            i = end;
        } else if (c == '*') {
            expression += ".*";
        } else if (c == '?') {
            expression += '.';
        } else {
            if (std::ispunct(static_cast<unsigned char>(c)) && c != '_') expression += '\\';
            expression += c;
        }
    }
    try {
        return std::regex_match(name, std::regex(expression, std::regex::icase));
    } catch (const std::regex_error&) {
        return false;  // of a set like [z-a]
    }
}

std::string folder_of(const std::string& path) {
    const std::string folder = to_string(to_path(path).parent_path());
    return folder.empty() ? "." : folder;
}

}  // namespace glint::os
