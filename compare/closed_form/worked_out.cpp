// SPDX-License-Identifier: MIT
#include <compare/closed_form/worked_out.h>

#include <algorithm>
#include <type_traits>

#include <compare/closed_form/free/free_motion.h>
#include <compare/closed_form/held/held_motion.h>

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

}  // namespace plumb::compare
