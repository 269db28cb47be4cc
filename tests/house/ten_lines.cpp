// SPDX-License-Identifier: MIT
#include "house/ten_lines.h"

#include <sstream>

#include "catch.h"
#include "house/shell.h"

namespace plumb::test {

// Radius 0.5 on a ground whose top is at 0.5. Contacts are soft: at rest they give by less than a millimetre.
void requireBallAtRest(const std::filesystem::path& program) {
    const Ran ran = shell(quoted(program.string()));
    INFO(ran.output);
    REQUIRE(ran.ok);
    double x = -1, y = -1;
    std::istringstream(ran.output) >> x >> y;
    CHECK(x == 0);
    CHECK_THAT(y, Catch::Matchers::WithinAbs(1, 1e-3));
}

}  // namespace plumb::test
