// SPDX-License-Identifier: MIT
// How high is the ground, and how does a blast change it?
#pragma once
#include <vector>

#include <games/frame/hash.h>
#include <plumb/math/random.h>
#include <plumb/space/shape_def.h>

namespace plumb::games::artillery {

/// A piece of ground that will be level.
struct Plot {
    double x = 0, halfWidth = 1, height = 0;  ///< [m]
};

/// An island as columns of earth, with straight lines between their tops. Blasts only lower it, so nothing that stands
/// on it ends up inside it.
class Terrain {
public:
    static constexpr double spacing = 0.25;  ///< between columns [m]
    static constexpr double half = 64;       ///< from the middle to either end [m]
    static constexpr int columns = 2 * 64 * 4 + 1;
    static constexpr double steepest = 2.4;  ///< rise over run of a crater's wall; steeper earth slides [-]

    explicit Terrain(Random& random);  ///< a random landscape
    explicit Terrain(double height);   ///< level everywhere

    static double xOf(int column) { return column * spacing - half; }
    static int columnAt(double x);  ///< the nearest column
    double height(int column) const { return heights_[static_cast<std::size_t>(column)]; }
    double heightAt(double x) const;
    double burnt(int column) const { return burnt_[static_cast<std::size_t>(column)]; }  ///< by blasts, 0 to 1

    /// Height before the first blast; the layers of earth follow it.
    double firstHeight(int column) const { return first_[static_cast<std::size_t>(column)]; }

    /// Makes the plots level, and the ground between them smooth. Call it before the first blast.
    void level(const std::vector<Plot>& plots);
    /// Each column loses its part inside the disc; the earth above falls; walls that are too steep slide down.
    void carve(const Vec2& center, double radius);

    ShapeDef shape() const;  ///< the outline, as one chain
    void addTo(Hash& hash) const;

private:
    void slide(int column);

    std::vector<double> heights_, burnt_, first_;
};

}  // namespace plumb::games::artillery
