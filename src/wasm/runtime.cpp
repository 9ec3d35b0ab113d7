// SPDX-License-Identifier: Apache-2.0
// Functions that Debian's C++ runtime for WebAssembly lacks, or that differ from it.
#include <cstdlib>
#include <new>

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
