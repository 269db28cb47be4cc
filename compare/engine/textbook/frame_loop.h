// SPDX-License-Identifier: MIT
// How does a game move things that has no engine? As a lecture says it: in each frame a step of a method, then a test
// of each pair, then the law of impact for those that hit.
#pragma once
#include <optional>
#include <vector>

#include <compare/engine/textbook/integration.h>
#include <compare/field/scene_fields.h>
#include <compare/scene/joint_geometry.h>
#include <compare/scene/state.h>
#include <plumb/collide/overlap.h>
#include <plumb/collide/sweep.h>

namespace plumb::compare {

/// How a frame finds out what hit.
enum class CollisionTest {
    AtEnd,      ///< what overlaps at the frame's end is moved apart
    Bisection,  ///< the same, but the time of the hit is looked for between the frame's start and its end
    Swept,      ///< the whole way is looked at: to the impact, through it, and on for the rest of the frame
};

class FrameLoop {
public:
    /// Throws Unsupported for what no lecture's loop has: movers, tile maps, locks, edges where the world goes on at
    /// the other side, bodies that come later, and joints that are not springs between the middles of bodies.
    FrameLoop(const Scene& scene, Integration integration, CollisionTest test);

    /// A frame takes dt [s].
    void advance(double dt);
    std::vector<BodyState> states() const;
    /// The time of the first impact in the last frame, as the test found it, 0 to 1; none if it found none [-].
    std::optional<double> firstImpact() const { return firstImpact_; }

private:
    struct Body {
        BodyDef def;
        Mass mass;
        double inverseMass = 0, inverseInertia = 0;
        Vec2 center{0, 0}, velocity{0, 0};         ///< of mass [m, m/s]
        double angle = 0, angularVelocity = 0;     ///< [rad, rad/s]
        Sweep way{};                               ///< in this frame
        Vec2 gain{0, 0};                           ///< of velocity in the whole frame, by forces [m/s]
        double from = 0;                           ///< where on the frame its way begins, 0 to 1 [-]
        double shareOfWay(double fraction) const;  ///< that it has gone at this share of the frame
        Transform poseAt(double fraction) const;
        Transform pose() const;
        /// At this share of the frame: velocity is that at its end, if nothing is met any more.
        Vec2 velocityAt(double fraction) const { return velocity - (1 - fraction) * gain; }
    };
    struct SpringBetween {
        std::size_t a = 0, b = 0;
        Vec2 anchorA{0, 0}, anchorB{0, 0};  ///< in the bodies' frames [m]
        double length = 0;
        Spring spring{};
    };
    struct Meeting {
        std::size_t a = 0, b = 0, shapeA = 0, shapeB = 0;
        double time = 0;  ///< of the frame, 0 to 1 [-]
        Vec2 point{0, 0}, normal{0, 1};
    };

    void move(double dt);
    Eigen::VectorXd accelerations(const Eigen::VectorXd& position, const Eigen::VectorXd& velocity, double dt) const;
    template <class Act>
    void forEachPair(const Act& act);
    template <class Act>
    void forEachShapes(std::size_t a, std::size_t b, const Act& act) const;
    void separate(std::size_t a, std::size_t b);
    void bisect(std::size_t a, std::size_t b, double dt);
    void sweep(double dt);
    std::vector<Meeting> touches(std::size_t a, std::size_t b) const;
    bool mayMeet(std::size_t a, std::size_t b) const;
    bool approach(const Meeting& meeting) const;
    void resolve(const Meeting& meeting);
    void goOn(std::size_t body, double fraction, double dt);

    Scene scene_;
    Integration integration_;
    CollisionTest test_;
    SceneFields fields_;
    std::vector<Body> bodies_{};
    std::vector<SpringBetween> springs_{};
    std::vector<std::size_t> moving_{};  ///< those that forces move
    std::optional<double> firstImpact_{};
};

}  // namespace plumb::compare
