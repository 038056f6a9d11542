// From touches to point, line and area controls (SPEC U1 to U5; paper sections 4.1 and 4.2).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "formation/mesh/arap.h"
#include "muster/control.h"

namespace muster {

/// How touches become controls and how these move.
struct ControlDef {
    double window = 0.15;            ///< Touches that begin within it form one control [s] >= 0.
    double checkpointSpacing = 0.5;  ///< Along a drawn path [m] > 0.
    double maxSpeed = 1.6;           ///< Bound on control points [m/s] > 0.
    double clockRate = 4.0;          ///< Bound on drawing seconds per second when catching up >= 1.
    double softWeight = 6.0;         ///< Of supplementary points > 0.
    double sampleSpacing = 1.0;      ///< Between supplementary points [m] > 0.
};

/// All controls on one mesh.
class ControlSet {
public:
    /// A finger comes down at `position` on the mesh with these vertices (Vf, as people see it): starts a
    /// point control on the nearest vertex, or joins the same client's open control and upgrades it to line
    /// or area. `held` are the vertices that controls move (Vu); empty where they are the same. Refused
    /// (false): a finger that is down already, one whose nearest vertex is held by a finger or a pin (a
    /// lifted control still on its way gives way), numbers that are not finite, more than 32 fingers of a
    /// client or 64 controls.
    bool touchDown(const ControlDef& def, std::uint32_t client, std::uint32_t touch, Vec2 position,
                   double time, const TriangleMesh& rest, std::span<const Vec2> vertices,
                   std::span<const Vec2> held = {});
    /// Starts a whole control of a given kind at once (mouse: rubber band, lasso; API): one position
    /// and touch number per point. False where the number does not suit the kind (1, 2, 3 and more), or as
    /// above.
    bool addControl(const ControlDef& def, std::uint32_t client, ControlKind kind,
                    std::span<const std::uint32_t> touches, std::span<const Vec2> positions, double time,
                    const TriangleMesh& rest, std::span<const Vec2> vertices,
                    std::span<const Vec2> held = {});
    /// The finger moves: its path grows (at most 4096 checkpoints; then every second goes). False for an
    /// unknown finger or a number that is not finite.
    bool touchMove(const ControlDef& def, std::uint32_t client, std::uint32_t touch, Vec2 position,
                   double time);
    /// The finger lifts: the path stays to be followed. False for an unknown finger.
    bool touchUp(std::uint32_t client, std::uint32_t touch);
    /// Ends the control that this finger belongs to at once, dropping the path still ahead.
    bool touchCancel(std::uint32_t client, std::uint32_t touch);
    /// Lifts every finger of a client that has gone.
    void releaseClient(std::uint32_t client);
    /// Keeps a control where its path ends, or lets it go. False for an unknown id.
    bool setPinned(ControlId id, bool pinned);
    /// Ends a control. False for an unknown id.
    bool remove(ControlId id);
    /// Ends all.
    void clear();

    /// Moves control points along their paths for `dt` [s]: clocks advance no faster than the speed
    /// bound times `pace` (0 to 1, SPEC U6) allows, never beyond `now`; lifted controls at the end of their
    /// paths go, unless pinned. Returns true where the set of constraints changed.
    bool advance(const ControlDef& def, double dt, double now, double pace);
    /// The mesh was exchanged: every control point takes the vertex nearest to where it is held,
    /// supplementary points are sampled anew; points that fall on one vertex are merged.
    void rebind(const ControlDef& def, const TriangleMesh& rest, std::span<const Vec2> vertices);

    /// In the order they were made.
    std::span<const Control> controls() const { return controls_; }
    /// Hard vertices, soft points and their targets for the solver, in a fixed order.
    void constraints(const ControlDef& def, std::vector<std::int32_t>& hard, std::vector<Vec2>& hardTargets,
                     std::vector<SoftConstraint>& soft, std::vector<Vec2>& softTargets) const;

    /// Lets an archive read or write the set.
    template <class Archive>
    void visit(Archive& archive) {
        archive(controls_, nextId_);
    }

private:
    std::vector<Control> controls_;
    std::uint32_t nextId_ = 1;
};

}  // namespace muster
