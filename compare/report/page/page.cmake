# SPDX-License-Identifier: MIT
# plumb_add_report_page(<target>), after plumb_find_dygraphs(): gives the target the report's page as a source, which is
# made again when a part of the page changes.
# The chart library is dygraphs 2 (MIT), taken from where a package installed it.

set(PLUMB_REPORT_PAGE_DIR "${CMAKE_CURRENT_LIST_DIR}")

# In the order of the page: a script may use the scripts before it at once, and those after it once the page runs.
set(PLUMB_REPORT_SCRIPTS
    dom.js format.js formula.js engines.js data.js
    stage/pose.js stage/camera.js stage/paper.js stage/field.js stage/still.js stage/path.js
    stage/arrows.js stage/aim.js stage/stage.js stage/picture.js
    player.js curves.js limits.js chart.js charts.js csv.js numbers.js lab_chart.js lab_page.js search.js overview.js
    controls.js partings.js scene_page.js address.js main.js)

# Where they are is in PLUMB_DYGRAPHS_JS and PLUMB_DYGRAPHS_CSS.
function(plumb_find_dygraphs)
    foreach(kind js css)
        string(TOUPPER ${kind} KIND)
        find_file(PLUMB_DYGRAPHS_${KIND} dygraph.min.${kind}
            PATHS ${CMAKE_SYSTEM_PREFIX_PATH}
            PATH_SUFFIXES share/javascript/dygraphs share/nodejs/dygraphs/dist lib/node_modules/dygraphs/dist
            DOC "dygraphs, the report's chart library")
    endforeach()
endfunction()

function(plumb_add_report_page target)
    set(output "${CMAKE_CURRENT_BINARY_DIR}/report_page.cpp")
    list(TRANSFORM PLUMB_REPORT_SCRIPTS PREPEND "${PLUMB_REPORT_PAGE_DIR}/" OUTPUT_VARIABLE scripts)
    list(JOIN PLUMB_REPORT_SCRIPTS "," script_names)
    add_custom_command(
        OUTPUT "${output}"
        COMMAND "${CMAKE_COMMAND}" "-DPAGE_DIR=${PLUMB_REPORT_PAGE_DIR}" "-DSCRIPTS=${script_names}"
            "-DDYGRAPHS_JS=${PLUMB_DYGRAPHS_JS}" "-DDYGRAPHS_CSS=${PLUMB_DYGRAPHS_CSS}" "-DOUTPUT=${output}"
            -P "${PLUMB_REPORT_PAGE_DIR}/embed.cmake"
        DEPENDS ${scripts} "${PLUMB_REPORT_PAGE_DIR}/page.html" "${PLUMB_REPORT_PAGE_DIR}/page.css"
            "${PLUMB_REPORT_PAGE_DIR}/overview.css" "${PLUMB_REPORT_PAGE_DIR}/scene.css"
            "${PLUMB_REPORT_PAGE_DIR}/lab.css"
            "${PLUMB_REPORT_PAGE_DIR}/embed.cmake" "${PLUMB_DYGRAPHS_JS}" "${PLUMB_DYGRAPHS_CSS}"
        COMMENT "Putting the report's page together"
        VERBATIM)
    target_sources(${target} PRIVATE "${output}")
endfunction()
