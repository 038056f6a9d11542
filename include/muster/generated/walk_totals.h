// Made by schema/generate.mjs from schema/api/views.txt: change these, not this file.
// Sums over the path costs of many.
#pragma once

namespace muster {

/// Sums over the path costs of all characters with a place, in metres of open ground.
struct WalkTotals {
    double sum = 0.0;      ///< Sum of the costs [m].
    double squares = 0.0;  ///< Sum of the squared costs [m^2].
    double longest = 0.0;  ///< Largest cost [m].

    /// Adds the cost of one path; infinite costs are ignored.
    void add(double walk);
    /// Adds the totals of other paths.
    void add(const WalkTotals& others);

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(sum, squares, longest);
    }
};

}  // namespace muster
