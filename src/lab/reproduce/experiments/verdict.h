// Criteria and how they are judged.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace muster {

/// The value among those of all seeds that is compared with the threshold.
enum class Aggregate : std::uint8_t {
    Median,   ///< The median of all seeds.
    Lowest,   ///< The lowest value: each seed's is at least the threshold.
    Highest,  ///< The highest value: each seed's is at most the threshold.
};

/// The side of the threshold on which a value passes. The threshold itself passes.
enum class Comparison : std::uint8_t { AtLeast, AtMost };

/// The outcome of one criterion.
struct Verdict {
    std::string criterion;  ///< Words such as "36 of 36 through the woodland in every seed".
    std::string preset;     ///< The preset of the runs.
    std::string unit;       ///< Unit of value and threshold; may be empty.
    Comparison comparison = Comparison::AtLeast;
    Aggregate aggregate = Aggregate::Median;
    double value = 0.0;  ///< The aggregate; NaN where nothing could be measured (then it fails).
    double threshold = 0.0;
    bool pass = false;
    bool binding = true;     ///< True if it decides over the exit code; false if it is shown for comparison.
    std::int32_t seeds = 0;  ///< Number of values.
    double low = 0.0;        ///< Lowest over the seeds.
    double high = 0.0;       ///< Highest over the seeds.
};

/// Collects verdicts. Criteria of the preset `muster` bind; others are shown for comparison.
class Judge {
public:
    /// Judges one value per seed. A criterion with fewer values than expected (a run had none) fails.
    void require(const std::string& criterion, const std::string& preset, const std::vector<double>& values,
                 Aggregate aggregate, Comparison comparison, double threshold, const std::string& unit = "");
    /// `expected` is the number of values that each criterion needs.
    explicit Judge(std::size_t expected) : expected_(expected) {}
    /// All verdicts in the order they were judged.
    const std::vector<Verdict>& verdicts() const { return verdicts_; }

private:
    std::size_t expected_;
    std::vector<Verdict> verdicts_;
};

}  // namespace muster
