// SPDX-License-Identifier: MIT
// What may be written in a scene's file?
#pragma once
#include <string>

#include <compare/scene/json_text.h>

namespace plumb::compare {

/// A JSON Schema, draft 2020-12. It is made from the lists of fields by which scenes are read: types, defaults, bounds,
/// and required fields. A schema cannot say that a name must exist or that one number must be less than another; the
/// reader checks that. In addition to the words of the standard, "unit" is the unit of a number.
std::string sceneSchema();

/// The same as a page in Markdown: a table for each kind of object.
std::string sceneSchemaPage();

/// A page in Markdown with a table for each definition of the schema: field, kind, unit, default, bounds, what it is.
std::string schemaPage(const Json& schema);

}  // namespace plumb::compare
