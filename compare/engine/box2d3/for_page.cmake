# SPDX-License-Identifier: MIT
# Box2D 3 in WebAssembly, for a page: from the sources that the build for this machine has fetched, else fetched here.
# Without them the page has one engine less. It is compiled as for a machine that it does not know: without threads and
# without SIMD of its own.
include(fetch.cmake)
set(source "${PROJECT_SOURCE_DIR}/build/release/_deps/${box2d3Folder}/source")
if(NOT EXISTS "${source}/src/body.c")
    set(source "")
    if(PLUMB_FETCH_BOX2D3)
        plumb_fetch_box2d3_source(source)
    endif()
endif()

if(source)
    message(STATUS "Box2D 3 for a page: from ${source}")
    enable_language(C)
    file(GLOB box2d CONFIGURE_DEPENDS "${source}/src/*.c")
    add_library(box2d3_for_page STATIC EXCLUDE_FROM_ALL ${box2d})
    target_compile_features(box2d3_for_page PRIVATE c_std_17)
    target_compile_options(box2d3_for_page PRIVATE -O2 -ffp-contract=off -w)
    target_include_directories(box2d3_for_page SYSTEM PUBLIC "${source}/include")
    add_library(compare_box2d3 STATIC ${sources})
    target_link_libraries(compare_box2d3 PRIVATE box2d3_for_page)
else()
    message(STATUS "Box2D 3 for a page: not there, the page works without it")
    add_library(compare_box2d3 STATIC box2d3_absent.cpp)
endif()
target_link_libraries(compare_box2d3 PRIVATE compare_core)
