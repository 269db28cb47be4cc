// SPDX-License-Identifier: MIT
#include <plumb/shapes/detail/counts.h>

#include <string>

#include <plumb/math/check.h>

namespace plumb {

void refuseCount(const Polygon& polygon, std::string_view field) {
    const std::size_t count = polygon.vertices.size();
    refuse(std::string(field) + ".vertices",
           std::to_string(count) + " corners are " +
               (count < 3 ? "fewer than 3" : "more than " + std::to_string(maxPolygonVertices)));
}

void refuseCount(const Chain& chain, std::string_view field) {
    refuse(std::string(field) + ".points", std::to_string(chain.points.size()) + " points are fewer than " +
                                               (chain.closed ? "3 of a closed chain" : "2"));
}

}  // namespace plumb
