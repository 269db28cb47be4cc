// SPDX-License-Identifier: MIT
#include <plumb/dynamics/loads/load_path_finder.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/math/detail/disjoint_sets.h>
#include <plumb/math/detail/sorting.h>

namespace plumb {

namespace {

// How much heavier must a body be? The more contacts count, the dearer a heap of bodies of all sizes is. A rest needs
// no path up to restRatio, because springs that are compressed a little further carry it: at 15.9 times the mass, a box
// of 1 m sinks in by 3.6 mm. A hit shows much earlier: at 1.5 times the mass, the heavier body would rebound. Tests: "a
// box of 15.9 times the mass of the one below sinks in by 3.6 mm, of 16.1 times by 0.2 mm", "a crate that falls on a
// loose plank stops there"
constexpr float hitRatio = 1.5f;  ///< than one that it hits [-]
constexpr float restRatio = 16;   ///< than one on which it rests [-]
constexpr float passRatio = 4;    ///< than one that passes its load on, and does not count as a support [-]
/// A hit is faster than this, as a multiple of what the bodies' accelerations make in half a step [-]: what rests, or
/// was put down, comes near with less.
constexpr float hitSpeed = 4;

/// Bodies that touch each other, directly or through others, are a crowd if loads start at so many of their contacts
/// [-]. Each path costs as much as dozens of contacts, and in a heap of all sizes there are hundreds: they took ten
/// times as long as the rest of the step. Test: "a slab a hundred times as heavy as a box stands on eleven boxes, and
/// sinks into twelve by 2 mm"
constexpr std::uint32_t crowd = 12;

/// Points whose surfaces are nearer than this carry load, even if they have not yet done so [m]: a support a fraction
/// of a millimetre off may take its share within the step.
constexpr float nearBy = 1e-3f;
/// A point holds against a load if the cosine of the angle between them is at least this [-]: up to 73 degrees. Shares
/// of points further aside would be more than three times the load itself.
constexpr float mostAside = 0.3f;
/// If a light body keeps more than this share of a load, it is a lever, and what presses on it elsewhere helps [-].
constexpr float mostLeft = 0.05f;
/// A path is of no use if its bodies respond to the load with more than this share of the two bodies' own response [-]:
/// then little holds the light body, and a pass over its single contact does as well.
constexpr float mostResponse = 0.5f;
/// A load that moves the heavy body by less than this share of what it would do there alone is none [-]: shares that
/// press the heavy body from both sides cancel, and the path's impulse would be divided by almost nothing.
constexpr float leastResponse = 0.1f;
constexpr float leastShare = 1e-4f;                   ///< smaller shares are left out, and not made exact [-]
constexpr int mostSweeps = 60;                        ///< at most, to find the shares
constexpr std::size_t mostBodies = 8, mostRows = 64;  ///< of a path

template <class T>
bool has(const StepList<T>& some, T one) {
    return std::find(some.begin(), some.end(), one) != some.end();
}

/// The inverse mass of the lightest body of a path [1/kg].
float lightestOf(const LoadPath& path, const BodyStore& bodies) {
    float most = 0;
    for (const LoadEffect& e : path.effects) most = std::max(most, bodies.velocity[e.body].inverseMass);
    return most;
}

}  // namespace

float LoadPath::inverseMass(const BodyStore& bodies) const {
    float sum = 0;
    for (const LoadEffect& e : effects) sum += bodies.velocity[e.body].inverseMass * e.dot(e);
    return sum;
}

/// Is the contact a rest on a much lighter body, or a hit on a lighter one?
bool LoadPathFinder::isStart(const Start& start) const {
    const float heavy = bodies_.velocity[start.heavy].inverseMass, light = bodies_.velocity[start.light].inverseMass;
    const ContactRecord& contact = contacts_[start.contact];
    if (!(heavy > 0 && light >= hitRatio * heavy) || !contact.isSolved()) return false;
    if (bodies_.links[start.heavy].actingJoints > 0 || bodies_.links[start.light].actingJoints > 0) return false;
    if (light >= restRatio * heavy) return true;
    const auto pull = [&](BodyIndex body) { return std::hypot(bodies_.place[body].pullX, bodies_.place[body].pullY); };
    const ContactLane at = graph_.laneOf(contact);
    return at.manifolds.approachSpeed[at.lane] > hitSpeed * std::max(pull(start.heavy), pull(start.light));
}

/// Most worlds have no two bodies of such different masses that touch, and this must cost them little: one pass over
/// the bodies finds the range of masses, and only if it is wide, the contacts of the fewer side are asked, as of one
/// heavy body among thousands of light ones. Sorted by shapes, so that the order of slots, which depends on what is far
/// away, does not matter.
StepList<LoadPathFinder::Start> LoadPathFinder::startsOf(std::span<const BodyIndex> all) const {
    StepList<BodyIndex> solved(all.begin(), all.end());
    std::erase_if(solved, [&](BodyIndex body) { return bodies_.links[body].actingJoints > 0; });
    float least = std::numeric_limits<float>::infinity(), most = 0;
    for (const BodyIndex body : solved) {
        const float inverseMass = bodies_.velocity[body].inverseMass;
        if (inverseMass > 0) least = std::min(least, inverseMass);
        most = std::max(most, inverseMass);
    }
    StepList<Start> starts;
    if (!(most >= hitRatio * least)) return starts;
    StepList<BodyIndex> heavy, light;  // all that may be: it is enough to ask the contacts of the fewer
    for (const BodyIndex body : solved) {
        const float inverseMass = bodies_.velocity[body].inverseMass;
        if (inverseMass > 0 && hitRatio * inverseMass <= most) heavy.push_back(body);
        if (inverseMass >= hitRatio * least) light.push_back(body);
    }
    const bool fromHeavy = heavy.size() < light.size();
    for (const BodyIndex body : fromHeavy ? heavy : light)
        forEachContact(bodies_, contacts_, body, [&](ContactIndex contact) {
            const BodyIndex other = otherOf(contacts_[contact], body);
            const Start start{contact, fromHeavy ? body : other, fromHeavy ? other : body};
            if (isStart(start)) starts.push_back(start);
        });
    sortBy(starts, [this](const Start& start) { return shapesOf(contacts_[start.contact]); });
    return starts;
}

/// Leaves out the starts in crowds: the lanes solve their contacts as they solve all others. O(contacts), but only
/// where there are so many starts at all.
void LoadPathFinder::leaveOutCrowds(StepList<Start>& starts, std::span<const BodyIndex> solved) const {
    if (starts.size() < crowd) return;
    DisjointSets touching(bodies_.record.size());
    for (const BodyIndex body : solved)
        forEachContact(bodies_, contacts_, body, [&](ContactIndex index) {
            const BodyIndex other = otherOf(contacts_[index], body);
            if (contacts_[index].isSolved() && bodies_.isDynamic(body) && bodies_.isDynamic(other))
                touching.unite(body, other);
        });
    StepMap<BodyIndex, std::uint32_t> sizes;
    for (const Start& start : starts) ++sizes[touching.of(start.heavy)];
    std::erase_if(starts, [&](const Start& start) { return sizes[touching.of(start.heavy)] >= crowd; });
}

/// Each point of a start has a path of its own, because the two ends of a plank may be held by different bodies.
/// pathOf_ keeps the first path that may use a contact, so that each contact belongs to one group.
void LoadPathFinder::findAll(std::span<const BodyIndex> solved) {
    StepList<Start> starts = startsOf(solved);
    leaveOutCrowds(starts, solved);
    for (const Start& start : starts) {
        const std::uint32_t contact = placeOf(start.contact);
        for (std::uint32_t point = 0; point < 2; ++point) {
            LoadPath path{start.heavy, start.light, {}, {}};
            if (!follow(path, {contact, point, 1})) continue;
            for (const std::uint32_t seen : seen_)
                pathOf_[seen] = std::min(pathOf_[seen], static_cast<std::uint32_t>(list_.paths.size()));
            list_.paths.push_back(std::move(path));
        }
    }
    if (!list_.paths.empty()) group();
}

/// Within the sub-steps only points count that carry load, no longer those that are merely near. If no path is found,
/// the old one stays.
void LoadPathFinder::findAgain(LoadPath& path, bool isRelax) {
    onlyLoaded_ = true;
    isRelax_ = isRelax;
    LoadPath now{path.heavy, path.light, {}, {}};
    if (follow(now, path.rows.front())) path = std::move(now);
}

/// Paths that share a body are solved together, until all of them are still; others do not wait for them.
void LoadPathFinder::group() {
    DisjointSets bodies(bodies_.record.size());
    for (const LoadPath& path : list_.paths)
        for (const LoadEffect& e : path.effects) bodies.unite(path.heavy, e.body);
    StepMap<BodyIndex, std::size_t> groupOf;
    for (std::uint32_t i = 0; i < list_.paths.size(); ++i) {
        const LoadPath& path = list_.paths[i];
        const auto [at, isNew] = groupOf.emplace(bodies.of(path.heavy), list_.groups.size());
        if (isNew) list_.groups.emplace_back();
        LoadGroup& group = list_.groups[at->second];
        group.paths.push_back(i);
        group.ratio = std::max(group.ratio, lightestOf(path, bodies_) / bodies_.velocity[path.heavy].inverseMass);
    }
    for (std::uint32_t c = 0; c < list_.contacts.size(); ++c) {
        if (pathOf_[c] == none) continue;
        list_.groups[groupOf[bodies.of(list_.paths[pathOf_[c]].heavy)]].contacts.push_back(c);
    }
}

std::uint32_t LoadPathFinder::placeOf(ContactIndex contact) {
    const auto [at, isNew] = places_.emplace(contact, static_cast<std::uint32_t>(list_.contacts.size()));
    if (!isNew) return at->second;
    const ContactRecord& record = contacts_[contact];
    const ContactLane lane = graph_.laneOf(record);
    list_.contacts.push_back({&lane.batch, lane.lane, isOfGround(record.colour)});
    pathOf_.push_back(none);
    return at->second;
}

/// Fills a path, body by body from the one that the load enters, breadth first; at most mostBodies pass it on. Returns
/// false if there is no such point, or if little holds the light body. The springs of all its points become as firm as
/// the whole path needs: their compliance falls from that for the light body's mass to that for the path's.
bool LoadPathFinder::follow(LoadPath& path, const LoadRow& load) {
    const LoadedContact contact = list_.contacts[load.contact];
    if (!(contact.batch->points[load.point].normalMass[contact.lane] > 0)) return false;
    loaded_.assign({path.light});
    passed_.assign({path.heavy});
    seen_.assign({load.contact});
    add(path, load);
    for (std::size_t i = 0; i < loaded_.size() && loaded_.size() < mostBodies && path.rows.size() < mostRows; ++i)
        passOn(path, loaded_[i]);
    const float inverseMass = path.inverseMass(bodies_);
    if (inverseMass * contact.batch->points[load.point].normalMass[contact.lane] > mostResponse ||
        inverseMass < leastResponse * bodies_.velocity[path.heavy].inverseMass)
        return false;
    for (const LoadRow& row : path.rows) {
        LoadedContact& c = list_.contacts[row.contact];
        c.compliance = std::min(c.compliance, inverseMass * c.batch->points[row.point].normalMass[c.lane]);
    }
    return true;
}

/// Lets the supports of a body take over its load. First as if only what is opposed to the load held it; if it then
/// keeps too much, as a plank that is loaded beyond its post, all that presses on it counts.
void LoadPathFinder::passOn(LoadPath& path, BodyIndex body) {
    passed_.push_back(body);
    LoadEffect load;
    for (const LoadEffect& e : path.effects)
        if (e.body == body) load = e;
    for (const bool isLever : {false, true}) {
        findSupports(path, body, load, isLever);
        if (shareOut(load) < mostLeft) break;
    }
    for (const Support& s : supports_) {
        if (s.row.share <= leastShare) continue;
        add(path, s.row);
        if (passesOn(path, s.other) && !has(passed_, s.other) && !has(loaded_, s.other)) loaded_.push_back(s.other);
    }
}

void LoadPathFinder::add(LoadPath& path, const LoadRow& row) const {
    path.rows.push_back(row);
    const LoadedContact& contact = list_.contacts[row.contact];
    for (const BodyIndex body : {contact.batch->bodyA[contact.lane], contact.batch->bodyB[contact.lane]}) {
        if (bodies_.record[body].type == BodyType::Static) continue;
        auto effect = std::find_if(path.effects.begin(), path.effects.end(),
                                   [body](const LoadEffect& e) { return e.body == body; });
        if (effect == path.effects.end()) effect = path.effects.insert(effect, LoadEffect{{}, body});
        effect->add(row.share, effectOn(body, row));
    }
}

/// The direction of a row for one of its bodies.
PointAxis LoadPathFinder::effectOn(BodyIndex body, const LoadRow& row) const {
    const LoadedContact& contact = list_.contacts[row.contact];
    const bool isB = contact.batch->bodyA[contact.lane] != body;
    const PointAxis axis = normalAxis(*contact.batch, contact.lane, row.point, isB);
    return isB ? axis : PointAxis{-axis.x, -axis.y, -axis.w};
}

/// A body nearly as heavy as the load stops it by its own mass; joints have a solution of their own.
bool LoadPathFinder::passesOn(const LoadPath& path, BodyIndex body) const {
    const float heavy = bodies_.velocity[path.heavy].inverseMass;
    return bodies_.velocity[body].inverseMass >= passRatio * heavy && bodies_.isDynamic(body) &&
           bodies_.links[body].actingJoints == 0;
}

/// The points that hold a body against its load. For a lever, also those where anything but a light body presses on it.
void LoadPathFinder::findSupports(const LoadPath& path, BodyIndex body, const LoadEffect& load, bool isLever) {
    supports_.clear();
    const LoadRow& first = path.rows.front();
    const LoadedContact& entry = list_.contacts[first.contact];
    const float gap = std::max(entry.batch->points[first.point].separation[entry.lane], 0.0f);
    const float least = mostAside * std::hypot(load.x, load.y);
    forEachContact(bodies_, contacts_, body, [&](ContactIndex index) {
        if (!contacts_[index].isSolved() || (onlyLoaded_ && !places_.contains(index))) return;
        const LoadRow contact{placeOf(index), 0, 0};
        const BodyIndex other = otherOf(contacts_[index], body);
        const bool hasPassed = has(passed_, other), balances = isLever && !passesOn(path, other);
        seen_.push_back(contact.contact);
        for (LoadRow row = contact; row.point < 2; ++row.point) {
            if (!carriesLoad(list_.contacts[row.contact], row.point, hasPassed ? gap + nearBy : nearBy)) continue;
            const PointAxis effect = effectOn(body, row);
            const float along = effect.x * load.x + effect.y * load.y;
            const bool isOpposed = hasPassed && along < 0;  // what loads the body from both sides holds nothing
            const bool holds = !hasPassed && along <= -least;
            if (holds || (balances && !isOpposed && !row.isSamePoint(first))) supports_.push_back({row, effect, other});
        }
    });
}

/// Does a point carry load, or will it as soon as its surfaces are nearer by this gap [m]?
bool LoadPathFinder::carriesLoad(const LoadedContact& contact, std::uint32_t point, float gap) const {
    const PointLanes& p = contact.batch->points[point];
    if (!(p.normalMass[contact.lane] > 0)) return false;
    if (!onlyLoaded_ && p.separation[contact.lane] < gap) return true;
    const float given = onlyLoaded_ && isRelax_ ? contact.start.normal[point] : 0.0f;
    return given + p.normalImpulse[contact.lane] > 0;
}

/// Finds the shares with which the supports keep the body at rest, as well as they can: they only push. It is a
/// non-negative least-squares problem, min |load + sum share effect|^2 with share >= 0, solved by projected
/// Gauss-Seidel. Returns what the body keeps, as a share of the load [-].
float LoadPathFinder::shareOut(LoadEffect kept) {
    for (int sweep = 0; sweep < mostSweeps; ++sweep) {
        float most = 0;
        for (Support& s : supports_) {
            const float wanted = s.row.share - kept.dot(s.effect) / s.effect.dot(s.effect);
            const float change = std::max(wanted, 0.0f) - s.row.share;
            s.row.share += change;
            kept.add(change, s.effect);
            most = std::max(most, std::fabs(change));
        }
        if (most < leastShare) break;
    }
    return std::sqrt(kept.dot(kept));
}

}  // namespace plumb
