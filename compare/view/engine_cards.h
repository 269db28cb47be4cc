// SPDX-License-Identifier: MIT
// How does a page tell engines apart?
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <span>

#include <compare/check/verdict.h>

namespace plumb::compare {

/// In the order in which they are shown: name, label, role, look and own numbers of the engines of this build, of those
/// that the results have, and of variants with bullets.
nlohmann::json engineCards(std::span<const SceneResult> results = {});
/// The same of engines that run only if they are named, and of a track that somebody brings.
nlohmann::json cardsOnDemand();

}  // namespace plumb::compare
