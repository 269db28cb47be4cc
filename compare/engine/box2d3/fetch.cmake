# SPDX-License-Identifier: MIT
# Brings Box2D 3.2 here and builds it, once, in a build of its own: it calls itself box2d, as Box2D 2.4 does.
include(FetchContent)
include(CheckCXXSourceRuns)

# The newest of version 3.2 that was compared with.
if(NOT DEFINED PLUMB_BOX2D3_COMMIT)
    set(PLUMB_BOX2D3_COMMIT 617d32ab02570930625bbcb8479f54be9bf8d045)
endif()

set(PLUMB_BOX2D3_GIT "https://github.com/erincatto/box2d.git" CACHE STRING "Where Box2D 3 is fetched from, or a mirror")
if(NOT "$ENV{PLUMB_BOX2D3_GIT}" STREQUAL "")
    set_property(CACHE PLUMB_BOX2D3_GIT PROPERTY VALUE "$ENV{PLUMB_BOX2D3_GIT}")
endif()

# Nobody waits for a network that is not there.
function(plumb_box2d3_is_there result)
    find_package(Git QUIET)
    set(${result} FALSE PARENT_SCOPE)
    if(NOT GIT_FOUND)
        return()
    endif()
    execute_process(COMMAND ${CMAKE_COMMAND} -E env GIT_TERMINAL_PROMPT=0 "${GIT_EXECUTABLE}" ls-remote -q
                            "${PLUMB_BOX2D3_GIT}" HEAD
                    TIMEOUT 8 RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
    if(status EQUAL 0)
        set(${result} TRUE PARENT_SCOPE)
    endif()
endfunction()

function(plumb_run_or_stop what)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "Box2D 3 from ${PLUMB_BOX2D3_GIT}: it could not be ${what}; PLUMB_FETCH_BOX2D3=OFF goes on without it.\n${said}")
    endif()
endfunction()

string(SUBSTRING "${PLUMB_BOX2D3_COMMIT}" 0 8 shortCommit)
set(box2d3Folder "box2d3-${shortCommit}")

# Sets result to the folder with its sources; to "" where they cannot be fetched.
function(plumb_fetch_box2d3_source result)
    set(root "${FETCHCONTENT_BASE_DIR}/${box2d3Folder}")
    set(${result} "${root}/source" PARENT_SCOPE)
    if(EXISTS "${root}/source/src/body.c")
        return()
    endif()
    plumb_box2d3_is_there(isThere)
    if(NOT isThere)
        set(${result} "" PARENT_SCOPE)
        return()
    endif()
    message(STATUS "Box2D 3: fetching ${shortCommit} from ${PLUMB_BOX2D3_GIT}")
    FetchContent_Populate(box2d3 QUIET GIT_REPOSITORY "${PLUMB_BOX2D3_GIT}" GIT_TAG ${PLUMB_BOX2D3_COMMIT}
                          SOURCE_DIR "${root}/source" BINARY_DIR "${root}/build" SUBBUILD_DIR "${root}/fetch")
endfunction()

# Sets result to the folder in which Box2D 3 is installed; to "" where it cannot be fetched.
function(plumb_fetch_box2d3 result)
    set(root "${FETCHCONTENT_BASE_DIR}/${box2d3Folder}")
    set(${result} "${root}/installed" PARENT_SCOPE)
    if(EXISTS "${root}/installed/lib/cmake/box2d/box2dConfig.cmake")
        return()
    endif()
    plumb_fetch_box2d3_source(source)
    if(NOT source)
        set(${result} "" PARENT_SCOPE)
        return()
    endif()
    # What this machine can run.
    check_cxx_source_runs("int main() { return __builtin_cpu_supports(\"avx2\") ? 0 : 1; }" PLUMB_RUNS_AVX2)
    set(avx2 OFF)
    if(PLUMB_RUNS_AVX2)
        set(avx2 ON)
    endif()
    file(REMOVE_RECURSE "${root}/build")  # of an attempt that failed
    plumb_run_or_stop(configured "${CMAKE_COMMAND}" -S "${root}/source" -B "${root}/build" -G "${CMAKE_GENERATOR}"
                      -DCMAKE_BUILD_TYPE=Release "-DBOX2D_AVX2=${avx2}" -DBOX2D_VALIDATE=OFF
                      -DBOX2D_SAMPLES=OFF -DBOX2D_UNIT_TESTS=OFF -DBOX2D_BENCHMARKS=OFF
                      "-DCMAKE_INSTALL_PREFIX=${root}/installed")
    plumb_run_or_stop(built "${CMAKE_COMMAND}" --build "${root}/build" --parallel)
    plumb_run_or_stop(installed "${CMAKE_COMMAND}" --install "${root}/build")
endfunction()
