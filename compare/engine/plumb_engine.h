// SPDX-License-Identifier: MIT
// How is a scene run in Plumb itself?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

Engine plumbEngine();

}  // namespace plumb::compare
