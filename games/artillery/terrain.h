// SPDX-License-Identifier: MIT
// How high is the ground, and what does a blast leave of it?
#pragma once
#include <vector>

#include <games/frame/hash.h>
#include <plumb/math/random.h>
#include <plumb/space/shape_def.h>

namespace plumb::games::artillery {

/// Ground that is to be level.
struct Plot {
    double x = 0, halfWidth = 1, height = 0;  ///< [m]
};

/// An island as columns of earth, each as high as its ground; in between it is straight. It only ever gets lower, so
/// that nothing that stands on it comes to lie within.
class Terrain {
public:
    static constexpr double spacing = 0.25;  ///< of the columns [m]
    static constexpr double half = 64;       ///< from the middle to either end [m]
    static constexpr int columns = 2 * 64 * 4 + 1;
    static constexpr double steepest = 2.4;  ///< what is steeper slides off: rise over run of a crater's wall [-]

    explicit Terrain(Random& random);  ///< one of the landscapes, as chance will have it
    explicit Terrain(double height);   ///< level everywhere

    static double xOf(int column) { return column * spacing - half; }
    static int columnAt(double x);  ///< the nearest there is
    double height(int column) const { return heights_[static_cast<std::size_t>(column)]; }
    double heightAt(double x) const;
    double burnt(int column) const { return burnt_[static_cast<std::size_t>(column)]; }  ///< by blasts, 0 to 1

    /// Before the first blast, which is where the layers of its earth lie.
    double firstHeight(int column) const { return first_[static_cast<std::size_t>(column)]; }

    /// Level where something is to stand, and smooth in between. Before the first blast.
    void level(const std::vector<Plot>& plots);
    /// Each column loses what the disc cuts out of it; what was above falls; and what stands too steep slides off.
    void carve(const Vec2& center, double radius);

    ShapeDef shape() const;  ///< the outline, as one chain
    void addTo(Hash& hash) const;

private:
    void slide(int column);

    std::vector<double> heights_, burnt_, first_;
};

}  // namespace plumb::games::artillery
