// SPDX-License-Identifier: MIT
#include <compare/scene/json_value.h>
#include <compare/scene/json_writer.h>

namespace plumb::compare {

Json jsonOf(const Scene& scene, Defaults defaults) {
    validate(scene);
    return defaults == Defaults::Written ? JsonWriter<Defaults::Written>::write(scene)
                                         : JsonWriter<Defaults::LeftOut>::write(scene);
}

std::string toJson(const Scene& scene, Defaults defaults) {
    return formatJson(jsonOf(scene, defaults));
}

}  // namespace plumb::compare
