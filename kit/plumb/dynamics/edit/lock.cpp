// SPDX-License-Identifier: MIT
#include <plumb/dynamics/lock.h>

#include <plumb/dynamics/edit/joint_edits.h>

namespace plumb {

Lock::Lock(bool locked) : joints_(locked ? &jointEdits : nullptr) {}

}  // namespace plumb
