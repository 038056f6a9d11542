// Made by schema/generate.mjs from schema/messages.txt: change these, not this file.
// clang-format off
#include <array>

#include "studio/session/inbox/protocol.h"

namespace muster::protocol {
namespace {

constexpr std::array kClientNames{
    "Hello", "Touches", "Playback", "SetSpeed", "LoadScenario", "Record", "SetOverlay", "Commands", "Attend",
    "FrameAck", "Ping", "Seek", "TakeAgain", "EditTake", "AskForecasts", "SetName", "GiveGroup", "SetScheme",
    "SetView", "Inputs", "EnterStudy", "AnswerForm", "AskPath", "BendPath", "Edit", "UndoEdit", "DoInStudy",
    "AskPlaces", "WatchStages", "AskStandings", "AskOthers", "AnswerAsk", "Build", "KeepPlace", "Say",
    "WatchTracks", "EditTrack", "EditPeople"};
constexpr std::array kServerNames{
    "Welcome", "Scene", "Motions", "GroupMesh", "Frame", "Overlay", "Notice", "Pong", "TakePath",
    "EditHistory", "Forecasts", "TakeState", "TakeReady", "TakeKept", "Directors", "Marks", "StudyForm",
    "StudyState", "Places", "StageTimes", "Standings", "SharedWorld", "Ask", "AskAnswered", "Scenarios",
    "PlaceKept", "Said", "TakeTracks", "TakeEdits"};
static_assert(kClientNames.size() == std::variant_size_v<ClientMessage>);
static_assert(kServerNames.size() == std::variant_size_v<ServerMessage>);

}  // namespace

const char* messageName(const ClientMessage& message) { return kClientNames[message.index()]; }

const char* messageName(const ServerMessage& message) { return kServerNames[message.index()]; }

}  // namespace muster::protocol
