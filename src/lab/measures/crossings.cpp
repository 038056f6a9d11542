#include "lab/measures/crossings.h"

#include <algorithm>
#include <set>

namespace muster {
namespace {

/// True where `p`, which is on the line through both ends, lies between them.
bool between(Line line, Vec2 p) {
    const Vec2 along = line.b - line.a;
    const double at = dot(p - line.a, along);
    return at >= 0.0 && at <= lengthSquared(along);
}

/// The crossing by a movement from `p` to `q`; direction 0 for none.
Crossing crossingOf(Line line, Vec2 p, Vec2 q) {
    const Vec2 along = line.b - line.a;
    const double sp = cross(along, p - line.a), sq = cross(along, q - line.a);
    if (sq == 0.0 || (sp > 0.0 && sq > 0.0) || (sp < 0.0 && sq < 0.0)) return {};
    const double share = sp / (sp - sq);
    const Vec2 point = lerp(p, q, share);
    if (!between(line, point)) return {};
    return {0, 0, share, sq < 0.0 ? 1 : -1, point};
}

}  // namespace

std::vector<Crossing> crossings(const Trajectories& trajectories, Line line) {
    std::vector<Crossing> found;
    const auto all = trajectories.all();
    for (std::size_t who = 0; who < trajectories.persons().size(); ++who) {
        const auto rows = trajectories.ofPerson(who);
        for (std::size_t k = 1; k < rows.size(); ++k) {
            const Sighting &from = all[rows[k - 1]], &to = all[rows[k]];
            if (to.frame != from.frame + 1) continue;
            Crossing crossing = crossingOf(line, from.position, to.position);
            if (crossing.direction == 0) continue;
            crossing.id = to.id;
            crossing.frame = to.frame;
            crossing.time = (from.frame + crossing.time) / trajectories.frameRate();
            found.push_back(crossing);
        }
    }
    std::sort(found.begin(), found.end(), [](const Crossing& a, const Crossing& b) {
        return a.time != b.time ? a.time < b.time : a.id < b.id;
    });
    return found;
}

std::vector<Crossing> firstCrossings(std::span<const Crossing> all, int direction) {
    std::vector<Crossing> first;
    std::set<std::uint32_t> seen;
    for (const Crossing& crossing : all)
        if ((direction == 0 || crossing.direction == direction) && seen.insert(crossing.id).second)
            first.push_back(crossing);
    return first;
}

std::vector<std::int32_t> crossedByFrame(const Trajectories& trajectories,
                                         std::span<const Crossing> crossed) {
    std::vector<std::int32_t> count(trajectories.frameCount(), 0);
    for (const Crossing& crossing : crossed) ++count[crossing.frame - trajectories.firstFrame()];
    for (std::size_t f = 1; f < count.size(); ++f) count[f] += count[f - 1];
    return count;
}

std::vector<FlowSample> flowSamples(const Trajectories& trajectories, std::span<const Crossing> crossed,
                                    std::int32_t frames, std::span<const double> speeds) {
    std::vector<FlowSample> samples;
    if (crossed.empty() || frames < 1) return samples;
    const auto speedOf = [&](const Crossing& crossing) {
        const auto row = trajectories.frame(crossing.frame - trajectories.firstFrame());
        const auto at = std::lower_bound(row.begin(), row.end(), crossing.id,
                                         [](const Sighting& s, std::uint32_t id) { return s.id < id; });
        return speeds.empty() ? kUnmeasured : speeds[&*at - trajectories.all().data()];
    };
    const std::int32_t last = trajectories.firstFrame() + trajectories.frameCount() - 1;
    std::int32_t before = crossed.front().frame;
    std::size_t passed = 0;
    for (std::int32_t frame = before + frames; frame < last; frame += frames) {
        std::size_t now = passed;
        while (now < crossed.size() && crossed[now].frame <= frame) ++now;
        if (now == passed) continue;
        const std::int32_t until = crossed[now - 1].frame + 1;
        double sum = 0.0;
        std::size_t counted = 0;
        for (const Crossing& crossing : crossed) {
            if (crossing.frame < before || crossing.frame > until) continue;
            const double speed = speedOf(crossing);
            if (!std::isfinite(speed)) continue;
            sum += speed;
            ++counted;
        }
        const double seconds = (until - before) / trajectories.frameRate();
        samples.push_back({trajectories.timeOf(before), trajectories.timeOf(until),
                           static_cast<double>(now - passed) / seconds,
                           counted > 0 ? sum / static_cast<double>(counted) : kUnmeasured});
        passed = now;
        before = until;
    }
    return samples;
}

double flowBetween(std::span<const Crossing> crossed, std::size_t first, std::size_t last) {
    if (last >= crossed.size() || first >= last) return kUnmeasured;
    const double seconds = crossed[last].time - crossed[first].time;
    return seconds > 0.0 ? static_cast<double>(last - first) / seconds : kUnmeasured;
}

double meanFlow(std::span<const Crossing> crossed) {
    return crossed.empty() ? kUnmeasured : flowBetween(crossed, 0, crossed.size() - 1);
}

std::vector<double> lastSeen(const Trajectories& trajectories) {
    std::vector<double> times;
    for (std::size_t who = 0; who < trajectories.persons().size(); ++who)
        times.push_back(trajectories.timeOf(trajectories.all()[trajectories.ofPerson(who).back()].frame));
    std::sort(times.begin(), times.end());
    return times;
}

}  // namespace muster
