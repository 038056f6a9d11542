#include <cmath>
#include <map>

#include "base/easing.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "files/export/formats.h"
#include "files/export/scene_camera.h"
#include "files/export/usd_file.h"
#include "files/export/usd_scene.h"
#include "files/export/usd_text.h"

namespace muster {
namespace {

class UsdExporter : public Exporter {
public:
    UsdExporter(std::string path, std::unique_ptr<UsdFile> file)
        : path_(std::move(path)), file_(std::move(file)) {}

    Status begin(const ExportInfo& info) override {
        info_ = info;
        if (Status s = file_->open(path_, {info.frames, info.fps}); !s.ok()) return s;
        if (Status s = file_->add(usdMaterials()); !s.ok()) return s;
        return file_->add(usdBodies());
    }

    Status frame(const ExportFrame& frame) override {
        if (frame.index == 0) {
            if (Status s = addScene(*frame.world); !s.ok()) return s;
        }
        for (const ExportCharacter& character : frame.characters) {
            if (Status s = add(character, frame); !s.ok()) return s;
            const Vec3 feet{static_cast<float>(character.position.x),
                            static_cast<float>(character.position.y), 0};
            fit_.add(feet);
            fit_.add(feet + Vec3{0.0f, 0.0f, static_cast<float>(kSeenHeight)});
            anyone_ = true;
        }
        return {};
    }

    Status finish() override {
        for (auto& [id, person] : people_) {
            if (Status s = fill(person, info_.frames); !s.ok()) return s;
            if (person.seen < info_.frames) person.changes.push_back(person.seen);
            const std::size_t track = person.track + static_cast<std::size_t>(UsdPersonTrack::Visibility);
            if (Status s = file_->words(track, visibilityOf(person)); !s.ok()) return s;
        }
        if (!anyone_) fit_.add({static_cast<float>(middle_.x), static_cast<float>(middle_.y), 0.0f});
        if (Status s = file_->add(usdCamera(fit_.camera())); !s.ok()) return s;
        return file_->finish();
    }

private:
    struct Person {
        std::size_t track = 0;             ///< Its first track.
        UsdPersonValues last;              ///< Its values in its last frame.
        double turn = 0.0;                 ///< Rotation without jumps by full turns [rad].
        std::size_t filled = 0;            ///< Number of frames written.
        std::size_t seen = 0;              ///< One more than the last frame that contains it.
        std::vector<std::size_t> changes;  ///< Frames at which the character appears or leaves, alternating.
    };

    Status addScene(const World& world) {
        const Box& box = inspect::environment(world).def().box;
        middle_ = (box.min + box.max) * 0.5;
        std::map<std::string, int> names{{"World", 1}, {"Materials", 1}, {"Bodies", 1}, {"Camera", 1}};
        for (SceneThing& thing : makeScene(world)) {
            // Different names may become the same USD name.
            const std::string name = usdName(thing.name);
            const int known = names[name]++;
            thing.name = known == 0 ? name : name + "__" + std::to_string(known);
            const std::size_t track = file_->tracks();
            if (Status s = file_->add(usdThing(thing)); !s.ok()) return s;
            if (thing.path.still()) continue;
            if (Status s = move(thing, track); !s.ok()) return s;
        }
        return {};
    }

    Status move(const SceneThing& thing, std::size_t track) {
        for (std::size_t k = 0; k < info_.frames; ++k) {
            const double time = info_.from + static_cast<double>(k) / info_.fps;
            const Vec2 at = thing.place(time);
            const double turn[] = {thing.turn(time) * 180.0 / kPi}, place[] = {at.x, at.y, 0.0};
            if (Status s = file_->sample(track, turn); !s.ok()) return s;
            if (Status s = file_->sample(track + 1, place); !s.ok()) return s;
        }
        return {};
    }

    Status add(const ExportCharacter& character, const ExportFrame& frame) {
        const auto [found, fresh] = people_.try_emplace(character.id);
        Person& person = found->second;
        if (fresh) {
            person.turn = static_cast<double>(character.yaw);
            person.track = file_->tracks();
            person.last = usdPersonValues(character, person.turn);
            const CharacterLook look = characterLook(character.id, character.group, *frame.world);
            if (Status s = file_->add(usdPerson(character, look, person.last)); !s.ok()) return s;
        }
        // Before the character appears it waits at its first position; while it is absent it keeps its last
        // pose.
        if (Status s = fill(person, frame.index); !s.ok()) return s;
        person.turn += wrappedAngle(static_cast<double>(character.yaw) - person.turn);
        person.last = usdPersonValues(character, person.turn);
        if (person.changes.empty()) {
            person.changes.push_back(frame.index);
        } else if (person.seen != frame.index) {
            person.changes.insert(person.changes.end(), {person.seen, frame.index});
        }
        person.seen = frame.index + 1;
        return fill(person, frame.index + 1);
    }

    Status fill(Person& person, std::size_t frames) {
        for (; person.filled < frames; ++person.filled)
            for (std::size_t k = 0; k < person.last.size(); ++k) {
                if (person.last[k].empty()) continue;
                if (Status s = file_->sample(person.track + k, person.last[k]); !s.ok()) return s;
            }
        return {};
    }

    static UsdWords visibilityOf(const Person& person) {
        UsdWords words;
        if (person.changes.front() > 0) words.emplace_back(0, "invisible");
        for (std::size_t k = 0; k < person.changes.size(); ++k)
            words.emplace_back(person.changes[k], k % 2 == 0 ? "inherited" : "invisible");
        return words;
    }

    std::string path_;
    std::unique_ptr<UsdFile> file_;
    ExportInfo info_;
    std::map<std::uint32_t, Person> people_;
    CameraFit fit_;
    bool anyone_ = false;
    Vec2 middle_;
};

}  // namespace

std::unique_ptr<Exporter> makeUsdExporter(const std::string& path) {
    return std::make_unique<UsdExporter>(path, makeUsdTextFile());
}

std::unique_ptr<Exporter> makeUsdCrateExporter(const std::string& path) {
    return std::make_unique<UsdExporter>(path, makeUsdCrateFile());
}

}  // namespace muster
