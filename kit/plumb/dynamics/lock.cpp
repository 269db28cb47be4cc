// SPDX-License-Identifier: MIT
#include <plumb/dynamics/lock.h>

#include <plumb/dynamics/detail/joint_system.h>

namespace plumb {

Lock::Lock(bool locked) : joints_(locked ? &jointSystem : nullptr) {}

}  // namespace plumb
