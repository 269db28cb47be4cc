// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/isolated_impacts.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <plumb/dynamics/bodies/free_motion.h>

namespace plumb {

namespace {

/// If this contact has an impact in this step, do the shapes bounce, and is the free motion after the bounce longer
/// than the step? The condition is 2 e v >= a dt.
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
        if (overlapping || 2 * contact.restitution * speed < press * dt) return false;
    }
    return true;
}

/// Finds the contacts that are isolated impacts, and the contacts that their bodies may also meet.
class ImpactSearch {
public:
    ImpactSearch(const ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies, double dt)
        : graph_(graph), contacts_(contacts), bodies_(bodies), dt_(dt) {}

    std::vector<ContactIndex> find() {
        findCandidates();
        if (found_.empty()) return {};
        keepOnly([](const ContactRecord&) { return true; });
        keepOnly([this](const ContactRecord& contact) { return bouncesClear(graph_, bodies_, contact, dt_); });
        addOthers();
        return std::move(found_);
    }

private:
    /// Finds the contacts whose two bodies, if they were alone, would bounce and stay apart for longer than the step.
    void findCandidates() {
        for (const Colour& colour : graph_.colours) {
            for (std::size_t b = 0; b < colour.batches.size(); ++b) {
                if (!colour.batches[b].bounces) continue;
                for (std::size_t lane = 0; lane < batchLanes; ++lane)
                    if (colour.manifolds[b].clear[lane] != 0) found_.push_back(colour.contactOf[b * batchLanes + lane]);
            }
        }
        if (!found_.empty()) candidatesOf_.assign(bodies_.record.size(), 0);
        for (const ContactIndex index : found_) {
            ++candidatesOf_[contacts_[index].bodyA];
            ++candidatesOf_[contacts_[index].bodyB];
        }
    }

    /// Removes the contacts that fail the test, and then, repeatedly, those with a body that the solver moves.
    template <class Test>
    void keepOnly(Test&& test) {
        for (bool changed = true; changed;) {
            const std::size_t removed = std::erase_if(found_, [&](ContactIndex index) {
                const ContactRecord& contact = contacts_[index];
                if (!isConstrained(contact) && test(contact)) return false;
                --candidatesOf_[contact.bodyA];
                --candidatesOf_[contact.bodyB];
                return true;
            });
            changed = removed > 0;
        }
    }

    /// Adds the other contacts of bouncing bodies: after an impact, a body may reach them in the rest of the step.
    void addOthers() {
        std::vector<bool> isFound(contacts_.records.size(), false);
        for (const ContactIndex index : found_) isFound[index] = true;
        const std::size_t count = found_.size();
        for (std::size_t i = 0; i < count; ++i) {
            const ContactRecord& candidate = contacts_[found_[i]];
            for (const BodyIndex body : {candidate.bodyA, candidate.bodyB}) {
                if (!bodies_.isDynamic(body)) continue;
                forEachContact(bodies_, contacts_, body, [&](ContactIndex index) {
                    const ContactRecord& contact = contacts_[index];
                    const bool free =
                        areBodiesReady(bodies_, contact) && !isConstrained(contact) && !letsPass(contact.verdict);
                    if (isFound[index] || !free) return;
                    isFound[index] = true;
                    found_.push_back(index);
                });
            }
        }
    }

    /// The solver moves bodies with a joint, and bodies with a contact that is not an isolated impact.
    bool isConstrained(BodyIndex body) const {
        const BodyLinks& links = bodies_.links[body];
        return bodies_.isDynamic(body) && (links.actingJoints > 0 || links.solverContacts > candidatesOf_[body]);
    }
    bool isConstrained(const ContactRecord& contact) const {
        return isConstrained(contact.bodyA) || isConstrained(contact.bodyB);
    }

    const ContactGraph& graph_;
    const ContactStore& contacts_;
    const BodyStore& bodies_;
    double dt_;
    std::vector<ContactIndex> found_;
    std::vector<std::uint32_t> candidatesOf_;  ///< for each body: how many of its contacts are in found_
};

/// Splits the contacts into groups that share no dynamic body; their order follows from the order of the contacts. Some
/// groups may be empty.
std::vector<std::vector<ContactIndex>> groupsOf(const ContactStore& contacts, const BodyStore& bodies,
                                                const std::vector<ContactIndex>& found) {
    std::map<BodyIndex, std::size_t> groupOf;
    std::vector<std::vector<ContactIndex>> groups;
    for (const ContactIndex index : found) {
        const std::size_t fresh = groups.size();
        groups.push_back({index});
        for (const BodyIndex body : {contacts[index].bodyA, contacts[index].bodyB}) {
            if (!bodies.isDynamic(body)) continue;
            const auto [known, isNew] = groupOf.try_emplace(body, fresh);
            const std::size_t old = known->second;
            if (isNew || old == fresh) continue;
            groups[fresh].insert(groups[fresh].end(), groups[old].begin(), groups[old].end());
            groups[old].clear();
            for (auto& [member, group] : groupOf)
                if (group == old) group = fresh;
        }
    }
    return groups;
}

/// Removes a contact from the solver for this step: the impacts have moved its bodies.
void leaveToImpacts(ContactGraph& graph, ContactStore& contacts, BodyStore& bodies, ContactIndex index) {
    ContactRecord& contact = contacts[index];
    const std::array<PointMemory, 2> memory = contact.memory;
    graph.remove(bodies, contacts, index);
    contacts.addNear(index);
    contact.state = ContactState::Impact;
    contact.memory = memory;
    contact.rollImpulse = 0;
    contacts.impacts.push_back(index);
}

/// Makes the contacts that were isolated impacts in the last step ordinary near contacts again.
void endImpacts(ContactStore& contacts) {
    for (const ContactIndex index : contacts.impacts)
        if (contacts[index].state == ContactState::Impact) contacts[index].state = ContactState::Near;
    contacts.impacts.clear();
}

}  // namespace

Impacts solveIsolatedImpacts(ContactGraph& graph, const ImpactStores& stores, double dt, double hitSpeed) {
    Impacts impacts;
    ContactStore& contacts = stores.contacts;
    endImpacts(contacts);
    const std::vector<ContactIndex> found = ImpactSearch(graph, contacts, stores.bodies, dt).find();
    for (const std::vector<ContactIndex>& group : groupsOf(contacts, stores.bodies, found)) {
        if (group.empty()) continue;
        for (const ContactIndex index : group) contacts[index].memory = {};
        if (!moveThroughImpacts(stores, group, dt, hitSpeed, impacts)) continue;
        for (const ContactIndex index : group) leaveToImpacts(graph, contacts, stores.bodies, index);
    }
    return impacts;
}

}  // namespace plumb
