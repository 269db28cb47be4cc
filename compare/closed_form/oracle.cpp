// SPDX-License-Identifier: MIT
#include <compare/closed_form/oracle.h>

#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include <compare/closed_form/free/free_motion.h>
#include <compare/closed_form/held/held_motion.h>
#include <compare/closed_form/motion.h>

namespace plumb::compare {
namespace {

template <class Motion>
concept HoldsNames = requires(const Motion& motion, const Scene& scene) {
    heldMotion(motion, scene);
};

bool holdsNumbers(const BodyMotion& motion) {
    return std::visit(
        []<class Motion>(const Motion&) { return !HoldsNames<Motion> && !std::is_same_v<Motion, FreeMotion>; }, motion);
}

double earlier(double a, double b) {
    return a == 0 ? b : b == 0 ? a : std::min(a, b);
}

// The time of a tick is k dt. By rounding, it may be just after the end of the closed form.
constexpr double timeRounding = 1e-9;

}  // namespace

bool isWorkedOut(const ClosedForm& form) {
    return std::ranges::all_of(form.bodies, holdsNumbers);
}

ClosedForm workedOut(const Scene& scene) {
    ClosedForm form = *scene.closedForm;
    if (isWorkedOut(form)) return form;
    const std::vector<WorkedMotion> free = freeMotions(scene);
    auto next = free.begin();
    for (BodyMotion& motion : form.bodies) {
        const auto work = [&]<class Motion>(const Motion& names) {
            if constexpr (std::is_same_v<Motion, FreeMotion>)
                return *next++;
            else if constexpr (HoldsNames<Motion>)
                return heldMotion(names, scene);
            else
                return WorkedMotion{names};
        };
        const WorkedMotion worked = std::visit(work, BodyMotion(motion));
        motion = worked.motion;
        if (worked.until < scene.duration) form.until = earlier(form.until, worked.until);
    }
    return form;
}

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
    // What is static stays, whatever the formula: a spring that hangs from it would have no energy else.
    for (std::size_t i = 0; i < states.size(); ++i) {
        const BodyDef& def = scene.bodies[i].def;
        if (def.type == BodyType::Static) states[i] = {def.position, def.angle, {0, 0}, 0};
    }
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
