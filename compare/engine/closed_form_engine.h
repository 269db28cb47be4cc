// SPDX-License-Identifier: MIT
// How is the textbook's answer compared with the engines?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// States are NaN for bodies and times for which the closed form gives nothing. It has no probes.
Engine closedFormEngine();

}  // namespace plumb::compare
