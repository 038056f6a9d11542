// The page's decoder of frames (docs/protocol.md): restores the whole crowd from changes.
#pragma once

#include <doctest.h>

#include <cmath>
#include <map>
#include <vector>

#include "muster/clip.h"
#include "muster/quat.h"
#include "studio/session/inbox/protocol.h"

namespace muster::testing {

/// A frame as a page shows it.
struct PageFrame {
    std::uint32_t frame = 0;
    std::vector<std::uint32_t> ids;
    std::vector<std::uint16_t> group;
    std::vector<double> x, y;     ///< [m]
    std::vector<double> heading;  ///< [rad], from 0 to a full turn.
    std::vector<std::uint8_t> clip;
    std::vector<double> phase;                     ///< 0 to 1.
    std::vector<std::vector<double>> places;       ///< By group: x, y per place [m].
    std::vector<std::vector<std::uint8_t>> unfit;  ///< By group, per place.
    std::vector<std::vector<QueuedOrder>> orders;  ///< By group: its queue.
};

/// Follows the frames of one session.
class PageDecoder {
public:
    /// Handles a group's mesh.
    void take(const protocol::GroupMesh& mesh) { groups_[mesh.group] = {mesh, {}, {}, {}}; }

    /// Handles a frame.
    const PageFrame& take(const protocol::Frame& frame) {
        page_.frame = frame.frame;
        if (!frame.ids.empty() || frame.crowd.count == 0) page_.ids = frame.ids, page_.group = frame.group;
        takeCrowd(frame.crowd);
        page_.places.clear();
        page_.unfit.clear();
        page_.orders.clear();
        for (const protocol::GroupFrame& group : frame.groups) takeGroup(group);
        return page_;
    }

    /// The rotations of the joints of one whole pose.
    static std::vector<Quat> turns(const std::int16_t* pose) {
        std::vector<Quat> all;
        for (std::size_t j = 0; j < kJointCount; ++j) all.push_back(turn(pose + 3 + 3 * j));
        return all;
    }

private:
    struct Group {
        protocol::GroupMesh mesh;
        std::vector<double> offsets;
        std::vector<std::uint8_t> unfit;
        std::vector<QueuedOrder> orders;
    };

    static Quat turn(const std::int16_t* numbers) {
        const int largest = (numbers[0] & 1) | ((numbers[1] & 1) << 1);
        double parts[4] = {0, 0, 0, 0};
        double rest = 1.0;
        for (int k = 0, n = 0; k < 4; ++k) {
            if (k == largest) continue;
            parts[k] = (numbers[n++] >> 1) / 16383.0 * std::sqrt(0.5);
            rest -= parts[k] * parts[k];
        }
        parts[largest] = std::sqrt(std::max(0.0, rest));
        const auto f = [&](int k) { return static_cast<float>(parts[k]); };
        return {f(0), f(1), f(2), f(3)};
    }

    void takeCrowd(const protocol::CrowdFrame& crowd) {
        const std::size_t count = crowd.count;
        REQUIRE(crowd.heading.size() == count);
        REQUIRE(page_.ids.size() == count);
        if (crowd.stepX.empty()) {
            REQUIRE(crowd.x.size() == count);
            x_.assign(crowd.x.begin(), crowd.x.end());
            y_.assign(crowd.y.begin(), crowd.y.end());
            page_.clip = crowd.clip;
        } else {
            REQUIRE(x_.size() == count);
            for (std::size_t i = 0; i < count; ++i) x_[i] += crowd.stepX[i], y_[i] += crowd.stepY[i];
            for (std::size_t k = 0; k < crowd.jumped.size(); ++k) {
                x_[crowd.jumped[k]] = crowd.jumpedX[k];
                y_[crowd.jumped[k]] = crowd.jumpedY[k];
            }
            for (std::size_t k = 0; k < crowd.changed.size(); ++k)
                page_.clip[crowd.changed[k]] = crowd.clip[k];
        }
        page_.x.resize(count);
        page_.y.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            page_.x[i] = crowd.x0 + x_[i] * static_cast<double>(crowd.quantum);
            page_.y[i] = crowd.y0 + y_[i] * static_cast<double>(crowd.quantum);
        }
        page_.heading = joined(crowd.heading, crowd.headingFine);
        for (double& heading : page_.heading) heading *= 6.283185307179586;
        page_.phase = joined(crowd.phase, crowd.phaseFine);
    }

    static std::vector<double> joined(const std::vector<std::uint8_t>& high,
                                      const std::vector<std::uint8_t>& low) {
        std::vector<double> all;
        for (std::size_t i = 0; i < high.size(); ++i)
            all.push_back((high[i] + (low.empty() ? 0.5 : low[i] / 256.0)) / 256.0);
        return all;
    }

    void takeGroup(const protocol::GroupFrame& frame) {
        Group& group = groups_.at(frame.id);
        const protocol::GroupMesh& mesh = group.mesh;
        const std::size_t count = mesh.placeTriangles.size();
        group.offsets.resize(2 * count, 0.0);
        for (std::size_t k = 0; k < frame.offsets.size(); ++k)
            group.offsets.at(2 * frame.moved[k / 2] + k % 2) = frame.offsets[k] / 100.0;
        if (!frame.unfit.empty()) group.unfit = frame.unfit;
        if (frame.queued) group.orders = frame.orders;
        page_.orders.push_back(group.orders);
        std::vector<double>& places = page_.places.emplace_back();
        std::vector<std::uint8_t>& unfit = page_.unfit.emplace_back();
        for (std::size_t k = 0; k < count; ++k) {
            const double a = mesh.placeWeights[2 * k], b = mesh.placeWeights[2 * k + 1];
            const double weights[3] = {a, b, 1.0 - a - b};
            for (std::size_t axis = 0; axis < 2; ++axis) {
                double at = group.offsets[2 * k + axis];
                for (std::size_t c = 0; c < 3; ++c)
                    at += weights[c] *
                          frame.vertices[2 * mesh.triangles[3 * mesh.placeTriangles[k] + c] + axis];
                places.push_back(at);
            }
            unfit.push_back(group.unfit.empty() ? 0 : (group.unfit[k / 8] >> (k % 8)) & 1);
        }
    }

    PageFrame page_;
    std::vector<int> x_, y_;
    std::map<std::uint32_t, Group> groups_;
};

}  // namespace muster::testing
