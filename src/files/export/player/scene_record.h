// The objects of a scene as a stream of shapes, from which the page makes meshes again: a beam is seven
// numbers instead of 24 corners.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "files/export/player/range_encoder.h"
#include "files/export/scene_mesh.h"

namespace muster {

/// The kinds of shapes; the page knows them by these numbers.
enum class PlayerShape : std::uint8_t { End, Floor, Walls, Quad, Frustum, Beam, Blob, Level, Count };

/// Writes the shapes of one object after the other.
class SceneRecord final : public SceneShapes {
public:
    /// Begins an object. `moves`: it has a place in each frame, that of its pivot.
    void begin(const ScenePlan& plan, bool moves);
    /// Ends it.
    void end();
    /// All objects. Nothing can be added afterwards.
    std::string finish();

    void quad(Finish finish, Vec3 a, Vec3 b, Vec3 c, Vec3 d) override;
    void floor(Finish finish, const Polygon& outline, double z) override;
    void level(Finish finish, const PolygonWithHoles& shape, const TriangleMesh& mesh) override;
    void walls(Finish finish, const Polygon& outline, double low, double high, bool inside) override;
    void frustum(Finish finish, Vec3 base, double height, double lowRadius, double highRadius,
                 int sides) override;
    void beam(Finish finish, Vec3 a, Vec3 b, double width) override;
    void blob(Finish finish, Vec3 centre, double radius, double height, std::uint32_t seed, int rows,
              int sides) override;

private:
    void shape(PlayerShape kind, Finish finish);
    void point(Vec2 at);
    void point(Vec3 at);
    void outline(const Polygon& polygon);
    /// A length or height, or a number of parts; each slot of each kind has a model, and expects what came
    /// last.
    void size(std::size_t slot, std::int32_t value);
    void length(std::size_t slot, double metres);

    static constexpr std::size_t kKinds = static_cast<std::size_t>(PlayerShape::Count), kSlots = 6;
    RangeEncoder coder_;
    Vec2 pivot_;
    PlayerShape kind_ = PlayerShape::End;
    std::array<std::int32_t, 3> last_{};  ///< The last point.
    NumberModel kindModel_, finishModel_, countModel_, seedModel_, indexModel_;
    std::array<NumberModel, kKinds> flat_, upright_;
    std::array<std::array<NumberModel, kSlots>, kKinds> sizes_;
    std::array<std::array<std::int32_t, kSlots>, kKinds> lastSizes_{};
    BitModel more_, moves_;
};

}  // namespace muster
