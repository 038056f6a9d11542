// A session's sentences: what they would do, and doing it.
#include <algorithm>
#include <utility>

#include "studio/session/session_state.h"
#include "studio/session/words/spoken.h"

namespace muster {
namespace {

constexpr std::size_t kMostText = 1000;  // [bytes]
constexpr std::size_t kMostSaid = 60;    // [bytes]
constexpr std::size_t kMostSpoken = 256;
constexpr std::size_t kMostShown = 20;  // Parts with a forecast.

std::string lines(const std::vector<std::string>& all) {
    std::string text;
    for (const std::string& line : all) text += (text.empty() ? "" : "\n") + line;
    return text;
}

/// The sentence as a history shows it.
std::string labelOf(const std::string& text) {
    if (text.size() <= kMostSaid) return text;
    std::size_t end = kMostSaid;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
    return text.substr(0, end) + "...";
}

}  // namespace

Result<protocol::Said> Session::Impl::say(SessionClient& client, const protocol::Say& message) {
    if (!world) return Status(StatusCode::NotFound, "there is no world yet");
    if (message.text.size() > kMostText)
        return Status(StatusCode::LimitExceeded, "found a sentence of " +
                                                     std::to_string(message.text.size()) +
                                                     " bytes, expected at most " + std::to_string(kMostText));
    protocol::Said said;
    said.number = message.number;
    said.act = message.act;
    if (message.act == protocol::SayAct::Look) {
        said.sentences = lines(lookAround(*world)) + "\n" + lines(mapFromAbove(*world));
        return said;
    }
    std::vector<GroupId> chosen;
    for (const std::uint32_t id : message.chosen) chosen.push_back(GroupId{id});
    const WordsScene scene{*world, chosen};
    if (message.act != protocol::SayAct::Do)
        for (WordsCompletion& one : completions(message.text, scene))
            said.completions.push_back({std::move(one.words), std::move(one.whole)});
    if (message.act == protocol::SayAct::Complete) return said;
    Understood understood = understand(message.text, scene);
    said.sentences = lines(understood.sentences);
    said.problem = understood.problem;
    if (!said.problem.empty()) return said;
    if (message.act == protocol::SayAct::Preview) {
        if (understood.previews.size() > kMostShown) understood.previews.resize(kMostShown);
        addPreviews(said, understood, *world);
        return said;
    }
    const Status done = carryOut(client, std::move(understood), labelOf(message.text));
    if (!done.ok()) said.sentences.clear(), said.problem = done.message() + ".";
    return said;
}

Status Session::Impl::carryOut(SessionClient& client, Understood understood, const std::string& label) {
    using protocol::PlaybackAction;
    switch (understood.deed) {
        case WordsDeed::None:
            break;
        case WordsDeed::Play:
            return handle(client, protocol::Playback{PlaybackAction::Play});
        case WordsDeed::Pause:
            return handle(client, protocol::Playback{PlaybackAction::Pause});
        case WordsDeed::Restart:
            return handle(client, protocol::Playback{PlaybackAction::Restart});
        case WordsDeed::Undo:
            return undoEdit(client, false);
        case WordsDeed::Redo:
            return undoEdit(client, true);
    }
    if (understood.speed) return handle(client, protocol::SetSpeed{static_cast<float>(*understood.speed)});
    if (spoken.size() + understood.parts.size() > kMostSpoken)
        return {StatusCode::LimitExceeded, "Too many sentences wait for the next step"};
    const std::uint32_t sentence = editor.nextSentence();
    if (!understood.edits.empty()) {
        if (player) return {StatusCode::Unsupported, "A take is being replayed"};
        for (CommandBody& body : understood.edits)
            if (Status mine = directors.admit(client.number, body); !mine.ok()) return mine;
        if (Status s = editor.want(client.number, label, 0, std::move(understood.edits)); !s.ok()) return s;
        if (!playing) singleSteps = std::max(singleSteps, 1);
    }
    const bool waits = !understood.followers.empty();
    if (!understood.commands.empty()) {
        editor.speaks(sentence, label);
        const Status status = act(client, std::move(understood.commands));
        editor.speaks(0, "");
        if (!status.ok()) return status;
    }
    if (!waits) return {};
    spoken.push_back(
        {client.number, sentence, label, std::move(understood.parts), std::move(understood.followers)});
    // Parts are there after one step, also of a world that is paused.
    if (!playing) singleSteps = std::max(singleSteps, 1);
    return {};
}

// Orders to parts are given in the step after the one that has made them groups.
void Session::Impl::submitSpoken() {
    std::vector<SpokenRest> rests = std::exchange(spoken, {});
    for (SpokenRest& rest : rests) {
        SessionClient* const client = clientOf(rest.client);
        if (client == nullptr) continue;
        std::vector<CommandBody> bodies = commandsOf(rest, *world);
        if (bodies.empty()) continue;
        editor.speaks(rest.sentence, rest.label);
        const Status status = act(*client, std::move(bodies));
        editor.speaks(0, "");
        if (!status.ok()) notice(*client, protocol::NoticeLevel::Error, "Say", status.message());
    }
}

}  // namespace muster
