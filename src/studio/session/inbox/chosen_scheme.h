// The control scheme that judges one client's raw inputs, and both as messages.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "muster/session.h"
#include "studio/gestures/control_scheme.h"
#include "studio/gestures/scheme_driver.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// Where a client's inputs are judged, if it chose a scheme.
class ChosenScheme {
public:
    /// Another scheme for the client of that number; an empty name for none. Fails with NotFound, listing
    /// the names, and changes nothing then.
    Status choose(const std::string& name, std::uint32_t client);
    /// A new world began, in which the client has that number: what the scheme remembers is forgotten.
    void restart(std::uint32_t client);
    /// How the ground is seen from now on; it outlives schemes and worlds.
    void setView(const GroundView& view, const World* world);
    /// Takes an input. Fails where there is no scheme or no view yet, and where the input is malformed.
    Status input(const InputEvent& event, const World& world);
    /// The commands for the next step.
    std::vector<CommandBody> take(const World& world);
    /// Appends what is to be shown, where it changed.
    void send(std::vector<MessageBytes>& messages);

private:
    std::string name_;
    SchemeDef def_;
    std::optional<GroundView> view_;
    std::optional<SchemeDriver> driver_;
    bool viewKnown_ = false;      // The driver knows the view.
    std::vector<Command> taken_;  // Working memory.
    MessageBytes sent_;           // The marks that were sent last.
};

/// The message as an input that happens at `time`, in world time [s].
InputEvent inputOf(const protocol::RawInput& raw, double time);
/// The message as a view. Fails where it holds no nine numbers, or none that can be inverted.
Result<GroundView> groundViewOf(const protocol::SetView& message);
/// Checks a message's number of inputs and their times.
Status checkInputs(const protocol::Inputs& message, const SessionLimits& limits);
/// What is to be shown of a scheme of that name.
protocol::Marks marksOf(std::string name, const SchemeMarks& marks);
/// The scheme for a list to choose from.
protocol::SchemeInfo infoOf(const NamedScheme& scheme);
/// x, y of each.
std::vector<float> pairsOf(const std::vector<Vec2>& points);

}  // namespace muster
