// SPDX-License-Identifier: MIT
#include <compare/report/packed_numbers.h>

#include <cmath>
#include <limits>
#include <vector>

#include "catch.h"
#include "unpacked.h"

namespace plumb::compare {
namespace {

std::string base64Of(const std::string& text) {
    return base64(std::vector<std::uint8_t>(text.begin(), text.end()));
}

}  // namespace

TEST_CASE("base64 gives RFC 4648's seven test vectors", "[compare][report]") {
    CHECK(base64Of("") == "");
    CHECK(base64Of("f") == "Zg==");
    CHECK(base64Of("fo") == "Zm8=");
    CHECK(base64Of("foo") == "Zm9v");
    CHECK(base64Of("foob") == "Zm9vYg==");
    CHECK(base64Of("fooba") == "Zm9vYmE=");
    CHECK(base64Of("foobar") == "Zm9vYmFy");
}

TEST_CASE("1 is packed as the bytes of IEEE 754, the least first", "[compare][report]") {
    CHECK(packNumbers(std::vector{1.0}, NumberWidth::Float64) == "AAAAAAAA8D8=");  // 00 00 00 00 00 00 f0 3f
    CHECK(packNumbers(std::vector{1.0}, NumberWidth::Float32) == "AACAPw==");      // 00 00 80 3f
}

TEST_CASE("doubles come back to the last bit, and floats to seven digits", "[compare][report]") {
    const std::vector<double> numbers{0.1, -9.81, 5e-324, 1.7976931348623157e308, 1.0 / 3};
    CHECK(unpackedDoubles(packNumbers(numbers, NumberWidth::Float64)) == numbers);
    const std::vector<double> few = unpackedFloats(packNumbers(numbers, NumberWidth::Float32));
    REQUIRE(few.size() == 5);
    // Half a unit in the last of a float's 24 bits.
    CHECK(std::abs(few[1] + 9.81) <= 9.81 * 0x1p-24);
    CHECK(std::abs(few[4] - 1.0 / 3) <= 0x1p-24 / 3);
}

TEST_CASE("what a float cannot hold becomes infinite, and what is not a number stays so", "[compare][report]") {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> numbers{1e300, -1e300, none};
    const std::vector<double> packed = unpackedFloats(packNumbers(numbers, NumberWidth::Float32));
    REQUIRE(packed.size() == 3);
    CHECK(packed[0] == std::numeric_limits<double>::infinity());
    CHECK(packed[1] == -std::numeric_limits<double>::infinity());
    CHECK(std::isnan(packed[2]));
}

}  // namespace plumb::compare
