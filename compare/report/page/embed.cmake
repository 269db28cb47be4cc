# SPDX-License-Identifier: MIT
# Makes a C++ source that holds the page. In: PAGE, OUTPUT.

cmake_minimum_required(VERSION 3.22)

# As numbers: a string literal this long is too much for some compilers, and would need escapes.
file(READ "${PAGE}" bytes HEX)
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
