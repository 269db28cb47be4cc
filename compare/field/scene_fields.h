// SPDX-License-Identifier: MIT
// What do a scene's fields do to its bodies?
//
// For engines that have no fields of their own: as somebody works it out who applies a force before each step. And for
// the energy that is in them, whoever's step it was.
#pragma once
#include <span>
#include <vector>

#include <compare/engine/engine.h>
#include <plumb/shapes/mass.h>

namespace plumb::compare {

/// At the centre of mass.
struct FieldForce {
    Vec2 force{0, 0};   ///< [N]
    double torque = 0;  ///< [N m]
};

class SceneFields {
public:
    explicit SceneFields(const Scene& scene);

    bool empty() const { return fields_.empty(); }
    /// On each body of the scene, in its order, over a step of dt [s]. What rubs takes no more than stops a body in it.
    std::vector<FieldForce> at(std::span<const BodyState> states, double dt) const;
    /// Of all bodies in all fields that have a potential energy and no region [J].
    double energyAt(std::span<const BodyState> states) const;

private:
    struct Body {
        bool dynamic = false;
        const BodyDef* def = nullptr;
        Mass mass;
        Vec2 center{0, 0};
        const BodyState* state = nullptr;
    };
    struct Field {
        FieldDef def;
        std::size_t carrier = 0;
    };
    friend class FieldWork;

    std::vector<Body> placed(std::span<const BodyState> states) const;
    static bool actsOn(const Field& field, const Body& body);

    std::vector<BodyDef> defs_;
    std::vector<Mass> masses_;
    std::vector<Field> fields_;
};

}  // namespace plumb::compare
