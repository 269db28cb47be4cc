# SPDX-License-Identifier: MIT
# The toolchain for WebAssembly: Clang 22 with its C++ library, as Debian packages them (.setup/packages.txt,
# section web). cmake --preset web uses it. What it builds runs in browsers, and in Node by means of run.mjs.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)

find_program(PLUMB_WASM_CLANG NAMES clang++-22 REQUIRED)
find_program(PLUMB_WASM_CLANG_C NAMES clang-22 REQUIRED)
find_program(PLUMB_WASM_AR NAMES llvm-ar-22 llvm-ar REQUIRED)  # GNU's ar writes no index of WebAssembly
find_program(PLUMB_WASM_RANLIB NAMES llvm-ranlib-22 llvm-ranlib REQUIRED)
find_program(PLUMB_NODE NAMES node nodejs REQUIRED)
set(CMAKE_CXX_COMPILER "${PLUMB_WASM_CLANG}")
set(CMAKE_C_COMPILER "${PLUMB_WASM_CLANG_C}")
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_AR "${PLUMB_WASM_AR}")
set(CMAKE_RANLIB "${PLUMB_WASM_RANLIB}")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)  # nothing is linked before the runtime is there
set(CMAKE_CROSSCOMPILING_EMULATOR "${PLUMB_NODE}" --no-warnings "${CMAKE_CURRENT_LIST_DIR}/run.mjs")
set(CMAKE_EXECUTABLE_SUFFIX .wasm)
set(CMAKE_EXECUTABLE_SUFFIX_CXX .wasm)

# Four lanes, exceptions, and Debian's triple without a warning of its age.
set(CMAKE_CXX_FLAGS_INIT "-msimd128 -fwasm-exceptions -Wno-deprecated")
set(CMAKE_C_FLAGS_INIT "-msimd128 -Wno-deprecated")

# The driver looks for its builtins in another folder than Debian's.
execute_process(COMMAND "${PLUMB_WASM_CLANG}" -print-resource-dir OUTPUT_VARIABLE resources
                OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nodefaultlibs -Wl,--gc-sections,-z,stack-size=1048576")
set(CMAKE_CXX_STANDARD_LIBRARIES "-lc++ -lc++abi -lc ${resources}/lib/wasi/libclang_rt.builtins-wasm32.a")

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
list(APPEND CMAKE_PREFIX_PATH /usr)  # Eigen is headers alone
