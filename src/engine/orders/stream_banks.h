// How far a stream fills the ground: its banks open and close gently, and what is too wide is squeezed
// evenly.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/orders/stream_paths.h"

namespace muster {

/// What passes through a run.
struct StreamLoad {
    double low = 0.0;    ///< Least ordinate [m].
    double high = -1.0;  ///< Largest ordinate [m]; less than the least where nobody passes.
    double right = 1e9;  ///< How far to the right they come [m].
    double left = -1e9;  ///< How far to the left [m].
    double room = 0.0;   ///< Width of the run [m].
    bool used() const { return high >= low; }  ///< True where somebody passes.
};

/// Finds how far to the left each place is in each row. First all courses are loaded, then steepened, then
/// laid.
class StreamBanks {
public:
    /// Begins.
    void start(const StreamRuns& runs, double step, std::int32_t entries);
    /// Adds a course to the loads of its runs.
    void load(const StreamPaths& paths, const StreamCourse& course);
    /// Lets banks open and close as steeply as the course needs at its ends.
    void steepen(const StreamRuns& runs, const StreamPaths& paths, const StreamCourse& course);
    /// To be called once between steepen() and lay().
    void settle();
    /// Lays the course: how far to the left it is in each of its rows.
    void lay(const StreamRuns& runs, const StreamPaths& paths, const StreamCourse& course);

    /// Keeps those apart that come through the same run of a row, as far as they are not squeezed. Once per
    /// row, after all are laid; `order` is a permutation of the courses, that of one row serves the next.
    std::int32_t part(const StreamRuns& runs, const StreamPaths& paths, std::span<const StreamCourse> courses,
                      std::span<std::uint32_t> order, std::int32_t k);

    /// Evens the course once more, after all rows.
    void smooth(const StreamRuns& runs, const StreamPaths& paths, const StreamCourse& course);

    /// How far to the left a course is at `s` [m].
    double left(const StreamCourse& course, double s) const;
    /// The same in its rows, from the first on [m].
    std::span<const double> of(const StreamCourse& course) const {
        return {left_.data() + course.entry, static_cast<std::size_t>(course.rows())};
    }
    std::span<const StreamLoad> loads() const { return loads_; }  ///< By run.

private:
    static constexpr double kGentle = 0.35;  // Slope of banks and places, where there is room for it...
    static constexpr double kSteep = 0.7;    // ... and of places where they keep apart, or runs want it.

    struct Bank {
        double value = 0.0;     // How far to the left [m].
        std::int32_t from = 0;  // The row that says so.
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
    std::vector<double> bankRise_, placeRise_;             // Per step from a row to the next [m].
    std::vector<Banks> near_;                              // By row, of one course.
    std::vector<double> up_, down_, least_, most_;         // The same.
    std::vector<double> left_;                             // By entry [m].
    std::vector<float> share_;                             // By entry: how far squeezed, 1 where not.
    std::vector<std::uint32_t> inRun_;                     // Those who come through a run.
    std::vector<double> ordinate_, gap_, value_, weight_;  // Of those in a run.
};

}  // namespace muster
