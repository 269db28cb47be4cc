// SPDX-License-Identifier: MIT
// What may stand in a scene's file?
#pragma once
#include <string>

namespace plumb::compare {

/// A JSON Schema, draft 2020-12, made from the lists of fields by which scenes are read: types, defaults, bounds, and
/// which fields a file must have. What no schema can say, that a name is one that exists or one number less than
/// another, is left to the reader. Beside the words of the standard, "unit" is the unit of a number.
std::string sceneSchema();

/// The same as a page in Markdown: a table for each kind of object.
std::string sceneSchemaPage();

}  // namespace plumb::compare
