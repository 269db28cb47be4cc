// SPDX-License-Identifier: MIT
// A main of our own: the two versions of Catch2 offer theirs in different ways.
#define CATCH_CONFIG_RUNNER
#include "catch.h"

int main(int argc, char** argv) {
    return Catch::Session().run(argc, argv);
}
