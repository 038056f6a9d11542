// The banks of a stream on the ground: they open and close gently, and a stream that is too wide is squeezed
// evenly.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/orders/stream_paths.h"

namespace muster {

/// The courses that pass through a run.
struct StreamLoad {
    double low = 0.0;    ///< Least ordinate [m].
    double high = -1.0;  ///< Largest ordinate [m]; less than the least where no course passes.
    double right = 1e9;  ///< Farthest offset to the right [m].
    double left = -1e9;  ///< Farthest offset to the left [m].
    double room = 0.0;   ///< Width of the run [m].
    bool used() const { return high >= low; }  ///< True where a course passes.
};

/// Finds the offset to the left of each place in each row. First all courses are loaded, then steepened, then
/// laid.
class StreamBanks {
public:
    /// Begins without courses.
    void start(const StreamRuns& runs, double step, std::int32_t entries);
    /// Adds a course to the loads of its runs.
    void load(const StreamPaths& paths, const StreamCourse& course);
    /// Lets banks open and close as steeply as the course needs at its ends.
    void steepen(const StreamRuns& runs, const StreamPaths& paths, const StreamCourse& course);
    /// Ends the changes of banks; called once between steepen() and lay().
    void settle();
    /// Lays the course: finds its offset to the left in each of its rows.
    void lay(const StreamRuns& runs, const StreamPaths& paths, const StreamCourse& course);

    /// Keeps courses in the same run of a row apart, as far as they are not squeezed. Called once per row,
    /// after all are laid; `order` is a permutation of the courses, whose result for one row serves the next.
    /// Returns the operations.
    std::int32_t part(const StreamRuns& runs, const StreamPaths& paths, std::span<const StreamCourse> courses,
                      std::span<std::uint32_t> order, std::int32_t k);

    /// Evens the course once more, after all rows.
    void smooth(const StreamRuns& runs, const StreamPaths& paths, const StreamCourse& course);

    /// The offset of a course to the left at `s` [m].
    double left(const StreamCourse& course, double s) const;
    /// The offsets of a course in its rows, from the first on [m].
    std::span<const double> of(const StreamCourse& course) const {
        return {left_.data() + course.entry, static_cast<std::size_t>(course.rows())};
    }
    std::span<const StreamLoad> loads() const { return loads_; }  ///< Loads by run.

private:
    static constexpr double kGentleSlope = 0.35;  // Slope of banks and places, where there is room for it...
    // ... and of places where they keep apart, or where runs require it.
    static constexpr double kSteepSlope = 0.7;

    struct Bank {
        double value = 0.0;     // Offset to the left [m].
        std::int32_t from = 0;  // The row that sets it.
    };
    struct Banks {
        Bank low, high;
    };

    void bound(const StreamRuns& runs, std::span<const std::int32_t> path, const StreamCourse& course);
    void partRun(std::span<const StreamCourse> courses, std::int32_t k, const StreamRun& run);
    void raise(std::int32_t from, std::int32_t to, double slope);
    void aim(std::span<const std::int32_t> path, const StreamCourse& course);
    void even(const StreamRuns& runs, std::span<const std::int32_t> path, const StreamCourse& course,
              double slope);
    const StreamRun& run(const StreamRuns& runs, std::span<const std::int32_t> path,
                         const StreamCourse& course, std::int32_t k) const {
        return runs.row(k)[path[k - course.first] - runs.first(k)];
    }

    double step_ = 0.5;
    std::vector<StreamLoad> loads_;
    std::vector<double> bankRise_, placeRise_;             // Greatest rise from a row to the next [m].
    std::vector<Banks> near_;                              // Banks of one course, by row.
    std::vector<double> up_, down_, least_, most_;         // Bounds of one course, by row.
    std::vector<double> left_;                             // Offsets to the left by entry [m].
    std::vector<float> share_;                             // Squeeze by entry: 1 where there is none.
    std::vector<std::uint32_t> inRun_;                     // Courses that come through a run.
    std::vector<double> ordinate_, gap_, value_, weight_;  // Values of the courses in a run.
};

}  // namespace muster
