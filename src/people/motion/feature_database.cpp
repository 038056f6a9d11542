#include "people/motion/feature_database.h"

#include <algorithm>

#include "base/maths.h"

namespace muster {
namespace {

constexpr float kRowRate = 30.0f;  // Rows per second.
// Length of the end of a clip that is not cyclic into which no search leads [s].
constexpr double kTailTime = 0.2;
constexpr float kNowhere = 1.0e4f;  // Value of the features of unused rows of a block.

/// A group of features with one unit. They share one standard deviation, so that features that hardly vary
/// are not amplified.
struct Group {
    std::size_t first;
    std::size_t count;
    float weight;
};
constexpr std::array<Group, 8> kGroups{{{0, 2, 1.5f},
                                        {2, 2, 1.5f},
                                        {4, 2, 1.5f},      // Trajectory, by horizon.
                                        {6, 6, 1.5f},      // Facing.
                                        {12, 6, 1.0f},     // Feet.
                                        {18, 6, 1.0f},     // Velocity of feet.
                                        {24, 3, 0.75f},    // Velocity of hips.
                                        {27, 2, 0.75f}}};  // Feet that touch.

// Travel at any time; beyond the end of a clip it is extrapolated.
Travel travelBeyond(const Clip& clip, double time) {
    const double end = clip.duration();
    if (clip.cyclic || time <= end) return clip.travelAt(time);
    const double before = std::max(0.0, end - 0.1);
    const Travel last = clip.travelAt(end), earlier = clip.travelAt(before);
    const auto ahead = static_cast<float>((time - end) / (end - before));
    return {last.x + (last.x - earlier.x) * ahead, last.y + (last.y - earlier.y) * ahead, last.yaw};
}

Travel relative(const Travel& from, const Travel& to) {
    const Travel turn{0.0f, 0.0f, -from.yaw};
    const Travel moved = turn * Travel{to.x - from.x, to.y - from.y, 0.0f};
    return {moved.x, moved.y, to.yaw - from.yaw};
}

/// Positions of the joints in the features, in the ground frame.
struct Marks {
    Vec3 hips, left, right;
};

Marks marksAt(const Clip& clip, double time, const Travel& origin) {
    BodyPose pose;
    clip.sample(clip.cyclic ? time : std::clamp(time, 0.0, clip.duration()), pose);
    const Travel at = relative(origin, travelBeyond(clip, time));
    JointTransforms joints;
    jointTransforms(pose, {yawTurn(at.yaw), {at.x, at.y, 0.0f}}, joints);
    return {joints[0].translation, joints[index(JointRole::LeftFoot)].translation,
            joints[index(JointRole::RightFoot)].translation};
}

void put(Features& row, std::size_t at, Vec3 v) {
    row[at] = v.x;
    row[at + 1] = v.y;
    row[at + 2] = v.z;
}

Features featuresAt(const Clip& clip, double time) {
    Features row{};
    const Travel now = travelBeyond(clip, time);
    for (std::size_t h = 0; h < kHorizons.size(); ++h) {
        const Travel later = relative(now, travelBeyond(clip, time + static_cast<double>(kHorizons[h])));
        row[2 * h] = later.x;
        row[2 * h + 1] = later.y;
        row[6 + 2 * h] = static_cast<float>(cosine(later.yaw));
        row[7 + 2 * h] = static_cast<float>(sine(later.yaw));
    }
    constexpr double kStep = 1.0 / 60.0;
    const Marks here = marksAt(clip, time, now), next = marksAt(clip, time + kStep, now);
    constexpr float kPerStep = 60.0f;
    put(row, 12, here.left);
    put(row, 15, here.right);
    put(row, 18, (next.left - here.left) * kPerStep);
    put(row, 21, (next.right - here.right) * kPerStep);
    put(row, 24, (next.hips - here.hips) * kPerStep);
    row[27] = clip.touches(Limb::LeftFoot, time) ? 1.0f : 0.0f;
    row[28] = clip.touches(Limb::RightFoot, time) ? 1.0f : 0.0f;
    return row;
}

}  // namespace

FeatureDatabase::FeatureDatabase(const ClipTable& table) {
    for (std::size_t c = 0; c < table.size(); ++c) addClip(table[c]);
    normalise();
    fillBlocks();
}

void FeatureDatabase::addClip(const ClipEntry& entry) {
    Range range;
    range.firstRow = static_cast<std::int32_t>(rows_.size());
    range.rows = std::max(1, static_cast<std::int32_t>(entry.duration * kRowRate));
    range.locomotion = entry.use == ClipUse::Locomotion;
    range.standing = entry.standing;
    range.ends = !entry.cyclic;
    range.set = entry.clip->set;
    if (range.set && range.gait()) hasGaits_[static_cast<std::size_t>(*range.set)] = true;
    for (std::int32_t r = 0; r < range.rows; ++r) {
        const double time = static_cast<double>(r) / static_cast<double>(kRowRate);
        rows_.push_back(featuresAt(*entry.clip, time));
        clipOfRow_.push_back(static_cast<std::uint16_t>(ranges_.size()));
        timeOfRow_.push_back(static_cast<float>(time));
    }
    ranges_.push_back(range);
}

bool FeatureDatabase::suits(const Range& range, std::optional<MotionSet> set) const {
    if (range.set || !set) return range.set == set;
    return !range.gait() || !hasGaits_[static_cast<std::size_t>(*set)];
}

// Means and deviations are those of the plain clips, so that plain walking is the same with and without the
// other sets.
void FeatureDatabase::normalise() {
    std::vector<const Features*> plain;
    for (const Range& range : ranges_)
        for (std::int32_t r = 0; !range.set && r < range.rows; ++r)
            plain.push_back(&rows_[range.firstRow + r]);
    if (plain.empty())
        for (const Features& row : rows_) plain.push_back(&row);
    if (plain.empty()) return;
    measure(plain);
    for (Features& row : rows_)
        for (std::size_t f = 0; f < kFeatureCount; ++f) row[f] = (row[f] - mean_[f]) * scale_[f];
}

void FeatureDatabase::measure(const std::vector<const Features*>& rows) {
    const double count = static_cast<double>(rows.size());
    for (std::size_t f = 0; f < kFeatureCount; ++f) {
        double sum = 0.0;
        for (const Features* row : rows) sum += static_cast<double>((*row)[f]);
        mean_[f] = static_cast<float>(sum / count);
    }
    for (const Group& group : kGroups) {
        double sum = 0.0;
        for (const Features* row : rows)
            for (std::size_t f = group.first; f < group.first + group.count; ++f)
                sum += static_cast<double>(((*row)[f] - mean_[f]) * ((*row)[f] - mean_[f]));
        const double spread = std::sqrt(sum / (count * static_cast<double>(group.count)));
        for (std::size_t f = group.first; f < group.first + group.count; ++f)
            scale_[f] = group.weight / static_cast<float>(std::max(spread, 1e-3));
    }
}

void FeatureDatabase::fillBlocks() {
    for (Range& range : ranges_) {
        range.firstBlock = static_cast<std::int32_t>(blocks_.size());
        if (!range.locomotion) continue;
        const auto tail = range.ends ? static_cast<std::int32_t>(kTailTime * static_cast<double>(kRowRate))
                                     : 0;
        const std::int32_t sought = std::max(1, range.rows - tail);
        for (std::int32_t r = 0; r < sought; ++r) {
            const auto lane = static_cast<std::size_t>(r) % kRowsPerBlock;
            if (lane == 0) {
                blocks_.emplace_back();
                for (auto& feature : blocks_.back()) feature.fill(kNowhere);
            }
            const Features& row = rows_[range.firstRow + r];
            for (std::size_t f = 0; f < kFeatureCount; ++f) blocks_.back()[f][lane] = row[f];
        }
        range.blocks = static_cast<std::int32_t>(blocks_.size()) - range.firstBlock;
    }
}

std::int32_t FeatureDatabase::rowOf(std::size_t clip, float time) const {
    const Range& range = ranges_[clip];
    const auto r = static_cast<std::int32_t>(std::max(0.0f, time * kRowRate + 0.5f));
    return range.firstRow + std::min(r, range.rows - 1);
}

Features FeatureDatabase::query(const Trajectory& trajectory, std::int32_t row) const {
    Features sought;
    for (std::size_t f = 0; f < kTrajectoryCount; ++f) sought[f] = (trajectory[f] - mean_[f]) * scale_[f];
    const Features& now = rows_[row];
    for (std::size_t f = kTrajectoryCount; f < kFeatureCount; ++f) sought[f] = now[f];
    return sought;
}

float FeatureDatabase::cost(const Features& query, std::int32_t row) const {
    const Features& it = rows_[row];
    float sum = 0.0f;
    for (std::size_t f = 0; f < kFeatureCount; ++f) sum += (query[f] - it[f]) * (query[f] - it[f]);
    return sum;
}

void FeatureDatabase::searchBlocks(const Features& query, const Range& range, Match& best) const {
    for (std::int32_t b = range.firstBlock; b < range.firstBlock + range.blocks; ++b) {
        const Block& block = blocks_[b];
        std::array<float, kRowsPerBlock> sum{};
        const auto add = [&](std::size_t from, std::size_t to) {
            for (std::size_t f = from; f < to; ++f)
                for (std::size_t k = 0; k < kRowsPerBlock; ++k) {
                    const float d = query[f] - block[f][k];
                    sum[k] += d * d;
                }
        };
        const auto least = [&] {
            float m = sum[0];
            for (std::size_t k = 1; k < kRowsPerBlock; ++k) m = sum[k] < m ? sum[k] : m;
            return m;
        };
        add(0, kTrajectoryCount);
        if (least() >= best.cost) continue;
        add(kTrajectoryCount, kFeatureCount);
        if (least() >= best.cost) continue;
        for (std::size_t k = 0; k < kRowsPerBlock; ++k) {
            if (!(sum[k] < best.cost)) continue;
            best.cost = sum[k];
            best.row = range.firstRow + (b - range.firstBlock) * static_cast<std::int32_t>(kRowsPerBlock) +
                       static_cast<std::int32_t>(k);
        }
    }
}

Match FeatureDatabase::search(const Features& query, ClipFilter filter, std::optional<MotionSet> set,
                              float below) const {
    Match best{-1, below};
    for (const Range& range : ranges_) {
        if (range.blocks == 0 || !suits(range, set)) continue;
        if (filter != ClipFilter::Any && range.standing != (filter == ClipFilter::Standing)) continue;
        searchBlocks(query, range, best);
    }
    return best;
}

std::int32_t FeatureDatabase::nearestPose(std::size_t clip, std::int32_t row) const {
    const Range& range = ranges_[clip];
    const Features& now = rows_[row];
    Match best{-1, 0.0f};
    for (std::int32_t r = range.firstRow; r < range.firstRow + range.rows; ++r) {
        float sum = 0.0f;
        const Features& it = rows_[r];
        for (std::size_t f = kTrajectoryCount; f < kFeatureCount; ++f)
            sum += (it[f] - now[f]) * (it[f] - now[f]);
        if (best.row < 0 || sum < best.cost) best = {r, sum};
    }
    return best.row;
}

}  // namespace muster
