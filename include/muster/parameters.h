// Parameters of a world. muster/parameter_table.h gives access to them by name.
#pragma once

#include "muster/generated/parameters.h"
