// The plan of a march that flows: its line, and the ground along it.
#include <algorithm>
#include <cmath>

#include "base/bounds.h"
#include "engine/orders/stream.h"

namespace muster {
namespace {

constexpr double kLineBeyond = 2.0;  // Length of the line beyond starts and ends [m].
// Greatest length of a bend; bends are as long as the formation is wide [m].
constexpr double kMostBend = 12.0;
// Least distance outside its own width to which a stream may turn aside [m].
constexpr double kLeastAside = 2.0;
// Share of length up to which the outside of a bend is as good as its middle.
constexpr double kBendTolerance = 0.1;
constexpr double kCentringSlope = 0.2;  // Slope at which the line leaves the middle of a street.
// Ratio of the formation's width to the room above which a row is narrow.
constexpr double kNarrowRatio = 1.2;
constexpr double kWallTolerance = 1e-3;  // Difference of distance to a wall that does not matter [m].
constexpr double kLeastLook = 0.05;      // Least distance between looks along a straight route [m].

}  // namespace

// Tests one place at a time: whether the straight line, or that of the whole in one piece, is free. A place
// that starts or ends near a wall may be as near there.
void Stream::checkStraight(StreamGround ground) {
    const Vec2 a = starts_[next_], b = ends_[next_];
    const double whole = piece_.empty() ? distance(a, b) : most_, atA = ground(a), atB = ground(b);
    for (double s = 0.0; s < whole;) {
        const double room = ground(straight(next_, s / whole, pieceAt(s / whole)));
        const double gap = room - std::min({radius_, atA + s, atB + whole - s}) + kWallTolerance;
        ++spent_;
        if (gap < 0.0) {
            if (!piece_.empty()) status_ = StreamStatus::Blocked;
            enter(Stage::Line);
            return;
        }
        s += std::max(kLeastLook, 0.5 * gap);
    }
    if (++next_ < starts_.size()) return;
    if (measured_ && ground.uneven()) {
        enter(Stage::Measure);
        return;
    }
    length_ = most_;
    status_ = StreamStatus::Straight;
}

void Stream::makeLine() {
    flows_ = true;
    const auto [least, most] = boundsOf(offsets_);
    const Vec2 middle = (least + most) * 0.5;
    for (Vec2& p : offsets_)
        p = {most.x - p.x, p.y - middle.y};  // From here on x is the distance behind the front.
    low_ = least.y - middle.y;
    high_ = most.y - middle.y;
    const std::size_t n = way_.size();
    const Vec2 first = normalized(way_[1] - way_[0]), last = normalized(way_[n - 1] - way_[n - 2]);
    back_ = fore_ = startReach_ = endReach_ = 0.0;
    for (std::size_t i = 0; i < starts_.size(); ++i) {
        back_ = std::max(back_, -dot(starts_[i] - way_[0], first));
        fore_ = std::max(fore_, dot(ends_[i] - way_[n - 1], last));
        startReach_ = std::max(startReach_, distance(starts_[i], way_[0]));
        endReach_ = std::max(endReach_, distance(ends_[i], way_[n - 1]));
    }
    back_ += kLineBeyond;
    fore_ += kLineBeyond;
    line_.make(way_, back_, fore_, std::min(high_ - low_ + spacing_, kMostBend));
    centred_ = formed_ = false;
    fadeStart_ = fadeEnd_ = 1.0;
    placeOnLine();
}

// Locates starts and ends on the line, and finds the reach of its rows.
void Stream::placeOnLine() {
    const double whole = (line_.rows() - 1) * line_.step();
    const auto near = [&](Vec2 p, double s, double reach) {
        return line_.locate(p, std::clamp(s - reach, 0.0, whole), std::clamp(s + reach, 0.0, whole));
    };
    startS_ = near(way_.front(), back_, kLineBeyond).s;
    endS_ = near(way_.back(), whole - fore_, kLineBeyond).s;
    courses_.resize(starts_.size());
    for (std::size_t i = 0; i < starts_.size(); ++i) {
        courses_[i] = {};
        courses_[i].start = near(starts_[i], startS_, startReach_ + 1.0);
        courses_[i].end = near(ends_[i], endS_, endReach_ + 1.0);
        courses_[i].ordinate = offsets_[i].y;
    }
    spent_ += 4 * line_.rows() + static_cast<std::int64_t>(startReach_ + endReach_) * starts_.size();
    reachOut();
    runs_.start(line_, half_, radius_);
    enter(Stage::Rows);
}

// True where a course must pass the last row, and that has no run.
bool Stream::isWalledOff() const {
    const std::int32_t k = runs_.known() - 1;
    if (k < 0 || !runs_.row(k).empty()) return false;
    const double s = k * line_.step();
    return std::any_of(courses_.begin(), courses_.end(), [&](const StreamCourse& course) {
        return course.a().s + line_.step() < s && s < course.b().s - line_.step();
    });
}

// Moves the line to the middle of streets in their bends, where all would go by the outside. True if it
// moved.
bool Stream::centre() {
    if (centred_) return false;
    centred_ = true;
    bool moves = false;
    shift_.assign(line_.rows(), 0.0);
    street_.assign(line_.rows(), 0);
    for (std::int32_t k = 0; k < line_.rows(); ++k) {
        const std::span<const StreamRun> row = runs_.row(k);
        const double s = k * line_.step();
        if (row.size() != 1 || row[0].high - row[0].low > high_ - low_ || s < startS_ || s > endS_) continue;
        const double middle = 0.5 * (row[0].low + row[0].high);
        if (line_.row(k).bend * middle > -kBendTolerance) continue;
        street_[k] = 1;
        shift_[k] = middle;
        moves = true;
    }
    if (!moves) return false;
    // Behind and ahead of a street the line comes back gradually.
    const double back = kCentringSlope * line_.step();
    const auto follow = [&](std::size_t k, std::size_t from) {
        if (shift_[from] - back > shift_[k] && shift_[k] >= 0.0 && !street_[k])
            shift_[k] = shift_[from] - back;
        if (shift_[from] + back < shift_[k] && shift_[k] <= 0.0 && !street_[k])
            shift_[k] = shift_[from] + back;
    };
    for (std::size_t k = 1; k < shift_.size(); ++k) follow(k, k - 1);
    for (std::size_t k = shift_.size() - 1; k-- > 0;) follow(k, k + 1);
    line_.shift(shift_, std::min(high_ - low_ + spacing_, kMostBend));
    placeOnLine();
    return true;
}

// Makes the formation before the first row that is narrower than it, and leaves it behind the last one:
// between them every place keeps its turn. False where there is none: all go straight from start to end.
bool Stream::formUp() {
    double first = 1e9, last = -1e9;
    for (std::int32_t k = 0; k < line_.rows(); ++k)
        for (std::int32_t r = runs_.first(k); r < runs_.first(k + 1); ++r) {
            const StreamLoad& load = banks_.loads()[r];
            if (load.high - load.low + spacing_ <= kNarrowRatio * (load.room + spacing_)) continue;
            first = std::min(first, k * line_.step());
            last = k * line_.step();
        }
    const double whole = endS_ - startS_;
    if (first > last || whole <= 0.0) return false;
    formed_ = true;
    double meanX = 0.0, front = -1e9, rear = 1e9;
    for (const Vec2 p : offsets_) meanX += p.x / static_cast<double>(offsets_.size());
    // Greatest offsets from the formation, at the start and at the end.
    const auto off = [&] {
        Vec2 most;
        for (std::size_t i = 0; i < courses_.size(); ++i) {
            const StreamPoint a = courses_[i].start, b = courses_[i].end;
            const double ahead = meanX - offsets_[i].x, y = offsets_[i].y;
            most.x = std::max({most.x, std::fabs(a.s - startS_ - ahead), std::fabs(a.d - y)});
            most.y = std::max({most.y, std::fabs(b.s - endS_ - ahead), std::fabs(b.d - y)});
        }
        return most;
    };
    const Vec2 most = off();
    for (const StreamCourse& course : courses_) {
        front = std::max(front, course.start.s);
        rear = std::min(rear, course.end.s);
    }
    fadeStart_ = std::min(1.0, std::max({kFade, (first - front) / whole, most.x / whole}));
    fadeEnd_ = std::min(1.0, std::max({kFade, (rear - last) / whole, most.y / whole}));
    for (StreamCourse& course : courses_) {
        course.perStart = 1.0 / fadeStart_;
        course.perEnd = 1.0 / fadeEnd_;
    }
    return true;
}

void Stream::startFlow() {
    const auto row = [&](double s) { return static_cast<std::int32_t>(std::floor(s / line_.step() + 0.5)); };
    const std::int32_t from = std::clamp(row(startS_), 0, line_.rows() - 2);
    const std::int32_t to = std::clamp(row(endS_), from + 1, line_.rows() - 1);
    flow_.start(runs_, line_.step(), from, to, low_, high_, spacing_);
    enter(Stage::Flow);
}

// Sets the reach of the rows: the width of the formation, some room to turn aside, and the reach of starts
// and ends.
void Stream::reachOut() {
    const double aside = std::max(kLeastAside, 0.5 * (high_ - low_));
    half_.assign(line_.rows(), std::max(high_, -low_) + aside);
    for (const StreamCourse& course : courses_)
        for (const StreamPoint p : {course.start, course.end}) {
            double&
                half = half_[std::clamp(static_cast<std::int32_t>(p.s / line_.step()), 0, line_.rows() - 1)];
            half = std::max(half, std::fabs(p.d) + kLeastAside);
        }
    for (std::size_t k = 1; k < half_.size(); ++k) half_[k] = std::max(half_[k], half_[k - 1] - line_.step());
    for (std::size_t k = half_.size() - 1; k-- > 0;)
        half_[k] = std::max(half_[k], half_[k + 1] - line_.step());
}

}  // namespace muster
