# SPDX-License-Identifier: Apache-2.0
# The command for node: Debian's emscripten, with threads and node's files. -fexceptions: clang 14's own exceptions for
# WebAssembly do not work together with threads.
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
set(CMAKE_CXX_FLAGS_INIT "-include ${CMAKE_CURRENT_LIST_DIR}/wasm32-node-compat.h -pthread -fexceptions -msimd128")
set(CMAKE_C_FLAGS_INIT "-pthread -fexceptions -msimd128")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-sPROXY_TO_PTHREAD -sEXIT_RUNTIME -sNODERAWFS -sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=2147483648")
