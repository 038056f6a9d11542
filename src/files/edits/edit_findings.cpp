#include "files/edits/edit_findings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

#include "engine/ground/environment/environment.h"
#include "files/edits/edited_path.h"

namespace muster {
namespace {

constexpr double kSample = 0.1;        // [s]
constexpr double kSpeedSpan = 0.4;     // Time over which a speed is measured [s].
constexpr double kOverlapShare = 0.9;  // Bodies nearer than this share of their radii overlap.
constexpr double kAtWall = 0.03;       // So much of a body may be in an obstacle [m].
constexpr double kFaster = 1.1;        // More than this share of the top speed is too fast.
constexpr double kMoved = 0.01;        // A smaller displacement is none [m].
constexpr double kPause = 0.35;        // Findings nearer in time are one [s].
constexpr std::size_t kMost = 20;      // Findings of a person.
constexpr double kWidest = 1.5;        // Largest radius of a body [m].

std::optional<Vec2> recordedAt(const RecordedPath& path, double spacing, double time) {
    if (path.points.empty()) return std::nullopt;
    const auto last = static_cast<double>(path.points.size() - 1);
    const double at = (time - path.first) / spacing;
    if (at < -1e-9 || at > last + 1.0) return std::nullopt;
    const double inside = std::clamp(at, 0.0, last);
    const auto k = static_cast<std::size_t>(inside);
    const Vec2 a = path.points[k], b = path.points[std::min(k + 1, path.points.size() - 1)];
    return a + (b - a) * (inside - static_cast<double>(k));
}

/// The path of one person as it is shown.
class ShownPath {
public:
    ShownPath(const RecordedPath& path, const TakeEdit* edit, double spacing)
        : path_(&path), edit_(edit), spacing_(spacing) {
        if (edit != nullptr) clock_ = OwnClock(edit->clock);
    }

    const RecordedPath& recorded() const { return *path_; }
    bool edited() const { return edit_ != nullptr; }

    /// Who is not in the recording at that time is not shown.
    std::optional<Vec2> at(double time) const {
        const auto here = recordedAt(*path_, spacing_, time);
        if (!here || edit_ == nullptr) return here;
        const double own = clock_.at(time).time;
        const double first = path_->first;
        const double last = first + spacing_ * static_cast<double>(path_->points.size() - 1);
        const auto was = recordedAt(*path_, spacing_, std::clamp(own, first, last));
        return was ? *was + pinMove(edit_->pins, own).offset : here;
    }

    /// Where it is shown elsewhere than it was.
    std::optional<Vec2> movedAt(double time) const {
        const auto shown = at(time), was = recordedAt(*path_, spacing_, time);
        if (!shown || !was || distance(*shown, *was) < kMoved) return std::nullopt;
        return shown;
    }

private:
    const RecordedPath* path_;
    const TakeEdit* edit_;
    double spacing_;
    OwnClock clock_{{}};
};

std::string between(double from, double to) {
    char text[80];
    if (to - from < 0.05)
        std::snprintf(text, sizeof text, " at %.1f s", from);
    else
        std::snprintf(text, sizeof text, " from %.1f to %.1f s", from, to);
    return text;
}

/// Joins what is found at single moments to findings.
class FindingList {
public:
    explicit FindingList(const Environment& environment) : environment_(environment) {}

    void add(const RecordedPath& path, FindingKind kind, std::uint32_t other, double time, Vec2 where,
             double worst) {
        const auto key = std::pair(kind, other);
        const auto open = open_.find(key);
        if (open != open_.end() && time - found_[open->second].to < kPause) {
            EditFinding& one = found_[open->second];
            one.to = time;
            if (worst <= one.worst) return;
            one.worst = worst;
            one.where = where;
            return;
        }
        if (found_.size() >= kMost) return;
        open_[key] = found_.size();
        found_.push_back({path.person, kind, other, time, time, where, worst, {}});
    }

    /// The findings of a person in words; the list is empty afterwards.
    void take(const RecordedPath& path, std::vector<EditFinding>& all) {
        for (EditFinding& one : found_) {
            one.text = words(one, path) + between(one.from, one.to);
            all.push_back(std::move(one));
        }
        found_.clear();
        open_.clear();
    }

private:
    std::string words(const EditFinding& one, const RecordedPath& path) const {
        char text[120];
        switch (one.kind) {
            case FindingKind::Person:
                return "overlaps with person " + std::to_string(one.other);
            case FindingKind::Outside:
                return "leaves the ground";
            case FindingKind::Speed:
                std::snprintf(text, sizeof text, "goes %.1f m/s, though %.1f are possible,", one.worst,
                              path.topSpeed);
                return text;
            case FindingKind::Obstacle:
                break;
        }
        const ObstacleDef* def = environment_.obstacle(ObstacleId{one.other});
        const bool named = def != nullptr && !def->name.empty();
        return "goes through " + (named ? def->name : "obstacle " + std::to_string(one.other));
    }

    const Environment& environment_;
    std::vector<EditFinding> found_;
    std::map<std::pair<FindingKind, std::uint32_t>, std::size_t> open_;
};

/// Everybody at one moment, from left to right.
struct Standing {
    double x = 0.0;
    Vec2 at;
    const RecordedPath* path = nullptr;
};

class Search {
public:
    Search(std::vector<ShownPath> paths, const Environment& environment)
        : paths_(std::move(paths)), environment_(environment) {}

    std::vector<EditFinding> run(double end) {
        std::vector<FindingList> lists(paths_.size(), FindingList(environment_));
        const auto samples = static_cast<std::size_t>(end / kSample) + 1;
        for (std::size_t k = 0; k < samples; ++k) {
            const double time = static_cast<double>(k) * kSample;
            stand(time);
            for (std::size_t i = 0; i < paths_.size(); ++i)
                if (paths_[i].edited()) look(paths_[i], time, lists[i]);
        }
        std::vector<EditFinding> all;
        for (std::size_t i = 0; i < paths_.size(); ++i) lists[i].take(paths_[i].recorded(), all);
        return all;
    }

private:
    void stand(double time) {
        now_.clear();
        for (const ShownPath& path : paths_)
            if (const auto at = path.at(time)) now_.push_back({at->x, *at, &path.recorded()});
        std::sort(now_.begin(), now_.end(), [](const Standing& a, const Standing& b) {
            return a.x != b.x ? a.x < b.x : a.path->person < b.path->person;
        });
    }

    void look(const ShownPath& shown, double time, FindingList& list) const {
        const auto at = shown.movedAt(time);
        if (!at) return;
        const RecordedPath& path = shown.recorded();
        lookAtPeople(path, *at, time, list);
        lookAtGround(path, *at, time, list);
        const auto before = shown.at(time - 0.5 * kSpeedSpan), after = shown.at(time + 0.5 * kSpeedSpan);
        if (!before || !after) return;
        const double speed = distance(*before, *after) / kSpeedSpan;
        if (speed > kFaster * path.topSpeed) list.add(path, FindingKind::Speed, 0, time, *at, speed);
    }

    void lookAtPeople(const RecordedPath& path, Vec2 at, double time, FindingList& list) const {
        const double reach = path.radius + kWidest;
        auto other = std::lower_bound(now_.begin(), now_.end(), at.x - reach,
                                      [](const Standing& one, double x) { return one.x < x; });
        for (; other != now_.end() && other->x <= at.x + reach; ++other) {
            if (other->path->person == path.person) continue;
            const double both = path.radius + other->path->radius, away = distance(at, other->at);
            if (away < kOverlapShare * both)
                list.add(path, FindingKind::Person, other->path->person, time, at, both - away);
        }
    }

    void lookAtGround(const RecordedPath& path, Vec2 at, double time, FindingList& list) const {
        const Box sides = environment_.def().sides();
        if (!sides.contains(at)) return list.add(path, FindingKind::Outside, 0, time, at, 0.0);
        environment_.forPiecesNear(at, path.radius, [&](const ObstaclePiece& piece) {
            const double depth = path.radius - piece.signedDistance(at);
            if (!piece.moving && depth > kAtWall)
                list.add(path, FindingKind::Obstacle, piece.obstacle.value, time, at, depth);
        });
    }

    std::vector<ShownPath> paths_;
    const Environment& environment_;
    std::vector<Standing> now_;
};

}  // namespace

std::vector<EditFinding> findTroubles(const std::vector<TakeEdit>& edits, std::span<const RecordedPath> paths,
                                      double spacing, double end, const Environment& environment) {
    if (edits.empty()) return {};
    std::map<std::uint32_t, const TakeEdit*> editOf;
    for (const TakeEdit& edit : edits)
        for (const std::uint32_t id : edit.people) editOf[id] = &edit;
    std::vector<ShownPath> shown;
    for (const RecordedPath& path : paths) {
        const auto found = editOf.find(path.person);
        shown.emplace_back(path, found == editOf.end() ? nullptr : found->second, spacing);
    }
    return Search(std::move(shown), environment).run(end);
}

void keepClear(TakeEdit& edit, std::span<const RecordedPath> paths, double spacing,
               const Environment& environment) {
    for (PathPin& pin : edit.pins)
        for (const std::uint32_t id : edit.people) {
            const auto path = std::lower_bound(
                paths.begin(), paths.end(), id,
                [](const RecordedPath& one, std::uint32_t wanted) { return one.person < wanted; });
            if (path == paths.end() || path->person != id) continue;
            const auto was = recordedAt(*path, spacing, pin.time);
            if (was) pin.offset = environment.projectToFreeSpace(*was + pin.offset, path->radius) - *was;
        }
}

}  // namespace muster
