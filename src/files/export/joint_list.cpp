#include "files/export/formats.h"

#include <cstdio>

#include "base/output_file.h"
#include "files/export/gltf_document.h"
#include "muster/motion.h"

namespace muster {
namespace {

class JointListExporter : public Exporter {
public:
    explicit JointListExporter(std::string path) : path_(std::move(path)) {}

    Status begin(const ExportInfo& info) override {
        from_ = info.from;
        if (Status s = file_.open(path_); !s.ok()) return s;
        std::string text = "{\"name\":" + jsonText(info.name) + ",\"fps\":" + jsonNumber(info.fps) +
                           ",\"joints\":[";
        for (std::size_t j = 0; j < kJointCount; ++j)
            text += (j == 0 ? "\"" : ",\"") + std::string(skeleton()[j].name) + "\"";
        return file_.write(text + "],\"frames\":[\n");
    }

    Status frame(const ExportFrame& frame) override {
        text_ = (frame.index == 0 ? "{\"time\":" : ",{\"time\":") + jsonNumber(frame.time - from_);
        text_ += ",\"characters\":[";
        for (std::size_t i = 0; i < frame.characters.size(); ++i) {
            if (i > 0) text_ += ",\n";
            put(frame.characters[i]);
        }
        text_ += "]}\n";
        return file_.write(text_);
    }

    Status finish() override {
        if (Status s = file_.write("]}\n"); !s.ok()) return s;
        return file_.commit();
    }

private:
    void put(const ExportCharacter& character) {
        MotionState place;
        place.position = character.position;
        place.yaw = character.yaw;
        place.size = character.size;
        JointTransforms joints;
        worldJoints(place, *character.pose, joints);
        text_ += "{\"id\":" + std::to_string(character.id) + ",\"positions\":[";
        for (std::size_t j = 0; j < kJointCount; ++j) {
            const Vec3 p = joints[j].translation;
            char numbers[80];
            std::snprintf(numbers, sizeof(numbers), "%s%.6f,%.6f,%.6f", j == 0 ? "" : ",",
                          static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
            text_ += numbers;
        }
        text_ += "]}";
    }

    std::string path_;
    OutputFile file_;
    std::string text_;
    double from_ = 0.0;
};

}  // namespace

std::unique_ptr<Exporter> makeJointListExporter(const std::string& path) {
    return std::make_unique<JointListExporter>(path);
}

}  // namespace muster
