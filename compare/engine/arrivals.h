// SPDX-License-Identifier: MIT
// Which bodies and joints of a scene appear while it runs, and when?
#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include <compare/engine/engine.h>
#include <compare/scene/joint_geometry.h>

namespace plumb::compare {

/// Bodies and joints that appear together, and also come back together, as indices of the scene.
struct Arrival {
    int first = 0;   ///< the step before which they appear, from 0 on
    int period = 0;  ///< after this number of steps they are taken out and made again; 0: never
    std::vector<std::size_t> bodies, joints;
};

/// Is the body there before the first step?
bool bodyIsThereAtStart(const Scene& scene, std::size_t body);
/// Are all bodies of the joint there before the first step? joints: the scene's.
bool jointIsThereAtStart(const Scene& scene, const std::vector<JointGeometry>& joints, std::size_t joint);

/// Keeps the parts of the scene that it needs; none if all bodies are there from start to end.
class Arrivals {
public:
    explicit Arrivals(const Scene& scene);

    /// The state of a body that has not appeared yet.
    BodyState awaited(std::size_t body) const;

    struct Due {
        const Arrival& arrival;
        bool again;  ///< the arrival is already there, and must be taken out first
    };
    /// The arrivals before a step; steps are counted from 0. What is there at the start is not due at step 0.
    std::vector<Due> dueBefore(int step) const;

    const Scene& scene() const { return *scene_; }
    const std::vector<JointGeometry>& joints() const { return joints_; }

private:
    std::shared_ptr<const Scene> scene_;
    std::vector<JointGeometry> joints_;
    std::vector<Arrival> arrivals_;
};

}  // namespace plumb::compare
