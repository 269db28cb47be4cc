// SPDX-License-Identifier: MIT
// Which shapes began to touch in this step, and which ceased?
#pragma once
#include <vector>

#include <plumb/dynamics/contacts/contact_graph.h>

namespace plumb {

/// Two shapes that came to touch, or hit each other.
struct ShapeTouch {
    ProxyId proxyA = 0, proxyB = 0;
    Vec2 shift{0, 0};          ///< of B, in a world that wraps [m]
    Vec2 point{0, 0};          ///< as A sees it [m]
    Vec2 normal{0, 1};         ///< from A to B
    double approachSpeed = 0;  ///< [m/s]
};

/// Two shapes that touch no more.
struct TouchEnd {
    ProxyId proxyA = 0, proxyB = 0;
};

/// What a phase of a step has to tell.
struct TouchEvents {
    std::vector<ShapeTouch> begins, hits;
    std::vector<TouchEnd> ends;
};

/// Two shapes touch when they press on each other or overlap, until they are a millimetre apart. Together faster than
/// hitSpeed [m/s] they hit each other.
TouchEvents findTouchEvents(ContactGraph& graph, ContactStore& contacts, const BodyStore& bodies, double hitSpeed);

}  // namespace plumb
