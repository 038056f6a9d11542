#include "studio/session/frames/frame_sender.h"

namespace muster {

void FrameSender::restart() {
    sentIds_ = 0;
    groups_.clear();
}

Status FrameSender::acknowledge(std::uint32_t number) {
    if (number > frame_) return invalidArgument("frame " + std::to_string(number) + " was never sent");
    if (number == frame_) awaitsAck_ = false;
    return {};
}

// Sends everything that a frame refers to before the frame.
void FrameSender::sendScene(const WorldPicture& picture, std::vector<MessageBytes>& messages) {
    if (sentScene_ != picture.sceneRevision) {
        messages.push_back(picture.scene);
        sentScene_ = picture.sceneRevision;
    }
    if (sentMotions_ != picture.motion.revision()) {
        messages.push_back(picture.motion.motions());
        sentMotions_ = picture.motion.revision();
    }
    for (std::size_t g = 0; g < picture.world.groupCount(); ++g) {
        const GroupView group = picture.world.group(g);
        const auto sent = groups_.find(group.id.value);
        if (sent != groups_.end() && sent->second.mesh == group.formationVersion) continue;
        messages.push_back(protocol::encode(buildGroupMesh(picture.world, g)));
        groups_[group.id.value] = {group.formationVersion, {}, {}, {}};
    }
}

// Writes what has changed of each group since the last frame: the offsets of places, how people stand, and
// the queue. What the client knows of the latter two is taken out of the frame until restoreGroups().
void FrameSender::encodeGroups(const WorldPicture& picture) {
    std::vector<protocol::GroupFrame>& groups = picture.frame.groups;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        protocol::GroupFrame& group = groups[g];
        SentGroup& sent = groups_[group.id];
        sent.places.encode(picture.frames.places()[g], group);
        group.queued = sent.queue != group.orders;
        if (group.queued)
            sent.queue = group.orders;
        else
            group.orders.clear();
        if (sent.standings == group.standings)
            group.standings.clear();
        else
            sent.standings = group.standings;
    }
}

// All clients share the frame, so it gets back what this client did not need.
void FrameSender::restoreGroups(protocol::Frame& frame) const {
    for (protocol::GroupFrame& group : frame.groups) {
        const SentGroup& sent = groups_.at(group.id);
        if (!group.queued) group.orders = *sent.queue;
        group.standings = sent.standings;
    }
}

void FrameSender::send(const WorldPicture& picture, double echo, std::vector<protocol::EventFrame>& events,
                       std::vector<MessageBytes>& messages) {
    sendScene(picture, messages);
    protocol::Frame& frame = picture.frame;
    const bool known = sentIds_ == picture.frames.idsVersion();
    crowd_.encode(picture.frames.crowd(), !known, frame.crowd);
    encodeGroups(picture);
    frame.frame = ++frame_;
    frame.touchEcho = echo;
    frame.events.swap(events);
    // Ids, groups and bodies are left out of this message where the client already has them.
    std::vector<std::uint32_t> ids;
    std::vector<std::uint16_t> groups;
    std::vector<std::uint8_t> classes, radii;
    const auto swapMembers = [&] {
        if (!known) return;
        ids.swap(frame.ids);
        groups.swap(frame.group);
        classes.swap(frame.unitClass);
        radii.swap(frame.radius);
    };
    swapMembers();
    messages.push_back(protocol::encode(frame));
    swapMembers();
    restoreGroups(frame);
    frame.events.swap(events);
    events.clear();
    sentIds_ = picture.frames.idsVersion();
    awaitsAck_ = true;
}

}  // namespace muster
