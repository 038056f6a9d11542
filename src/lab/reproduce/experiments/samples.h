// Results of runs, by arm and seed.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "muster/vec2.h"

namespace muster {

/// The value of a figure that a run does not have.
inline constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// A picture of a film strip.
struct FilmFrame {
    double time = 0.0;    ///< Time of the simulation [s].
    std::string caption;  ///< Sentence that says what is to be seen in the picture.
    std::string svg;      ///< The picture, a whole SVG document.
};

/// The results of one run.
struct RunSample {
    /// Figures by name, in the unit of their FigureInfo; NaN for a figure without a value.
    std::map<std::string, double> figures;
    std::map<std::string, std::vector<Vec2>> curves;  ///< Curves for charts, by name.
    std::vector<FilmFrame> film;                      ///< Pictures, where they were asked for.
    std::string plan;        ///< Method of the plans at the end: "fast" or "exact"; empty where unknown.
    std::uint64_t hash = 0;  ///< State hash of the world at the end; 0 where there is none.
};

/// All runs of an experiment.
class Samples {
public:
    /// Adds the run of an arm; seeds are added in rising order.
    void add(const std::string& arm, const std::string& preset, RunSample sample);
    /// A figure of an arm by seed; runs without a value are left out. Empty for an unknown arm or figure.
    std::vector<double> values(const std::string& arm, const std::string& preset,
                               const std::string& figure) const;
    /// All runs of an arm by seed; empty for an unknown one.
    const std::vector<RunSample>& runs(const std::string& arm, const std::string& preset) const;
    /// Number of runs of each arm.
    std::size_t seeds() const;

private:
    std::map<std::pair<std::string, std::string>, std::vector<RunSample>> runs_;  // Runs by arm and preset.
};

/// Median (of an even number: the mean of the middle two); NaN of none.
double median(std::vector<double> values);
/// Ratios a[i] / b[i] of as many pairs as both have; NaN where b is 0.
std::vector<double> ratios(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace muster
