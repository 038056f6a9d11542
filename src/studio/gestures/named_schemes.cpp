#include <array>

#include "studio/gestures/control_scheme.h"

namespace muster {
namespace {

using enum SchemeKind;
using enum SchemeMovement;

constexpr std::array<NamedScheme, 9> kSchemes{{
    {"touch",
     "Touch",
     "Fingers on the crowd: drag, spread, pull apart, join; two taps call somebody.",
     {Touch, Free}},
    {"mouse-paper",
     "Mouse, as in the paper",
     "Drag with the right button across characters to select them; click with the left one to send them.",
     {MousePaper, Continuum}},
    {"mouse-full-continuum",
     "Mouse, full, continuum",
     "Drag to select, Shift adds, Ctrl removes; the right button sends, with Shift it adds a point; Ctrl and "
     "a "
     "digit keep a selection.",
     {MouseFull, Continuum}},
    {"mouse-full-free",
     "Mouse, full, free move",
     "As the other full mouse; each goes by the shortest way, in formation at the end.",
     {MouseFull, Free}},
    {"mouse-mesh", "Mouse on the mesh", "The mesh by one mouse and keys.", {MouseMesh, Free}},
    {"touch-one-finger",
     "Touch, one finger",
     "As Touch; other fingers than the first do nothing.",
     {Touch, Free, true, true, true}},
    {"touch-no-shapes",
     "Touch, no change of shape",
     "As Touch; a formation keeps its shape.",
     {Touch, Free, false, false, true}},
    {"touch-no-splits",
     "Touch, no split",
     "As Touch; the crowd stays whole, as the paper's.",
     {Touch, Free, false, true, false}},
    {"touch-no-calls",
     "Touch, no calls",
     "As Touch; two taps call nobody.",
     {Touch, Free, false, true, true, false}},
}};

}  // namespace

std::span<const NamedScheme> namedSchemes() {
    return kSchemes;
}

Result<NamedScheme> namedScheme(std::string_view name) {
    std::string names;
    for (const NamedScheme& scheme : kSchemes) {
        if (scheme.name == name) return scheme;
        names += (names.empty() ? "" : ", ") + std::string(scheme.name);
    }
    return Status{StatusCode::NotFound, "no control scheme is called '" + std::string(name.substr(0, 60)) +
                                            "'; there are " + names};
}

}  // namespace muster
