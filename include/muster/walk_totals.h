// Sums over the path costs of many.
#pragma once

#include "muster/generated/walk_totals.h"
