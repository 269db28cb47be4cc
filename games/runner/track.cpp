// SPDX-License-Identifier: MIT
#include <games/runner/track.h>

#include <algorithm>

#include <games/runner/legend.h>

namespace plumb::games::runner {
namespace {

struct Spot {
    int row = 0, column = 0;
    friend bool operator==(const Spot&, const Spot&) = default;
};
struct Way {
    int down = 0, right = 0;
    friend bool operator==(const Way&, const Way&) = default;
};
constexpr Way ways[] = {{0, 1}, {0, -1}, {-1, 0}, {1, 0}};

Spot next(const Spot& from, const Way& way) {
    return {from.row + way.down, from.column + way.right};
}
Way back(const Way& way) {
    return {-way.down, -way.right};
}

/// Does a track continue through this letter in this direction?
bool leads(char letter, const Way& way) {
    return letter == '+' || letter == (way.down == 0 ? '-' : '|');
}

/// A run of the letter p.
struct Run {
    int row = 0, first = 0, last = 0;
    int middle() const { return (first + last) / 2; }
    bool holds(const Spot& spot) const { return spot.row == row && spot.column >= first && spot.column <= last; }
    /// The cell of the run where a track in this direction begins.
    Spot edge(const Way& way) const { return {row, way.right > 0 ? last : way.right < 0 ? first : middle()}; }
};

class Tracer {
public:
    explicit Tracer(const DrawnMap& map) : map_(map) {}

    std::vector<Platform> platforms() {
        std::vector<Platform> found;
        for (int row = 0; row < static_cast<int>(map_.rows.size()); ++row) {
            const int width = static_cast<int>(map_.rows[static_cast<std::size_t>(row)].size());
            for (int column = 0; column < width; ++column) {
                if (map_.at(row, column) != platformLetter) continue;
                Run run{row, column, column};
                while (map_.at(row, run.last + 1) == platformLetter) ++run.last;
                found.push_back(platformOf(run));
                column = run.last;
            }
        }
        refuseTracksWithout();
        return found;
    }

private:
    char at(const Spot& spot) const { return map_.at(spot.row, spot.column); }
    [[noreturn]] void refuseAt(const Spot& spot, std::string_view complaint) const {
        refuse(map_.file, map_.place(spot.row, spot.column), complaint);
    }

    Platform platformOf(const Run& run) {
        std::vector<Way> starts;
        for (const Way& way : ways)
            if (leads(at(next(run.edge(way), way)), way)) starts.push_back(way);
        if (starts.empty())
            refuseAt({run.row, run.first}, "a platform without a track: one of -, | or + was wanted beside it");
        if (starts.size() > 2) refuseAt({run.row, run.first}, "more than two tracks begin at a platform");
        std::vector<Vec2> there = follow(run, starts.front());
        const double width = run.last - run.first + 1;
        const bool loop = closed_;
        std::vector<Vec2> points;
        if (starts.size() == 2 && !loop) {
            points = follow(run, starts.back());
            std::reverse(points.begin(), points.end());
        }
        points.push_back(middleOf(run));
        points.insert(points.end(), there.begin(), there.end());
        MotionPath path(points.front());
        for (std::size_t i = 1; i < points.size(); ++i) path.lineTo(points[i]);
        if (loop) path.close();
        return {width, path, loop ? PathRepeat::Loop : PathRepeat::BackAndForth};
    }

    Vec2 middleOf(const Run& run) const {
        return 0.5 * (map_.center(run.row, run.first) + map_.center(run.row, run.last));
    }

    /// The corners of a track and its end, shifted to the right by as much as the platform's middle is within its cell.
    std::vector<Vec2> follow(const Run& run, const Way& start) {
        closed_ = false;
        const double shift = middleOf(run).x() - map_.center(run.row, run.middle()).x();
        const auto placeOf = [&](const Spot& spot) -> Vec2 {
            return map_.center(spot.row, spot.column) + Vec2(shift, 0);
        };
        std::vector<Vec2> points;
        Way way = start;
        Spot spot = next(run.edge(way), way);
        while (true) {
            followed_.push_back(spot);
            if (at(spot) == '+') {
                points.push_back(placeOf(spot));
                way = turnAt(spot, way, run);
            }
            const Spot ahead = next(spot, way);
            if (run.holds(ahead)) {
                closed_ = true;
                return points;
            }
            if (!leads(at(ahead), way)) {
                if (at(spot) != '+') points.push_back(placeOf(spot));
                return points;
            }
            if (std::find(followed_.begin(), followed_.end(), ahead) != followed_.end())
                refuseAt(ahead, "a track that returns to itself instead of its platform");
            spot = ahead;
        }
    }

    Way turnAt(const Spot& spot, const Way& way, const Run& run) const {
        std::vector<Way> on;
        for (const Way& turn : ways) {
            if (turn == way || turn == back(way)) continue;
            const Spot ahead = next(spot, turn);
            if (leads(at(ahead), turn) || run.holds(ahead)) on.push_back(turn);
        }
        if (on.empty()) refuseAt(spot, "'+' without a track that continues round a corner");
        if (on.size() > 1) refuseAt(spot, "a track that forks");
        return on.front();
    }

    void refuseTracksWithout() const {
        for (int row = 0; row < static_cast<int>(map_.rows.size()); ++row) {
            const int width = static_cast<int>(map_.rows[static_cast<std::size_t>(row)].size());
            for (int column = 0; column < width; ++column) {
                const Spot spot{row, column};
                const bool isTrack = trackLetters.find(at(spot)) != std::string_view::npos;
                if (isTrack && std::find(followed_.begin(), followed_.end(), spot) == followed_.end())
                    refuseAt(spot, "a track without a platform: a run of p was wanted beside it");
            }
        }
    }

    const DrawnMap& map_;
    std::vector<Spot> followed_;
    bool closed_ = false;
};

}  // namespace

char DrawnMap::at(int row, int column) const {
    if (row < 0 || row >= static_cast<int>(rows.size()) || column < 0) return '.';
    const std::string& letters = rows[static_cast<std::size_t>(row)];
    return column < static_cast<int>(letters.size()) ? letters[static_cast<std::size_t>(column)] : '.';
}

Vec2 DrawnMap::center(int row, int column) const {
    return {column + 0.5, static_cast<int>(rows.size()) - row - 0.5};
}

std::vector<Platform> platformsOf(const DrawnMap& map) {
    return Tracer(map).platforms();
}

}  // namespace plumb::games::runner
