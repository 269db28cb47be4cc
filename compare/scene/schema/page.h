// SPDX-License-Identifier: MIT
// How is a schema written as a page?
#pragma once
#include <string>

#include <compare/scene/json_text.h>

namespace plumb::compare {

/// A page in Markdown with a table for each definition of the schema: field, kind, unit, default, bounds, what it is.
std::string schemaPage(const Json& schema);

}  // namespace plumb::compare
