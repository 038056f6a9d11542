#include "lab/picture/picture.h"

#include <algorithm>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "lab/picture/theme.h"

namespace muster {
namespace {

struct LayerName {
    const char* name;
    Layer layer;
};

constexpr LayerName kLayers[] = {
    {"patches", Layer::Patches}, {"field", Layer::Field},         {"cost", Layer::Cost},
    {"density", Layer::Density}, {"obstacles", Layer::Obstacles}, {"mesh", Layer::Mesh},
    {"places", Layer::Places},   {"paths", Layer::Paths},         {"characters", Layer::Characters}};

constexpr std::uint32_t bit(Layer layer) {
    return static_cast<std::uint32_t>(layer);
}

constexpr std::uint32_t kPlain = bit(Layer::Obstacles) | bit(Layer::Patches) | bit(Layer::Mesh) |
                                 bit(Layer::Places) | bit(Layer::Paths) | bit(Layer::Characters);

bool endsWith(const std::string& text, std::string_view ending) {
    return text.size() >= ending.size() &&
           text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

}  // namespace

std::vector<std::string> layerNames() {
    std::vector<std::string> names;
    for (const LayerName& layer : kLayers) names.emplace_back(layer.name);
    return names;
}

Result<std::uint32_t> parseLayers(std::string_view names) {
    std::uint32_t bits = 0;
    while (!names.empty()) {
        const std::size_t comma = names.find(',');
        const std::string_view name = names.substr(0, comma);
        names = comma == std::string_view::npos ? std::string_view() : names.substr(comma + 1);
        const auto* found = std::find_if(std::begin(kLayers), std::end(kLayers),
                                         [&](const LayerName& layer) { return name == layer.name; });
        if (found == std::end(kLayers)) {
            std::string list;
            for (const std::string& known : layerNames()) list += (list.empty() ? "" : ", ") + known;
            return invalidArgument("found the layer \"" + std::string(name.substr(0, 40)) +
                                   "\", expected some of " + list);
        }
        bits |= bit(found->layer);
    }
    return bits;
}

void drawWorld(DebugDraw& draw, const World& world, const PictureDef& def) {
    const std::uint32_t layers = def.layers == 0 ? kPlain : def.layers;
    const Pen pen{draw, Theme::of(def.dark), world, def, std::max(0.5, def.width / 1280.0)};
    const auto shows = [&](Layer layer) { return (layers & bit(layer)) != 0; };
    if (shows(Layer::Cost)) drawCostField(pen);
    drawGroundLines(pen);
    if (shows(Layer::Patches)) drawPatches(pen);
    if (shows(Layer::Field)) drawPotentialField(pen);
    if (shows(Layer::Density)) drawDensity(pen);
    if (shows(Layer::Patches)) drawItems(pen);
    if (shows(Layer::Obstacles)) drawObstacles(pen);
    if (shows(Layer::Mesh)) drawMeshes(pen);
    if (shows(Layer::Places)) drawPlaces(pen);
    if (shows(Layer::Paths)) drawTrails(pen);
    if (shows(Layer::Characters)) drawCharacters(pen);
    if (shows(Layer::Paths)) drawPaths(pen);
    if (shows(Layer::Paths) || shows(Layer::Mesh)) drawControls(pen);
    if (shows(Layer::Patches)) drawPatchTags(pen);
}

namespace {

/// The visible area, or the reason why it cannot be drawn.
Result<Box> viewOf(const World& world, const PictureDef& def) {
    if (def.width < 64 || def.width > 8192)
        return invalidArgument("found a width of " + std::to_string(def.width) +
                               " pixels, expected 64 to 8192");
    const Box view = def.view.value_or(inspect::environment(world).def().box);
    if (!(view.width() > 0.0 && view.height() > 0.0 && view.height() * def.width < 8192.0 * view.width()))
        return invalidArgument("found an empty view or one too high for its width, expected a box");
    return view;
}

}  // namespace

Result<std::string> svgPicture(const World& world, const PictureDef& def) {
    const auto view = viewOf(world, def);
    if (!view.ok()) return view.status();
    const auto draw = makeSvgDraw(*view, def.width, Theme::of(def.dark).ground);
    drawWorld(*draw, world, def);
    return draw->document();
}

Status writePicture(const World& world, const PictureDef& def, const std::string& path) {
    const auto view = viewOf(world, def);
    if (!view.ok()) return view.status();
    const Colour ground = Theme::of(def.dark).ground;
    std::unique_ptr<DebugDraw> draw;
    if (endsWith(path, ".png")) draw = makePngDraw(*view, def.width, ground);
    if (endsWith(path, ".svg")) draw = makeSvgDraw(*view, def.width, ground);
    if (!draw) return invalidArgument(path + ": found another ending, expected .png or .svg");
    drawWorld(*draw, world, def);
    return draw->write(path);
}

}  // namespace muster
