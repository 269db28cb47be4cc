// SPDX-License-Identifier: MIT
#include <string>

#include <compare/scene/json_value.h>
#include <compare/scene/json_writer.h>

namespace plumb::compare {

Json jsonOf(const Scene& scene, Defaults defaults) {
    validate(scene);
    return uncheckedJsonOf(scene, defaults);
}

Json uncheckedJsonOf(const Scene& scene, Defaults defaults) {
    return JsonWriter(defaults).write(scene);
}

std::string toJson(const Scene& scene, Defaults defaults) {
    return formatJson(jsonOf(scene, defaults));
}

}  // namespace plumb::compare
