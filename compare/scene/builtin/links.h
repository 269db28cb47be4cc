// SPDX-License-Identifier: MIT
// How are chains and bridges put together?
#pragma once
#include <string>
#include <vector>

#include <compare/scene/scene.h>
#include <plumb/math/trig.h>

namespace plumb::compare {

/// Boxes between neighbouring hinges.
struct Links {
    std::vector<Vec2> hinges{};
    double halfWidth = 0.05;  ///< [m]
    double linkMass = 1;      ///< [kg]
    bool solid = false;       ///< do other bodies collide with them? They never collide with each other
    double damping = 0;       ///< of their motion [1/s]
};

inline SceneJoint& hinge(Scene& scene, const std::string& name, const std::string& a, const std::string& b,
                         const Vec2& anchor) {
    return scene.joints.emplace_back(SceneJoint{name, a, b, RevoluteJointDef{.anchor = anchor}});
}

/// Adds the bodies link_1 ... link_n, and hinge_1 ... hinge_(n - 1) between them.
inline void addLinks(Scene& scene, const Links& links) {
    for (std::size_t i = 0; i + 1 < links.hinges.size(); ++i) {
        const Vec2 along = links.hinges[i + 1] - links.hinges[i];
        const Vec2 halfSize(along.norm() / 2, links.halfWidth);
        ShapeDef shape = box(halfSize, {.density = links.linkMass / (4 * halfSize.prod())});
        shape.filter = {.category = 2, .mask = links.solid ? ~std::uint64_t{2} : 0};
        const std::string name = "link_" + std::to_string(i + 1), before = "link_" + std::to_string(i);
        scene.bodies.push_back({name,
                                {.position = (links.hinges[i] + links.hinges[i + 1]) / 2,
                                 .angle = arcTangent(along.y(), along.x()),
                                 .linearDamping = links.damping,
                                 .angularDamping = links.damping,
                                 .canSleep = links.solid,
                                 .shapes = {shape}}});
        if (i > 0) hinge(scene, "hinge_" + std::to_string(i), before, name, links.hinges[i]);
    }
}

/// Adds hinge_0 and hinge_n from the body "pivot" to the first link and the last.
inline void holdEnds(Scene& scene, const std::vector<Vec2>& hinges) {
    const std::string last = std::to_string(hinges.size() - 1);
    hinge(scene, "hinge_0", "pivot", "link_1", hinges.front());
    hinge(scene, "hinge_" + last, "pivot", "link_" + last, hinges.back());
}

}  // namespace plumb::compare
