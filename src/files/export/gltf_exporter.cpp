#include <algorithm>
#include <cstdio>
#include <optional>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "files/export/formats.h"
#include "files/export/gltf_people.h"
#include "files/export/scene_camera.h"

namespace muster {
namespace {

// Largest buffer; 64 MiB remain for the JSON text.
constexpr std::uint64_t kMostBytes = 0xFFFFFFFFull - (64u << 20);

/// The rotation whose matrix has these columns; they are orthogonal and right-handed.
Quat rotationOf(Vec3 x, Vec3 y, Vec3 z) {
    // The largest of the four components is computed first, to avoid division by nearly zero.
    const float w = 1.0f + x.x + y.y + z.z, i = 1.0f + x.x - y.y - z.z;
    const float j = 1.0f - x.x + y.y - z.z, k = 1.0f - x.x - y.y + z.z;
    const float most = std::max({w, i, j, k});
    if (most == w) return normalized(Quat{y.z - z.y, z.x - x.z, x.y - y.x, w});
    if (most == i) return normalized(Quat{i, x.y + y.x, z.x + x.z, y.z - z.y});
    if (most == j) return normalized(Quat{x.y + y.x, j, y.z + z.y, z.x - x.z});
    return normalized(Quat{z.x + x.z, y.z + z.y, k, x.y - y.x});
}

/// A moving obstacle or patch.
struct MovingThing {
    GltfTrack track;
    SceneThing thing;
    std::uint32_t node = 0;
    Quat before;
};

class GltfExporter : public Exporter {
public:
    explicit GltfExporter(std::string path) : path_(std::move(path)) {}

    Status begin(const ExportInfo& info) override {
        info_ = info;
        if (Status s = checkSize(info.people()); !s.ok()) return s;
        if (Status s = file_.open(path_); !s.ok()) return s;
        if (Status s = buffer_.open(path_ + ".data.part"); !s.ok()) return s;
        return writeTimes();
    }

    Status frame(const ExportFrame& frame) override {
        if (frame.index == 0) {
            if (Status s = addScene(*frame.world); !s.ok()) return s;
        }
        if (Status s = people_->frame(frame); !s.ok()) return s;
        if (buffer_.size() > kMostBytes) return checkSize(frame.characters.size());
        for (const ExportCharacter& c : frame.characters) {
            const Vec3 feet{static_cast<float>(c.position.x), static_cast<float>(c.position.y), 0.0f};
            fit_.add(feet);
            fit_.add(feet + Vec3{0.0f, 0.0f, static_cast<float>(kSeenHeight)});
            anyone_ = true;
        }
        return moveThings(frame.time);
    }

    Status finish() override {
        if (Status s = people_->finish(times_, info_.fps); !s.ok()) return s;
        for (MovingThing& moving : moving_) {
            if (Status s = moving.track.flush(); !s.ok()) return s;
            animate(moving);
        }
        addCamera();
        return assemble();
    }

private:
    Status checkSize(std::size_t characters) const {
        const double bytes = static_cast<double>(GltfPeople::trackBytes(1)) *
                             static_cast<double>(info_.frames) * static_cast<double>(characters);
        if (bytes <= static_cast<double>(kMostBytes) && buffer_.size() <= kMostBytes) return {};
        char text[200];
        std::snprintf(
            text, sizeof(text),
            "glb: found %zu characters in %zu frames, expected no more than the format's 4 GiB hold; "
            "take a shorter part or fewer frames a second",
            characters, info_.frames);
        return {StatusCode::LimitExceeded, text};
    }

    Status writeTimes() {
        std::vector<float> times;
        for (std::size_t k = 0; k < info_.frames; ++k)
            times.push_back(static_cast<float>(static_cast<double>(k) / info_.fps));
        const std::size_t bytes = times.size() * sizeof(float);
        std::uint64_t offset = 0;
        Status s = buffer_.append({reinterpret_cast<const char*>(times.data()), bytes}, offset);
        if (!s.ok()) return s;
        GltfValues values{GltfNumber::Float, "SCALAR", times.size()};
        values.least = jsonNumbers(std::span<const float>(times).first(1));
        values.most = jsonNumbers(std::span<const float>(times).last(1));
        times_ = document_.addAccessor(document_.addView(offset, bytes, GltfTarget::None), 0, values);
        people_.emplace(document_, buffer_, meshes_, info_.frames);
        return {};
    }

    Status addScene(const World& world) {
        const Box& box = inspect::environment(world).def().box;
        middle_ = (box.min + box.max) * 0.5;
        for (SceneThing& thing : makeScene(world)) {
            const auto mesh = meshes_.thing(thing);
            if (!mesh.ok()) return mesh.status();
            const Vec3 place = gltfAxes(
                Vec3{static_cast<float>(thing.pivot.x), static_cast<float>(thing.pivot.y), 0});
            const std::uint32_t node = document_.nodes.add("{\"name\":" + jsonText(thing.name) +
                                                           ",\"mesh\":" + std::to_string(*mesh) +
                                                           ",\"translation\":" + jsonNumbers(place) + "}");
            document_.roots.add(std::to_string(node));
            if (thing.path.still()) continue;
            const std::uint32_t widths[] = {3 * sizeof(float), 4 * sizeof(float)};
            moving_.push_back({GltfTrack(buffer_, info_.frames, widths), std::move(thing), node, {}});
        }
        return {};
    }

    Status moveThings(double time) {
        for (MovingThing& moving : moving_) {
            const Vec2 p = moving.thing.place(time);
            const Vec3 place = gltfAxes(Vec3{static_cast<float>(p.x), static_cast<float>(p.y), 0.0f});
            Quat turn = gltfAxes(yawTurn(moving.thing.turn(time)));
            if (dot(turn, moving.before) < 0.0f) turn = -turn;
            moving.before = turn;
            const float values[] = {place.x, place.y, place.z, turn.x, turn.y, turn.z, turn.w};
            Status s = moving.track.add({reinterpret_cast<const char*>(values), sizeof(values)});
            if (!s.ok()) return s;
        }
        return {};
    }

    void animate(const MovingThing& moving) {
        const std::uint32_t view = document_.addView(moving.track.begin(), moving.track.bytes(),
                                                     GltfTarget::None);
        const auto add = [&](const char* path, std::size_t value, const char* type) {
            const GltfValues values{GltfNumber::Float, type, info_.frames};
            const std::uint32_t accessor = document_.addAccessor(view, moving.track.offset(value), values);
            document_.animate(moving.node, path, times_, accessor);
        };
        add("translation", 0, "VEC3");
        add("rotation", 1, "VEC4");
    }

    void addCamera() {
        if (!anyone_) fit_.add({static_cast<float>(middle_.x), static_cast<float>(middle_.y), 0.0f});
        const SceneCamera c = fit_.camera();
        const std::uint32_t camera = document_.cameras.add(
            "{\"name\":\"Camera\",\"type\":\"perspective\",\"perspective\":{\"aspectRatio\":" +
            jsonNumber(c.aspect) + ",\"yfov\":" + jsonNumber(c.fieldOfView) +
            ",\"znear\":0.1,\"zfar\":" + jsonNumber(c.farthest) + "}}");
        const Quat turn = rotationOf(gltfAxes(c.right), gltfAxes(c.up), gltfAxes(-c.forward));
        document_.roots.add(std::to_string(document_.nodes.add(
            "{\"name\":\"Camera\",\"camera\":" + std::to_string(camera) + ",\"translation\":" +
            jsonNumbers(gltfAxes(c.eye)) + ",\"rotation\":" + jsonNumbers(turn) + "}")));
    }

    Status assemble() {
        const std::string text = document_.text(info_.name, buffer_.size());
        if (glbSize(text.size(), buffer_.size()) > 0xFFFFFFFFull)
            return {StatusCode::LimitExceeded, path_ + ": would be more than 4 GiB large"};
        if (Status s = file_.write(glbStart(text, buffer_.size())); !s.ok()) return s;
        if (Status s = buffer_.copyTo(file_); !s.ok()) return s;
        return file_.commit();
    }

    std::string path_;
    ExportInfo info_;
    OutputFile file_;
    GltfBuffer buffer_;
    GltfDocument document_;
    GltfMeshes meshes_{document_, buffer_};
    std::optional<GltfPeople> people_;
    std::vector<MovingThing> moving_;
    std::uint32_t times_ = 0;
    CameraFit fit_;
    bool anyone_ = false;
    Vec2 middle_;
};

}  // namespace

std::unique_ptr<Exporter> makeGltfExporter(const std::string& path) {
    return std::make_unique<GltfExporter>(path);
}

}  // namespace muster
