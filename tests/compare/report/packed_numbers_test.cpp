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
    CHECK(packNumbers(std::vector{1.0}) == "AAAAAAAA8D8=");  // 00 00 00 00 00 00 f0 3f
}

TEST_CASE("doubles come back to the last bit, and a block's floats to seven digits", "[compare][report]") {
    const std::vector<double> numbers{0.1, -9.81, 5e-324, 1.7976931348623157e308, 1.0 / 3};
    CHECK(unpackedDoubles(packNumbers(numbers)) == numbers);
    PackedBlock block;
    block.addFloats(numbers);
    const std::vector<double> few = UnpackedBlock(block.text()).floats(0, 5);
    // Half a unit in the last of a float's 24 bits.
    CHECK(std::abs(few[1] + 9.81) <= 9.81 * 0x1p-24);
    CHECK(std::abs(few[4] - 1.0 / 3) <= 0x1p-24 / 3);
}

TEST_CASE("what a float cannot hold becomes infinite, and what is not a number stays so", "[compare][report]") {
    const double none = std::numeric_limits<double>::quiet_NaN();
    PackedBlock block;
    block.addFloats(std::vector{1e300, -1e300, none});
    const std::vector<double> packed = UnpackedBlock(block.text()).floats(0, 3);
    CHECK(packed[0] == std::numeric_limits<double>::infinity());
    CHECK(packed[1] == -std::numeric_limits<double>::infinity());
    CHECK(std::isnan(packed[2]));
}

TEST_CASE("a block's steps come back to half a step, whatever came before them in it", "[compare][report]") {
    PackedBlock block;
    block.addFloats(std::vector{1.0, 2.0});
    const PackedPart part = block.addSteps(std::vector{0.0, 1.26, -3.0, 1e9}, 0.5);
    CHECK(part.first == 2);
    CHECK(part.count == 4);
    const UnpackedBlock read(block.text());
    CHECK(read.floats(0, 2) == std::vector{1.0, 2.0});
    CHECK(read.steps(2, 4, 0.5) == std::vector{0.0, 1.5, -3.0, 1e9});
}

TEST_CASE("what is 2^31 steps off or no number reads back as none, and what follows it is right", "[compare][report]") {
    PackedBlock block;
    block.addSteps(std::vector{1.0, 0x1p31, std::numeric_limits<double>::quiet_NaN(), -2.0}, 1);
    const std::vector<double> read = UnpackedBlock(block.text()).steps(0, 4, 1);
    CHECK(read[0] == 1);
    CHECK(std::isnan(read[1]));
    CHECK(std::isnan(read[2]));
    CHECK(read[3] == -2);
}

// Its first two words say where it starts and how fast; the other 9,998 are 0, which zlib makes about 1,000 times
// smaller.
TEST_CASE("10,000 positions at constant speed take less than 200 characters", "[compare][report]") {
    std::vector<double> positions;
    for (int i = 0; i < 10'000; ++i) positions.push_back(3 * i);
    PackedBlock block;
    block.addSteps(positions, 1);
    CHECK(block.text().size() < 200);
}

}  // namespace plumb::compare
