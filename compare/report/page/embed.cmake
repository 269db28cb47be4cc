# SPDX-License-Identifier: MIT
# Makes one page of page.html, the style sheets, the scripts and the chart library, and a C++ source that holds it.
# In: PAGE_DIR, SCRIPTS (separated by commas), DYGRAPHS_JS, DYGRAPHS_CSS, OUTPUT.

cmake_minimum_required(VERSION 3.22)

function(read_inline file variable)
    file(READ "${file}" text)
    # A browser would ask for the source map over the network, where there is none.
    string(REGEX REPLACE "(//|/\\*)# sourceMappingURL=[^\n]*" "" text "${text}")
    set(${variable} "${text}" PARENT_SCOPE)
endfunction()

read_inline("${PAGE_DIR}/page.html" page)
read_inline("${PAGE_DIR}/page.css" page_style)
read_inline("${PAGE_DIR}/overview.css" overview_style)
read_inline("${PAGE_DIR}/scene.css" scene_style)
read_inline("${PAGE_DIR}/lab.css" lab_style)
read_inline("${DYGRAPHS_CSS}" chart_style)
read_inline("${DYGRAPHS_JS}" chart_library)
set(scripts "")
string(REPLACE "," ";" script_names "${SCRIPTS}")
foreach(name IN LISTS script_names)
    read_inline("${PAGE_DIR}/${name}" script)
    string(APPEND scripts "${script}\n")
endforeach()
foreach(text IN ITEMS "${chart_library}" "${scripts}")
    if(text MATCHES "</script")
        message(FATAL_ERROR "a script of the report contains </script, and would end too early in the page")
    endif()
endforeach()

string(REPLACE "@@style@@" "${chart_style}\n${page_style}\n${overview_style}\n${scene_style}\n${lab_style}"
    page "${page}")
string(REPLACE "@@charts@@" "${chart_library}" page "${page}")
string(REPLACE "@@scripts@@" "${scripts}" page "${page}")

# As numbers: a string literal this long is too much for some compilers, and would need escapes.
string(HEX "${page}" bytes)
string(REGEX REPLACE "(................................................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE "${OUTPUT}" "// Made by compare/report/page/embed.cmake.
#include <compare/report/page.h>

namespace plumb::compare {
namespace {

constexpr unsigned char bytes[] = {
${bytes}};

}  // namespace

std::string_view page() {
    return {reinterpret_cast<const char*>(bytes), sizeof(bytes)};
}

}  // namespace plumb::compare
")
