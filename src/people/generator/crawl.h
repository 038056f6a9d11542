// Crawling on hands and knees.
#pragma once

#include "people/generator/clip_maker.h"

namespace muster::generator {

/// Crawling as a function of time. At time `start` the phase is 0 (the left knee lands) and the travelling
/// frame is at the origin.
class CrawlTrack {
public:
    static constexpr double kCycle = 64.0 / kFrameRate;  ///< Duration of a cycle [s].
    static constexpr double kSpeed = 0.52;               ///< Speed of crawling [m/s].
    static constexpr double kContact = 0.60;  ///< Share of the cycle in which a limb is in contact.

    explicit CrawlTrack(double start = 0.0);

    Placement travel(double time) const { return {kSpeed * (time - start_), 0.0, 0.0}; }
    /// The figure at a time, in the travelling frame.
    Figure figure(double time) const;
    /// Position of the limb in the contact that begins in the cycle, in the travelling frame of time `start`
    /// [m].
    Vec3 kneeAnchor(std::size_t side, int cycle) const;
    Vec3 handAnchor(std::size_t side, int cycle) const;
    /// Times at which these contacts begin [s].
    double kneeLanding(std::size_t side, int cycle) const;
    double handLanding(std::size_t side, int cycle) const;

private:
    double start_;
};

/// The clip "crawl".
Clip crawlClip();

}  // namespace muster::generator
