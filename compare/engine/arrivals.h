// SPDX-License-Identifier: MIT
// Which bodies and joints of a scene come while it runs, and when?
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include <compare/engine/engine.h>
#include <compare/engine/joint_geometry.h>

namespace plumb::compare {

/// What comes together, and again together. Places in the scene.
struct Arrival {
    int first = 0;   ///< the step before which it comes, from 0 on
    int period = 0;  ///< after so many steps it is taken out and made anew; 0: never
    std::vector<std::size_t> bodies, joints;
};

/// Before the first step.
bool bodyIsThereAtStart(const Scene& scene, std::size_t body);
/// Its bodies are. joints: the scene's.
bool jointIsThereAtStart(const Scene& scene, const std::vector<JointGeometry>& joints, std::size_t joint);

/// Keeps what it needs of the scene; nothing, of a scene whose bodies are all there from its start to its end.
class Arrivals {
public:
    explicit Arrivals(const Scene& scene);

    /// The state of a body that has not appeared yet.
    BodyState awaited(std::size_t body) const;

    struct Due {
        const Arrival& arrival;
        bool again;  ///< it is there, and is to be taken out first
    };
    /// What comes before a step, counted from 0. What is there at the start is not due at 0.
    std::vector<Due> dueBefore(int step) const;

    const Scene& scene() const { return *scene_; }
    const std::vector<JointGeometry>& joints() const { return joints_; }

private:
    std::shared_ptr<const Scene> scene_;
    std::vector<JointGeometry> joints_;
    std::vector<Arrival> arrivals_;
};

}  // namespace plumb::compare
