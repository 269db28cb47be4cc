// SPDX-License-Identifier: MIT
#include <compare/metric/length_text.h>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {

TEST_CASE("lengths are told in the unit that fits them", "[compare][metric]") {
    CHECK(lengthText(0) == "0 m");
    CHECK(lengthText(2e-16) == "0 m");
    CHECK(lengthText(1.2345) == "1.23 m");
    CHECK(lengthText(0.0417) == "41.7 mm");
    CHECK(lengthText(12.34e-6) == "12.3 µm");
    CHECK(lengthText(5e-9) == "5 nm");
    CHECK(lengthText(3.6e-15) == "4e-15 m");
    CHECK(lengthText(infinity) == "infinite");
}

}  // namespace plumb::compare
