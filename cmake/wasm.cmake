# SPDX-License-Identifier: Apache-2.0
# Toolchain: WebAssembly by Debian's clang 19, for a host without an operating system (a browser, Node.js):
#   cmake -S . -B build/wasm -DCMAKE_TOOLCHAIN_FILE=cmake/wasm.cmake -DAVO_THREADS=OFF -DAVO_CLI=OFF -DAVO_C=OFF
# Packages: clang-19 lld-19 llvm-19 libc++-19-dev-wasm32 libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 wasi-libc
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_AR llvm-ar-19)
set(CMAKE_RANLIB llvm-ranlib-19)
# Sources throw as everywhere. The standard library for WebAssembly cannot unwind: who links has to say what becomes of
# a throw, and no catch is ever reached (core/retell.h).
set(CMAKE_CXX_FLAGS_INIT "-stdlib=libc++ -fexceptions -DAVO_CANNOT_UNWIND")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-mexec-model=reactor")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
