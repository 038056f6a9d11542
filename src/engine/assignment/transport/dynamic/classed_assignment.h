// Dynamic assignment of characters and places that have classes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/assignment/transport/dynamic/dynamic_assignment.h"

namespace muster {

/// The class of each character and of each place.
struct AssignmentClasses {
    std::span<const std::uint8_t> character;  ///< Class per character.
    std::span<const std::uint8_t> place;      ///< Class per place.
};

/// Matches as many characters as possible; of these as many as possible with places of their class; at a
/// near-least sum of cost^p within each class. Every class is a dynamic assignment of its own. A character
/// that finds no place in its class takes one that nobody of its class takes (docs/method/roles.md).
/// Requirements as of DynamicAssignment.
class ClassedAssignment {
public:
    /// Forgets everything.
    void clear() { *this = {}; }
    /// Starts without incumbents.
    void coldStart(const DynamicAssignmentDef& def, const AssignmentInput& input,
                   const AssignmentClasses& classes, CostOracle& costs, ThreadPool& pool);
    /// One step from the places of `incumbent`, per character, -1 for none. Classes may change from step to
    /// step: a character with a place of another class leaves it for one of its own.
    void update(const DynamicAssignmentDef& def, const AssignmentInput& input,
                const AssignmentClasses& classes, std::span<const std::int32_t> incumbent, CostOracle& costs,
                ThreadPool& pool);

    /// Place per character, -1 unmatched.
    std::span<const std::int32_t> placeOf() const { return placeOf_; }
    /// Per character: cost to its place at the last call [m]; 0 unmatched.
    std::span<const float> cost() const { return cost_; }
    /// Sum of the gaps of all classes, as DynamicAssignment::dualityGap() [m^p].
    double dualityGap() const;

    /// Lets an archive read or write all data that influences later results.
    template <class Archive>
    void visit(Archive& archive) {
        archive(parts_, placeOf_, cost_);
        if constexpr (Archive::kReading) {
            if (!consistent()) archive.fail();
            if (!archive.ok()) clear();
        }
    }

private:
    /// The assignment of one class. Its places have slots, which stay while other places come and go.
    struct Part {
        std::uint8_t unitClass = 0;
        std::vector<std::int32_t> members;  // Characters of the class, ascending.
        std::vector<std::int32_t> places;   // Per slot, -1 for an empty one.
        DynamicAssignment assignment;

        template <class Archive>
        void visit(Archive& archive) {
            archive(unitClass, members, places, assignment);
        }
    };
    /// Input of one step of one class.
    struct PartInput {
        std::vector<Vec2> characters;         // Positions of the characters [m].
        std::vector<Vec2> places;             // Positions per slot [m].
        std::vector<std::uint8_t> usable;     // 0 per slot that nobody may take.
        std::vector<std::uint8_t> present;    // 0 per character that is left out.
        std::vector<std::int32_t> incumbent;  // Per character: its slot, -1 for none.
    };

    bool consistent() const;
    void sortMembers(const AssignmentInput& input, const AssignmentClasses& classes);
    bool sortPlaces(Part& part, const AssignmentInput& input, const AssignmentClasses& classes);
    void gather(const Part& part, const AssignmentInput& input, std::span<const std::int32_t> incumbent);
    bool holdsIncumbents(const Part& part) const;
    void publish(const Part& part);
    void fillUp(const AssignmentInput& input, std::span<const std::int32_t> incumbent, CostOracle& costs,
                ThreadPool& pool);
    void matchLeftOver(const AssignmentInput& input);

    std::vector<Part> parts_;            // Parts by class, ascending; one for each class that has characters.
    std::vector<std::int32_t> placeOf_;  // Place per character, -1 unmatched.
    std::vector<float> cost_;            // Cost per character [m].
    // Working memory.
    PartInput input_;
    std::vector<std::vector<std::int32_t>> members_;  // Members by class.
    std::vector<std::int32_t> slotOf_;                // Per place: its slot in the part of its class, or -1.
    std::vector<std::uint8_t> taken_;                 // 1 per place that is taken.
    std::vector<std::int32_t> unmatched_;             // Unmatched characters.
    std::vector<std::int32_t> free_;                  // Free places.
    std::vector<AssignmentPair> pairs_;               // Pairs of characters and places of different classes.
    std::vector<float> pairCosts_;                    // Costs of the pairs [m].
};

}  // namespace muster
