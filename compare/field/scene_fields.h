// SPDX-License-Identifier: MIT
// What do a scene's fields do to its bodies?
//
// This is for engines that have no fields: their user computes the force and applies it before each step. It also gives
// the energy of the bodies in the fields, for any engine.
#pragma once
#include <span>
#include <vector>

#include <compare/scene/scene.h>
#include <compare/scene/state.h>
#include <plumb/shapes/mass.h>

namespace plumb::compare {

/// The force of fields on one body, at its centre of mass.
struct FieldForce {
    Vec2 force{0, 0};   ///< [N]
    double torque = 0;  ///< [N m]
};

class SceneFields {
public:
    explicit SceneFields(const Scene& scene);

    bool empty() const { return fields_.empty(); }
    /// The force on each body, in the scene's order, over a step of dt [s]. The friction of a ground is never larger
    /// than what stops a body within the step.
    std::vector<FieldForce> at(std::span<const BodyState> states, double dt) const;
    /// The energy of all bodies in all fields that have a potential energy and no region [J].
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
