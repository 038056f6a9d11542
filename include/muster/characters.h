// Read access to the characters of a world.
#pragma once

#include "muster/generated/characters.h"
