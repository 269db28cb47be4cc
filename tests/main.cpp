// SPDX-License-Identifier: MIT
// A main of our own: the two versions of Catch2 offer theirs in different ways.
#define CATCH_CONFIG_RUNNER
#include "catch.h"

// Asked by LeakSanitizer: fontconfig, which the games' texts need, keeps memory by offsets, in which that sees no
// pointers.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libfontconfig\n";
}

int main(int argc, char** argv) {
    return Catch::Session().run(argc, argv);
}
