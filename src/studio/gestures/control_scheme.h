// Control schemes: from raw inputs to commands (SPEC U1 to U7, B2, X12; paper sections 4 and 7.5).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "muster/status.h"
#include "muster/world.h"
#include "studio/gestures/input_event.h"

namespace muster {

/// By what a crowd is directed.
enum class SchemeKind : std::uint8_t {
    Touch,       ///< Fingers on the mesh: Muster's own, with shapes, split and merge.
    MousePaper,  ///< The paper's figure 12: a right drag selects, a left click sends.
    MouseFull,   ///< What strategy players expect: selections, control groups, queued points.
    MouseMesh,   ///< The mesh by mouse and keys (SPEC U7).
};

/// How those who were sent to a point get there.
enum class SchemeMovement : std::uint8_t {
    Continuum,  ///< By one continuum field (Treuille et al. 2006), without formation.
    Free,       ///< By Muster's free move: each by the shortest way, in formation at the end.
};

/// A control scheme and its switches.
struct SchemeDef {
    SchemeKind kind = SchemeKind::Touch;                  ///< By what the crowd is directed.
    SchemeMovement movement = SchemeMovement::Continuum;  ///< For MousePaper and MouseFull.
    bool oneFinger = false;  ///< For Touch: other fingers than the first are ignored.
    bool shapes = true;      ///< False: lines, areas and widths are off; one point moves a formation.
    bool splits = true;      ///< False: nothing divides or joins formations.
    bool calls = true;       ///< For Touch: two taps where nobody stands call whoever is nearest.

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, movement, oneFinger, shapes, splits, calls);
    }
    friend bool operator==(const SchemeDef&, const SchemeDef&) = default;
};

/// A control scheme with its switches, as files, reports and the page name it.
struct NamedScheme {
    std::string_view name;         ///< "touch", "mouse-full-free"...
    std::string_view title;        ///< For display: "Touch", "Mouse, full, free move"...
    std::string_view description;  ///< One or two sentences: how it is used.
    SchemeDef def;                 ///< What it is.
};

/// True where a scheme takes hold of the mesh, as fingers do; false for those that send characters.
constexpr bool holdsMesh(SchemeKind kind) {
    return kind == SchemeKind::Touch || kind == SchemeKind::MouseMesh;
}

/// All schemes, the ablations among them, in the order of display.
std::span<const NamedScheme> namedSchemes();
/// The scheme of that name. Fails with NotFound, listing the names.
Result<NamedScheme> namedScheme(std::string_view name);

/// What a scheme shows of what is being done.
struct SchemeMarks {
    std::vector<std::uint32_t> selected;  ///< Ids of the characters that are selected, ascending.
    std::vector<Vec2> rectangle;          ///< Corners of the box that is being drawn [m]; empty for none.
    std::vector<Vec2> stroke;             ///< What a finger draws that moves nothing yet [m]: a cut, a loop.
    std::vector<Vec2> goals;              ///< Points to which the selected are on their way [m].
    std::string notice;                   ///< What the last gesture missed, in one sentence; empty for none.
};

/// Judges inputs. It reads the world and answers with commands; it keeps no copy of the world.
class ControlScheme {
public:
    virtual ~ControlScheme() = default;

    /// Takes one input, in the order of time. Appends the commands that follow from it.
    virtual void input(const InputEvent& event, const World& world, std::vector<CommandBody>& commands) = 0;
    /// Call once before every step, after its inputs: for what takes several steps, as giving an order to a
    /// group that the last step has made.
    virtual void beforeStep(const World& world, std::vector<CommandBody>& commands) = 0;
    /// What is to be shown.
    virtual const SchemeMarks& marks() const = 0;
    /// True while it waits for a step, or a pointer is down.
    virtual bool busy() const = 0;
};

/// Makes a scheme whose commands are given by the client of that number.
std::unique_ptr<ControlScheme> makeControlScheme(const SchemeDef& def, std::uint32_t client);

}  // namespace muster
