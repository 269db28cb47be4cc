// SPDX-License-Identifier: MIT
#include <compare/formula/atwood.h>

namespace plumb::compare {

double accelerationOf(const AtwoodMachine& machine) {
    const double r = machine.ratio;
    return machine.gravity * (machine.massB - r * machine.massA) / (r * r * machine.massA + machine.massB);
}

double tensionOf(const AtwoodMachine& machine) {
    const double r = machine.ratio;
    return (1 + r) * machine.gravity * machine.massA * machine.massB / (r * r * machine.massA + machine.massB);
}

}  // namespace plumb::compare
