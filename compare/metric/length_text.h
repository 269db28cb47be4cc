// SPDX-License-Identifier: MIT
// How does a person read a length?
#pragma once
#include <string>

namespace plumb::compare {

/// In m, mm, µm or nm to three digits; as a power of ten when it is smaller still; below 1e-15 m it is 0.
std::string lengthText(double metres);

}  // namespace plumb::compare
