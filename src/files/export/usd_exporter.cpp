#include <cmath>
#include <cstdio>
#include <map>

#include "base/maths.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "files/export/formats.h"
#include "files/export/scene_camera.h"
#include "files/export/usd_text.h"

namespace muster {
namespace {

constexpr std::size_t kMostChanges = 8;   // Largest number of a character's visibility changes in the file.
constexpr std::size_t kChangeWidth = 32;  // Number of bytes per visibility change.
constexpr const char* kStarts[] = {
    "        double3 xformOp:translate.timeSamples = {\n", "        float xformOp:rotateZ.timeSamples = {\n",
    "            quatf[] rotations.timeSamples = {\n", "            float3[] translations.timeSamples = {\n"};

/// One frame of a character: a line for each of its four lists of samples.
using Lines = std::array<std::string, 4>;

/// The lines of a character in one frame. Lines of one kind have the same length in all frames.
Lines linesOf(std::size_t frame, const ExportCharacter& c, double turn) {
    Lines lines;
    char number[24];
    std::snprintf(number, sizeof(number), "%10zu: ", frame);
    lines.fill(number);
    const auto fixed = [&](std::size_t line, double value, int width, int decimals, const char* then) {
        usdFixed(value, width, decimals, lines[line]);
        lines[line] += then;
    };
    lines[0] += "(";
    fixed(0, c.position.x, 14, 5, ",");
    fixed(0, c.position.y, 14, 5, ", 0),\n");
    fixed(1, turn * 180.0 / kPi, 14, 5, ",\n");
    lines[2] += "[";
    for (std::size_t j = 0; j < kJointCount; ++j) {
        const Quat q = normalized(c.pose->rotation[j]);
        lines[2] += "(";
        fixed(2, static_cast<double>(q.w), 9, 6, ",");
        fixed(2, static_cast<double>(q.x), 9, 6, ",");
        fixed(2, static_cast<double>(q.y), 9, 6, ",");
        fixed(2, static_cast<double>(q.z), 9, 6, j + 1 < kJointCount ? ")," : ")],\n");
    }
    lines[3] += "[(";
    fixed(3, static_cast<double>(c.pose->hips.x), 10, 5, ",");
    fixed(3, static_cast<double>(c.pose->hips.y), 10, 5, ",");
    fixed(3, static_cast<double>(c.pose->hips.z), 10, 5, ")");
    for (std::size_t j = 1; j < kJointCount; ++j) {
        lines[3] += ',';
        lines[3] += usdPoint(skeleton()[j].offset);
    }
    lines[3] += "],\n";
    return lines;
}

class UsdExporter : public Exporter {
public:
    explicit UsdExporter(std::string path) : path_(std::move(path)) {}

    Status begin(const ExportInfo& info) override {
        info_ = info;
        if (Status s = file_.open(path_); !s.ok()) return s;
        return file_.write("#usda 1.0\n(\n    defaultPrim = \"World\"\n    doc = \"Written by Muster\"\n" +
                           std::string("    endTimeCode = ") + std::to_string(info.frames - 1) +
                           "\n    framesPerSecond = " + usdNumber(info.fps) +
                           "\n    metersPerUnit = 1\n    startTimeCode = 0\n    timeCodesPerSecond = " +
                           usdNumber(info.fps) + "\n    upAxis = \"Z\"\n)\n\ndef Xform \"World\"\n{\n" +
                           usdMaterials() + usdBodies());
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
            for (UsdSamples& samples : person.samples)
                if (Status s = samples.flush(file_); !s.ok()) return s;
            if (person.seen < info_.frames) person.changes.push_back(person.seen);
            if (Status s = file_.rewrite(person.visibility, visibilityOf(person)); !s.ok()) return s;
        }
        if (!anyone_) fit_.add({static_cast<float>(middle_.x), static_cast<float>(middle_.y), 0.0f});
        if (Status s = file_.write(usdCamera(fit_.camera()) + "}\n"); !s.ok()) return s;
        return file_.commit();
    }

private:
    struct Person {
        /// Translation, rotation of the root, rotations of joints, and hips.
        std::vector<UsdSamples> samples;
        ExportCharacter last;              ///< The character in its last frame.
        BodyPose pose;                     ///< The pose of `last`.
        double turn = 0.0;                 ///< Rotation without jumps by full turns [rad].
        std::size_t filled = 0;            ///< Number of frames written.
        std::size_t seen = 0;              ///< One more than the last frame that contains it.
        std::vector<std::size_t> changes;  ///< Frames at which the character appears or leaves, alternating.
        std::uint64_t visibility = 0;      ///< Offset of its visibility changes in the file.
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
            if (Status s = file_.write(usdThing(thing, info_.from, info_.fps, info_.frames)); !s.ok())
                return s;
        }
        return {};
    }

    Status add(const ExportCharacter& character, const ExportFrame& frame) {
        auto found = people_.find(character.id);
        if (found == people_.end()) {
            found = people_.emplace(character.id, Person{}).first;
            found->second.turn = static_cast<double>(character.yaw);
            if (Status s = begin(character, frame, found->second); !s.ok()) return s;
        }
        Person& person = found->second;
        // Before the character appears it waits at its first position; while it is absent it keeps its last
        // pose.
        if (person.filled == 0) remember(character, person);
        if (Status s = fill(person, frame.index); !s.ok()) return s;
        remember(character, person);
        if (person.changes.empty()) {
            person.changes.push_back(frame.index);
        } else if (person.seen != frame.index) {
            person.changes.insert(person.changes.end(), {person.seen, frame.index});
        }
        person.seen = frame.index + 1;
        return fill(person, frame.index + 1);
    }

    static void remember(const ExportCharacter& character, Person& person) {
        const double change = static_cast<double>(character.yaw) - person.turn;
        person.turn += change - 2.0 * kPi * std::floor(change / (2.0 * kPi) + 0.5);
        person.last = character;
        person.pose = *character.pose;
        person.last.pose = nullptr;
    }

    Status fill(Person& person, std::size_t frames) {
        for (; person.filled < frames; ++person.filled) {
            ExportCharacter character = person.last;
            character.pose = &person.pose;
            const Lines lines = linesOf(person.filled, character, person.turn);
            for (std::size_t k = 0; k < lines.size(); ++k)
                if (Status s = person.samples[k].add(file_, lines[k]); !s.ok()) return s;
        }
        return {};
    }

    /// Writes everything of a character but its samples, and reserves their ranges.
    Status begin(const ExportCharacter& character, const ExportFrame& frame, Person& person) {
        const CharacterLook look = characterLook(character.id, character.group, *frame.world);
        char name[40];
        std::snprintf(name, sizeof(name), "character_%04u", character.id);
        const std::string size = usdNumber(static_cast<double>(character.size));
        std::string
            text = "    def SkelRoot \"" + std::string(name) + "\"\n    {\n" +
                   "        float3 xformOp:scale = (" + size + ", " + size + ", " + size + ")\n" +
                   "        uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:rotateZ\", " +
                   "\"xformOp:scale\"]\n        token visibility.timeSamples = {\n";
        person.visibility = file_.size() + text.size();
        text.append(kMostChanges * kChangeWidth, ' ');
        if (Status s = file_.write(text + "\n        }\n"); !s.ok()) return s;
        const Lines lines = linesOf(0, character, person.turn);
        const std::string root = "</World/" + std::string(name);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            if (k == 2) {
                if (Status s = file_.write(skeletonOf(root)); !s.ok()) return s;
            }
            if (Status s = file_.write(kStarts[k]); !s.ok()) return s;
            if (Status s = person.samples.emplace_back(info_.frames, lines[k].size()).reserve(file_); !s.ok())
                return s;
            if (Status s = file_.write(k < 2 ? "        }\n" : "            }\n"); !s.ok()) return s;
        }
        return file_.write("        }\n" + bodyOf(root, look) + "    }\n");
    }

    /// The skeleton, and the animation up to its samples.
    static std::string skeletonOf(const std::string& root) {
        std::string sizes;
        for (std::size_t j = 0; j < kJointCount; ++j) sizes += j == 0 ? "(1, 1, 1)" : ", (1, 1, 1)";
        return "        def Skeleton \"Skeleton\" (\n            prepend references = "
               "</World/Bodies/Skeleton>\n" +
               std::string("        )\n        {\n            rel skel:animationSource = ") + root +
               "/Animation>\n        }\n        def SkelAnimation \"Animation\"\n        {\n" +
               "            uniform token[] joints = " + usdJoints() + "\n            half3[] scales = [" +
               sizes + "]\n";
    }

    static std::string bodyOf(const std::string& root, const CharacterLook& look) {
        std::string
            text = "        def Mesh \"Body\" (\n            prepend references = </World/Bodies/Body" +
                   std::to_string(static_cast<int>(look.body) + 1) + ">\n        )\n        {\n" +
                   "            rel skel:skeleton = " + root + "/Skeleton>\n";
        for (std::size_t r = 0; r < kBodyRegionCount; ++r) {
            const auto region = static_cast<BodyRegion>(r);
            const bool own = region == BodyRegion::Shirt && look.chosen;
            text += std::string("            over \"") + bodyRegionName(region) + "\"\n            {\n" +
                    "                rel material:binding = " + (own ? root : "</World/Materials") + "/" +
                    usdName(regionColour(region, look).name) + ">\n            }\n";
        }
        text += "        }\n";
        if (look.chosen) text += usdShirt(regionColour(BodyRegion::Shirt, look), root.substr(1));
        return text;
    }

    static std::string visibilityOf(const Person& person) {
        std::string text;
        const auto say = [&](std::size_t frame, bool there) {
            char line[kChangeWidth + 1];
            std::snprintf(line, sizeof(line), "%12zu: \"%s\",", frame, there ? "inherited" : "invisible");
            text += line;
            text += '\n';
        };
        if (person.changes.front() > 0) say(0, false);
        for (std::size_t k = 0;
             k < person.changes.size() && text.size() + kChangeWidth <= kMostChanges * kChangeWidth; ++k)
            say(person.changes[k], k % 2 == 0);
        return text;
    }

    std::string path_;
    ExportInfo info_;
    OutputFile file_;
    std::map<std::uint32_t, Person> people_;
    CameraFit fit_;
    bool anyone_ = false;
    Vec2 middle_;
};

}  // namespace

std::unique_ptr<Exporter> makeUsdExporter(const std::string& path) {
    return std::make_unique<UsdExporter>(path);
}

}  // namespace muster
