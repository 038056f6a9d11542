#include "files/export/formats.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "base/appearance_text.h"
#include "base/output_file.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "files/export/character_look.h"
#include "files/export/player/crowd_track.h"
#include "files/export/player/player_format.h"
#include "files/export/player/scene_record.h"
#include "files/export/scene_camera.h"
#include "json/json.h"

namespace muster {
namespace {

/// A moving obstacle or patch.
struct MovingObject {
    Vec2 pivot;
    TimedPath path;
};

class PlayerExporter final : public Exporter {
public:
    explicit PlayerExporter(std::string path) : path_(std::move(path)) {}

    bool wantsPoses() const override { return false; }
    bool wantsClips() const override { return true; }

    Status begin(const ExportInfo& info) override {
        info_ = info;
        if (Status s = checkSize(info.people() * info.frames); !s.ok()) return s;
        track_.emplace(*info.clips);
        box_ = inspect::environment(*info.world).def().box;
        return file_.open(path_);
    }

    Status frame(const ExportFrame& frame) override {
        if (frame.index == 0) addScene(*frame.world);
        track_->frame(frame);
        for (std::size_t k = 0; k < moving_.size(); ++k) {
            const Waypoint at = moving_[k].path.at(frame.time);
            track_->thing(k, moving_[k].pivot + at.position, at.angle);
        }
        return checkSize(track_->samples());
    }

    Status finish() override {
        PlayerFile file;
        const std::string frames = track_->finish();
        file.add("head", compactJson(head()));
        file.add("body", playerBodies(*track_));
        file.add("clip", playerClips(*info_.clips, track_->clips()));
        file.add("land", scene_.finish());
        file.add("crwd", frames);
        if (Status s = file_.write(file.bytes()); !s.ok()) return s;
        return file_.commit();
    }

private:
    static Status checkSize(std::uint64_t samples) {
        if (samples <= kMostPlayerSamples) return {};
        char text[200];
        std::snprintf(
            text, sizeof(text),
            "player: found %llu positions (characters in all frames together), expected at most %llu; "
            "take a shorter part or fewer frames a second",
            static_cast<unsigned long long>(samples), static_cast<unsigned long long>(kMostPlayerSamples));
        return {StatusCode::LimitExceeded, text};
    }

    void addScene(const World& world) {
        visitScene(world, [&](const ScenePlan& plan, const std::function<void(SceneShapes&)>& addShapes) {
            const bool moves = !plan.path.still();
            scene_.begin(plan, moves);
            addShapes(scene_);
            scene_.end();
            if (moves) moving_.push_back({plan.pivot, plan.path});
        });
    }

    Json head() const {
        Json colours = Json::array();
        for (const std::uint32_t colour : track_->colours())
            colours.push(colour < kAccents ? Json(colour) : Json(colourText(colour & 0xFFFFFFu)));
        return {{"title", info_.name},
                {"fps", info_.fps},
                {"frames", info_.frames},
                {"from", info_.from},
                {"most", track_->mostAtOnce()},
                {"samples", track_->samples()},
                {"clips", track_->clips().size()},
                {"things", moving_.size()},
                {"colours", colours},
                {"box", Json::array({box_.min.x, box_.min.y, box_.max.x, box_.max.y})},
                // The studio's view as it opens; the page moves it away until everybody is seen.
                {"camera", {{"turn", kViewTurn}, {"pitch", kViewPitch}, {"angle", kViewAngle}}}};
    }

    std::string path_;
    ExportInfo info_;
    OutputFile file_;
    Box box_;
    std::optional<CrowdTrack> track_;
    SceneRecord scene_;
    std::vector<MovingObject> moving_;
};

}  // namespace

std::unique_ptr<Exporter> makePlayerExporter(const std::string& path) {
    return std::make_unique<PlayerExporter>(path);
}

}  // namespace muster
