# SPDX-License-Identifier: MIT
# Makes one page of its parts. In: PAGE, SCENE, STYLES and SCRIPTS (separated by commas), CHARTS, OUTPUT.

cmake_minimum_required(VERSION 3.22)

function(read_inline files variable)
    set(text "")
    string(REPLACE "," ";" files "${files}")
    foreach(file IN LISTS files)
        file(READ "${file}" part)
        string(APPEND text "${part}\n")
    endforeach()
    # A browser would ask for the source map over the network, where there is none.
    string(REGEX REPLACE "(//|/\\*)# sourceMappingURL=[^\n]*" "" text "${text}")
    set(${variable} "${text}" PARENT_SCOPE)
endfunction()

read_inline("${PAGE}" page)
read_inline("${SCENE}" scene)
read_inline("${STYLES}" style)
read_inline("${CHARTS}" charts)
read_inline("${SCRIPTS}" scripts)
foreach(text IN ITEMS "${charts}" "${scripts}")
    if(text MATCHES "</script")
        message(FATAL_ERROR "a script of ${PAGE} contains </script, and would end too early in the page")
    endif()
endforeach()

foreach(part scene style charts scripts)
    string(REPLACE "@@${part}@@" "${${part}}" page "${page}")
endforeach()
file(WRITE "${OUTPUT}" "${page}")
