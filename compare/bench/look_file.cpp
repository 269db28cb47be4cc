// SPDX-License-Identifier: MIT
#include <compare/bench/look_file.h>

#include <array>
#include <cstdint>
#include <stdexcept>

namespace plumb::compare {
namespace {

/// A body's state as it is written in the file.
using Row = std::array<double, 7>;

}  // namespace

LookFile::LookFile() : file_(std::tmpfile()) {
    if (!file_) throw std::runtime_error("bench: the system gives no file for a while");
}

void LookFile::write(const std::vector<BodyState>& states, const Broken& broken) {
    const std::uint64_t counts[] = {states.size(), broken.size()};
    bool written = std::fwrite(counts, sizeof counts, 1, file_.get()) == 1;
    for (const BodyState& state : states) {
        const Row row{state.position.x(),     state.position.y(), state.angle,
                      state.velocity.x(),     state.velocity.y(), state.angularVelocity,
                      state.present ? 1.0 : 0};
        written = written && std::fwrite(row.data(), sizeof row, 1, file_.get()) == 1;
    }
    for (const bool isBroken : broken) written = written && std::fputc(isBroken ? 1 : 0, file_.get()) != EOF;
    if (!written) throw std::runtime_error("bench: no room for the states of a run");
}

bool LookFile::read(std::vector<BodyState>& states, Broken& broken) {
    if (!reading_) std::rewind(file_.get());
    reading_ = true;
    std::uint64_t counts[2];
    if (std::fread(counts, sizeof counts, 1, file_.get()) != 1) return false;
    states.resize(counts[0]);
    broken.resize(counts[1]);
    for (BodyState& state : states) {
        Row row;
        if (std::fread(row.data(), sizeof row, 1, file_.get()) != 1) return false;
        state = {{row[0], row[1]}, row[2], {row[3], row[4]}, row[5], row[6] != 0};
    }
    for (auto&& isBroken : broken) isBroken = std::fgetc(file_.get()) == 1;
    return true;
}

}  // namespace plumb::compare
