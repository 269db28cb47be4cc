# SPDX-License-Identifier: MIT
# plumb_add_report_page(<target>): gives the target the report's page as a source, which is made again when a part of
# the page changes.

set(PLUMB_REPORT_PAGE_DIR "${CMAKE_CURRENT_LIST_DIR}")

function(plumb_add_report_page target)
    set(styles lab.css)
    set(scripts packed.js lab_chart.js lab_page.js search.js overview.js address.js main.js)
    list(TRANSFORM styles PREPEND "${PLUMB_REPORT_PAGE_DIR}/")
    list(TRANSFORM scripts PREPEND "${PLUMB_REPORT_PAGE_DIR}/")
    set(page "${CMAKE_CURRENT_BINARY_DIR}/report_page.html")
    set(output "${CMAKE_CURRENT_BINARY_DIR}/report_page.cpp")
    plumb_assemble_page("${page}" "${PLUMB_REPORT_PAGE_DIR}/page.html" STYLES ${styles} SCRIPTS ${scripts})
    add_custom_command(
        OUTPUT "${output}"
        COMMAND "${CMAKE_COMMAND}" "-DPAGE=${page}" "-DOUTPUT=${output}" -P "${PLUMB_REPORT_PAGE_DIR}/embed.cmake"
        DEPENDS "${page}" "${PLUMB_REPORT_PAGE_DIR}/embed.cmake"
        VERBATIM)
    target_sources(${target} PRIVATE "${output}")
endfunction()
