// SPDX-License-Identifier: MIT
#include <games/runner/way_search.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <queue>
#include <set>
#include <tuple>

#include <games/runner/buttons.h>

namespace plumb::games::runner {
namespace {

struct Move {
    Buttons first = 0;
    int firstTicks = 0;
    Buttons then = 0;
    int ticks = 12;             ///< in total, at most
    bool untilLanding = false;  ///< it ends on the next floor
};

constexpr Buttons right = rightButton | runButton, left = leftButton | runButton;

// The likeliest move first.
const std::vector<Move> floorMoves{
    {right, 14, right, 14},
    {right | jumpButton, 30, right, 75, true},
    {right | jumpButton, 6, right, 60, true},
    {right | jumpButton, 14, right, 65, true},
    {rightButton | jumpButton, 30, rightButton, 75, true},
    {right | jumpButton, 22, 0, 70, true},
    {0, 24, 0, 24},
    {rightButton, 10, 0, 14},
    {rightButton | jumpButton, 8, rightButton, 60, true},
    {jumpButton, 30, rightButton, 75, true},
    {left, 14, left, 14},
    {left | jumpButton, 30, left, 75, true},
    {leftButton | jumpButton, 30, leftButton, 75, true},
};
// On a lift, or at a place visited before: wait, or leave.
const std::vector<Move> waitMoves{
    {0, 20, 0, 20},
    {right | jumpButton, 30, right, 75, true},
    {right | jumpButton, 14, right, 65, true},
    {rightButton | jumpButton, 30, rightButton, 75, true},
    {right, 14, right, 14},
    {right | jumpButton, 22, 0, 70, true},
};
const std::vector<Move> airMoves{
    {right, 10, right, 10, true},
    {0, 10, 0, 10, true},
    {left, 10, left, 10, true},
    {right, 50, right, 50, true},
};

struct Node {
    std::unique_ptr<Stage> stage;
    std::vector<Buttons> buttons;  ///< from its parent to here
    int parent = -1;
    int ticks = 0;  ///< from the root
    double far = 0;
    std::size_t next = 0;  ///< index of the next move to try
    int before = 0;        ///< number of earlier nodes at this place, at other times
};

bool isOnLift(const Stage& stage) {
    const auto& floor = stage.hero().mover.slide().floor;
    const auto isUnder = [&](const Lift& lift) { return floor && lift.body == floor->shape.body; };
    return std::any_of(stage.lifts().begin(), stage.lifts().end(), isUnder);
}

class Search {
public:
    Search(const WayField& field, const SearchSettings& settings) : field_(field), settings_(settings) {}

    std::vector<Buttons> run(const Stage& stage, Buttons last) {
        Node root{std::make_unique<Stage>(stage), {last}};
        root.stage->keepEvents(false);
        root.far = field_.distance(stage.heroAt());
        nodes_.push_back(std::move(root));
        push(0);
        for (const int most : {settings_.mostTicks, settings_.lastTicks}) {
            if (const int enough = searchOn(most); enough > 0) return wayTo(enough);
            if (const int found = best(settings_.leastGain); found > 0) return wayTo(found);
        }
        return waitAt(best(-settings_.gain));
    }

private:
    const Node& node(int index) const { return nodes_[static_cast<std::size_t>(index)]; }
    Node& node(int index) { return nodes_[static_cast<std::size_t>(index)]; }

    const std::vector<Move>& movesOf(const Node& from) const {
        const Slide& slide = from.stage->hero().mover.slide();
        if (!slide.isOnFloor) return airMoves;
        return from.before > 0 || isOnLift(*from.stage) ? waitMoves : floorMoves;
    }

    /// Searches until this many ticks are simulated. Returns the first node that is good enough; 0 if none is.
    int searchOn(int mostTicks) {
        while (!open_.empty() && looked_ < mostTicks) {
            const int from = open_.top().second;
            open_.pop();
            const std::optional<int> reached = tryNext(from);
            if (reached && isEnough(*reached) && canStop(*reached)) return *reached;
        }
        return 0;
    }

    void push(int index) {
        const Node& now = node(index);
        if (now.next >= movesOf(now).size()) return;
        const double hurt = isUnhurt(index) ? 0 : settings_.hurtTicks;
        const double cost = now.ticks + settings_.ticksPerMetre * now.far + hurt +
                            settings_.triedTicks * static_cast<double>(now.next) + settings_.againTicks * now.before;
        open_.push({cost, index});
    }

    std::optional<int> tryNext(int from) {
        const Move move = movesOf(node(from))[node(from).next++];
        push(from);
        Node to{std::make_unique<Stage>(*node(from).stage), {}, from};
        play(to, move, node(from).buttons.back());
        if (!to.stage->hero().alive) return std::nullopt;
        to.ticks = node(from).ticks + static_cast<int>(to.buttons.size());
        to.far = to.stage->isFinished() ? 0 : field_.distance(to.stage->heroAt());
        std::set<int>& times = seen_[placeOf(to)];
        to.before = static_cast<int>(times.size());
        if (!times.insert(to.ticks / 24).second) return std::nullopt;
        nodes_.push_back(std::move(to));
        const int index = static_cast<int>(nodes_.size()) - 1;
        push(index);
        return index;
    }

    void play(Node& to, const Move& move, Buttons last) {
        const auto tick = [&](Buttons buttons) {
            to.stage->update(platformInput(buttons));
            to.buttons.push_back(buttons);
            ++looked_;
        };
        if ((move.first & last & jumpButton) != 0) tick(move.first & ~jumpButton);
        for (int i = 0; i < move.ticks && !to.stage->isOver(); ++i) {
            tick(i < move.firstTicks ? move.first : move.then);
            if (move.untilLanding && i > 2 && to.stage->hero().mover.slide().isOnFloor) return;
        }
    }

    using Place = std::tuple<int, int, int, int>;

    /// Nodes with the same result share a place; of those, only the first at a given time is kept.
    Place placeOf(const Node& now) const {
        const Vec2 at = now.stage->heroAt(), velocity = now.stage->hero().mover.slide().velocity;
        const auto part = [](double value, double size) { return static_cast<int>(std::floor(value / size)); };
        return {part(at.x(), 0.75), part(at.y(), 0.75), part(velocity.x() + 3, 6), part(velocity.y(), 6)};
    }

    bool isUnhurt(int index) const { return node(index).stage->hero().tall || !node(0).stage->hero().tall; }

    bool isEnough(int index) const {
        const Node& now = node(index);
        if (now.stage->isFinished()) return true;
        return isUnhurt(index) && now.stage->hero().mover.slide().isOnFloor && now.far < node(0).far - settings_.gain;
    }

    /// The buttons with which the hero stops there and stays unhurt; empty if none of the tries works. Then there may
    /// still be a way onwards.
    std::optional<std::vector<Buttons>> stopAt(int index) const {
        for (const Buttons brake : {Buttons{0}, left, right}) {
            Stage ahead = *node(index).stage;
            std::vector<Buttons> buttons(static_cast<std::size_t>(settings_.stopTicks), 0);
            std::fill_n(buttons.begin(), buttons.size() / 3, brake);
            for (const Buttons now : buttons) ahead.update(platformInput(now));
            const bool unhurt = ahead.hero().tall == node(index).stage->hero().tall;
            if (ahead.hero().alive && unhurt && ahead.hero().mover.slide().isOnFloor) return buttons;
        }
        return std::nullopt;
    }
    bool canStop(int index) const { return node(index).stage->isFinished() || stopAt(index); }

    /// The node nearest to the beacon where the hero can stop, if it is nearer by gain; otherwise 0, the root.
    int best(double gain) const {
        std::vector<int> order;
        for (int i = 1; i < static_cast<int>(nodes_.size()); ++i)
            if (isUnhurt(i) && node(i).stage->hero().mover.slide().isOnFloor && node(i).far < node(0).far - gain)
                order.push_back(i);
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return node(a).far < node(b).far; });
        for (std::size_t i = 0; i < std::min<std::size_t>(order.size(), 8); ++i)
            if (canStop(order[i])) return order[i];
        return 0;
    }

    /// Goes there and waits for a while: a lift may come.
    std::vector<Buttons> waitAt(int index) const {
        std::vector<Buttons> way = wayTo(index);
        const std::vector<Buttons> rest = stopAt(index).value_or(std::vector<Buttons>(20, 0));
        way.insert(way.end(), rest.begin(), rest.end());
        return way;
    }

    std::vector<Buttons> wayTo(int index) const {
        std::vector<const Node*> way;
        for (int at = index; at > 0; at = node(at).parent) way.push_back(&node(at));
        std::vector<Buttons> buttons;
        for (auto at = way.rbegin(); at != way.rend(); ++at)
            buttons.insert(buttons.end(), (*at)->buttons.begin(), (*at)->buttons.end());
        return buttons;
    }

    const WayField& field_;
    const SearchSettings& settings_;
    std::vector<Node> nodes_;
    std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> open_;
    std::map<Place, std::set<int>> seen_;
    int looked_ = 0;
};

}  // namespace

std::vector<Buttons> findWay(const Stage& stage, Buttons last, const WayField& field, const SearchSettings& settings) {
    return Search(field, settings).run(stage, last);
}

}  // namespace plumb::games::runner
