# SPDX-License-Identifier: MIT
# How is a page that shows scenes put together? Its own HTML, styles and scripts are joined with those that all such
# pages share, and with their chart library: dygraphs 2 (MIT), taken from where a package installed it.

set(PLUMB_VIEW_DIR "${CMAKE_CURRENT_LIST_DIR}/..")

# In this order: a script may use the scripts before it at once, and those after it once the page runs.
set(PLUMB_VIEW_SCRIPTS
    page/words.js page/dom.js page/bytes.js page/format.js page/formula.js page/engines.js page/data.js
    stage/pose.js stage/camera.js stage/paper.js stage/field.js stage/still.js stage/path.js
    stage/quantities.js stage/arrows.js stage/tools.js stage/readout.js stage/aim.js stage/stage.js stage/picture.js
    page/player.js page/curves.js page/limits.js page/chart.js page/charts.js page/csv.js page/numbers.js
    page/controls.js page/switches.js page/partings.js page/scene_page.js)
list(TRANSFORM PLUMB_VIEW_SCRIPTS PREPEND "${PLUMB_VIEW_DIR}/")
set(PLUMB_VIEW_STYLES page/page.css page/overview.css page/scene.css)
list(TRANSFORM PLUMB_VIEW_STYLES PREPEND "${PLUMB_VIEW_DIR}/")

# Where they are is in PLUMB_DYGRAPHS_JS and PLUMB_DYGRAPHS_CSS.
function(plumb_find_dygraphs)
    foreach(kind js css)
        string(TOUPPER ${kind} KIND)
        find_file(PLUMB_DYGRAPHS_${KIND} dygraph.min.${kind}
            PATHS ${CMAKE_SYSTEM_PREFIX_PATH} /usr
            PATH_SUFFIXES share/javascript/dygraphs share/nodejs/dygraphs/dist lib/node_modules/dygraphs/dist
            DOC "dygraphs, the chart library of pages")
    endforeach()
endfunction()

# In PLUMB_KATEX is the folder of KaTeX, which sets formulas.
function(plumb_find_katex)
    find_path(PLUMB_KATEX katex.min.js
        PATHS ${CMAKE_SYSTEM_PREFIX_PATH} /usr
        PATH_SUFFIXES share/javascript/katex share/nodejs/katex/dist lib/node_modules/katex/dist
        DOC "KaTeX, which sets the formulas of lessons")
endfunction()

# plumb_assemble_page(<output> <page> STYLES ... SCRIPTS ... [LESSONS ... WORDS ... SLIDES ...]): what the page has beside what all
# share. In the page @@style@@, @@scene@@, @@charts@@ and @@scripts@@ say where each goes; of one with lessons, also
# @@lessons@@, @@words@@, @@slides@@, @@katex@@ and @@katex_style@@.
function(plumb_assemble_page output page)
    cmake_parse_arguments(own "" "SLIDES" "STYLES;SCRIPTS;LESSONS;WORDS" ${ARGN})
    set(styles "${PLUMB_DYGRAPHS_CSS}" ${PLUMB_VIEW_STYLES} ${own_STYLES})
    set(scripts ${PLUMB_VIEW_SCRIPTS} ${own_SCRIPTS})
    list(JOIN styles "," style_names)
    list(JOIN scripts "," script_names)
    set(lessons "")
    if(own_LESSONS)
        list(JOIN own_LESSONS "," lesson_names)
        list(JOIN own_WORDS "," word_names)
        set(lessons "-DKATEX=${PLUMB_KATEX}" "-DLESSONS=${lesson_names}" "-DWORDS=${word_names}" "-DSLIDES=${own_SLIDES}")
    endif()
    add_custom_command(
        OUTPUT "${output}"
        COMMAND "${CMAKE_COMMAND}" "-DPAGE=${page}" "-DSCENE=${PLUMB_VIEW_DIR}/page/scene.html"
            "-DSTYLES=${style_names}" "-DCHARTS=${PLUMB_DYGRAPHS_JS}" "-DSCRIPTS=${script_names}"
            "-DOUTPUT=${output}" ${lessons} -P "${PLUMB_VIEW_DIR}/page/assemble.cmake"
        DEPENDS "${page}" "${PLUMB_VIEW_DIR}/page/scene.html" "${PLUMB_VIEW_DIR}/page/assemble.cmake" ${styles}
            ${scripts} "${PLUMB_DYGRAPHS_JS}" ${own_LESSONS} ${own_WORDS} ${own_SLIDES}
        COMMENT "Putting together ${output}"
        VERBATIM)
endfunction()
