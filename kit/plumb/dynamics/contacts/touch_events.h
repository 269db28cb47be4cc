// SPDX-License-Identifier: MIT
// Which pairs of shapes began to touch in this step, and which stopped touching?
#pragma once
#include <vector>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/math/detail/step_list.h>

namespace plumb {

/// Two shapes that began to touch, or that hit each other.
struct ShapeTouch {
    ProxyId proxyA = 0, proxyB = 0;
    Vec2 shift{0, 0};          ///< to B's periodic image that touches A, in a world that wraps [m]
    Vec2 point{0, 0};          ///< on A, in a world that wraps not on a periodic image of A [m]
    Vec2 normal{0, 1};         ///< from A to B
    double approachSpeed = 0;  ///< [m/s]
};

/// Two shapes that stopped touching.
struct TouchEnd {
    ProxyId proxyA = 0, proxyB = 0;
};

/// The touch events that a phase of a step returns.
struct TouchEvents {
    StepList<ShapeTouch> begins, hits;
    StepList<TouchEnd> ends;
};

/// A touch begins when two shapes press on each other or overlap. It ends when they do not press and are at least 1 mm
/// apart. Two shapes that press on each other after an approach faster than hitSpeed [m/s] hit each other.
TouchEvents findTouchEvents(ContactGraph& graph, ContactStore& contacts, const BodyStore& bodies, double hitSpeed);

}  // namespace plumb
