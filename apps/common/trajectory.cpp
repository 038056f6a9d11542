#include "trajectory.h"

#include "base/maths.h"

namespace muster {

Result<TrajectoryWriter> TrajectoryWriter::create(const std::string& path) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) return Status(StatusCode::IoError, path + ": cannot be written");
    TrajectoryWriter writer(file, path);
    std::fprintf(file, "t,id,x,y,place_x,place_y,group,heading,motion,goal\n");
    return writer;
}

void TrajectoryWriter::add(const World& world) {
    const CharactersView characters = world.characters();
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const Vec2 p = characters.position[i];
        const auto places = world.group(characters.group[i]).placePositions;
        const auto place = static_cast<std::size_t>(characters.place[i]);
        std::fprintf(file_.get(), "%.9g,%u,%.9g,%.9g,", world.time(), characters.id[i], p.x, p.y);
        if (characters.place[i] >= 0 && place < places.size()) {
            std::fprintf(file_.get(), "%.9g,%.9g,", places[place].x, places[place].y);
        } else {
            std::fprintf(file_.get(), ",,");
        }
        const Vec2 facing = characters.heading[i];
        std::fprintf(file_.get(), "%u,%.6g,%d,%u\n", world.group(characters.group[i]).id.value,
                     arcTangent2(facing.y, facing.x), characters.motion[i],
                     i < characters.goal.size() ? characters.goal[i] : 0);
    }
}

Status TrajectoryWriter::close() {
    const bool good = std::ferror(file_.get()) == 0;
    const bool closed = std::fclose(file_.release()) == 0;
    return good && closed ? Status() : Status(StatusCode::IoError, path_ + ": cannot be written in full");
}

}  // namespace muster
