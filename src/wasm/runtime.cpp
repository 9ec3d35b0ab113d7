// SPDX-License-Identifier: Apache-2.0
// Functions that Debian's C++ runtime for WebAssembly lacks.

/// Registers the destructor of a thread_local object. There is one thread and it never ends.
extern "C" int __cxa_thread_atexit(void (*)(void*), void*, void*) {
    return 0;
}  // NOLINT(bugprone-reserved-identifier)
