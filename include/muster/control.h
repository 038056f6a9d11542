// Controls: points of a group's mesh that fingers move along trajectories.
#pragma once

#include "muster/generated/control.h"
