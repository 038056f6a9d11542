// A session's paths: where somebody goes in the open take, and the same take with another path.
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "files/take/take_encoder.h"
#include "studio/session/session_state.h"
#include "studio/session/takes/bend_path.h"

namespace muster {

Status Session::Impl::askPath(SessionClient& client, const protocol::AskPath& message) {
    if (!player) return {StatusCode::Unsupported, "no take is open, so there is no path to show"};
    client.path = message;
    return {};
}

void Session::Impl::sendPath(SessionClient& client) {
    if (!client.path || !player || player->preparing()) return;
    protocol::TakePath answer;
    answer.group = client.path->group;
    answer.character = client.path->character;
    answer.spacing = kPathSpacing;
    std::uint32_t first = 0;
    const std::vector<Vec2> points = client.path->character == 0
                                         ? player->paths().ofGroup(GroupId{answer.group}, first)
                                         : player->paths().ofCharacter(answer.character, first);
    // Who came later stood, for the eye, at its first point.
    const std::size_t before = points.empty() ? 0 : first / kPathSpacing;
    for (std::size_t k = 0; k < before + points.size(); ++k) {
        const Vec2 p = points[k < before ? 0 : k - before];
        answer.points.push_back(static_cast<float>(p.x));
        answer.points.push_back(static_cast<float>(p.y));
    }
    client.path.reset();
    client.outbox.push_back(protocol::encode(answer));
}

Status Session::Impl::changePath(const protocol::BendPath& message) {
    if (!player) return {StatusCode::Unsupported, "no take is open, so no path can be changed"};
    if (player->stored())
        return {StatusCode::Unsupported,
                "the take is shown from its stored frames, so no path can be changed"};
    if (player->preparing())
        return {StatusCode::Unsupported,
                "the take is still being read; its paths can be changed in a moment"};
    const PathBend bend{
        GroupId{message.group}, message.character, message.step, {message.dx, message.dy}, message.seconds};
    auto changed = bendPath(player->take(), player->paths(), inspect::environment(*world), bend);
    if (!changed.ok()) return changed.status();
    return openChanged(std::move(changed).value());
}

// A take with other commands opens, and is simulated again.
Status Session::Impl::openChanged(Take changed) {
    TakeAbout about = player->about();
    const std::string ending = " (changed)";
    if (about.title.empty()) about.title = worldDef.name;
    if (!about.title.ends_with(ending) && about.title.size() + ending.size() <= TakeAbout::kMaxTitleBytes)
        about.title += ending;
    const std::uint32_t now = world->stepCount();
    auto take = std::make_shared<Take>(std::move(changed));
    take->about = about;
    if (Status s = begin(name, take->def, TakePlayer::marking(take)); !s.ok()) return s;
    takenBytes = TakeEncoder::whole(*take, about);
    playing = false;
    player->want(now);
    touchState();
    return {};
}

// Keeps the open take as a new file on the shelf, and gives its name; none where that is not possible.
std::string Session::Impl::keepFile() {
    if (!def.openSink) return {};
    auto sink = def.openSink(name);
    Status status = sink.ok() ? (*sink)->append(takenBytes) : sink.status();
    if (status.ok()) status = (*sink)->finish();
    if (status.ok()) return (*sink)->name();
    noticeAll(protocol::NoticeLevel::Warning, "record", status.message());
    return {};
}

// The changed take has been simulated to its end.
void Session::Impl::keepChanged() {
    takenBytes = TakeEncoder::whole(player->take(), player->about());
    const std::string file = tracksChange ? keepTracks() : keepFile();
    if (tracksChange) tellRefused(refusedBefore);
    tracksChange = false;
    player->kept(file);
    touchTake();
    const protocol::TakeKept kept{file, player->steps() * world->parameters().stepTime, worldDef.name};
    for (auto& [id, to] : clients)
        if (to.greeted) to.outbox.push_back(protocol::encode(kept));
}

}  // namespace muster
