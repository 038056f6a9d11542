// Criteria and how they are judged.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace muster {

/// Which of the seeds' values stands against the threshold.
enum class Aggregate : std::uint8_t {
    Median,   ///< Of all seeds.
    Lowest,   ///< In every seed at least.
    Highest,  ///< In every seed at most.
};

/// On which side of the threshold it passes. The threshold itself passes.
enum class Comparison : std::uint8_t { AtLeast, AtMost };

/// One criterion as judged.
struct Verdict {
    std::string criterion;  ///< "36 of 36 through the woodland in every seed"
    std::string preset;     ///< Whose figures these are.
    std::string unit;       ///< Of value and threshold; may be empty.
    Comparison comparison = Comparison::AtLeast;
    Aggregate aggregate = Aggregate::Median;
    double value = 0.0;  ///< The aggregate; NaN where nothing could be measured (then it fails).
    double threshold = 0.0;
    bool pass = false;
    bool binding = true;     ///< Decides over the whole; false where it is shown for comparison only.
    std::int32_t seeds = 0;  ///< Values it rests on.
    double low = 0.0;        ///< Lowest over the seeds.
    double high = 0.0;       ///< Highest over the seeds.
};

/// Collects verdicts. Criteria of the preset `muster` bind; others are shown for comparison.
class Judge {
public:
    /// Judges one value per seed. `expected` values are needed: with fewer (a run had no value) it fails.
    void require(const std::string& criterion, const std::string& preset, const std::vector<double>& values,
                 Aggregate aggregate, Comparison comparison, double threshold, const std::string& unit = "");
    /// How many values each criterion must rest on.
    explicit Judge(std::size_t expected) : expected_(expected) {}
    /// In the order they were judged.
    const std::vector<Verdict>& verdicts() const { return verdicts_; }

private:
    std::size_t expected_;
    std::vector<Verdict> verdicts_;
};

}  // namespace muster
