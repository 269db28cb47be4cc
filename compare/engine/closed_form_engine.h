// SPDX-License-Identifier: MIT
// How is the textbook's answer put beside the engines?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// States are NaN for bodies and times that the closed form says nothing about; no probes.
Engine closedFormEngine();

}  // namespace plumb::compare
