// SPDX-License-Identifier: MIT
#include <compare/closed_form/oracle.h>

#include <algorithm>
#include <stdexcept>

#include <compare/closed_form/motion_state.h>
#include <compare/closed_form/worked_out.h>

namespace plumb::compare {
namespace {

// The time of a tick is k dt. By rounding, it may be just after the end of the closed form.
constexpr double timeRounding = 1e-9;

}  // namespace

std::vector<BodyState> closedFormStates(const Scene& scene, double t) {
    std::vector<BodyState> states(scene.bodies.size(), unknownState());
    if (!scene.closedForm) return states;
    if (!isWorkedOut(*scene.closedForm)) {
        Scene worked = scene;
        worked.closedForm = workedOut(scene);
        return closedFormStates(worked, t);
    }
    const ClosedForm& form = *scene.closedForm;
    if (form.until > 0 && t > form.until + timeRounding) return states;
    for (const BodyMotion& motion : form.bodies) {
        const std::string& name = std::visit([](const auto& m) -> const std::string& { return m.body; }, motion);
        const auto body = std::ranges::find(scene.bodies, name, &SceneBody::name);
        if (body == scene.bodies.end()) {
            throw std::invalid_argument("closedForm.bodies: \"" + name + "\" is not the name of a body");
        }
        states[static_cast<std::size_t>(body - scene.bodies.begin())] = motionState(motion, body->def, t);
    }
    return states;
}

}  // namespace plumb::compare
