// Costs to places, read from the windows round them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cost/dynamic_cost.h"
#include "cost/static_ground.h"
#include "geodesics/windows.h"

namespace muster {

/// Windows of one level of the ground, and what each place reads from them while it is asked for.
class WindowCosts {
public:
    explicit WindowCosts(const WindowsDef& def) : windows_(def) {}  ///< Knows nothing yet.

    /// Begins a step with these places on a level of the still ground. All must live until the next.
    void beginStep(const StaticGround& ground, const GroundLevel& level, const DynamicCost& excess,
                   std::span<const Vec2> places);
    /// Makes at most `most` of the windows missed so far; returns how many.
    std::int32_t build(std::int32_t most, ThreadPool& pool) { return windows_.build(most, pool); }
    /// Makes those named by an archive.
    void rebuild(ThreadPool& pool) { windows_.rebuild(pool); }
    /// Finds what places read that were asked for in the last steps; `ticks` counts this as a step.
    void findStencils(bool ticks);

    /// True where the place's windows reach `from`, if there are any.
    bool reaches(Vec2 from, std::int32_t place) const;
    /// Asks for the windows of a place for some time; they are made sooner where its `owner` needs them. May
    /// be called from several threads.
    void ask(std::int32_t place, bool owner) const;
    /// True where a place was asked for in the last steps.
    bool asked(std::int32_t place) const { return asked_[place] > 0; }
    /// True where there are windows for the place.
    bool known(std::int32_t place) const { return seen_[place].count > 0; }
    /// Cost of the way with the excess on it, `line` [m] long as the crow flies; infinite where the windows
    /// do not know.
    double cost(Vec2 from, std::int32_t place, double line) const;
    /// The way down the field of the nearest landmark, straight to the place beside it.
    Vec2 direction(Vec2 from, std::int32_t place) const;
    /// The field of the nearest landmark; only for places known().
    const CostField& field(std::int32_t place) const;
    /// The windows themselves.
    Windows& windows() { return windows_; }
    const Windows& windows() const { return windows_; }

    /// Lets an archive read or write all that influences later steps.
    template <class Archive>
    void visit(Archive& archive) {
        archive(step_, generation_, asked_, owned_, mixed_, seen_, stencil_, windows_);
        if constexpr (Archive::kReading)
            if (owned_.size() != asked_.size() || mixed_.size() != asked_.size() ||
                seen_.size() != asked_.size() || stencil_.size() != asked_.size() || !slotsFit())
                archive.fail();
    }
    /// Places that an archive told of.
    std::size_t places() const { return asked_.size(); }

private:
    bool looks(std::size_t place) const;
    void tick();
    void look(std::size_t place, bool anew);
    bool slotsFit() const;
    double stillCost(Vec2 from, std::int32_t place) const;
    double through(const CostField& field, Vec2 from, Vec2 to) const;
    Vec2 lastSeen(Vec2 from, Vec2 near, Vec2 far) const;
    double aroundCorner(Vec2 from, Vec2 mark, Vec2 to) const;
    double interpolated(Vec2 from, std::int32_t place) const;
    double excessAlong(const CostField& field, Vec2 from, Vec2 to) const;

    Windows windows_;
    const StaticGround* ground_ = nullptr;
    const DynamicCost* excess_ = nullptr;
    std::span<const Vec2> places_;
    std::uint32_t step_ = 0;
    std::uint32_t generation_ = 0;     // Of the windows that slots tell of.
    std::vector<std::uint8_t> asked_;  // Steps for which a place still wants windows...
    std::vector<std::uint8_t> owned_;  // ... because somebody walks there...
    std::vector<std::uint8_t> mixed_;  // ... and stencils, as ways to it lead over ground of several kinds.
    std::vector<SeenWindows> seen_;
    std::vector<LandmarkStencil> stencil_;
};

/// Bilinear interpolation of squares overrates them by this much on ground where a metre costs `unit`.
double readingShift(const Grid& grid, Vec2 from, double unit);

}  // namespace muster
