// What the two bodies measure.
#pragma once

#include <span>

#include "muster/vec3.h"

namespace muster::bodies {

/// A cut through a trunk, limb or head: two half ellipses.
struct Section {
    float along = 0.0f;   ///< Height of the cut; for arms how far out to the side it is [m].
    float side = 0.0f;    ///< Half the width to the sides; for arms half the height [m].
    float front = 0.0f;   ///< How far it reaches forward of x = 0 [m].
    float back = 0.0f;    ///< How far backward [m].
    bool far = false;     ///< Kept in the coarse mesh.
    float middle = 0.0f;  ///< Of legs: to the side; of arms: height [m].
};

/// Everything that makes one body differ from another.
struct Shape {
    std::span<const Section> pelvis;  ///< From where the legs part to under the shirt.
    std::span<const Section> shirt;   ///< From its hem to the collar.
    std::span<const Section> leg;     ///< From below the crotch to the trousers' hem.
    std::span<const Section> sleeve;  ///< From the shoulder to the sleeve's hem.
    std::span<const Section> arm;     ///< From inside the sleeve to the finger tips.
    std::span<const Section> neck;    ///< From inside the collar into the head.
    std::span<const Section> head;    ///< From the chin to the crown.
    std::size_t holeBegin = 0;  ///< Cuts of the shirt between which the sleeves start, in the fine mesh.
    std::size_t holeEnd = 0;
    float midDrop = 0.0f;    ///< How much lower the first cut of the pelvis is in the middle [m].
    float crotch = 0.0f;     ///< Height between the legs [m].
    float hairSides = 0.0f;  ///< Height of the hairline at the temples [m].
    float hairNape = 0.0f;   ///< And behind [m].
    float hairThick = 0.0f;  ///< [m]
    bool tied = false;       ///< Hair hangs in a tail.
    float handSize = 1.0f;   ///< Of the thumb.
    float footWidth = 1.0f;  ///< Of the shoes.
};

/// Wide shoulders, short hair.
const Shape& broadShape();
/// Narrow shoulders, wider hips, tied hair.
const Shape& narrowShape();

}  // namespace muster::bodies
