// SPDX-License-Identifier: MIT
#include <compare/closed_form/atwood.h>

namespace plumb::compare {

double accelerationOf(const AtwoodMachine& machine) {
    return machine.gravity * (machine.massB - machine.massA) / (machine.massA + machine.massB);
}

double tensionOf(const AtwoodMachine& machine) {
    return 2 * machine.gravity * machine.massA * machine.massB / (machine.massA + machine.massB);
}

}  // namespace plumb::compare
