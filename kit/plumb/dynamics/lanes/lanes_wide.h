// SPDX-License-Identifier: MIT
// Which templates have the number of lanes as their parameter?
#pragma once
#include <plumb/dynamics/bodies/body_solver_wide.h>
#include <plumb/dynamics/contacts/lanes/contact_solver_wide.h>
#include <plumb/dynamics/contacts/lanes/lane_collider_wide.h>
#include <plumb/dynamics/joints/lanes/island_wide.h>
#include <plumb/dynamics/joints/lanes/swept_joints_wide.h>
