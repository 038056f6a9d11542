// The plan of a march that flows, stage by stage.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/orders/stream.h"

namespace muster {

bool Stream::valid() const {
    const std::size_t n = starts_.size();
    if (n == 0 || ends_.size() != n || offsets_.size() != n || way_.size() < 2) return false;
    if (!(spacing_ > 0.0) || !(radius_ > 0.0) || !(closest_ > 0.0)) return false;
    const auto finite = [](const std::vector<Vec2>& list) {
        return std::all_of(list.begin(), list.end(), isFinite);
    };
    return finite(starts_) && finite(ends_) && finite(offsets_) && finite(way_);
}

void Stream::start(const StreamDef& def) {
    offsets_.assign(def.offsets.begin(), def.offsets.end());
    starts_.assign(def.starts.begin(), def.starts.end());
    ends_.assign(def.ends.begin(), def.ends.end());
    way_.clear();
    for (const Vec2 p : def.way)
        if (way_.empty() || distance(p, way_.back()) > 1e-6) way_.push_back(p);
    if (way_.size() == 1) way_.push_back(way_[0] + Vec2{1e-3, 0.0});
    spacing_ = def.spacing;
    radius_ = def.radius;
    closest_ = std::min(def.closest, def.spacing);
    measured_ = def.measured;
    spent_ = 0;
    status_ = valid() ? StreamStatus::Planning : StreamStatus::Blocked;
    if (status_ == StreamStatus::Blocked) return;
    moved_.resize(starts_.size());
    last_.resize(starts_.size());
    length_ = 0.0;
    flows_ = false;
    most_ = 0.0;
    for (std::size_t i = 0; i < starts_.size(); ++i) most_ = std::max(most_, distance(starts_[i], ends_[i]));
    startPiece(def.poses);
    enter(def.drawn && piece_.empty() ? Stage::Line : Stage::Straight);
}

// Starts a march in one piece: the offsets of starts and ends from the formation fade.
void Stream::startPiece(std::span<const Pose> poses) {
    double reach = 0.0;
    for (const Vec2 offset : offsets_) reach = std::max(reach, distance(offset, {}));
    piece_.start(poses, reach);
    if (piece_.empty()) return;
    most_ = std::max(most_, piece_.length());
    legs_.assign(offsets_.size(), {});
    for (std::size_t i = 0; i < offsets_.size(); ++i) {
        legs_[i].missFrom = starts_[i] - poses.front().apply(offsets_[i]);
        legs_[i].missTo = ends_[i] - poses.back().apply(offsets_[i]);
    }
}

StreamStatus Stream::advance(StreamGround ground, std::int64_t operations) {
    const std::int64_t until = spent_ + operations;
    while (status_ == StreamStatus::Planning && spent_ < until) step(ground);
    return status_;
}

void Stream::enter(Stage stage) {
    stage_ = stage;
    next_ = 0;
}

void Stream::step(StreamGround ground) {
    ++spent_;
    switch (stage_) {
        case Stage::Straight:
            checkStraight(ground);
            break;
        case Stage::Line:
            makeLine();
            break;
        case Stage::Rows:
            spent_ += 4 * runs_.probe(line_, ground);
            if (isWalledOff())
                status_ = StreamStatus::Blocked;
            else if (runs_.done() && !centre())
                startFlow();
            break;
        case Stage::Flow:
            spent_ += flow_.advance(runs_);
            if (flow_.done()) {
                paths_.start(runs_, line_.step());
                enter(Stage::Paths);
            }
            break;
        case Stage::Paths:
        case Stage::Load:
        case Stage::Steepen:
        case Stage::Lay:
        case Stage::Smooth:
            stepCourses();
            break;
        case Stage::Part:
            spent_ += banks_.part(runs_, paths_, courses_, beside_, static_cast<std::int32_t>(next_));
            if (++next_ == static_cast<std::size_t>(line_.rows())) enter(Stage::Smooth);
            break;
        case Stage::Finish:
            finish();
            break;
        case Stage::Measure:
            measure(ground);
            break;
    }
}

// Treats one course at a time, all of them in each stage.
void Stream::stepCourses() {
    StreamCourse& course = courses_[next_];
    if (stage_ == Stage::Paths) {
        spent_ += paths_.choose(runs_, flow_.shares(), course);
    } else if (stage_ == Stage::Load) {
        banks_.load(paths_, course);
        spent_ += course.rows() / 4;
    } else if (stage_ == Stage::Steepen) {
        banks_.steepen(runs_, paths_, course);
        spent_ += course.rows();
    } else if (stage_ == Stage::Lay) {
        banks_.lay(runs_, paths_, course);
        spent_ += 2 * course.rows();
    } else {
        banks_.smooth(runs_, paths_, course);
        spent_ += course.rows();
    }
    if (++next_ < courses_.size()) return;
    const Stage done = stage_;
    enter(static_cast<Stage>(static_cast<std::uint8_t>(done) + 1));
    if (done == Stage::Paths) {
        if (!paths_.all()) status_ = StreamStatus::Blocked;
        banks_.start(runs_, line_.step(), paths_.entries());
    } else if (done == Stage::Load) {
        if (formed_ || !formUp()) return;
        banks_.start(runs_, line_.step(), paths_.entries());
        enter(Stage::Load);
    } else if (done == Stage::Steepen) {
        banks_.settle();
    } else if (done == Stage::Lay) {
        orderRows();
        stretch_.start(line_, spacing_, closest_);
    }
}

}  // namespace muster
