#include "studio/study/host/trial_screen.h"

#include "muster/own_clips.h"
#include "studio/session/frames/scene_message.h"
#include "studio/session/frames/scene_signature.h"

namespace muster {

void TrialScreen::begin(const Trial& trial) {
    const TrialDef& def = trial.def();
    const auto environment = studyEnvironment(def.environment);
    auto world = environment.ok() ? studyWorld(environment.value(), def.crowd, def.seed, def.mirrored)
                                  : Result<WorldDef>(environment.status());
    if (world.ok()) def_ = std::move(world).value();  // The trial was made of the same, so it is there.
    frames_.restart();
    motion_.restart(ownClips());
    motion_.observe(trial.world(), {});
    refreshScene(trial);
}

void TrialScreen::observe(const Trial& trial, const std::vector<Attention>& attentions) {
    frames_.observe(trial.world());
    motion_.observe(trial.world(), attentions);
    ++state_;
    if (sceneSignature(trial.world()) != signature_) refreshScene(trial);
}

void TrialScreen::refreshScene(const Trial& trial) {
    signature_ = sceneSignature(trial.world());
    const Place place;
    scene_ = protocol::encode(
        sceneMessage({trial.def().environment, def_, trial.world(), place, 1, false}, ++sceneRevision_));
    ++state_;
}

void TrialScreen::send(const Trial& trial, bool playing, double speed, double echo, FrameSender& sender,
                       std::vector<MessageBytes>& messages) {
    if (built_ != state_) {
        frames_.build(trial.world(), frame_);
        motion_.build(frames_.crowd());
        built_ = state_;
    }
    frame_.playing = playing;
    frame_.speed = static_cast<float>(speed);
    frame_.recordedSeconds = -1.0f;
    frame_.sceneRevision = sceneRevision_;
    const WorldPicture picture{trial.world(), frames_, motion_, sceneRevision_, scene_, frame_};
    std::vector<protocol::EventFrame> events;
    sender.send(picture, echo, events, messages);
}

}  // namespace muster
