#include "studio/study/trial/trial_environment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/random.h"

namespace muster {
namespace {

constexpr std::array<std::int32_t, 3> kCrowds{36, 16, 100};
constexpr std::int32_t kMostCharacters = 400;
// Random positions that are tried before items are placed closer than they should be.
constexpr std::int32_t kMostTries = 100000;

const std::array<StudyEnvironment, 4>& environments() {
    static const std::array<StudyEnvironment, 4> all{{
        {"single-block",
         "Single Block",
         "Open ground round one block; the crowd starts at the left.",
         {-13.5, 0.0},
         {{{-4.0, -3.5}, {4.0, 3.5}}}},
        {"corridor",
         "Corridor",
         "Two rooms and a corridor 14 m long and 4 m wide between them; the crowd starts in the left room.",
         {-13.5, 0.0},
         {{{-7.0, 2.0}, {7.0, 11.25}}, {{-7.0, -11.25}, {7.0, -2.0}}}},
        {"multiple-paths",
         "Multiple Paths",
         "Four paths, 16 m long and 4.5 m wide, side by side; the crowd starts before them, at the left.",
         {-13.5, 0.0},
         {{{-8.0, 5.25}, {8.0, 6.75}}, {{-8.0, -0.75}, {8.0, 0.75}}, {{-8.0, -6.75}, {8.0, -5.25}}}},
        {"four-blocks",
         "Four Blocks",
         "A block in each quarter; the crowd starts in the centre.",
         {0.0, 0.0},
         {{{6.5, 3.25}, {13.5, 7.75}},
          {{-13.5, 3.25}, {-6.5, 7.75}},
          {{-13.5, -7.75}, {-6.5, -3.25}},
          {{6.5, -7.75}, {13.5, -3.25}}}},
    }};
    return all;
}

double distanceTo(const Box& box, Vec2 p) {
    const double x = std::max({box.min.x - p.x, 0.0, p.x - box.max.x});
    const double y = std::max({box.min.y - p.y, 0.0, p.y - box.max.y});
    return std::sqrt(x * x + y * y);
}

bool isFree(const StudyEnvironment& environment, const StudyRules& rules, Vec2 p,
            const std::vector<ItemDef>& items) {
    for (const Box& block : environment.blocks)
        if (distanceTo(block, p) < rules.itemClearance) return false;
    if (std::abs(p.x - environment.start.x) < rules.startFree &&
        std::abs(p.y - environment.start.y) < rules.startFree)
        return false;
    for (const ItemDef& item : items)
        if (distance(item.position, p) < rules.itemSpacing) return false;
    return true;
}

// Uniform on the free ground, all of which can be reached.
std::vector<ItemDef> placeItems(const StudyEnvironment& environment, std::uint64_t seed) {
    const StudyRules& rules = studyRules();
    Random random(seed);
    std::vector<ItemDef> items;
    const Box& box = rules.box;
    const double margin = rules.itemClearance;
    for (std::int32_t tries = 0; std::ssize(items) < rules.items && tries < kMostTries; ++tries) {
        const double x = random.uniform(box.min.x + margin, box.max.x - margin);
        const double y = random.uniform(box.min.y + margin, box.max.y - margin);
        if (isFree(environment, rules, {x, y}, items)) items.push_back({{x, y}, rules.itemRadius});
    }
    return items;
}

Polygon cornersOf(const Box& box) {
    return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
}

GroupDef crowdAt(Vec2 start, std::int32_t count) {
    GroupDef group;
    group.name = "Crowd";
    group.count = count;
    group.formation.kind = FormationKind::Square;
    group.formation.spacing = studyRules().spacing;
    group.position = start;
    return group;
}

}  // namespace

std::span<const std::int32_t> studyCrowds() {
    return kCrowds;
}

const StudyRules& studyRules() {
    static const StudyRules rules;
    return rules;
}

std::span<const StudyEnvironment> studyEnvironments() {
    return environments();
}

Result<StudyEnvironment> studyEnvironment(std::string_view name) {
    std::string names;
    for (const StudyEnvironment& environment : environments()) {
        if (environment.name == name) return environment;
        names += (names.empty() ? "" : ", ") + std::string(environment.name);
    }
    return Status{StatusCode::NotFound, "no environment of the study is called '" +
                                            std::string(name.substr(0, 60)) + "'; there are " + names};
}

Result<WorldDef> studyWorld(const StudyEnvironment& environment, std::int32_t crowd, std::uint64_t seed,
                            bool mirrored) {
    if (crowd < 1 || crowd > kMostCharacters)
        return invalidArgument("found a crowd of " + std::to_string(crowd) + ", expected 1 to " +
                               std::to_string(kMostCharacters));
    const double up = mirrored ? -1.0 : 1.0;
    WorldDef def;
    def.name = std::string(environment.title);
    def.description = std::string(environment.description);
    def.box = studyRules().box;
    def.seed = seed;
    def.parameters.control.speed = studyRules().speed;
    def.parameters.character.maxSpeed = studyRules().speed;
    for (const Box& block : environment.blocks) {
        Box placed = block;
        if (mirrored) {
            placed.min.y = -block.max.y;
            placed.max.y = -block.min.y;
        }
        ObstacleDef obstacle;
        obstacle.polygon = cornersOf(placed);
        obstacle.height = 1.5;
        def.obstacles.push_back(std::move(obstacle));
    }
    def.groups.push_back(crowdAt({environment.start.x, up * environment.start.y}, crowd));
    def.items = placeItems(environment, seed);
    for (ItemDef& item : def.items) item.position.y *= up;
    return def;
}

GroundView studyView() {
    const StudyRules& rules = studyRules();
    const Vec2 middle = (rules.box.min + rules.box.max) * 0.5;
    return GroundView::fromAbove(middle, rules.width / (rules.box.max.x - rules.box.min.x), rules.width,
                                 rules.height, rules.mmPerPixel);
}

}  // namespace muster
