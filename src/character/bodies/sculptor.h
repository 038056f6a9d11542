// Lofts a body through the cuts of a shape.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "character/bodies/mesh_builder.h"
#include "character/bodies/shape.h"

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

/// How many corners the rings have.
struct Detail {
    bool fine = true;
    std::size_t trunk = 0, limb = 0, arm = 0, head = 0;
};
inline constexpr Detail kFine{true, 16, 12, 8, 12}, kCoarse{false, 8, 6, 4, 6};

/// The angle of corner `k` [rad].
double angleOf(std::size_t k, std::size_t corners);
/// Corners on an ellipse lie inside it; rings are widened by this to keep the area.
float widening(std::size_t corners);

/// Builds one body. A trunk in trousers and shirt from whose corners legs and sleeves grow, so that skin
/// bends without seams at hips and shoulders; arms, neck, head, hair and shoes are lofts of their own that
/// begin hidden in the others.
class Sculptor {
public:
    Sculptor(const Shape& shape, const Detail& detail) : shape_(shape), detail_(detail) {}

    /// The body. To be called once.
    BodyMesh make();

private:
    /// On a level cut, at an angle from straight ahead to the left.
    static Vec3 levelPoint(const Section& cut, double angle, float widen);
    std::vector<Vec3> levelRing(const Section& cut, std::size_t corners, double first = 0.0) const;
    /// A cut through an arm, from the top round by the front.
    std::vector<Vec3> armRing(const Section& cut, std::size_t corners) const;
    /// Cloth at an edge goes inwards, unshared so that the edge is sharp.
    void turnIn(const Ring& edge, const Stuff& stuff, float scale, Vec3 shift, bool left);
    /// Round cuts along a path, closed at its end.
    void tube(std::span<const Vec3> path, std::span<const float> radii, Vec3 tip, std::size_t corners,
              const Stuff& stuff, float flat = 1.0f);
    /// The corner of a trunk's ring on the side that is built.
    std::uint32_t column(const Ring& ring, std::size_t k) const;
    void makePelvis();
    void makeShirt();
    /// The shirt's surface but for the holes of the sleeves.
    void coverShirt();
    void makeLeg();
    void makeSleeve();
    void makeArm();
    void makeShoe();
    /// From the sole's inner corner round by the outer side, seen from the toes.
    Ring shoeRing(float x, float width, float top);
    void makeNeckAndHead();
    void makeNoseAndEars();
    /// The head's cut at a height between its first and last.
    Section sectionAt(float height) const;
    /// Where hair begins at an angle from straight ahead: high over the face, low at temples and nape.
    float hairline(double angle) const;
    void makeHair();
    void makeTail();
    bool wanted(const Section& cut) const { return detail_.fine || cut.far; }

    const Shape& shape_;
    Detail detail_;
    MeshBuilder mesh_;
    Ring hips_, crotch_;  ///< Where the legs begin.
    std::vector<Ring> shirt_;
    std::array<std::size_t, 2> hole_{};  ///< The sleeves begin between these rings of the shirt.
    bool mirrored_ = false;
};

}  // namespace muster::bodies
