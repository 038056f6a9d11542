// What a control scheme lets an operator do, as its planner needs to know it.
#pragma once

#include "studio/gestures/control_scheme.h"

namespace muster {

/// What can be done with a scheme.
struct Repertoire {
    bool touch = false;        ///< Fingers, else a mouse.
    bool draws = false;        ///< A stroke is a way that a formation follows to its end.
    bool queues = false;       ///< Points can be added behind those that are not reached yet.
    bool divides = false;      ///< Parts can be sent apart.
    bool spreads = false;      ///< Two fingers set a formation's width and draw two ways at once.
    bool calls = false;        ///< Two taps call whoever is nearest.
    bool keepsShape = false;   ///< Those who are sent keep about their places beside each other; else they
                               ///< gather.
    bool keepsGroups = false;  ///< A digit brings a selection back.
};

/// The repertoire of a scheme.
Repertoire repertoireOf(const SchemeDef& def);

}  // namespace muster
