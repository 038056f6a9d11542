#include "files/export/exporter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "base/easing.h"
#include "files/edits/edited_crowd.h"
#include "files/export/chosen_people.h"
#include "muster/motion.h"

namespace muster {
namespace {

constexpr double kTimeGrain = 1e-7;  // Times closer than this are equal [s].

/// All characters after one step.
struct Moment {
    double time = 0.0;
    std::vector<ExportCharacter> characters;
    std::vector<BodyPose> poses;
};

/// Interpolates frames between steps.
class Resampler {
public:
    /// `times` are those of the frames in the take.
    Resampler(const ClipLibrary& library, const ExportDef& def, std::vector<double> times, EditedCrowd edited,
              Exporter& exporter)
        : def_(def),
          edited_(std::move(edited)),
          chosen_(def_),
          times_(std::move(times)),
          exporter_(exporter),
          posesWanted_(exporter.wantsPoses()) {
        if (exporter.wantsClips()) motion_.emplace(library, CrowdMotionDef{posesWanted_});
    }

    /// Takes the next step; returns false when no further steps are needed.
    bool observe(const World& world) {
        std::swap(before_, now_);
        const auto shown = edited_.shown(world);
        if (motion_) motion_->update(world, shown);
        // Steps that are not adjacent to a frame are only simulated.
        const double step = world.parameters().stepTime;
        if (world.time() + step * 1.5 >= frameTime()) fill(world);
        while (!done() && frameTime() <= world.time() + kTimeGrain) {
            status_ = exporter_.frame(make(world));
            if (!status_.ok()) return false;
            ++next_;
        }
        return !done();
    }

    bool done() const { return next_ == times_.size(); }
    double share() const { return static_cast<double>(next_) / static_cast<double>(times_.size()); }
    const Status& status() const { return status_; }
    /// False where somebody was to be chosen and nobody was.
    bool anyone() const { return chosen_.all() || chosen_.anyone(); }

private:
    double frameTime() const { return times_[next_]; }

    void fill(const World& world) {
        const CharactersView characters = world.characters();
        now_.time = world.time();
        now_.characters.resize(characters.size());
        if (posesWanted_) now_.poses.resize(characters.size());
        for (std::size_t i = 0; i < characters.size(); ++i) {
            ExportCharacter& out = now_.characters[i];
            out = {characters.id[i], characters.group[i], characters.position[i]};
            out.yaw = static_cast<float>(arcTangent2(characters.heading[i].y, characters.heading[i].x));
            out.size = characterSize(out.id);
            if (motion_) fillMotion(i, out);
        }
        if (!motion_) fillShown();
    }

    // Without motion edited people are put in their places here.
    void fillShown() {
        std::size_t i = 0;
        for (const ShownCharacter& one : edited_.shown()) {
            while (i < now_.characters.size() && now_.characters[i].id < one.id) ++i;
            if (i == now_.characters.size() || now_.characters[i].id != one.id || !one.moved) continue;
            now_.characters[i].position = one.position;
            now_.characters[i].yaw = static_cast<float>(arcTangent2(one.heading.y, one.heading.x));
        }
    }

    void fillMotion(std::size_t i, ExportCharacter& out) {
        const MotionState& state = motion_->states()[i];
        out.position = state.position;
        out.yaw = state.yaw;
        out.size = state.size;
        out.clip = state.clip;
        out.clipTime = state.time;
        out.fade = state.fade;
        if (!posesWanted_) return;
        const auto near = motion_->near();
        const auto at = std::lower_bound(near.begin(), near.end(), static_cast<std::uint32_t>(i));
        if (at != near.end() && *at == i)
            now_.poses[i] = motion_->pose(static_cast<std::size_t>(at - near.begin()));
    }

    ExportFrame make(const World& world) {
        const double span = now_.time - before_.time;
        const double share = span > 0.0 ? std::clamp((frameTime() - before_.time) / span, 0.0, 1.0) : 1.0;
        frame_ = now_.characters;
        if (posesWanted_) poses_.resize(frame_.size());
        std::size_t b = 0;
        for (std::size_t i = 0; i < frame_.size(); ++i) {
            if (posesWanted_) poses_[i] = now_.poses[i];
            while (b < before_.characters.size() && before_.characters[b].id < frame_[i].id) ++b;
            const bool known = b < before_.characters.size() && before_.characters[b].id == frame_[i].id;
            if (known && share < 1.0) between(b, share, i);
            if (posesWanted_) frame_[i].pose = &poses_[i];
        }
        chosen_.keep(world, frame_);
        return {next_, frameTime(), frame_, &world, edited_.shown()};
    }

    void between(std::size_t b, double share, std::size_t i) {
        const ExportCharacter& before = before_.characters[b];
        ExportCharacter& out = frame_[i];
        out.position = before.position + (out.position - before.position) * share;
        const double turn = static_cast<double>(out.yaw) - before.yaw;
        out.yaw = static_cast<float>(before.yaw + share * wrappedAngle(turn));
        // Where it goes on in its clip without a switch or a new beginning.
        if (before.clip == out.clip && before.clipTime <= out.clipTime && before.fade >= out.fade) {
            out.clipTime = before.clipTime + static_cast<float>(share) * (out.clipTime - before.clipTime);
            out.fade = before.fade + static_cast<float>(share) * (out.fade - before.fade);
        }
        if (posesWanted_) blend(before_.poses[b], now_.poses[i], static_cast<float>(share), poses_[i]);
    }

    ExportDef def_;
    EditedCrowd edited_;
    ChosenPeople chosen_;
    std::vector<double> times_;
    Exporter& exporter_;
    bool posesWanted_ = false;
    std::optional<CrowdMotion> motion_;
    Moment before_, now_;
    std::vector<ExportCharacter> frame_;
    std::vector<BodyPose> poses_;
    std::size_t next_ = 0;
    Status status_;
};

/// Steps of the integration of a frame's way through the take.
constexpr int kSpeedSamples = 8;

/// How the take's edits show the crowd in that part.
Result<EditedCrowd> editedCrowd(const Take& take, const ClipLibrary& library, const ExportDef& part,
                                ReplayFrom from) {
    auto tracks = gatherTracks(take, part.to, part.threads, from);
    if (!tracks.ok()) return tracks.status();
    EditedCrowd edited(take.about.edits, library);
    edited.setTracks(std::make_shared<const OwnTracks>(std::move(tracks).value()));
    return edited;
}

/// The times of the frames in the take.
std::vector<double> timesOf(const ExportDef& def) {
    std::vector<double> times;
    if (def.speeds.empty()) {
        const auto frames = static_cast<std::size_t>((def.to - def.from + kTimeGrain) * def.fps) + 1;
        for (std::size_t i = 0; i < frames; ++i) times.push_back(def.from + static_cast<double>(i) / def.fps);
        return times;
    }
    TakeAbout about;
    about.speeds = def.speeds;
    for (double time = def.from; time <= def.to + kTimeGrain;) {
        times.push_back(time);
        for (int i = 0; i < kSpeedSamples; ++i)
            time += about.speedAt(time + kTimeGrain) / (def.fps * kSpeedSamples);
    }
    return times;
}

}  // namespace

Result<std::vector<double>> exportTimes(const Take& take, ExportDef& def) {
    const double end = static_cast<double>(take.steps()) * take.def.parameters.stepTime;
    const auto bad = [end](const char* what, double found, const char* expected) {
        char text[160];
        std::snprintf(text, sizeof(text), "%s: found %.6g, expected %s; the take is %.6g s long", what, found,
                      expected, end);
        return invalidArgument(text);
    };
    if (!(def.fps >= 1.0 && def.fps <= 240.0)) return bad("fps", def.fps, "1 to 240 frames a second");
    if (!(def.from >= 0.0 && def.from <= end)) return bad("from", def.from, "a time within the take");
    if (def.to < 0.0) def.to = end;
    if (!(def.to >= def.from)) return bad("to", def.to, "a time not before from");
    if (def.to > end + 1e-6) return bad("to", def.to, "a time within the take");
    def.to = std::min(def.to, end);
    TakeAbout about;
    about.speeds = def.speeds;
    if (Status s = about.check(); !s.ok()) return s;
    if (def.firstPerson > def.lastPerson)
        return invalidArgument("people: found " + std::to_string(def.firstPerson) + " to " +
                               std::to_string(def.lastPerson) + ", expected the smaller number first");
    return timesOf(def);
}

Status exportTake(const Take& take, const ClipLibrary& library, const ExportDef& def, Exporter& exporter,
                  const ExportProgress& progress, ReplayFrom from) {
    ExportDef part = def;
    auto times = exportTimes(take, part);
    if (!times.ok()) return times.status();
    auto start = World::create(take.def, part.threads);
    if (!start.ok()) return start.status();
    auto edited = editedCrowd(take, library, part, from);
    if (!edited.ok()) return edited.status();
    const std::size_t chosen = ChosenPeople(part).idsIn(*start).size();
    const ExportInfo info{take.def.name, part.fps, part.from, times->size(), &*start, &library, chosen};
    if (Status s = exporter.begin(info); !s.ok()) return s;
    Resampler resampler(library, part, std::move(*times), std::move(edited).value(), exporter);
    bool more = resampler.observe(*start);
    bool cancelled = false;
    if (more) {
        const auto report = replayTake(
            take, part.threads,
            [&](const World& world) {
                more = resampler.observe(world);
                cancelled = progress && !progress(resampler.share());
                return more && !cancelled;
            },
            from);
        if (!report.ok()) return report.status();
    }
    if (!resampler.status().ok()) return resampler.status();
    if (cancelled) return {StatusCode::Unsupported, "the export was cancelled"};
    if (!resampler.done()) return {StatusCode::Corrupt, "the take ended before its last frame"};
    if (!resampler.anyone()) return invalidArgument("nobody in this part of the take was chosen");
    return exporter.finish();
}

}  // namespace muster
