#include "game_options.h"

#include <charconv>
#include <string_view>

namespace game {
namespace {

constexpr std::int32_t kDemoFrames = 2780;
constexpr std::int32_t kMostFrames = 1'000'000;

}  // namespace

muster::Result<Options> readOptions(int count, const char* const* arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string_view argument = arguments[i];
        const std::string_view value = i + 1 < count ? arguments[i + 1] : "";
        if (argument == "--frames") {
            const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(),
                                                      options.frames);
            if (error != std::errc() || end != value.data() + value.size() || options.frames < 1 ||
                options.frames > kMostFrames)
                return muster::invalidArgument("--frames is '" + std::string(value) +
                                               "', expected 1 to 1000000");
            ++i;
        } else if (argument == "--picture") {
            if (value.empty()) return muster::invalidArgument("--picture needs the name of a file");
            options.picture = value;
            ++i;
        } else if (argument.starts_with("-")) {
            return muster::invalidArgument("no option is called '" + std::string(argument) +
                                           "'; there are --frames N and --picture FILE.bmp");
        } else {
            options.picture = std::string(argument) + "/sdl_game.bmp";
        }
    }
    if (!options.picture.empty() && options.frames == 0) options.frames = kDemoFrames;
    return options;
}

}  // namespace game
