// Builds the mesh of a body by lofting through the cross sections of a shape.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "people/bodies/mesh_builder.h"
#include "people/bodies/shape.h"

namespace muster::bodies {

inline constexpr Vec3 kSkin{0.745f, 0.397f, 0.212f}, kShirt{0.012f, 0.115f, 0.638f},
    kTrousers{0.012f, 0.024f, 0.069f}, kHair{0.042f, 0.019f, 0.009f}, kShoes{0.78f, 0.75f, 0.71f},
    kSoles{0.25f, 0.24f, 0.22f};

inline constexpr Stuff kTrunkShirt{BodyRegion::Shirt, Part::Trunk, kShirt};
inline constexpr Stuff kSleeves{BodyRegion::Shirt, Part::Arm, kShirt};
inline constexpr Stuff kPants{BodyRegion::Trousers, Part::Trunk, kTrousers};
inline constexpr Stuff kLegs{BodyRegion::Trousers, Part::Leg, kTrousers};
inline constexpr Stuff kBareArm{BodyRegion::Skin, Part::Arm, kSkin};
inline constexpr Stuff kBareNeck{BodyRegion::Skin, Part::Trunk, kSkin};
inline constexpr Stuff kFace{BodyRegion::Skin, Part::Head, kSkin};
inline constexpr Stuff kHeadHair{BodyRegion::Hair, Part::Head, kHair};
inline constexpr Stuff kShoe{BodyRegion::Shoes, Part::Shoe, kShoes};
inline constexpr Stuff kSole{BodyRegion::Shoes, Part::Shoe, kSoles};

/// Numbers of vertices in the rings.
struct Detail {
    bool fine = true;  ///< True for the near level of detail.
    std::size_t trunk = 0, limb = 0, arm = 0, head = 0;
};
inline constexpr Detail kFine{true, 16, 12, 8, 12}, kCoarse{false, 8, 6, 4, 6};

/// Angle of vertex `k` of a ring [rad].
double angleOf(std::size_t k, std::size_t corners);
/// The factor that scales rings to the area of their ellipse: a polygon with vertices on an ellipse has less
/// area than it.
float widening(std::size_t corners);

/// Builds one body. Legs and sleeves share vertices with the trunk, so that the surface bends without seams
/// at hips and shoulders. Arms, neck, head, hair and shoes are separate lofts that begin hidden inside the
/// others.
class Sculptor {
public:
    Sculptor(const Shape& shape, const Detail& detail) : shape_(shape), detail_(detail) {}

    /// Builds the body. It may be called once only.
    BodyMesh make();

private:
    /// A point on a horizontal section, at an angle from straight ahead to the left [rad].
    static Vec3 levelPoint(const Section& cut, double angle, float widen);
    std::vector<Vec3> levelRing(const Section& cut, std::size_t corners, double first = 0.0) const;
    /// Points of a section through an arm, from the top round by the front.
    std::vector<Vec3> armRing(const Section& cut, std::size_t corners) const;
    /// Folds cloth inwards at an edge. It shares no vertices with the outside, so that the edge is shaded
    /// sharp.
    void turnIn(const Ring& edge, const Stuff& stuff, float scale, Vec3 shift, bool left);
    /// A loft of circles along a path, closed at its end.
    void tube(std::span<const Vec3> path, std::span<const float> radii, Vec3 tip, std::size_t corners,
              const Stuff& stuff, float flat = 1.0f);
    /// The vertex of a trunk's ring on the side under construction.
    std::uint32_t column(const Ring& ring, std::size_t k) const;
    void makePelvis();
    void makeShirt();
    /// Adds the shirt's surface except the holes for the sleeves.
    void coverShirt();
    void makeLeg();
    void makeSleeve();
    void makeArm();
    void makeShoe();
    /// A ring of a shoe, from the sole's inner corner round by the outer side, seen from the toes.
    Ring shoeRing(float x, float width, float top);
    void makeNeckAndHead();
    void makeNoseAndEars();
    /// The head's section at a height between its first and last section.
    Section sectionAt(float height) const;
    /// Height of the hairline at an angle from straight ahead: high over the face, low at temples and nape
    /// [m].
    float hairline(double angle) const;
    void makeHair();
    void makeTail();
    bool wanted(const Section& cut) const { return detail_.fine || cut.far; }

    const Shape& shape_;
    Detail detail_;
    MeshBuilder mesh_;
    Ring hips_, crotch_;  ///< Rings at which the legs begin.
    std::vector<Ring> shirt_;
    std::array<std::size_t, 2> hole_{};  ///< Rings of the shirt between which the sleeves begin.
    bool mirrored_ = false;
};

}  // namespace muster::bodies
