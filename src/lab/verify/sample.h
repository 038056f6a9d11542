// Measurements of one run of a scene, and all runs of a scene.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "lab/measures/trajectories.h"
#include "muster/vec2.h"

namespace muster {

/// Measurements of one run.
struct VerifySample {
    std::map<std::string, double> figures;            ///< Figures by name; kUnmeasured where a run has none.
    std::map<std::string, std::vector<Vec2>> curves;  ///< Curves by name, for judges and plots.
    std::string picture;                              ///< Picture as an SVG document; of the first seed only.
    std::uint64_t hash = 0;                           ///< State hash of the world at the end.
    double seconds = 0.0;                             ///< Time simulated [s].
};

/// The runs of one scene, by variant and seed.
class VerifySamples {
public:
    /// Adds a run; seeds are added in rising order.
    void add(const std::string& variant, VerifySample sample);
    /// All runs of a variant by seed; empty for an unknown one.
    const std::vector<VerifySample>& runs(const std::string& variant) const;
    /// A figure of all runs of a variant; kUnmeasured where a run has none.
    std::vector<double> values(const std::string& variant, const std::string& figure) const;
    /// Mean over the seeds; kUnmeasured where a run has no value, or none ran.
    double mean(const std::string& variant, const std::string& figure) const;
    /// Smallest and largest value of all seeds; kUnmeasured where a run has no value, or none ran.
    double least(const std::string& variant, const std::string& figure) const;
    double most(const std::string& variant, const std::string& figure) const;
    /// A curve of all runs of a variant, one after the other.
    std::vector<Vec2> points(const std::string& variant, const std::string& curve) const;

private:
    std::map<std::string, std::vector<VerifySample>> runs_;
};

}  // namespace muster
