// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/impact_candidates.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/impact/detail/bounces.h>
#include <plumb/math/detail/sorting.h>

namespace plumb {

namespace {

/// If this contact has an impact in this step, do the shapes bounce, and are all their bounces longer than the step? If
/// not, the pair comes to rest within the step, after infinitely many bounces, and only the solver can do that.
/// The condition is 2 (e + e^2 + ...) v >= a dt: a bounce at speed u lasts 2 u / a, and the next one has the speed e u.
/// e restitution [-], v approach speed at the impact [m/s], a acceleration that presses the two together [m/s^2]
bool bouncesClear(const ContactGraph& graph, const BodyStore& bodies, const ContactRecord& contact, double dt) {
    if (contact.restitution <= 0) return false;
    const BodyMotion& a = bodies.motion[contact.bodyA];
    const BodyMotion b = shifted(bodies.motion[contact.bodyB], contact.shift);
    const Manifold manifold = graph.manifoldOf(contact);
    const Vec2 normal = a.rotation * Vec2(manifold.normal.cast<double>());
    const Vec2 pull =
        flightLawOf(bodies, contact.bodyA).acceleration.linear - flightLawOf(bodies, contact.bodyB).acceleration.linear;
    const double press = pull.dot(normal);
    for (int p = 0; p < manifold.count; ++p) {
        const ManifoldPoint& point = manifold.points[static_cast<std::size_t>(p)];
        const Vec2 at = a.center + a.rotation * Vec2(point.position.cast<double>());
        const Vec2 relative = velocityAt(b, at) - velocityAt(a, at);
        const double opening = relative.dot(normal);
        const double fall = std::max(press * static_cast<double>(point.separation), 0.0);
        const double speed = std::sqrt(opening * opening + 2 * fall);
        const bool overlapping = point.separation < -1e-4f && opening >= 0;  // only the solver corrects it
        if (overlapping || 2 * sumOfBounces(contact.restitution) * speed < press * dt) return false;
    }
    return true;
}

/// In a crowd that is pressed together, nearly all candidates go. Passes over all of them are much faster there than
/// following the contacts of each body: they save 5 ms a step with 60,000 contacts. What they leave is followed from
/// body to body.
constexpr int passesOverAll = 3;

/// Begins with the contacts whose two bodies, if they were alone, would bounce for longer than the step.
/// Then removes, one after the other, those with a body that the solver moves.
class CandidateSearch {
public:
    CandidateSearch(const ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies)
        : graph_(graph), contacts_(contacts), bodies_(bodies) {}

    ImpactCandidates find(double dt) {
        collect();
        collectSpinning();
        if (found_.contacts.empty()) return std::move(found_);
        // From here on a contact goes if the solver moves one of its bodies. That makes its other body constrained, and
        // so on: the candidates that stay are those of islands without any other contact.
        isCandidate_.assign(contacts_.records.size(), 0);
        found_.countOf.assign(bodies_.record.size(), 0);
        for (const ContactIndex index : found_.contacts) {
            isCandidate_[index] = 1;
            ++found_.countOf[contacts_[index].bodyA];
            ++found_.countOf[contacts_[index].bodyB];
        }
        markConstrained();
        for (int pass = 0; pass < passesOverAll; ++pass) removeMarked();
        for (const ContactIndex index : found_.contacts)
            for (const BodyIndex body : {contacts_[index].bodyA, contacts_[index].bodyB})
                if (isMarked_[body] != 0) constrained_.push_back(body);
        removeConstrained();
        for (const ContactIndex index : found_.contacts) {
            // The flag clear, by which candidates were collected, comes from the lanes and is computed in floats. This
            // second test is in doubles, and only for the few that are left.
            if (isCandidate_[index] == 0 || bouncesClear(graph_, bodies_, contacts_[index], dt)) continue;
            if (std::binary_search(spinning_.begin(), spinning_.end(), index)) continue;
            remove(index);
            removeConstrained();
        }
        std::erase_if(found_.contacts, [this](ContactIndex index) { return isCandidate_[index] == 0; });
        sortByShapes();
        return std::move(found_);
    }

private:
    /// Batches without restitution are skipped whole. O(batches with restitution).
    void collect() {
        for (const Colour& colour : graph_.colours)
            for (std::size_t b = 0; b < colour.batches.size(); ++b) {
                if (!colour.batches[b].bounces) continue;
                for (std::size_t lane = 0; lane < batchLanes; ++lane)
                    if (colour.manifolds[b].clear[lane] != 0)
                        found_.contacts.push_back(colour.contactOf[b * batchLanes + lane]);
            }
    }

    /// What spins is moved to where it meets other bodies, even if it does not bounce: the solver could let it pass,
    /// because it predicts contacts from the step's start.
    void collectSpinning() {
        for (const ContactIndex index : contacts_.predicted)
            if (contacts_[index].isSolved()) spinning_.push_back(index);
        if (spinning_.empty()) return;
        StepList<ContactIndex>& all = found_.contacts;
        all.insert(all.end(), spinning_.begin(), spinning_.end());
        sortOnceBy(spinning_, std::identity{});
        sortOnceBy(all, std::identity{});
    }

    void markConstrained() {
        isMarked_.assign(bodies_.record.size(), 0);
        for (const ContactIndex index : found_.contacts)
            for (const BodyIndex body : {contacts_[index].bodyA, contacts_[index].bodyB})
                if (found_.isConstrained(bodies_, body)) isMarked_[body] = 1;
    }

    /// Removes the candidates of marked bodies, and marks their other bodies.
    void removeMarked() {
        std::erase_if(found_.contacts, [this](ContactIndex index) {
            const BodyIndex a = contacts_[index].bodyA, b = contacts_[index].bodyB;
            if (isMarked_[a] == 0 && isMarked_[b] == 0) return false;
            isCandidate_[index] = 0;
            for (const BodyIndex body : {a, b}) {
                --found_.countOf[body];
                if (bodies_.isDynamic(body)) isMarked_[body] = 1;
            }
            return true;
        });
    }

    /// Each contact is removed once, so all removals together cost O(contacts of the bodies they touch).
    void remove(ContactIndex index) {
        isCandidate_[index] = 0;
        for (const BodyIndex body : {contacts_[index].bodyA, contacts_[index].bodyB}) {
            --found_.countOf[body];
            if (bodies_.isDynamic(body)) constrained_.push_back(body);
        }
    }

    /// Removes the candidates of constrained bodies. That may constrain their other bodies.
    void removeConstrained() {
        while (!constrained_.empty()) {
            const BodyIndex body = constrained_.back();
            constrained_.pop_back();
            if (found_.countOf[body] == 0) continue;
            forEachContact(bodies_, contacts_, body, [this](ContactIndex index) {
                if (isCandidate_[index] != 0) remove(index);
            });
        }
    }

    /// The order of slots changes with each contact that goes, also far away; of two impacts at the same time, the
    /// first in the list is solved first.
    void sortByShapes() {
        sortBy(found_.contacts, [this](ContactIndex index) { return shapesOf(contacts_[index]); });
    }

    const ContactGraph& graph_;
    const ContactStore& contacts_;
    const BodyStore& bodies_;
    ImpactCandidates found_;
    StepList<ContactIndex> spinning_;  ///< contacts of spinning bodies, predicted, sorted
    StepList<std::uint8_t> isCandidate_;
    StepList<std::uint8_t> isMarked_;  ///< of each body: 1 if its candidates are to be removed
    StepList<BodyIndex> constrained_;  ///< bodies whose candidates are to be removed
};

}  // namespace

ImpactCandidates findImpactCandidates(const ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies,
                                      double dt) {
    return CandidateSearch(graph, contacts, bodies).find(dt);
}

}  // namespace plumb
