// Definitions from which a world is made: the data of a scenario.
#pragma once

#include "muster/formation.h"
#include "muster/generated/world_definitions.h"
#include "muster/ground.h"
#include "muster/order.h"
#include "muster/parameters.h"
#include "muster/people.h"
