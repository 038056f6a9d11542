// A session's tracks: what the open take tells whom, and the same take with other blocks.
#include "files/take/take_encoder.h"
#include "studio/session/session_state.h"
#include "studio/session/takes/edit_tracks.h"

namespace muster {

void Session::Impl::sendTracks(SessionClient& client) {
    if (!client.watchesTracks || client.sentTracks == takeNumber || !player || player->preparing()) return;
    client.sentTracks = takeNumber;
    protocol::TakeTracks answer;
    answer.revision = takeNumber;
    for (const TakeNews::GroupTimes& group : player->news().groups())
        answer.tracks.push_back(
            {group.id.value, group.name, group.from, std::min(group.to, player->steps())});
    std::uint32_t id = 0;
    for (const TakeBlock& block : takeBlocks(player->take(), player->paths(), player->news()))
        answer.blocks.push_back({id++, block.group.value, block.kind, block.begin, block.begun, block.end,
                                 block.label, block.moves, block.stretches});
    answer.undo = versions.undo();
    answer.redo = versions.redo();
    client.outbox.push_back(protocol::encode(answer));
}

Status Session::Impl::changeTracks(const protocol::EditTrack& message) {
    if (!player) return {StatusCode::Unsupported, "no take is open, so nothing in it can be changed"};
    if (player->stored())
        return {StatusCode::Unsupported, "the take is shown from its stored frames and cannot be changed"};
    if (message.edit == protocol::TrackEdit::Undo || message.edit == protocol::TrackEdit::Redo)
        return stepVersion(message.edit == protocol::TrackEdit::Redo);
    if (message.revision != takeNumber)
        return {StatusCode::Unsupported, "the take has changed meanwhile; try again"};
    if (player->preparing())
        return {StatusCode::Unsupported, "the take is still being read; it can be changed in a moment"};
    const TrackChange change{message.edit, message.block, message.step, GroupId{message.group},
                             player->first()};
    auto changed = editTracks(player->take(), player->paths(), player->news(), change);
    if (!changed.ok()) return changed.status();
    TakeVersion before = present();
    before.what = changed->what;
    const std::size_t refused = player->news().refused();
    TakeVersions kept = std::move(versions);
    if (kept.undo().empty() && kept.redo().empty()) kept.fileName.clear();
    if (Status s = openChanged(std::move(changed->take)); !s.ok()) return versions = std::move(kept), s;
    refusedBefore = refused;
    kept.changed(std::move(before));
    versions = std::move(kept);
    tracksChange = true;
    return {};
}

TakeVersion Session::Impl::present() const {
    return {player->shared(), player->about(), player->fileName(), takenBytes, !player->marks(), {}};
}

// The take before the last change or after it: the same bytes again.
Status Session::Impl::stepVersion(bool redo) {
    TakeVersions kept = versions;
    const auto shown = kept.step(present(), redo);
    if (!shown)
        return {StatusCode::NotFound,
                redo ? "there is nothing to do again" : "there is nothing to take back"};
    const std::uint32_t now = world->stepCount();
    auto opened = shown->marked ? std::make_unique<TakePlayer>(shown->take, shown->fileName)
                                : TakePlayer::marking(shown->take);
    // The camera and speeds are no part of what is taken back.
    TakeAbout about = shown->about;
    about.camera = player->about().camera;
    about.speeds = player->about().speeds;
    opened->edit(about, player->loops());
    if (Status s = begin(name, shown->take->def, std::move(opened)); !s.ok()) return s;
    takenBytes = shown->bytes;
    versions = std::move(kept);
    tracksChange = !shown->marked;
    playing = false;
    player->want(now);
    touchState();
    const bool changes = !shown->fileName.empty() && shown->fileName == versions.fileName;
    if (changes) return shown->marked ? def.replaceTake(shown->fileName, openBytes()) : Status();
    const bool said = !(about == shown->about) && !shown->fileName.empty() && def.keepAbout;
    return said ? def.keepAbout(shown->fileName, about) : Status();
}

// What changes of blocks make goes to one file, beside the take that they began with.
std::string Session::Impl::keepTracks() {
    if (!def.replaceTake) return keepFile();
    if (!versions.fileName.empty() && def.replaceTake(versions.fileName, openBytes()).ok())
        return versions.fileName;
    return versions.fileName = keepFile();
}

void Session::Impl::tellRefused(std::size_t before) {
    const std::size_t refused = player->news().refused();
    if (refused <= before) return;
    noticeAll(protocol::NoticeLevel::Warning, "track",
              std::to_string(refused - before) +
                  " of the take's commands no longer apply: " + player->news().firstRefusal() + ".");
}

}  // namespace muster
