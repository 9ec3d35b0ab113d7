// SPDX-License-Identifier: Apache-2.0
// Functions that Debian's C++ runtime for WebAssembly lacks, or that differ from it.
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include "formats/number_text.h"

/// Registers the destructor of a thread_local object. There is one thread and it never ends.
extern "C" int __cxa_thread_atexit(void (*)(void*), void*, void*) {
    return 0;
}  // NOLINT(bugprone-reserved-identifier)

// libc++ without exceptions would return null, which no caller expects: reads and writes near address 0 are
// no error in WebAssembly. The trap ends the instance (glint.mjs).
void* operator new(std::size_t bytes) {
    if (void* memory = std::malloc(bytes == 0 ? 1 : bytes)) return memory;
    __builtin_trap();
}

void* operator new[](std::size_t bytes) { return operator new(bytes); }

void* operator new(std::size_t bytes, std::align_val_t alignment) {
    const auto unit = static_cast<std::size_t>(alignment);
    if (void* memory = std::aligned_alloc(unit, (bytes + unit - 1) / unit * unit)) return memory;
    __builtin_trap();
}

void* operator new[](std::size_t bytes, std::align_val_t alignment) { return operator new(bytes, alignment); }

// fmt refers to snprintf for the hexadecimal numbers of {:a}, libc++ to vfprintf for the reason why it ends
// the program. Nothing here formats such numbers, and the reason is not seen: without them 5 kB less are
// fetched.
extern "C" int snprintf(char*, std::size_t, const char*, ...) { __builtin_trap(); }
extern "C" int vfprintf(std::FILE*, const char*, std::va_list) { __builtin_trap(); }

// Of JSON's numbers, which have no spaces before them: by what reads all other numbers, 3 kB less.
extern "C" double strtod(const char* text, char** end) {
    double value = 0;
    *end = const_cast<char*>(glint::read_any_number(text, text + std::strlen(text), value));
    return value;
}
// The others of its file, which nothing calls.
extern "C" float strtof(const char*, char**) { __builtin_trap(); }
extern "C" long double strtold(const char*, char**) { __builtin_trap(); }
