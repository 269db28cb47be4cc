// SPDX-License-Identifier: MIT
// What may a user do to a world, in any order? Whatever comes, what the world says of itself must add up.
#pragma once
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>

#include "catch.h"

namespace plumb::test {

/// Does random things to a world. A list of actions says what: those to bodies and shapes are here, and others may be
/// put beside them.
class RandomEditor {
public:
    struct Action {
        int weight;
        void (*act)(RandomEditor&);
    };

    RandomEditor(std::uint64_t seed, int lanes) : world({.hitSpeed = 0.5, .solver = {.lanes = lanes}}), random(seed) {
        BodyDef ground{.type = BodyType::Static, .shapes = {segment({-12, 0}, {12, 0}), chain({{-12, 8}, {-12, 0}})}};
        ground.shapes.push_back(box({1, 1}));
        bodies.push_back(world.add(ground));
    }

    void run(const std::vector<Action>& actions, int calls) {
        int whole = 0;
        for (const Action& action : actions) whole += action.weight;
        for (int call = 0; call < calls; ++call) {
            int left = random.integer(0, whole - 1);
            for (const Action& action : actions) {
                left -= action.weight;
                if (left >= 0) continue;
                action.act(*this);
                break;
            }
        }
    }

    // Draws, one after the other: the order of arguments is the compiler's.
    bool chance(int oneIn) { return random.integer(1, oneIn) == 1; }
    double number(double low, double high) { return random.uniform(low, high); }
    Vec2 vector(double size) {
        const double x = random.uniform(-size, size);
        const double y = random.uniform(-size, size);
        return {x, y};
    }
    BodyId someBody() {
        if (bodies.empty()) return makeBody();
        return bodies[static_cast<std::size_t>(random.integer(0, static_cast<int>(bodies.size()) - 1))];
    }
    Body some() { return world.body(someBody()); }

    BodyId makeBody();
    ShapeDef anyShape();
    void step(double dt);
    /// Makes a call that the world may refuse, and then nothing may have changed.
    template <class Call>
    bool tryTo(Call&& call) {
        const std::uint64_t before = stateHash(world);
        const std::size_t shapes = world.counts().shapes;
        try {
            call();
            return true;
        } catch (const std::invalid_argument&) {
            if (stateHash(world) != before || world.counts().shapes != shapes) FAIL("a refused call changed the world");
            return false;
        }
    }
    void check();

    World world;
    Random random;
    std::vector<BodyId> bodies, removed;
    long long steps = 0, begins = 0, hits = 0, visits = 0, quarantines = 0;

private:
    using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;
    static Key keyOf(const ShapeId& a, const ShapeId& b) {
        return {a.body.index, a.body.generation, a.number, b.body.index, b.body.generation, b.number};
    }
    void checkContacts();
    void checkMoves() const;
    void checkSensors() const;
    void followEvents();

    double lastStep_ = 0;
    std::map<Key, int> touching_, inside_;
};

/// What bodies and shapes can be made to do, and the passing of time.
std::vector<RandomEditor::Action> bodyActions();

}  // namespace plumb::test
