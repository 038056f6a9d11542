#include "scale/crowd_scenes.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "base/random.h"
#include "scale/city.h"
#include "scale/features.h"
#include "scale/spots.h"

namespace muster::scale {
namespace {

constexpr double kRimSpeed = 0.6;  // Speed of the rim of a rotating formation [m/s].
constexpr double kBehind = 2.0;    // Distance of a crowd behind a dragged formation at the start [m].
constexpr double kMargin = 6.0;    // Margin of the box [m].

// Amplitude of the rotation at which the rim moves at kRimSpeed, at most 0.5 rad.
double turnOf(double side, double period) {
    return std::min(0.5, kRimSpeed / (0.7 * side) * period / (2.0 * kPi));
}

// A nearly straight course through the feature; a circle round the origin in scenes without a feature.
Course courseOf(const SceneDef& def, const FeatureSize& features, double side) {
    Random random(def.seed * 7919 + 17);
    Course course;
    course.speed = random.uniform(1.2, 1.5);
    course.turn = turnOf(side, course.turnPeriod);
    const double sway = random.uniform(-0.05, 0.05) * side;
    if (def.name == "open") {
        const double radius = 0.4 * side + 8.0;
        for (int k = 0; k <= 64; ++k) {
            const double a = 2.0 * kPi * k / 64.0;
            course.points.push_back({radius * sine(a), -radius * cosine(a)});
        }
        course.closed = true;
        course.begin = random.uniform(0.0, 2.0 * kPi * radius);
    } else {
        const double reach = features.halfLength + 0.5 * side + 1.0;
        course.points = {{-reach, sway}, {0.0, -sway}, {reach, sway}};
    }
    if (def.regime == Regime::Reversing) {
        course.reverseEvery = 2.5;
        // Reversals happen within the feature.
        if (!course.closed) course.begin = 0.3 * side;
    }
    return course;
}

// A box round all positions of the formation, the crowd and the feature.
Box boxOf(const Scene& scene, const FeatureSize& features, Regime regime, double far) {
    const double reach = 0.75 * scene.side + kMargin;
    Box box{{-features.halfLength - kMargin, -features.halfWidth},
            {features.halfLength + kMargin, features.halfWidth}};
    const auto include = [&](Vec2 p) {
        box.min = {std::min(box.min.x, p.x - reach), std::min(box.min.y, p.y - reach)};
        box.max = {std::max(box.max.x, p.x + reach), std::max(box.max.y, p.y + reach)};
    };
    if (regime == Regime::Far) {
        include({-far, 0.0});
        include({far, 0.0});
    } else {
        for (const Vec2 p : scene.course.points) include(p);
    }
    return box;
}

}  // namespace

Status addCrowd(const SceneDef& def, const CoursePose& formation, Vec2 crowd, Scene& scene) {
    const Result<Environment> ground = groundOf(scene.world);
    if (!ground.ok()) return ground.status();
    const Result<std::vector<Vec2>> starts = freeSpots(*ground, crowd, formation.angle, def.count);
    if (!starts.ok()) return starts.status().within("scene " + def.name);
    GroupDef group{.name = "Crowd",
                   .count = def.count,
                   .formation = {.spacing = 1.0},
                   .position = formation.position,
                   .angle = formation.angle,
                   .starts = *starts,
                   .jitter = 0.15};
    scene.world.groups.push_back(std::move(group));
    return {};
}

Vec2 behind(const CoursePose& formation) {
    return formation.position -
           Rotation{cosine(formation.angle), sine(formation.angle)}.apply({kBehind, 0.0});
}

// At the default top speed of 2 m/s the crowd would never fall behind its places.
void letLag(Parameters& parameters) {
    parameters.character.maxSpeed = 1.2;
    parameters.opposing.gain = 0.15;
}

const char* regimeName(Regime regime) {
    constexpr const char* kNames[] = {"far", "tracking", "reversing"};
    return kNames[static_cast<std::size_t>(regime)];
}

const std::vector<std::string>& sceneNames() {
    static const std::vector<std::string> names{"open", "block", "corridor", "woodland", "paths", "city"};
    return names;
}

Result<Scene> makeScene(const SceneDef& def) {
    if (std::find(sceneNames().begin(), sceneNames().end(), def.name) == sceneNames().end())
        return Status(StatusCode::NotFound, "found scene '" + def.name +
                                                "', expected one of open, block, corridor, "
                                                "woodland, paths, city");
    Scene scene;
    scene.side = std::sqrt(static_cast<double>(def.count));
    scene.seconds = 20.0;
    scene.world.name = def.name;
    scene.world.seed = def.seed;
    if (def.name == "city") {
        if (Status status = makeCity(def, scene); !status.ok()) return status;
        return scene;
    }
    const FeatureSize features = featureSize(def.name, scene.side);
    const double far = 0.5 * scene.side + std::max(0.5 * kAway, features.halfLength + 2.0);
    scene.course = courseOf(def, features, scene.side);
    scene.world.box = boxOf(scene, features, def.regime, far);
    addFeature(def.name, scene.side, def.seed, scene.world);
    if (def.regime == Regime::Far) {
        scene.seconds = 30.0 + 2.0 * far / 0.8;
        if (Status status = addCrowd(def, {{far, 0.0}, 0.0}, {-far, 0.0}, scene); !status.ok()) return status;
    } else {
        const CoursePose pose = poseAt(scene.course, 0.0);
        if (Status status = addCrowd(def, pose, behind(pose), scene); !status.ok()) return status;
        letLag(scene.world.parameters);
    }
    return scene;
}

}  // namespace muster::scale
