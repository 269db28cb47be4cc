// SPDX-License-Identifier: MIT
// What may a user do to a world, in any order? Whatever comes, what the world says of itself must add up.
#pragma once
#include <cmath>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>

#include "catch.h"
#include "numbers.h"

namespace plumb::test {

/// How one editor goes about it.
struct Manner {
    int lanes = 16;
    bool wild = false;    ///< now and then, numbers of joints that nobody in his right mind would give
    bool ledger = false;  ///< does the world keep account?
    bool asks = true;     ///< does it ask what it draws to ask, or only draws?
    Wrap wrap = {};       ///< how wide and high the world is, if it goes on at its other side
};

/// Does random things to a world. A list of actions says what: each family of them has a file of its own.
class RandomEditor {
public:
    struct Action {
        int weight;
        void (*act)(RandomEditor&);
    };

    explicit RandomEditor(std::uint64_t seed, const Manner& manner = {});

    void run(const std::vector<Action>& actions, int calls);

    // Draws, one after the other: the order of arguments is the compiler's.
    bool chance(int oneIn) { return random.integer(1, oneIn) == 1; }
    bool goesWild() { return manner.wild && chance(40); }
    double number(double low, double high) { return random.uniform(low, high); }
    Vec2 vector(double size) {
        const double x = random.uniform(-size, size);
        const double y = random.uniform(-size, size);
        return {x, y};
    }
    /// Mostly up to what is usual; wildly, of any order.
    double amount(double usual);
    double eitherWay(double usual) { return chance(2) ? amount(usual) : -amount(usual); }
    template <class Thing>
    const Thing& oneOf(const std::vector<Thing>& things) {
        return things[static_cast<std::size_t>(random.integer(0, static_cast<int>(things.size()) - 1))];
    }
    BodyId someBody() { return bodies.empty() ? makeBody() : oneOf(bodies); }
    Body some() { return world.body(someBody()); }
    ShapeId someShape();  ///< none, if the body drawn has none

    BodyId makeBody();
    void removeBody(BodyId body);
    void removeJoint(JointId joint);
    ShapeDef anyShape();
    Filter anyFilter();
    void step(double tick);
    /// Makes a call that the world may refuse, and then nothing may have changed. What it said, or nothing.
    template <class Call>
    std::string refusalOf(Call&& call) {
        const std::uint64_t before = stateHash(world);
        const WorldCounts counts = world.counts();
        try {
            call();
            return {};
        } catch (const std::invalid_argument& refusal) {
            const WorldCounts now = world.counts();
            if (stateHash(world) != before || now.shapes != counts.shapes || now.joints != counts.joints)
                FAIL("a refused call changed the world");
            return refusal.what();
        }
    }
    template <class Call>
    bool tryTo(Call&& call) {
        return refusalOf(std::forward<Call>(call)).empty();
    }
    void check();

    // What the world says is not only looked at, but kept: as bits, by FNV-1a.
    void hear(std::uint64_t bits) { heard = (heard ^ bits) * 0x100000001B3u; }
    void hear(double number) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        hear(bits);
    }
    void hear(const ShapeId& shape) { hear(std::uint64_t{shape.body.index} << 32 | shape.number); }

    static bool passes(const Filter& a, const Filter& b);

    /// A joint as its def says: whom it holds, and which joints drive it.
    struct Joined {
        JointId id;
        std::vector<BodyId> bodies;
        std::vector<JointId> drivers;
        Breaking breaking;
    };
    struct Tally {
        long long steps = 0, begins = 0, hits = 0, visits = 0, quarantines = 0, joints = 0, breaks = 0, gears = 0,
                  refusals = 0, asked = 0, found = 0, fields = 0, blasts = 0, copies = 0;
    };

    const Manner manner;
    World world;
    Random random, asker;
    std::vector<BodyId> bodies, removed;
    std::vector<ShapeId> removedShapes;
    std::vector<Joined> joints;
    std::vector<JointId> unjoined;
    std::vector<FieldId> fields, ended;
    Tally tally;
    std::uint64_t heard = 0xCBF29CE484222325u;

private:
    using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;
    static Key keyOf(const ShapeId& a, const ShapeId& b) {
        return {a.body.index, a.body.generation, a.number, b.body.index, b.body.generation, b.number};
    }
    void checkContacts();
    void checkMoves() const;
    void checkSensors() const;
    void checkJoints();
    void checkFields() const;
    void checkLedger();
    void followEvents();
    void followBreaks();
    void forgetJoint(JointId joint);
    void forgetJointsOf(BodyId body);

    struct Place {
        Vec2 position;
        double angle;
    };

    double lastStep_ = 0;
    std::map<std::uint32_t, Place> placesBefore_;  ///< of the bodies' slots, before the last step
    std::map<Key, int> touching_, inside_;
    double mostEnergy_ = 0, mostMomentum_ = 0;
};

/// What bodies and shapes can be made to do, and the passing of time.
std::vector<RandomEditor::Action> bodyActions();
std::vector<RandomEditor::Action> jointActions();
std::vector<RandomEditor::Action> queryActions();
/// What must be refused: ids that are stale or never were, and numbers that are none.
std::vector<RandomEditor::Action> refusedActions();
/// What is done to a world as a whole.
std::vector<RandomEditor::Action> worldActions();
std::vector<RandomEditor::Action> fieldActions();
std::vector<RandomEditor::Action> copyActions();
std::vector<RandomEditor::Action> allActions();
/// All but queries, of which the truth is that of a world that does not wrap.
std::vector<RandomEditor::Action> wrappedActions();

}  // namespace plumb::test
