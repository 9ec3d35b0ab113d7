# SPDX-License-Identifier: Apache-2.0
# The browser build: Debian's clang 14 for wasm32-wasi (lld-14, wasi-libc, libc++-14-dev-wasm32, libc++abi-14-dev-wasm32,
# libclang-rt-14-dev-wasm32).
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-14)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_AR llvm-ar-14)
set(CMAKE_RANLIB llvm-ranlib-14)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# clang's default include folders end with the host's /usr/include, so a header that wasi-libc lacks would be taken from
# glibc. Therefore the folders are listed here, in clang's order: libc++, the compiler's own, wasi-libc.
# Nothing asks for types at run time, and there is one thread: without what these need, the compressed file is 1% smaller.
set(CMAKE_CXX_FLAGS_INIT "-nostdlibinc -isystem /usr/include/wasm32-wasi/c++/v1 -idirafter /usr/include/wasm32-wasi \
-msimd128 -fno-exceptions -fno-rtti -fno-threadsafe-statics")
# A reactor: no main, the host calls the exported functions. The stack is 1 MiB, below the data, so that a stack overflow
# traps and does not overwrite data.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wno-unused-command-line-argument -mexec-model=reactor -Wl,--stack-first -Wl,-z,stack-size=1048576")

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
