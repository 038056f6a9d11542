// From touches to point, line and area controls (SPEC U1 to U5; paper sections 4.1 and 4.2).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/formation/mesh/arap.h"
#include "muster/generated/control.h"
#include "muster/generated/parameters.h"

namespace muster {

/// All controls on one mesh.
class ControlSet {
public:
    /// A finger comes down at `position` [m]. It starts a point control on the nearest of `finalVertices`
    /// (Vf, as people see it), or joins the same client's open control, which becomes a line or an area.
    /// `userVertices` are the vertices that controls move (Vu); empty where they are the same. Refused
    /// (false): a finger that is down already; a nearest vertex that is held by a finger or a pinned control
    /// (a lifted control that still follows its trajectories ends instead); numbers that are not finite; more
    /// than 32 fingers of a client or 64 controls.
    bool touchDown(const Parameters::Input& input, std::uint32_t client, std::uint32_t touch, Vec2 position,
                   double time, const TriangleMesh& rest, std::span<const Vec2> finalVertices,
                   std::span<const Vec2> userVertices = {});
    /// Starts a control of a given kind at once (mouse: rubber band, lasso; API), with one position and touch
    /// number per point. Refused (false) where the number of points does not suit the kind, or as
    /// touchDown().
    bool addControl(std::uint32_t client, ControlKind kind, std::span<const std::uint32_t> touches,
                    std::span<const Vec2> positions, double time, const TriangleMesh& rest,
                    std::span<const Vec2> finalVertices, std::span<const Vec2> userVertices = {});
    /// Extends the trajectory of a finger (at most 4096 checkpoints; then every second is dropped). False for
    /// an unknown finger or a number that is not finite.
    bool touchMove(const Parameters::Input& input, std::uint32_t client, std::uint32_t touch, Vec2 position,
                   double time);
    /// Lifts a finger; its trajectory is still followed. False for an unknown finger.
    bool touchUp(std::uint32_t client, std::uint32_t touch);
    /// Ends the control of a finger at once. False for an unknown finger.
    bool touchCancel(std::uint32_t client, std::uint32_t touch);
    /// Lifts all fingers of a client that has left.
    void releaseClient(std::uint32_t client);
    /// Pins a control where its trajectories end, or releases it. False for an unknown id.
    bool setPinned(ControlId id, bool pinned);
    /// Ends a control. False for an unknown id.
    bool remove(ControlId id);
    /// Ends all controls.
    void clear();

    /// Moves control points along their trajectories for `dt` [s]. Clocks advance no faster than the top
    /// speed times `pace` (0 to 1, SPEC U6) allows and never beyond `now` [s]. Lifted controls at the ends of
    /// their trajectories end, unless pinned. Returns true where the set of constraints changed.
    bool advance(const Parameters::Input& input, const Parameters::Control& def, double dt, double now,
                 double pace);
    /// Binds the controls to another mesh: every control point takes the vertex nearest to its position,
    /// points that fall on one vertex are merged, and supplementary points are sampled again.
    void rebind(const TriangleMesh& rest, std::span<const Vec2> vertices);

    /// All controls, in the order in which they were made.
    std::span<const Control> controls() const { return controls_; }
    /// Writes the constraints for the solver and their targets [m], in a fixed order.
    void constraints(const Parameters::Control& def, std::vector<std::int32_t>& hard,
                     std::vector<Vec2>& hardTargets, std::vector<SoftConstraint>& soft,
                     std::vector<Vec2>& softTargets) const;

    /// Lets an archive read or write the set.
    template <class Archive>
    void visit(Archive& archive) {
        archive(controls_, nextId_);
    }

private:
    std::vector<Control> controls_;
    std::uint32_t nextId_ = 1;  // Id of the next control.
};

}  // namespace muster
