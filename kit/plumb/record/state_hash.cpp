// SPDX-License-Identifier: MIT
#include <plumb/record/state_hash.h>

#include <cstring>

namespace plumb {

namespace {

/// Source: Fowler, Noll, Vo; 64-bit FNV-1a, a byte at a time.
struct Fnv1a {
    std::uint64_t value = 0xCBF29CE484222325u;

    void add(std::uint64_t bits) {
        for (int byte = 0; byte < 8; ++byte) {
            value ^= (bits >> (8 * byte)) & 0xFF;
            value *= 0x100000001B3u;
        }
    }
    void add(double number) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        add(bits);
    }
    void add(const Vec2& v) {
        add(v.x());
        add(v.y());
    }
};

}  // namespace

std::uint64_t stateHash(const World& world) {
    Fnv1a hash;
    for (const BodyId id : world.bodies()) {
        const BodyView body = world.body(id);
        hash.add((std::uint64_t{id.index} << 32) | id.generation);
        hash.add(body.position());
        hash.add(body.angle());
        hash.add(body.velocity());
        hash.add(body.angularVelocity());
    }
    return hash.value;
}

}  // namespace plumb
