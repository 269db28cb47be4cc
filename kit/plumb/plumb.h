// SPDX-License-Identifier: MIT
// Everything a first program needs.
#pragma once
#include <plumb/dynamics/world.h>
#include <plumb/record/forecast.h>
#include <plumb/record/state_hash.h>
#include <plumb/shapes/tile_text.h>
#include <plumb/space/shape_def.h>
#include <plumb/stepping/clock.h>
